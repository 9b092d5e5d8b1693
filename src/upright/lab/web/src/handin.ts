// A hand-in of the page without Python, as lab/handin.py writes and reads it: what was done since the robot stood up.
import type { Setup } from "./messages";

const LONGEST = 60; // [s]
const MOST = 5000; // actions

export type Action = { kind: "Drag"; force: number; height: number } | { kind: "Steer"; speed: number; rate: number } | { kind: "Strike"; what: string; size: number };

export interface RunResult {
  fell: boolean;
  seconds: number;
  peak: number;
  travel: number;
  best: number;
}

/** Notes what is done to the robot since it was stood up; after a change of the set-up there is nothing to hand in. */
export class Recorder {
  private since = -1;
  private lean = 0;
  private actions: [number, Action][] = [];

  begin(t: number, lean: number, steer: { speed: number; rate: number }): void {
    [this.since, this.lean] = [t, lean];
    this.actions = steer.speed || steer.rate ? [[0, { kind: "Steer", ...steer }]] : [];
  }

  stop(): void {
    this.since = -1;
  }

  note(action: Action, t: number): void {
    if (this.since >= 0 && this.actions.length < MOST) this.actions.push([micro(t - this.since), action]);
  }

  /** The file's text; null where there is no run to hand in. */
  handIn(student: string, setup: Setup, step: number, t: number, claimed: RunResult): string | null {
    const seconds = micro(t - this.since);
    if (this.since < 0 || !(seconds > 0 && seconds <= LONGEST) || !student.trim()) return null;
    const rest = { kind: "upright hand-in", version: 1, student: student.trim(), setup, step, lean: this.lean, seconds, actions: this.actions, claimed };
    return canonical({ ...rest, seal: sha256(canonical(rest)) });
  }
}

/** To a millionth, as the file has its numbers. */
export function micro(value: number): number {
  return Number(value.toFixed(6));
}

const WHOLE = ["version", "seed"];

/** JSON as Python writes it with sorted keys, over which the seal is computed: a number that is not whole by its
 * meaning has a point or an exponent. */
export function canonical(value: unknown, name = ""): string {
  if (typeof value === "number") return WHOLE.includes(name) ? String(value) : real(value);
  if (Array.isArray(value)) return `[${value.map((item) => canonical(item)).join(", ")}]`;
  if (value === null || typeof value !== "object") return JSON.stringify(value);
  const members = Object.entries(value).sort(([a], [b]) => (a < b ? -1 : 1));
  return `{${members.map(([key, item]) => `${JSON.stringify(key)}: ${canonical(item, key)}`).join(", ")}}`;
}

function real(value: number): string {
  const [digits, exponent] = value.toExponential().split("e").map((part, i) => (i ? Number(part) : part)) as [string, number];
  if (value && (exponent < -4 || exponent > 15)) return `${digits}e${exponent < 0 ? "-" : "+"}${String(Math.abs(exponent)).padStart(2, "0")}`;
  const text = Object.is(value, -0) ? "-0" : String(value);
  return text.includes(".") ? text : `${text}.0`;
}

/** SHA-256 (FIPS 180-4) in hexadecimal; `crypto.subtle` is not there on a page from a plain http address. */
export function sha256(text: string): string {
  const data = new TextEncoder().encode(text);
  const length = Math.ceil((data.length + 9) / 64) * 64;
  const bytes = new Uint8Array(length);
  bytes.set(data);
  bytes[data.length] = 0x80;
  const view = new DataView(bytes.buffer);
  view.setUint32(length - 8, Math.floor(data.length / 2 ** 29));
  view.setUint32(length - 4, data.length << 3);
  const hash = PRIMES.slice(0, 8).map((prime) => fraction(Math.sqrt(prime)));
  const round = PRIMES.map((prime) => fraction(Math.cbrt(prime)));
  const w = new Int32Array(64);
  const turn = (v: number, by: number) => (v >>> by) | (v << (32 - by));
  for (let at = 0; at < length; at += 64) {
    for (let i = 0; i < 16; i += 1) w[i] = view.getInt32(at + 4 * i);
    for (let i = 16; i < 64; i += 1) {
      const [a, b] = [w[i - 15], w[i - 2]];
      w[i] = w[i - 16] + (turn(a, 7) ^ turn(a, 18) ^ (a >>> 3)) + w[i - 7] + (turn(b, 17) ^ turn(b, 19) ^ (b >>> 10));
    }
    let [a, b, c, d, e, f, g, h] = hash;
    for (let i = 0; i < 64; i += 1) {
      const one = (h + (turn(e, 6) ^ turn(e, 11) ^ turn(e, 25)) + ((e & f) ^ (~e & g)) + round[i] + w[i]) | 0;
      const two = ((turn(a, 2) ^ turn(a, 13) ^ turn(a, 22)) + ((a & b) ^ (a & c) ^ (b & c))) | 0;
      [a, b, c, d, e, f, g, h] = [(one + two) | 0, a, b, c, (d + one) | 0, e, f, g];
    }
    [a, b, c, d, e, f, g, h].forEach((v, i) => (hash[i] = (hash[i] + v) | 0));
  }
  return hash.map((v) => (v >>> 0).toString(16).padStart(8, "0")).join("");
}

const PRIMES = Array.from({ length: 312 }, (_, n) => n).filter((n) => n > 1 && ![2, 3, 5, 7, 11, 13, 17].some((p) => n % p === 0 && n > p));

/** The first 32 bits behind the point. */
function fraction(value: number): number {
  return ((value - Math.floor(value)) * 2 ** 32) | 0;
}
