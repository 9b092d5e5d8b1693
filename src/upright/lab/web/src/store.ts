// What the page knows: the latest snapshot, the traces of the last seconds, the set-up, and who wants to hear of it.
import { DEFAULT_SETUP } from "./messages";
import type { Analysed, Board, Catalogue, Changed, ClientMessage, Equations, JobResult, Light, ServerMessage, Setup, Snapshot } from "./messages";

export const STATES = ["pitch", "pitch_rate", "wheel", "wheel_rate", "yaw", "yaw_rate"] as const;
export const UNITS = ["rad", "rad/s", "rad", "rad/s", "rad", "rad/s"];
export const SYMBOLS = ["ψ", "ψ̇", "θ", "θ̇", "φ", "φ̇"];

const LONGEST = 3200; // a minute at 50 Hz and some

/** Time and, for every body, its six states; then what the other plots need. */
export class Traces {
  t: number[] = [];
  x: number[][][] = []; // [body][state][sample]
  estimate: number[] = [];
  volts: number[][] = [[], []];
  saturated: number[] = [];

  reset(bodies: number): void {
    this.t = [];
    this.x = Array.from({ length: bodies }, () => STATES.map(() => []));
    this.estimate = [];
    this.volts = [[], []];
    this.saturated = [];
  }

  add(s: Snapshot): void {
    const last = this.t.at(-1);
    if (last !== undefined && s.t <= last) return;
    if (s.x.length !== this.x.length) this.reset(s.x.length);
    this.push(s.t, s.x, s.e[0] ?? NaN, s.x[0][6], s.x[0][7], s.s);
    if (this.t.length > LONGEST + 400) this.cut(this.t.length - LONGEST);
  }

  push(t: number, x: number[][], estimate: number, left: number, right: number, saturated: number): void {
    this.t.push(t);
    x.forEach((row, body) => this.x[body].forEach((trace, i) => trace.push(row[i])));
    this.estimate.push(estimate);
    this.volts[0].push(left);
    this.volts[1].push(right);
    this.saturated.push(saturated);
  }

  /** Forget everything from time t on: the session went back. */
  until(t: number): void {
    let keep = this.t.length;
    while (keep > 0 && this.t[keep - 1] >= t) keep -= 1;
    for (const trace of this.all()) trace.length = keep;
  }

  private cut(count: number): void {
    for (const trace of this.all()) trace.splice(0, count);
  }

  private all(): number[][] {
    return [this.t, this.estimate, ...this.volts, this.saturated, ...this.x.flat()];
  }
}

type Listener = (message: ServerMessage) => void;

export class Store {
  snapshot: Snapshot | null = null;
  traces = new Traces();
  changed: Changed | null = null;
  catalogue: Catalogue | null = null;
  analysed: Analysed | null = null;
  equations: Equations | null = null;
  lit: Light | null = null;
  board: Board | null = null;
  found: JobResult | null = null;
  role = "alone";
  session = "";
  files = "";
  setup: Setup = DEFAULT_SETUP;
  replaying = false;
  send: (message: ClientMessage) => void = () => undefined;
  private listeners: Listener[] = [];

  listen(listener: Listener): void {
    this.listeners.push(listener);
  }

  /** Change the set-up and tell the session. */
  change(part: Partial<Setup>): void {
    this.setup = { ...this.setup, ...part };
    this.send({ kind: "Change", setup: this.setup });
  }

  hear(message: ServerMessage): void {
    switch (message.kind) {
      case "Snapshot":
        this.snapshot = message;
        if (!message.back) this.traces.add(message);
        break;
      case "Welcome":
        this.role = message.role;
        this.session = message.session;
        this.files = message.files;
        break;
      case "Catalogue": this.catalogue = message; break;
      case "Changed": this.changedTo(message); break;
      case "Analysed": this.analysed = message; break;
      case "Equations": this.equations = message; break;
      case "Light": this.lit = message; break;
      case "Board": this.board = message; break;
      case "JobResult": this.found = message; break;
      case "History": this.filled(message.t, message.rows); break;
    }
    for (const listener of this.listeners) listener(message);
  }

  private changedTo(message: Changed): void {
    const same = this.changed?.bodies.join() === message.bodies.join();
    this.changed = message;
    this.setup = message.setup;
    if (!same) this.traces.reset(message.bodies.length);
  }

  private filled(t: number[], rows: number[][]): void {
    const bodies = (rows[0]?.length ?? 0) / 6;
    this.traces.reset(bodies);
    t.forEach((time, k) => {
      const x = Array.from({ length: bodies }, (_, i) => rows[k].slice(6 * i, 6 * i + 6));
      this.traces.push(time, x, NaN, NaN, NaN, 0);
    });
  }
}

export const store = new Store();
