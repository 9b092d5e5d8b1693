// Whether the smallest margins are enough, in plain words.
import { digits, h } from "./dom";
import type { Analysed } from "./messages";
import { store } from "./store";
import { t, translate } from "./texts";

const [LEAST_GAIN, LEAST_DELAY] = [0.04, 0.25]; // below which a margin is thin [1, periods], as certify/verdict.py

/** The smallest margins in plain words and with a verdict: how much later, stronger or weaker the loop bears. */
export function leastMargins(a: Analysed): Node[] {
  const every = store.changed?.period ?? 0.01;
  const [delay, place] = weakest(a);
  const verdict = (enough: boolean, words: string) => h("p", { className: `verdict ${enough ? "good" : "bad"}` }, h("b", {}, t(enough ? "enough" : "thin")), ` ${words}`);
  const [down, up] = [1 - (a.gain_low ?? 0), (a.gain_high ?? Infinity) - 1];
  const percent = (part: number) => digits(100 * part, 2);
  return [
    delay === null ? verdict(true, t("anyDelay")) : verdict(delay >= LEAST_DELAY * every, t("leastDelay", { delay: digits(delay * 1000, 2), place: translate(place), least: digits(LEAST_DELAY * every * 1000, 2) })),
    verdict(Math.min(down, up) >= LEAST_GAIN, up === Infinity ? t("leastGainLow", { down: percent(down) }) : t("leastGain", { down: percent(down), up: percent(up) })),
  ];
}

/** The smallest delay margin [s] and its place; at the motors as long as no other is known. */
function weakest(a: Analysed): [number | null, string] {
  return typeof store.lit?.delay === "number" ? [store.lit.delay, store.lit.delay_at ?? ""] : [a.delay, "both motors"];
}

/** The heading of the margins at the motors, which are not always the smallest. */
export function atMotors(a: Analysed): Node {
  return h("h4", {}, t("margins"), weakest(a)[1] === "both motors" ? "" : ` ${t("notWeakest")}`);
}
