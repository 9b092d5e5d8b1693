// A session without a server: what lab/export.py printed into the page, stepped here. It answers the page's messages as
// lab/session.py does, as far as that needs no Python.
import { Recorder, micro } from "./handin";
import type { RunResult } from "./handin";
import type { Analysed, Catalogue, Changed, ClientMessage, Equations, Look, Setup, Snapshot, Welcome } from "./messages";
import { DEFAULT_SETUP } from "./messages";
import type { Offer } from "./link";
import { analysed, shown } from "./margins";
import type { Plant } from "./margins";
import { Score } from "./score";
import { Loop, combined, linearMotion } from "./simulator";
import type { Kit, Law, Motion, Push } from "./simulator";
import { STATES, UNITS, UNLIT, store } from "./store";
import { inEach } from "./texts";
import { headOf } from "./verdict";

export interface Controller {
  kind: string;
  reads: number[];
  stride: number;
  gains: number[];
  analysed?: Analysed;
  plant?: Plant; // of gains by hand, which are analysed here
  S?: number[][];
  Sy?: number[][];
}

/** What is drawn and said of a robot, and the command [V or N m] that a pull of 1 N at a wheel turns into. */
interface Shown {
  pull: number;
  look: Look;
  equations: Equations;
}

export interface Facts extends Shown {
  title: Record<string, string>;
  kit_name: string;
  period: number;
  gravity: number;
  every: number;
  delay_own: number;
  setup: Partial<Setup> | null; // what makes this robot in the live lab; null where its kit is a file
  kit: Kit | null;
  laden: Shown | null; // the same under the one payload that can be put on it
  linear: Parameters<typeof linearMotion>[0];
  controllers: Record<string, Controller>;
}

export interface Exported {
  facts: { version: string; catalogue: Catalogue; welcome: Welcome; robots: Record<string, Facts> };
  motions: Record<string, Motion>;
  laden: Record<string, Motion>;
  laws: Record<string, Record<string, Law>>;
}

/** What was printed into this page; null in a live lab. */
export const exported = (globalThis as { uprightExport?: Exported }).uprightExport ?? null;

const BODIES = ["nonlinear", "linear"] as const;
const OFF = "off";
const SETTLED = 200; // [ms] without a change before gains by hand are analysed
const KNOCK = 0.02; // [s] that an impulse takes, a pull, and a hold: as lab/pushing.py
const PULL = 0.3;
const HOLD = 3.0;
const LYING = 1.5; // [rad] at which a fallen robot is shown
const KEPT = 60; // [s] that can be scrubbed back through
const MOMENT = 0.02; // [s] between two of its pictures
const BEHIND = 2; // [s] of wall time made up in one go: a frame may take long, and a laptop that slept does not race

/** What a link can ask this page for. */
export function offered({ facts }: Exported): Offer {
  const robots = Object.entries(facts.robots).map(([name, { controllers, laden }]) => [name, { controllers: [...Object.keys(controllers), OFF], load: laden?.look ?? null }] as const);
  const first = DEFAULT_SETUP.robot in facts.robots ? DEFAULT_SETUP.robot : facts.catalogue.robots[0].name;
  return {
    usual: { ...DEFAULT_SETUP, robot: first, bodies: [...BODIES] }, robots: Object.fromEntries(robots), kits: [], parameters: [], bodies: BODIES,
    keys: ["gains", "slope", "noise", "delay", "seed", "payload", "payload_height", "bodies"],
  };
}

/** One body under a controller of its own; the wheel's angle starts from zero, as in lab/lane.py. */
class Lane {
  loop: Loop;
  private offset: number[];

  constructor(facts: Facts, motion: Motion, kit: Kit | null, control: ConstructorParameters<typeof Loop>[1], start: number[], seed: number) {
    this.offset = [0, 0, start[2], 0, start[4], 0];
    const from = [start[0], start[1], 0, start[3], 0, start[5]];
    this.loop = new Loop({ motion, period: facts.period, gravity: facts.gravity, kit }, control, from, seed);
  }

  state(): number[] {
    const x = Array.from(this.loop.x, (v, i) => v + this.offset[i]);
    if (this.loop.fallen) [x[0], x[1], x[3], x[5]] = [Math.sign(x[0]) * LYING, 0, 0, 0];
    return x;
  }

  row(): number[] {
    return [...this.state(), ...this.loop.applied, this.loop.fallen ? 1 : 0];
  }

  shifted(target: Float64Array): [number, number] {
    return [target[2] + this.offset[2], target[4] + this.offset[4]];
  }

  estimate(c: Controller): number[] {
    const { before: z, y } = this.loop;
    const [S, Sy] = [c.S ?? [], c.Sy ?? []];
    const dot = (row: number[], values: Float64Array) => row.reduce((sum, v, i) => sum + v * values[i], 0);
    return S.map((row, i) => dot(row, z) + dot(Sy[i], y) + this.offset[i]);
  }
}

