// What the page knows: the latest snapshot, the traces of the last seconds, the set-up, and who wants to hear of it.
import { LastPush } from "./link";
import { DEFAULT_SETUP } from "./messages";
import type { Analysed, Board, Catalogue, Changed, ClientMessage, Drag, Equations, JobResult, Light, Progress, ServerMessage, Setup, Snapshot, Strike } from "./messages";

export const STATES = ["pitch", "pitch_rate", "wheel", "wheel_rate", "yaw", "yaw_rate"] as const;
export const UNITS = ["rad", "rad/s", "rad", "rad/s", "rad", "rad/s"];
export const SHOWN_UNITS = UNITS.map((unit) => unit.replace("rad", "°"));
export const DEGREES = 180 / Math.PI; // of a radian: data are in radians, and people read degrees
export const SYMBOLS = ["ψ", "ψ̇", "θ", "θ̇", "φ", "φ̇"];

export const LEAN = 0.02; // [rad] from which a robot without a controller starts: upright it would stand for seconds

const LONGEST = 3200; // a minute at 50 Hz and some
const GAP = 0.15; // [s] without a sample: this page, or the way to it, is too slow for every one
const AGAIN = 1000; // [ms] between two questions for what is missing
const APART = 0.03; // [s] a sample of the history is taken where there is none so near before it
const [STEP, SWIFT] = [0.1, 2]; // [rad] and times what its rate makes of it: an angle that goes further was set, not reached
const [SOON, ROLLED] = [2, 0.05]; // [s] up to which a session is new; [rad] of the wheels, far more than a robot at rest creeps
const UNDESIGNED = ["bodies", "payload", "payload_height", "slope", "grip", "seed"]; // what no controller is designed for

/** The part of a set-up that a controller is designed for. */
function designed(setup: Setup): string {
  return JSON.stringify(Object.entries(setup).filter(([name]) => !UNDESIGNED.includes(name)));
}

/** The robot and the controller of a set-up, without their numbers that a slider changes. */
function which({ robot, drive, kit, controller }: Setup): string {
  return [robot, drive, kit, controller].join();
}

/** A set-up as text, the same for the same one. */
function same(setup: Setup): string {
  return JSON.stringify(Object.entries(setup).sort(([a], [b]) => (a < b ? -1 : 1)));
}

/** A push that began at `t` [s], of the size that its message has; one by hand: its impulse so far. */
export interface Mark {
  t: number;
  what: string;
  size: number;
}

/** Time and, for every body, its six states; then what the other plots need. */
export class Traces {
  t: number[] = [];
  x: number[][][] = []; // [body][state][sample]
  estimate: number[] = [];
  volts: number[][] = [[], []];
  saturated: number[] = [];
  marks: Mark[] = [];
  breaks: [number, number][] = []; // [s] two samples of which the second does not go on from the first
  other = false; // whether the next sample is another robot's or controller's
  from = -Infinity; // [s] up to which nothing is shown

  /** Forget what was before t [s], here and in the history. */
  begin(t: number): void {
    this.reset(this.x.length);
    this.from = t;
    this.other = false;
  }

  /** Where the samples from t [s] on begin. */
  since(t: number): number {
    return this.t.findLastIndex((time) => time < t) + 1;
  }

  reset(bodies: number): void {
    this.from = -Infinity;
    this.t = [];
    this.x = Array.from({ length: bodies }, () => STATES.map(() => []));
    this.estimate = [];
    this.volts = [[], []];
    this.saturated = [];
    this.breaks = [];
    this.marks = [];
  }

  add(s: Snapshot): void {
    const last = this.t.at(-1);
    if (s.t <= this.from || (last !== undefined && s.t < last)) return;
    if (s.t === last) {
      const k = this.t.length - 1;
      if (s.x.length !== this.x.length || this.x.every((body, b) => body.every((trace, i) => trace[k] === s.x[b][i]))) return;
      this.pop(); // stood up at this time: its first lean is drawn
    }
    if (s.x.length !== this.x.length) this.reset(s.x.length);
    this.push(s.t, s.x, s.e[0] ?? NaN, s.x[0][6], s.x[0][7], s.s);
    if (this.t.length > LONGEST + 400) this.cut(this.t.length - LONGEST);
  }

