// What the page needs of a room, in three dimensions or two, and how a hand's way becomes newtons.
import type { Look, Snapshot } from "./messages";

const STIFF = 0.3; // weights of the robot for each height of it that the hand is away
const MOST = 0.8; // weights: a push beyond it lifts nothing, it only throws the robot over

export interface Hand {
  force: number;
  height: number;
}

export interface Stage {
  readonly element: HTMLElement | SVGElement;
  paint?(): void;
  furnish(look: Look, bodies: string[]): void;
  move(s: Snapshot): void;
  draw?(elapsed: number): void;
  picture(words: string): Promise<Blob | null>;
  turn?(azimuth: number, height: number): void;
  zoom?(factor: number): void;
  /** Where the middle of the robot's body is [CSS pixels from the upper left], for whoever wants to grasp it. */
  grasp(): { x: number; y: number };
}

export function sizeOf(look: Look): number {
  return look.body_height + 2 * look.wheel_radius;
}

/** The force [N] of a hand that is `along` [m] away from where it grasped the robot. */
export function forceOf(along: number, look: Look): number {
  const force = (along / sizeOf(look)) * STIFF * look.weight;
  return Math.max(-MOST * look.weight, Math.min(MOST * look.weight, force));
}