export class LocalSession {
  setup: Setup;
  private lanes: Lane[] = [];
  private periods = 0;
  private owed = 0;
  private paused = false;
  private speed = 1;
  private back = 0;
  private n = 0;
  private wall = performance.now();
  private target = new Float64Array(6);
  private steer = { speed: 0, rate: 0 };
  private hand: Push = { force: 0, start: -1, duration: Infinity, height: 0 };
  private active: Push[] = [];
  private pulled = { until: -1, force: 0 };
  private acting = new Float64Array(3); // force, height and slope of the last period, and the pull
  private pulling = 0;
  private kept: Snapshot[] = [];
  private score = new Score();
  private recorder = new Recorder();
  private run = { rows: 0, peak: 0, travel: 0, from: 0 }; // of the first body since it was built
  private thinking = 0;
  spent = 0; // [ms] of computing, for benchmarks

  constructor(private data: Exported) {
    this.setup = offered(data).usual;
    store.send = (message) => this.take(message);
    store.hear(data.facts.welcome);
    store.hear(data.facts.catalogue);
    this.changeTo(this.setup);
    window.setInterval(() => this.tick(), 16);
  }

  get facts(): Facts {
    const facts = this.data.facts.robots[this.setup.robot];
    return this.setup.payload && facts.laden ? { ...facts, ...facts.laden } : facts;
  }

  private get controller(): Controller | null {
    return this.facts.controllers[this.setup.controller] ?? null;
  }

  get t(): number {
    return this.periods * this.facts.every;
  }

  take(message: ClientMessage): void {
    store.note(message, this.t);
    switch (message.kind) {
      case "Change": this.changeTo(message.setup); break;
      case "Drag":
        if (message.force && !this.hand.force) this.score.push();
        this.hand = { ...this.hand, force: message.force, height: message.height };
        break;
      case "Strike": this.strike(message.what, message.size); break;
      case "Steer": this.steer = { speed: message.speed, rate: message.rate }; break;
      case "Play": [this.paused, this.speed, this.back] = [message.paused, message.speed, message.paused ? this.back : 0]; break;
      case "Step": this.stepped(message.periods); break;
      case "Scrub": [this.paused, this.back] = [true, message.back]; break;
      case "StandUp": this.stand(message.pitch); break;
      case "Save": message.what === "csv" ? this.keepTraces() : this.handIn(message.name); break;
      default: return;
    }
    if (message.kind === "Drag" || message.kind === "Strike" || message.kind === "Steer") this.recorder.note(message, this.t);
    this.show();
  }

  private changeTo(asked: Setup): void {
    const robots = this.data.facts.robots;
    const robot = Object.hasOwn(robots, asked.robot) ? asked.robot : this.setup.robot;
    const there = robots[robot].controllers;
    const known = Object.hasOwn(there, asked.controller) || asked.controller === OFF;
    const controller = known ? asked.controller : Object.keys(there)[0];
    const gains = asked.gains.length === 6 ? asked.gains : (there.gains?.gains ?? []);
    const bodies = BODIES.filter((name, i) => i === 0 || asked.bodies.includes(name));
    const load = asked.payload ? robots[robot].laden?.look : undefined;
    const { payload, payload_height } = load ?? DEFAULT_SETUP;
    const [before, same] = [this.setup, this.lanes.length > 0 && robot === this.setup.robot];
    this.setup = { ...asked, robot, controller, gains, bodies, payload, payload_height };
    this.recorder.stop();
    const alike = same && bodies.length === this.lanes.length;
    const still = alike && controller === before.controller && asked.noise === before.noise && asked.delay === before.delay && payload === before.payload;
    const main = same && !this.lanes[0].loop.fallen ? this.lanes[0].state() : [0, 0, 0, 0, 0, 0];
    const starts = bodies.map((_, i) => (alike && !this.lanes[i].loop.fallen ? this.lanes[i].state() : main));
    if (JSON.stringify({ ...before, slope: 0 }) !== JSON.stringify({ ...this.setup, slope: 0 })) this.score.exchanged();
    if (still) for (const lane of this.lanes) lane.loop.control.gains = gains;
    else this.build(starts);
    if (!alike) this.kept = [];
    if (!same) this.traced();
    this.said(!same || payload !== before.payload);
  }

