// What is said of the margins: in the live lab by the server, and of gains by hand in a page without Python here, in the
// same words and by the same limits.
import { digits, h } from "./dom";
import { exported } from "./exported";
import { first } from "./found";
import type { Analysis } from "./margins";
import { LEAST_DELAY, LEAST_GAIN, PHASE, STRONG, WEAK } from "./messages";
import type { Analysed, Head } from "./messages";
import { store } from "./store";
import { filled, spoken, t, texts } from "./texts";

const ROUNDED = 1e-6; // an integrator's pole is at 1 but for rounding
const MOST_GAIN = 11; // from here on it is not said how large a gain may be

/** Whether the loop is known to be unstable: a controller that is not linear has no poles. */
export function unstable({ stable, poles }: Analysed): boolean {
  return !stable && poles.length > 0;
}

/** That a controller is being designed, and of one that takes long how long. */
export function designing(): string {
  return [t("designing"), store.setup.controller === "robust" && t("robustTakes")].filter(Boolean).join(" ");
}

/** What is known of the loop; in a page without Python, whose controllers stay as they were designed, for which dead time. */
export function judged(): HTMLElement[] {
  const a = store.analysed;
  if (store.off) return [h("p.note", t("noLoop"))];
  if (!a) return [h("p.note", designing())];
  const own = exported?.facts.robots[store.setup.robot]?.delay_own ?? 0;
  const { delay } = store.setup;
  const other = exported && delay >= 0 && Math.abs(delay - own) > 5e-4;
  const note = h("p.note", t("delayOwn", { own: digits(1000 * own, 2), now: digits(1000 * delay, 2) }));
  return [first(spoken(a.heads)), ...(other ? [note] : [])];
}

/** The first screen for a loop that was broken at both motors, of a controller with this period [s]. */
export function headOf(a: Analysis, period: number): Head {
  const words = texts().loopSaid;
  const radius = Math.hypot(...a.poles[0]);
  if (radius > 1 + ROUNDED) {
    const time = seconds((period * Math.log(2)) / Math.log(radius), 2);
    return { verdict: words.unstable, level: "bad", title: filled(words.doubles, { time }), lead: [], numbers: [] };
  }
  if (radius > 1 - ROUNDED) return { verdict: words.free, level: "warn", title: words.unheld, lead: [], numbers: [] };
  const place = words.both;
  const high = a.gain_high ?? Infinity;
  const delay = a.delay === null ? Infinity : Math.floor(1e4 * a.delay) / 1e4;
  const kinds: [number, string][] = [
    [(a.delay ?? Infinity) / (LEAST_DELAY * period), ""], // a delay is among the numbers
    [(high - 1) / LEAST_GAIN, filled(words.stronger, { change: percent(high - 1), place })],
    [(1 - a.gain_low) / LEAST_GAIN, filled(words.weaker, { change: percent(1 - a.gain_low), place })],
  ];
  const [part, margin] = kinds.reduce((least, kind) => (kind[0] < least[0] ? kind : least));
  const low = String(Math.ceil(100 * a.gain_low));
  const range = high < MOST_GAIN ? filled(words.range, { low, high: String(Math.floor(100 * high)) }) : filled(words.atLeast, { low });
  const phase = a.phase === null ? Infinity : (180 * a.phase) / Math.PI;
  const reached: [number, string, string][] = [ // over the usual target, and what the title says of the least
    [(high - 1) / (STRONG - 1), words.unlessStronger, percent(high - 1)],
    [(1 - a.gain_low) / (1 - WEAK), words.unlessWeaker, percent(1 - a.gain_low)],
    [(a.delay ?? Infinity) / period, words.unlessLater, seconds(delay, 3)],
    [phase / PHASE, words.withPhase, `${digits(phase, 2)}°`],
  ];
  const [least, unless, size] = reached.reduce((one, other) => (other[0] < one[0] ? other : one));
  const usual = least >= 1;
  const [verdict, level] = part < 1 ? [words.thin, "warn"] : usual ? [words.usual, "good"] : [words.small, "warn"];
  const target = filled(words.range, { low: 100 * WEAK, high: 100 * STRONG });
  return {
    verdict, level: level as Head["level"],
    title: filled(usual ? words.roomy : unless, { controller: "u = −K x", robot: store.setup.robot, size, place }), lead: part < 1 && margin ? [margin] : [],
    numbers: [
      [`${range}\u00a0%`, filled(words.strength, { usual: `${target}\u00a0%` })],
      [seconds(delay, 3), filled(words.delay, { place, usual: seconds(period, 3) })],
      [phase < Infinity ? `${digits(phase, 2)}°` : "∞", filled(words.phase, { usual: `${PHASE}°` })],
    ],
  };
}

function seconds(time: number, count: number): string {
  return time < 0.1 ? `${digits(1000 * time, count)}\u00a0ms` : `${digits(time, count)}\u00a0s`;
}

function percent(part: number): string {
  return `${digits(100 * part, 2)}\u00a0%`;
}
