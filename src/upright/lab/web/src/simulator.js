// A robot under a controller, in the page: the loop of experiment/loop.py and the times of bodies/electronics.py, over
// the motion, the programs and the electronics that compiled/print_javascript.py prints. Plain JavaScript, so that a
// test runs it beside Python. Arrays are doubles: x the state, u a command, w force, height and slope, y readings.

import { driveTorque, driveVolts, fuse, measure, settle, slacken, swing, turn } from "./electronics.js";

/**
 * @typedef {object} Motion what moves a state by one of the body's periods, and the six ideal sensors
 * @property {(x: Float64Array, u: Float64Array, w: Float64Array, y: Float64Array) => void} step
 * @property {(x: Float64Array, u: Float64Array, w: Float64Array, y: Float64Array) => void} read
 *
 * @typedef {object} Law a controller's printed program
 * @property {number[]} start
 * @property {(z: Float64Array, y: Float64Array, r: Float64Array, u: Float64Array, k: ArrayLike<number>) => void} command
 * @property {(z: Float64Array, y: Float64Array, r: Float64Array, u: Float64Array, k: ArrayLike<number>, a: Float64Array) => void} update
 *
 * @typedef {object} Sensor its numbers by name, times in steps of the body; `from` is its place among the ideal sensors,
 *   −1 for the battery; one of a gyro that swings or is tilted has `b0` and more, one of a filter `time_constant` and more
 * @property {number} from
 * @property {number} kind its place in `KINDS` of compiled/counter.py
 * @property {number} play
 * @property {number} delay
 * @property {number} every
 * @property {number} walks from one draw of its walk to the next
 * @property {number} bias
 * @property {number} bias_walk from one draw to the next
 * @property {number} noise
 * @property {number} quantum
 * @property {number} [b0]
 * @property {number} [time_constant]
 * @property {Sensor[]} [sources] gyro and accelerometer, of whose readings it makes the angle
 *
 * @typedef {object} Kit null stands for no limit
 * @property {number | null} limit
 * @property {number} dead_zone
 * @property {number} quantum
 * @property {number} drop
 * @property {number} left
 * @property {number} right
 * @property {number | null} voltage
 * @property {number} sag
 * @property {boolean} volts whether commands are volts
 * @property {number} delay
 * @property {number} jitter
 * @property {Sensor[]} sensors
 *
 * @typedef {object} Push
 * @property {number} force
 * @property {number} start
 * @property {number} duration
 * @property {number} height
 */

export const FALLEN = 1.4;
const STOP = 0.8; // [rad] at which every program stops the motors, as robots.kit.STOP
const SAME_TIME = 1e-9;
const [FOR_NOISE, FOR_WALK, FOR_BIAS, FOR_JITTER] = [0, 2, 4, 6]; // as in compiled/counter.py

/**
 * What several pushes make together at time t: forces add, at the height that gives the same moment.
 * @param {readonly Push[]} pushes
 * @param {number} t
 * @param {number} slope
 * @param {Float64Array} w
 */
export function combined(pushes, t, slope, w) {
  let force = 0;
  let moment = 0;
  for (const push of pushes) {
    const on = push.start - SAME_TIME <= t && t < push.start + push.duration - SAME_TIME;
    force += on ? push.force : 0;
    moment += (on ? push.force : 0) * push.height;
  }
  w[0] = force;
  w[1] = force ? moment / force : 0;
  w[2] = slope;
}

/**
 * @param {number} a
 * @param {number} b
 */
function high(a, b) {
  const [ah, al, bh, bl] = [a >>> 16, a & 0xffff, b >>> 16, b & 0xffff];
  const one = ah * bl + Math.floor((al * bl) / 65536);
  const two = al * bh + (one % 65536);
  return ah * bh + Math.floor(one / 65536) + Math.floor(two / 65536);
}

/**
 * Philox 4×32-10 (Salmon et al. 2011), as compiled/counter.py: four words of a counter and a key.
 * @param {[number, number, number, number]} counter
 * @param {[number, number]} key
 * @returns {[number, number, number, number]}
 */
export function philox([c0, c1, c2, c3], [k0, k1]) {
  for (let round = 0; round < 10; round += 1) {
    [c0, c1, c2, c3] = [
      (high(0xcd9e8d57, c2) ^ c1 ^ k0) >>> 0, Math.imul(0xcd9e8d57, c2) >>> 0,
      (high(0xd2511f53, c0) ^ c3 ^ k1) >>> 0, Math.imul(0xd2511f53, c0) >>> 0,
    ];
    k0 = (k0 + 0x9e3779b9) >>> 0;
    k1 = (k1 + 0xbb67ae85) >>> 0;
  }
  return [c0, c1, c2, c3];
}