  /** Tell the page how it stands now. */
  private said(another: boolean): void {
    const { facts, controller, setup } = this;
    const kit = { delay: this.delay(), dead_zone: facts.kit?.dead_zone ?? 0, voltage: facts.kit?.voltage ?? -1 };
    const changed: Changed = { kind: "Changed", setup, look: facts.look, bodies: setup.bodies, period: facts.every, kit, busy: false };
    store.hear(changed);
    if (another) store.hear(facts.equations);
    store.analysed = null;
    window.clearTimeout(this.thinking);
    store.hear(UNLIT);
    if (!controller) return;
    const { plant } = controller;
    if (controller.analysed) store.hear({ ...controller.analysed, L: [shown(facts.every), ...controller.analysed.L] });
    else if (plant) this.thinking = window.setTimeout(() => {
      const found = analysed(plant, this.data.laws[setup.robot][setup.controller], setup.gains);
      const { stable, poles, L } = found;
      store.hear({ kind: "Analysed", stable, heads: inEach(() => headOf(found, plant.period)), gain: [setup.gains], poles, L });
    }, SETTLED);
  }

  private traced(): void {
    store.traces.reset(this.setup.bodies.length);
    this.kept = [];
    this.periods = 0;
  }

  private delay(): number {
    return this.setup.delay < 0 ? this.facts.delay_own : this.setup.delay;
  }

  /** The kit with what the page has changed of it; the controller is still the one for the kit as it was. */
  private kit(): Kit | null {
    const { kit, period } = this.facts;
    if (!kit) return null;
    const scale = this.setup.noise;
    const sensors = kit.sensors.map((s) => ({ ...s, quantum: s.quantum * scale, noise: s.noise * scale, bias: s.bias * scale }));
    return { ...kit, sensors, delay: Math.round(this.delay() / period) };
  }

  private build(starts: number[][]): void {
    const { facts, setup, controller } = this;
    const law = controller ? this.data.laws[setup.robot][setup.controller] : null;
    const stride = controller?.stride ?? Math.round(facts.every / facts.period);
    const control = { law, reads: controller?.reads ?? [], stride, gains: setup.gains };
    const motions = setup.bodies.map((name) => (name === BODIES[0] ? this.data[setup.payload ? "laden" : "motions"][setup.robot] : linearMotion(facts.linear)));
    const kit = this.kit();
    this.lanes = motions.map((motion, i) => new Lane(facts, motion, kit, { ...control }, starts[i] ?? [0, 0, 0, 0, 0, 0], setup.seed));
    this.target.fill(0);
    [this.owed, this.back] = [0, 0];
    this.run = { rows: 0, peak: 0, travel: 0, from: this.lanes[0].loop.x[2] };
  }

  private stand(pitch: number): void {
    [this.active, this.pulled] = [[], { until: -1, force: 0 }];
    this.hand = { ...this.hand, force: 0 };
    this.score = this.score.anew(pitch);
    this.build(this.lanes.map(() => [pitch, 0, 0, 0, 0, 0]));
    this.recorder.begin(this.t, pitch, this.steer);
    store.hear({ kind: "Acted", t: this.t });
  }

  /** What the page saw, as lab/handin.py's result_of says. */
  result(): RunResult {
    const { rows, peak, travel } = this.run;
    const { fallen } = this.lanes[0].loop;
    return { fell: fallen, seconds: micro((rows - 1) * this.facts.every), peak: micro(peak), travel: micro(travel * this.facts.look.wheel_radius), best: micro(this.score.run) };
  }

  /** Save the run since the robot stood up under the student's name. */
  private handIn(student: string): void {
    const { facts } = this;
    const setup = { ...this.setup, ...facts.setup, gains: this.setup.controller === "gains" ? this.setup.gains : [] };
    const text = facts.setup && this.recorder.handIn(student, setup, facts.period, this.t, this.result());
    if (!text) return store.hear({ kind: "Notice", level: "error", parts: {}, key: facts.setup ? "noRun" : "noReplay", job: "" });
    made("hand-in.json", text, "application/json");
  }

  /** The traces of the first body, as a log that upright reads. */
  private keepTraces(): void {
    const { t, x, volts } = store.traces;
    const unit = this.facts.look.command_unit;
    const columns: [string, string, number[]][] = STATES.map((name, i) => [`truth/${name}`, UNITS[i], x[0][i]]);
    columns.push(["applied/left", unit, volts[0]], ["applied/right", unit, volts[1]]);
    const origin = { robot: { name: this.setup.robot }, controller: { kind: this.controller?.kind ?? OFF }, body: { kind: "nonlinear model, in a page", real: false } };
    const head = JSON.stringify({ units: Object.fromEntries(columns.map(([name, u]) => [name, u])), origin });
    const rows = t.map((time, k) => [time, ...columns.map(([, , values]) => values[k])].join());
    const text = [`# upright-log: ${head}`, ["t", ...columns.map(([name]) => name)].join(), ...rows].join("\n") + "\n";
    made("run.csv", text, "text/csv");
  }

