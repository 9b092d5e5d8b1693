// A link that restores the whole set-up: what differs from the usual one, in the part of the address no server sees. The
// live lab and the page without Python open each other's, and lab/framed.py and classwork/worksheet.py write them too.
import type { BodyName, ClientMessage, Setup } from "./messages";

export type Push = [string, number];

const PUSHES: Record<string, [number, number]> = { front: [0, 0.5], back: [-0.5, 0], impulse: [-20, 20], pull_left: [-100, 100], pull_right: [-100, 100], tilt: [-1.2, 1.2] };
const BRIEF = 0.5; // [s] of a push by hand that a knock of the same impulse stands for: SHORT of lab/pushing.py

/** The last push, as a link can carry it: by name, or one by hand as a knock of the same impulse; a long one is left out. */
export class LastPush {
  push: Push | null = null;
  kept: "noPush" | "namedPush" | "knockPush" | "heldPush" = "noPush";
  hand = { from: 0, at: 0, force: 0, impulse: 0, on: false };

  /** Take notice of a message at the simulated time t [s]. */
  note(message: ClientMessage, t: number): void {
    if (message.kind === "Strike") this.name([message.what, message.size]);
    else if (message.kind === "StandUp" && message.pitch) this.name(["tilt", message.pitch]);
    else if (message.kind === "Drag") this.drag(message.force, t);
  }

  /** A push by its name; none where there was none. */
  name(push: Push | null): void {
    [this.push, this.kept] = [push, push ? "namedPush" : "noPush"];
  }

  private drag(force: number, t: number): void {
    const { hand } = this;
    if (!hand.on && !force) return;
    if (!hand.on) Object.assign(hand, { from: t, at: t, force: 0, impulse: 0, on: true });
    hand.impulse += hand.force * (t - hand.at);
    [hand.at, hand.force, hand.on] = [t, force, force !== 0];
    const knock = t - hand.from <= BRIEF;
    [this.push, this.kept] = knock ? [["impulse", Number(hand.impulse.toPrecision(4))], "knockPush"] : [null, "heldPush"];
  }
}