/**
 * A normal number for a kind of sensor at a whole time (Box and Muller 1958).
 * @param {number} time
 * @param {number} purpose
 * @param {number} kind
 * @param {number} seed of 32 bits
 */
export function normal(time, purpose, kind, seed) {
  const words = philox([time, 0, 0, purpose + (kind >> 2)], [seed, 0]);
  const [first, second] = kind & 2 ? words.slice(2) : words;
  const radius = Math.sqrt(-2 * Math.log((first + 0.5) / 2 ** 32));
  const angle = Math.PI * (second / 2 ** 31 - 1);
  return radius * (kind & 1 ? Math.sin(angle) : Math.cos(angle));
}

/**
 * What a sensor senses: of a gyro that swings or is tilted, and of a fused angle, another number than the ideal one.
 * @param {Sensor} sensor
 * @param {Loop} loop
 * @returns {() => number}
 */
function sensing(sensor, loop) {
  const { from, every, b0, sources } = sensor;
  const { x, ideal } = loop;
  const own = new Float64Array(3); // and the two memories of a gyro
  if (b0 !== undefined) {
    settle(x[1], x[5], sensor, own);
    return () => {
      if (loop.steps) swing(x[1], x[5], own[1], own[2], sensor, own);
      return own[0];
    };
  }
  if (sources) {
    own[0] = x[0];
    // channels of its own: what they draw depends on the time alone, so that both copies read the same
    const made = sources.map((source) => new Channel(source, loop.seed, loop));
    return () => {
      if (made[0].count > loop.steps) return own[0]; // before the first step it is asked twice
      const [cosine, sine] = [Math.cos(own[0]), Math.sin(own[0])];
      const [rate, forward, up] = made.map((channel) => channel.read());
      if (loop.steps && loop.steps % every === 0)
        fuse(own[0], cosine, sine, rate, forward, up, loop.body.gravity, sensor, own);
      return own[0];
    };
  }
  return () => (from < 0 ? loop.voltage : ideal[from]);
}

/** One sensor: play, delay, bias, noise, quantum, range, sample and hold, in this order. */
class Channel {
  /**
   * @param {Sensor} sensor
   * @param {number} seed
   * @param {Loop} loop
   */
  constructor(sensor, seed, loop) {
    this.sensor = sensor;
    this.sense = sensing(sensor, loop);
    const first = this.sense();
    this.seed = seed;
    this.count = 0;
    this.held = 0;
    this.touch = first;
    this.line = new Float64Array(sensor.delay + 1).fill(first);
    this.bias = sensor.bias * this.normal(FOR_BIAS);
    this.out = new Float64Array(2);
  }

  /** @param {number} purpose */
  normal(purpose) {
    return normal(this.count, purpose, this.sensor.kind, this.seed);
  }

  read() {
    const { play, delay, every } = this.sensor;
    let value = this.sense();
    if (play) {
      slacken(this.touch, value, play, this.out);
      this.touch = value = this.out[0];
    }
    this.line[this.count % (delay + 1)] = value;
    if (this.count % every === 0) this.held = this.fresh(this.line[(this.count + 1) % (delay + 1)]);
    this.count += 1;
    return this.held;
  }

  /** @param {number} value */
  fresh(value) {
    const { bias_walk, noise, walks } = this.sensor;
    const step = bias_walk && this.count % walks === 0 ? this.normal(FOR_WALK) : 0;
    measure(value, this.bias, noise ? this.normal(FOR_NOISE) : 0, step, this.sensor, this.out);
    this.bias = this.out[1];
    return this.out[0];
  }
}

/** Body, electronics and controller together, from the state `start` on. */
export class Loop {
  /**
   * @param {{motion: Motion, period: number, gravity: number, kit: Kit | null}} body
   * @param {{law: Law | null, reads: number[], stride: number, gains?: ArrayLike<number>}} control `reads` are places
   *   among the six true states and the sensors behind them; without a law nothing is commanded
   * @param {ArrayLike<number>} start
   * @param {number} seed
   */
  constructor(body, control, start, seed) {
    this.body = body;
    this.control = control;
    this.x = Float64Array.from(start);
    this.steps = 0;
    this.z = Float64Array.from(control.law?.start ?? []);
    this.before = Float64Array.from(this.z); // the memory that the last command came from
    this.y = new Float64Array(control.reads.length);
    this.u = new Float64Array(8); // both commands, then what else a program gives out
    this.sent = new Float64Array(2);
    this.applied = new Float64Array(2);
    this.driven = new Float64Array(2);
    this.out = new Float64Array(4);
    this.w = new Float64Array(3);
    this.ideal = new Float64Array(7); // the last is the true pitch, the angle of an ideal filter
    this.stopped = false;
    this.twist = 0; // of a pull at one wheel
    body.motion.read(this.x, this.applied, this.w, this.ideal);
    this.ideal[6] = this.x[0];
    this.voltage = body.kit?.voltage ?? Infinity;
    /** @type {[number, number, number][]} */
    this.waiting = [];
    this.latest = [0, 0];
    this.arrived = [0, 0];
    this.seed = seed;
    this.channels = (body.kit?.sensors ?? []).map((s) => new Channel(s, seed, this));
    this.values = new Float64Array(6 + (body.kit ? this.channels.length : 7));
    this.sense();
  }