  push(t: number, x: number[][], estimate: number, left: number, right: number, saturated: number): void {
    if (this.other || this.jumps(t, x)) this.breaks.push([this.t.at(-1) ?? t, t]);
    this.other = false;
    this.t.push(t);
    x.forEach((row, body) => this.x[body].forEach((trace, i) => trace.push(row[i])));
    this.estimate.push(estimate);
    this.volts[0].push(left);
    this.volts[1].push(right);
    this.saturated.push(saturated);
  }

  private pop(): void {
    for (const trace of this.all()) trace.pop();
    this.other = true;
  }

  /** Whether an angle goes further than its rates allow: the robot was stood up, or exchanged. */
  private jumps(t: number, x: number[][]): boolean {
    const [k, dt] = [this.t.length - 1, t - (this.t.at(-1) ?? t)];
    const far = (row: number[], trace: number[][], i: number) => Math.abs(row[i] - trace[i][k]) > STEP + SWIFT * dt * Math.max(Math.abs(row[i + 1]), Math.abs(trace[i + 1][k]));
    return k >= 0 && x.some((row, body) => [0, 2, 4].some((i) => far(row, this.x[body], i)));
  }

  /** Put samples of the history where none of its own is: six states of each body, ψ̂, both commands and their limits. */
  fill(times: number[], rows: number[][]): void {
    if (!rows.length) return;
    const bodies = Math.floor(rows[0].length / 6);
    if (bodies !== this.x.length || (this.t.at(-1) ?? 0) > (times.at(-1) as number) + 1) this.reset(bodies); // begun anew
    const whole = new Traces();
    whole.reset(bodies);
    let k = 0;
    const history = (until: number) => {
      for (; k < times.length && times[k] < until - 1e-3; k += 1) {
        if (times[k] <= this.from || times[k] - (whole.t.at(-1) ?? -Infinity) < APART) continue;
        const [row, rest] = [rows[k], rows[k].slice(6 * bodies)];
        whole.push(times[k], Array.from({ length: bodies }, (_, i) => row.slice(6 * i, 6 * i + 6)), rest[0], rest[1], rest[2], rest[3]);
      }
    };
    this.t.forEach((time, i) => {
      history(time);
      whole.push(time, this.x.map((body) => body.map((trace) => trace[i])), this.estimate[i], this.volts[0][i], this.volts[1][i], this.saturated[i]);
    });
    history(Infinity);
    whole.breaks.push(...this.breaks);
    whole.marks.push(...this.marks);
    Object.assign(this, whole, { from: this.from, other: this.other });
  }

  /** Forget everything from time t on: the session went back. */
  until(t: number): void {
    const keep = this.since(t);
    for (const trace of this.all()) trace.length = keep;
    this.marks = this.marks.filter((mark) => mark.t < t);
  }

  private cut(count: number): void {
    for (const trace of this.all()) trace.splice(0, count);
    this.marks = this.marks.filter((mark) => mark.t >= this.t[0]);
  }

  private all(): number[][] {
    return [this.t, this.estimate, ...this.volts, this.saturated, ...this.x.flat()];
  }
}

/** What is known of a loop before its certificate. */
export const UNLIT: Light = { kind: "Light", light: "none", heads: {} };

type Listener = (message: ServerMessage) => void;

