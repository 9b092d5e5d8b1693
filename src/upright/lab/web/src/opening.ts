// Opens what a link says, and makes the link to what is here: the same in the live lab and in a page without Python.
import { exported, offered } from "./exported";
import { fromLink, isLink, pushing, toLink } from "./link";
import type { Offer } from "./link";
import { DEFAULT_SETUP } from "./messages";
import type { BodyName } from "./messages";
import { LEAN, store } from "./store";
import { t } from "./texts";

const AFTER = 1000; // [ms] from the controller to the push
const MODELS: BodyName[] = ["nonlinear", "linear"]; // with which a class begins, as lab/classroom.py
const LIVE: BodyName[] = ["twin", "nonlinear", "linear", "published"];

let timer = 0;

/** What a link can ask this page for. */
function offer(): Offer {
  if (exported) return offered(exported);
  const { robots, families, kits, units } = store.catalogue ?? { robots: [], families: [], kits: [], units: {} };
  const controllers = families.map((family) => family.name);
  const bodies = store.role === "alone" ? DEFAULT_SETUP.bodies : MODELS;
  return {
    usual: { ...DEFAULT_SETUP, bodies }, robots: Object.fromEntries(robots.map(({ name, kit }) => [name, { kit, controllers }])),
    kits, bodies: LIVE, parameters: Object.keys(units), keys: Object.keys(DEFAULT_SETUP),
  };
}

/** The address of robot, controller and the last push. */
export function address(): string {
  return location.href.split("#")[0] + toLink(store.setup, store.last.push, offer());
}

/** Do what the address says: its set-up, and a second after that its push; what nothing balances begins with a lean. */
export function open(): void {
  if (!isLink(location.hash)) return;
  const { setup, push, robot, controller, left } = fromLink(location.hash, offer());
  const { robots } = offer();
  store.change(setup);
  const words = () => [
    robot && t("noSuchRobot", { name: robot, shown: setup.robot, all: Object.keys(robots).join(", ") }),
    controller && t("noSuchController", { name: controller, shown: setup.controller, all: robots[setup.robot].controllers.join(", ") }),
    left.length && t("leftOut", { parts: left.join(", ") }),
  ].filter(Boolean).join(" ");
  if (words()) store.say(words, "error");
  store.last.name(push);
  window.clearTimeout(timer);
  const wait = () => {
    timer = store.settled ? window.setTimeout(() => (push || store.falls) && store.send(pushing(push ?? ["tilt", LEAN])), AFTER) : window.setTimeout(wait, 100);
  };
  wait();
}