/** The push of a link, if it is one. */
export function pushIn(hash: string): Push | null {
  const [what, size] = (new URLSearchParams(hash.replace(/^#/, "")).get("push") ?? "").split(":");
  const [low, high] = Object.hasOwn(PUSHES, what) ? PUSHES[what] : [0, -1];
  return Number(size) >= low && Number(size) <= high ? [what, Number(size)] : null;
}

/** What does that push. */
export function pushing([what, size]: Push): ClientMessage {
  return what === "tilt" ? { kind: "StandUp", pitch: size } : { kind: "Strike", what: what as "impulse", size };
}

const RANGES = { // of Setup in lab/messages.py
  slope: [-0.35, 0.35], noise: [0, 20], delay: [-1, 0.2], voltage: [-1, 60], dead_zone: [-1, 5], grip: [0.02, 10],
  seed: [0, 2 ** 31], payload: [0, 5], payload_height: [0, 1],
} as const;
const NUMBERS = Object.keys(RANGES) as (keyof typeof RANGES)[];
const LISTS = { gains: 6, largest: 7 } as const;
const LONGEST_SHOWN = 40; // letters of a link's unknown part

/** What a link can ask a page for. */
export interface Offer {
  usual: Setup; // what stands for all that a link leaves out
  robots: Record<string, { kit?: string; controllers: readonly string[]; load?: { payload: number; payload_height: number } | null }>;
  kits: readonly string[];
  bodies: readonly BodyName[];
  parameters: readonly string[];
  keys: readonly string[]; // parts of a set-up that can be changed here
}

/** What a link says, and what of it this page does not have. */
export interface Link {
  setup: Setup;
  push: Push | null;
  robot: string;
  controller: string;
  left: string[];
}

const partsOf = (hash: string) => new URLSearchParams(hash.replace(/^#/, ""));
const short = (text: string) => (text.length > LONGEST_SHOWN ? text.slice(0, LONGEST_SHOWN) + "…" : text);
const digits = (value: number) => String(Number(value.toPrecision(6)));

/** Whether there is a set-up or a push behind the address. */
export function isLink(hash: string): boolean {
  const known = ["robot", "controller", "kit", "bodies", "numbers", "push", ...NUMBERS, ...Object.keys(LISTS)];
  return [...partsOf(hash).keys()].some((key) => known.includes(key));
}

export function toLink(setup: Setup, push: Push | null, { usual, robots, keys }: Offer): string {
  const parts = new URLSearchParams({ robot: setup.robot, controller: setup.controller });
  const put = (key: string, value: string) => keys.includes(key) && parts.set(key, value);
  if (setup.kit !== robots[setup.robot]?.kit) put("kit", setup.kit);
  if (setup.controller === "gains" && setup.gains.length) put("gains", setup.gains.map(digits).join());
  if (setup.largest.length) put("largest", setup.largest.map(digits).join());
  if (setup.drive) put("drive", setup.drive);
  if (Object.keys(setup.numbers).length) put("numbers", Object.entries(setup.numbers).map(([name, value]) => `${name}:${String(value)}`).join());
  for (const name of NUMBERS) if (setup[name] !== usual[name]) put(name, digits(setup[name]));
  const bodies = setup.bodies.filter((name) => name !== "calibrated"); // which is of this session alone
  if (bodies.length && bodies.join() !== usual.bodies.join()) put("bodies", bodies.join());
  if (push) parts.set("push", `${push[0]}:${Number(push[1].toPrecision(4))}`);
  return "#" + parts.toString().replaceAll("%2C", ",").replaceAll("%3A", ":");
}

/** What the address asks for; of what cannot be the usual stands there. */
export function fromLink(hash: string, offer: Offer): Link {
  const parts = partsOf(hash);
  const [robot, controller] = [parts.get("robot") ?? "", parts.get("controller") ?? ""];
  const numbers = pairs(parts.get("numbers") ?? "", offer.parameters);
  const whole = offer.keys.includes("drive") && parts.has("drive") && Object.keys(numbers).length === offer.parameters.length;
  const there = Object.hasOwn(offer.robots, robot);
  const setup: Setup = { ...offer.usual, robot: there || (robot && whole) ? robot : offer.usual.robot };
  const own = offer.robots[setup.robot] ?? offer.robots[offer.usual.robot];
  if (own.controllers.includes(controller)) setup.controller = controller;
  setup.kit = own.kit ?? setup.kit;
  const inRange = (text: string, [low, high]: readonly [number, number]) => (text.trim() && Number(text) >= low && Number(text) <= high ? Number(text) : undefined);
  const list = (text: string, length: number) => [text.split(",").map(Number)].find((values) => values.length === length && values.every(Number.isFinite));
  const readers: Record<string, (text: string) => unknown> = {
    ...Object.fromEntries(NUMBERS.map((name) => [name, (text: string) => inRange(text, RANGES[name])])),
    ...Object.fromEntries(Object.entries(LISTS).map(([name, length]) => [name, (text: string) => list(text, length)])),
    seed: (text) => inRange(Number.isInteger(Number(text)) ? text : "", RANGES.seed),
    payload: (text) => inRange(text, own.load === undefined ? RANGES.payload : own.load ? [own.load.payload, own.load.payload] : [0, 0]),
    kit: (text) => offer.kits.find((name) => name === text),
    drive: (text) => ["voltage", "torque", "speed"].find((name) => name === text),
    numbers: (text) => (Object.keys(numbers).length === text.split(",").length ? numbers : undefined),
    bodies: (text) => [offer.bodies.filter((name) => text.split(",").includes(name))].find((names) => names.length === text.split(",").length),
  };
  const left: string[] = [];
  for (const [key, text] of parts) {
    if (!Object.hasOwn(readers, key)) continue;
    const value = offer.keys.includes(key) ? readers[key](text) : undefined;
    if (value === undefined) left.push(short(`${key}=${text}`));
    else Object.assign(setup, { [key]: value });
  }
  const push = pushIn(hash);
  if (parts.has("push") && !push) left.push(short(`push=${parts.get("push") ?? ""}`));
  return { setup, push, left, robot: setup.robot === robot ? "" : short(robot), controller: setup.controller === controller ? "" : short(controller) };
}

/** NAME:NUMBER, … of names that there are. */
function pairs(text: string, names: readonly string[]): Record<string, number> {
  const split = text.split(",").map((one) => one.split(":"));
  return Object.fromEntries(split.filter(([name, value]) => names.includes(name) && value?.trim() && Number.isFinite(Number(value))).map(([name, value]) => [name, Number(value)]));
}

export function tokenIn(hash: string): string {
  return /[#&]token=([\w-]+)/.exec(hash)?.[1] ?? "";
}