export class Store {
  snapshot: Snapshot | null = null;
  traces = new Traces();
  changed: Changed | null = null;
  catalogue: Catalogue | null = null;
  analysed: Analysed | null = null;
  equations: Equations | null = null;
  lit: Light | null = null;
  trying: Progress | null = null; // for the light
  jobs = new Set<string>(); // that have begun or wait, but for those of the controller itself
  ceiling: number | null = null; // [rad] up to which the pitch is shown
  board: Board | null = null;
  found: JobResult | null = null;
  certified: JobResult | null = null; // of the controller that is chosen
  role = "alone";
  session = "";
  files = "";
  invite = "";
  setup: Setup = DEFAULT_SETUP;
  last = new LastPush(); // for a link
  corrected: () => void = () => undefined; // called where the set-up is changed here
  say: (words: () => string, level?: "info" | "warn" | "error") => void = () => undefined; // to whoever looks at the page
  recorded = 0; // [s] that a recording lasts; 0 in a session that lives
  send: (message: ClientMessage) => void = () => undefined;
  private listeners: Listener[] = [];
  private sent: Mark | null = null; // a push that is on its way
  private waiting = false; // for the session to have the set-up that was chosen here
  private asked: string[] = []; // set-ups that were sent and not answered, in order
  private fresh = false; // whether the curves begin anew when the robot stands up
  lain: number | null = null; // [s] since when every body lies
  private recalled = -AGAIN; // [ms] when it asked for samples
  private rest: { wheel: number; from: number } | null | undefined; // of a robot that nobody has touched, since a time [s]; undefined before the first picture
  private missing = Infinity; // [s] since when there are holes that nobody was asked about

  /** Whether nothing balances the robot: upright it would stand for seconds. */
  get falls(): boolean {
    return this.off || this.analysed?.stable === false;
  }

  get off(): boolean {
    return this.setup.controller === "off";
  }

  /** Whether its six gains are set by hand. */
  get byHand(): boolean {
    return this.setup.controller === "gains";
  }

  /** Of a command. */
  get unit(): string {
    return this.changed?.look.command_unit ?? "V";
  }

  /** Begin with empty curves: `act` stands the robot up to another run. */
  anew(act: () => void): void {
    this.fresh = true;
    act();
    if (this.fresh) this.traces.begin(Infinity);
  }

  /** A push or a lean that was asked for acts from t [s] on. */
  private acted(t: number): void {
    if (this.sent?.what === "stood") this.rest = { wheel: 0, from: t };
    if (this.fresh) this.traces.begin(t);
    else if (this.sent) this.sent.t = t;
    this.fresh = false;
    this.sent = null;
  }

  /** Whether the controller that was chosen drives. */
  get settled(): boolean {
    return this.snapshot !== null && !this.waiting && this.changed?.busy === false;
  }

  /** Take notice of what is sent at the simulated time t [s]: for a link, and for a mark in the traces. */
  note(message: ClientMessage, t: number): void {
    const { hand } = this.last;
    const { marks } = this.traces;
    const held = hand.on;
    if (["Change", "Drag", "Strike", "Steer", "StandUp"].includes(message.kind)) this.rest = null;
    this.last.note(message, t);
    if (message.kind === "Strike") marks.push({ t, what: message.what, size: message.size });
    else if (message.kind === "StandUp") marks.push({ t, what: message.pitch ? "tilt" : "stood", size: message.pitch });
    else if (hand.on && !held) marks.push({ t, what: "hand", size: 0 });
    else if (held && marks.at(-1)?.what === "hand") (marks.at(-1) as Mark).size = hand.impulse;
    if (message.kind === "Strike" || message.kind === "StandUp" || (hand.on && !held)) this.sent = marks.at(-1) ?? null;
  }

  listen(listener: Listener): void {
    this.listeners.push(listener);
  }

  /** Change the set-up and tell the session. */
  change(part: Partial<Setup>): void {
    if (part.robot !== undefined && part.robot !== this.setup.robot) this.last.name(null); // it was another robot's
    this.expect(part);
    this.corrected();
    this.ceiling = null;
    this.asked.push(same(this.setup));
    this.send({ kind: "Change", setup: this.setup });
  }

  /** Push the robot, unless it lies: then say what helps. */
  push(message: Drag | Strike): void {
    const begins = message.kind === "Strike" || message.force !== 0;
    if (begins && this.snapshot?.x[0][8]) this.hear({ kind: "Notice", level: "info", parts: {}, key: "lies", job: "" });
    else this.send(message);
  }

  /** Change the set-up here; what is known of another controller goes at once. */
  expect(part: Partial<Setup>): void {
    const before = designed(this.setup);
    this.setup = { ...this.setup, ...part };
    if (designed(this.setup) === before) return;
    this.waiting = true;
    this.forget();
  }

