// A link that restores the whole set-up: what differs from the usual one, in the part of the address no server sees.
import { DEFAULT_SETUP } from "./messages";
import type { ClientMessage, Setup } from "./messages";

export type Push = [string, number];

const PUSHES: Record<string, [number, number]> = { front: [0, 0.5], back: [-0.5, 0], impulse: [-20, 20], pull_left: [-100, 100], pull_right: [-100, 100], tilt: [-1.2, 1.2] };
const BRIEF = 0.5; // [s] of a push by hand that a knock of the same impulse stands for: SHORT of lab/pushing.py

/** The last push, as a link can carry it: by name, or one by hand as a knock of the same impulse; a long one is left out. */
export class LastPush {
  push: Push | null = null;
  kept: "noPush" | "namedPush" | "knockPush" | "heldPush" = "noPush";
  private hand = { from: 0, at: 0, force: 0, impulse: 0, on: false };

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

export function toLink(setup: Setup, push: Push | null = null): string {
  const entries = Object.entries(setup).filter(
    ([key, value]) => JSON.stringify(value) !== JSON.stringify(DEFAULT_SETUP[key as keyof Setup]),
  );
  if (!entries.length && !push) return "";
  const text = JSON.stringify(Object.fromEntries(entries));
  const bytes = Array.from(new TextEncoder().encode(text), (b) => String.fromCharCode(b)).join("");
  return "#setup=" + btoa(bytes).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "") + (push ? `&push=${push.join(":")}` : "");
}

export function fromLink(hash: string): Setup | null {
  const found = /[#&]setup=([\w-]+)/.exec(hash);
  if (!found) return null;
  try {
    const bytes = Uint8Array.from(atob(found[1].replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));
    const part = JSON.parse(new TextDecoder().decode(bytes)) as Partial<Setup>;
    return { ...DEFAULT_SETUP, ...part };
  } catch {
    return null;
  }
}

export function tokenIn(hash: string): string {
  return /[#&]token=([\w-]+)/.exec(hash)?.[1] ?? "";
}
