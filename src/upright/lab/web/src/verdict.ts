// Whether the smallest margins are enough, in plain words: once every place is known where the loop can be broken.
import { digits, h } from "./dom";
import { exported } from "./exported";
import type { Analysed, Light } from "./messages";
import { store } from "./store";
import { t, translate } from "./texts";

const [LEAST_GAIN, LEAST_DELAY] = [0.04, 0.25]; // below which a margin is thin [1, periods], as certify/verdict.py

/** Whether the loop is known to be unstable: a controller that is not linear has no poles. */
export function unstable({ stable, poles }: Analysed): boolean {
  return !stable && poles.length > 0;
}

/** The smallest margins in plain words and with a verdict: how much later, stronger or weaker the loop bears. */
export function leastMargins(a: Analysed): Node[] {
  const lit = store.lit;
  const known = Boolean(lit?.delay_at);
  const thin = tight(known && lit ? lit : a); // no smallest margin is larger than one
  if (!known || !lit) {
    const exceeded = exceedsMargin(a);
    const places = thin || exceeded ? "" : t(exported ? "placesPython" : lit?.reasons.length ? "placesCertificate" : store.jobs.size ? "placesQueued" : "placesPending");
    return [h("p", { className: `verdict ${thin || exceeded ? "bad" : "open"}` }, exceeded ? h("b", {}, moreDelay(a)) : thin && h("b", {}, `${t("thinMotors")} `), places, exceeded ? "" : ` ${moreDelay(a)}`.trimEnd())];
  }
  const red = lit.light === "red" || lit.light === "amber" ? lit.light : null;
  const own = (store.setup.payload > 0 ? t("butPayload") : "") + (addedDelay() ? t("butDelay") : ""); // the margins are those of the robot alone
  const words = thin ? t("thin") : lit.met !== 5 ? t("targetsMet", { met: lit.met ?? 0 }).replace(/\.$/, `${own}.`) : t(red === "red" ? "enoughRed" : red ? "enoughAmber" : "enough").replace(/\.$/, `${own}.`);
  const exceeded = exceedsMargin(a);
  return [h("p", { className: `verdict ${thin || exceeded ? "bad" : red || addedDelay() || lit.met !== 5 ? "open" : "good"}` }, h("b", {}, exceeded ? moreDelay(a) : words), ` ${delayed(lit)} ${scaled(lit)} ${exceeded ? "" : moreDelay(a)}`.trimEnd())];
}

/** By how much the dead time [s] was changed since the margins were computed: only in a page without Python, whose
 *  controllers stay as they were designed. */
function addedDelay(): number {
  const own = exported?.facts.robots[store.setup.robot]?.delay_own;
  const by = own === undefined || store.setup.delay < 0 ? 0 : store.setup.delay - own;
  return Math.abs(by) < 5e-4 ? 0 : by;
}

/** Whether the dead time grew by more than the loop bears: it is one of both motors. */
function exceedsMargin({ delay }: Analysed): boolean {
  return addedDelay() > (delay ?? Infinity);
}

/** What the changed dead time is of these margins; "" where it is as it was. */
function moreDelay(a: Analysed): string {
  const by = addedDelay();
  if (!by) return "";
  const values = { by: digits(Math.abs(1000 * by), 2), own: digits(1000 * (store.setup.delay - by), 2), bears: digits(1000 * (a.delay ?? 0), 2) };
  return t(exceedsMargin(a) ? "delayLost" : by < 0 ? "delayLess" : a.delay === null ? "delayMore" : "delayUsed", values);
}

function tight({ delay, gain_low, gain_high }: Pick<Light, "delay" | "gain_low" | "gain_high">): boolean {
  return (delay ?? Infinity) < least() || Math.min(1 - (gain_low ?? 0), (gain_high ?? Infinity) - 1) < LEAST_GAIN;
}

/** The shortest delay margin that is enough [s]. */
function least(): number {
  return LEAST_DELAY * (store.changed?.period ?? 0.01);
}

function delayed({ delay, delay_at }: Light): string {
  if (delay === null) return t("anyDelay");
  return t("leastDelay", { delay: digits(delay * 1000, 2), place: translate(delay_at), least: digits(least() * 1000, 2) });
}

function scaled({ gain_low, low_at, gain_high, high_at }: Light): string {
  const percent = (part: number) => digits(100 * part, 2);
  const down = { down: percent(1 - (gain_low ?? 0)), low: translate(low_at) };
  return gain_high === null ? t("leastGainLow", down) : t("leastGain", { ...down, up: percent(gain_high - 1), high: translate(high_at) });
}

/** The heading of the margins at the motors, of which none may be the smallest. */
export function atMotors(): Node {
  const { delay_at, low_at, high_at } = store.lit ?? { delay_at: "", low_at: "", high_at: "" };
  const elsewhere = [delay_at, low_at, high_at].every((place) => place && place !== "both motors");
  return h("h4", {}, t("margins"), elsewhere ? ` ${t("notWeakest")}` : "");
}