  get t() {
    return this.steps * this.body.period;
  }

  get fallen() {
    return Math.abs(this.x[0]) > FALLEN;
  }

  sense() {
    this.values.set(this.x);
    if (!this.body.kit) this.values.set(this.ideal, 6);
    this.channels.forEach((channel, i) => (this.values[6 + i] = channel.read()));
  }

  /**
   * One of the controller's periods towards the state `reference`; `disturb(t, w)` fills what acts from t on.
   * @param {Float64Array} reference
   * @param {(t: number, w: Float64Array) => void} disturb
   */
  step(reference, disturb) {
    const { law, reads, stride, gains = [] } = this.control;
    this.before.set(this.z);
    for (let i = 0; i < reads.length; i += 1) this.y[i] = this.values[reads[i]];
    law?.command(this.z, this.y, reference, this.u, gains);
    this.stopped ||= Math.abs(this.x[0]) > STOP;
    if (this.stopped) this.sent.fill(0);
    else this.sent.set(this.u.subarray(0, 2));
    for (let k = 0; k < stride; k += 1) {
      disturb(this.t, this.w);
      this.move();
    }
    law?.update(this.z, this.y, reference, this.u, gains, this.applied);
  }

  move() {
    const { motion, kit } = this.body;
    if (kit) this.drive(kit);
    else this.applied.set(this.sent);
    turn(this.applied[0], this.applied[1], kit?.left ?? 1, kit?.right ?? 1, this.driven);
    this.driven[0] += this.twist;
    this.driven[1] -= this.twist;
    motion.step(this.x, this.driven, this.w, this.ideal);
    this.ideal[6] = this.x[0];
    this.steps += 1;
    this.sense();
  }

  /**
   * What reaches both motors, after their dead time.
   * @param {Kit} kit
   */
  drive(kit) {
    const [left, right] = this.delayed(kit);
    const [limit, full] = [kit.limit ?? Infinity, kit.voltage ?? Infinity];
    const drive = kit.volts ? driveVolts : driveTorque;
    drive(left, right, limit, kit.dead_zone, kit.quantum, kit.drop, full, kit.sag, this.out);
    [this.applied[0], this.applied[1], this.voltage] = this.out;
  }

  /**
   * @param {Kit} kit
   * @returns {number[]}
   */
  delayed(kit) {
    const [left, right] = this.sent;
    if (left !== this.latest[0] || right !== this.latest[1]) {
      const [word] = philox([this.steps, 0, 0, FOR_JITTER], [this.seed, 0]);
      const jitter = Math.floor((word * (kit.jitter + 1)) / 2 ** 32);
      this.waiting.push([this.steps + kit.delay + jitter, left, right]);
      this.latest = [left, right];
    }
    while (this.waiting.length && this.waiting[0][0] <= this.steps) this.arrived = this.waiting.splice(0, 1)[0].slice(1);
    return this.arrived;
  }
}

/**
 * The linear model as a motion: exact between commands.
 * @param {{A: number[][], B: number[][], E: number[][], turn: number, radius: number, gravity: number, period: number}} m
 * @returns {Motion}
 */
export function linearMotion(m) {
  const next = new Float64Array(6);
  let acceleration = 0;
  /** @type {Motion["read"]} */
  const read = (x, _u, w, y) => {
    const side = m.turn * x[4];
    const [cos, sin] = [Math.cos(x[0]), Math.sin(x[0])];
    const forward = m.radius * acceleration + m.gravity * Math.sin(w[2]) * Math.cos(x[4]);
    const up = m.gravity * Math.cos(w[2]);
    y.set([x[2] - side - x[0], x[2] + side - x[0], x[1], x[4], forward * cos - up * sin, forward * sin + up * cos]);
  };
  return {
    step(x, u, w, y) {
      const push = [w[0], w[0] * w[1], w[2]];
      for (let i = 0; i < 6; i += 1) {
        let sum = 0;
        for (let j = 0; j < 6; j += 1) sum += m.A[i][j] * x[j];
        next[i] = sum + m.B[i][0] * u[0] + m.B[i][1] * u[1] + m.E[i][0] * push[0] + m.E[i][1] * push[1] + m.E[i][2] * push[2];
      }
      acceleration = (next[3] - x[3]) / m.period;
      x.set(next);
      read(x, u, w, y);
    },
    read,
  };
}