  private strike(what: string, size: number): void {
    const { look, equations, every } = this.facts;
    const start = this.t;
    this.score.push();
    store.hear({ kind: "Acted", t: start });
    if (what === "pull_left" || what === "pull_right") {
      this.pulled = { until: start + PULL, force: what === "pull_left" ? size : -size };
      this.active.push({ force: size, start, duration: PULL, height: 0 });
    } else if (what === "impulse") {
      const duration = Math.max(Math.round(KNOCK / every), 1) * every; // whole periods, as the forces
      this.active.push({ force: size / duration, start, duration, height: look.com_height });
    } else {
      const force = (-equations.weight * Math.sin(size)) / (look.com_height * Math.cos(size) + look.wheel_radius);
      this.active.push({ force, start, duration: HOLD, height: look.com_height });
    }
  }

  /** Let so much wall time pass as has passed. */
  tick(): void {
    const now = performance.now();
    const elapsed = Math.min((now - this.wall) / 1000, BEHIND);
    this.wall = now;
    if (this.paused) return;
    this.advance(elapsed * this.speed);
    this.spent += performance.now() - now;
    this.show();
  }

  advance(seconds: number): void {
    const { every } = this.facts;
    this.owed += seconds;
    while (this.owed >= every * (1 - 1e-9)) {
      this.owed -= every;
      this.period();
    }
  }

  private stepped(periods: number): void {
    [this.paused, this.back] = [true, 0];
    for (let k = 0; k < periods; k += 1) this.period();
  }

  private period(): void {
    const { every, look, pull } = this.facts;
    const { t } = this;
    this.active = this.active.filter((push) => t < push.start + push.duration - 1e-9);
    const pushes = this.hand.force ? [...this.active, this.hand] : this.active;
    const w = this.acting;
    combined(pushes, t, this.setup.slope, w);
    const pulled = t < this.pulled.until - 1e-9 ? this.pulled.force : 0;
    this.pulling = pulled;
    const rolling = this.steer.speed / look.wheel_radius;
    this.target.set([0, 0, this.target[2] + rolling * every, rolling, this.target[4] + this.steer.rate * every, this.steer.rate]);
    this.noted();
    for (const { loop } of this.lanes) {
      loop.twist = pulled * pull;
      if (!loop.fallen) loop.step(this.target, (_t, into) => into.set(w));
    }
    this.periods += 1;
    const { x, applied, fallen } = this.lanes[0].loop;
    const ended = this.score.watch(every, pulled ? 0 : w[0], x[0], x[1], applied, fallen);
    if (ended) store.hear(ended);
    const last = this.kept.at(-1);
    if (!last || this.t - last.t >= MOMENT - 1e-9) this.kept.push(this.snapshot());
    if (this.kept.length > KEPT / MOMENT + 200) this.kept.splice(0, 200);
  }

  /** A row of the first body's run, which ends where it falls. */
  private noted(): void {
    const { x, fallen } = this.lanes[0].loop;
    if (fallen) return;
    this.run.rows += 1;
    this.run.peak = Math.max(this.run.peak, Math.abs(x[0]));
    this.run.travel = Math.max(this.run.travel, Math.abs(x[2] - this.run.from));
  }

  private snapshot(): Snapshot {
    const main = this.lanes[0];
    const limit = this.facts.look.limit ?? Infinity;
    const saturated = (main.loop.sent[0] ** 2 >= limit ** 2 ? 1 : 0) + (main.loop.sent[1] ** 2 >= limit ** 2 ? 2 : 0);
    this.n += 1;
    return {
      kind: "Snapshot", n: this.n, t: this.t, x: this.lanes.map((lane) => lane.row()), e: this.controller ? main.estimate(this.controller) : [],
      f: [...this.acting, this.pulling], r: main.shifted(this.target), s: saturated, paused: false, back: 0,
    };
  }

  /** Show now, or while scrubbing the moment asked for; the page's traces get every moment in between. */
  private show(): void {
    const now = this.snapshot();
    if (this.back) {
      const then = this.kept.findLast((s) => s.t <= now.t - this.back) ?? this.kept[0] ?? now;
      this.n += 1;
      return store.hear({ ...then, n: this.n, paused: true, back: this.back });
    }
    const last = store.traces.t.at(-1) ?? -Infinity;
    const shown = this.kept.findLastIndex((moment) => moment.t <= last);
    for (const moment of this.kept.slice(shown + 1)) if (moment.t < now.t) store.traces.add(moment);
    store.hear({ ...now, paused: this.paused });
  }
}

/** A file, to be saved by whoever looks at the page. */
function made(name: string, text: string, type: string): void {
  store.hear({ kind: "Made", name, url: URL.createObjectURL(new Blob([text], { type })) });
}