  private forget(): void {
    this.analysed = null;
    this.certified = null;
    this.trying = null;
    this.lit = UNLIT;
    for (const listener of this.listeners) listener(this.lit);
  }

  /** Mark where a robot that nobody has touched sets off by itself. */
  private alone({ t, x: [row] }: Snapshot): void {
    if (this.rest === undefined) this.rest = t < SOON && !this.recorded ? { wheel: row[2], from: t } : null;
    if (!this.rest || t <= this.rest.from || this.falls || Math.abs(row[2] - this.rest.wheel) < ROLLED) return;
    const { rest, traces } = this;
    const k = traces.t.findIndex((time, i) => time > rest.from && Math.abs(traces.x[0][2][i] - rest.wheel) >= ROLLED); // of many that came at once
    traces.marks.push({ t: traces.t[k] ?? t, what: "self", size: 0 });
    this.rest = null;
  }

  /** Ask for the samples that this page has missed: for a hole that comes too soon after a question, later. */
  private recall(s: Snapshot): void {
    const last = this.traces.t.at(-1);
    if (last !== undefined && s.t - last >= GAP) this.missing = Math.min(this.missing, last);
    if (this.missing === Infinity || performance.now() - this.recalled < AGAIN) return;
    this.recalled = performance.now();
    this.send({ kind: "Recall", since: this.missing });
    this.missing = Infinity;
  }

  hear(message: ServerMessage): void {
    switch (message.kind) {
      case "Snapshot":
        this.snapshot = message;
        if (this.sent?.what === "hand" && message.f[0]) [this.sent.t, this.sent] = [message.t, null];
        if (!message.back) this.lain = message.x.every((row) => row[8]) ? (this.lain ?? message.t) : null;
        if (!message.back) {
          this.recall(message);
          this.traces.add(message);
          this.alone(message);
        }
        break;
      case "Welcome":
        this.traces.from = -Infinity; // its time may begin anew
        this.asked = [];
        this.jobs.clear(); // those of a session before
        this.role = message.role;
        this.session = message.session;
        this.files = message.files;
        this.invite = message.invite;
        break;
      case "Catalogue": this.catalogue = message; break;
      case "Changed": this.changedTo(message); break;
      case "Analysed":
        if (this.waiting) return; // it is of the controller before
        this.analysed = message;
        break;
      case "Equations": this.equations = message; break;
      case "Light":
        if (this.waiting) return;
        this.lit = message;
        this.trying = null;
        break;
      case "Progress":
        if (message.job === "light" && message.runs && !this.waiting) this.trying = message;
        if (message.job !== "light" && message.job !== "design") message.fraction < 1 ? this.jobs.add(message.job) : this.jobs.delete(message.job);
        break;
      case "Acted": this.acted(message.t); break;
      case "Board": this.board = message; break;
      case "JobResult":
        this.found = message;
        if (message.job === "certify") this.certified = message;
        break;
      case "Notice":
        if (message.key === "tooMany" && this.changed) { // what was left out may be a set-up: the one that is known stands
          this.asked = [];
          this.hear(this.changed);
        }
        break;
      case "History": this.traces.fill(message.t, message.rows); break;
    }
    for (const listener of this.listeners) listener(message);
  }

  /** Whether a set-up answers what was chosen here before something else was: the later choice stands. */
  private outdated(setup: Setup): boolean {
    const k = this.asked.indexOf(same(setup));
    this.asked = k < 0 ? [] : this.asked.slice(k + 1);
    return this.asked.length > 0;
  }

  private changedTo(message: Changed): void {
    const alike = this.changed?.bodies.join() === message.bodies.join();
    const before = this.changed;
    const other = before !== null && designed(before.setup) !== designed(message.setup);
    this.changed = message;
    const late = this.outdated(message.setup);
    this.traces.other ||= before !== null && (which(before.setup) !== which(message.setup) || (before.busy && !message.busy));
    if (other && !this.waiting) this.forget();
    if (!late) [this.waiting, this.setup] = [false, message.setup];
    if (!alike) this.traces.reset(message.bodies.length);
  }
}

export const store = new Store();
