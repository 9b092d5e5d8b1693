// A tour, from a first push along the paper: what to do, what to watch, and a question. A page without Python has those that
// need neither the twin nor a design.
import { small } from "./charts";
import { button, h, replace } from "./dom";
import { exported } from "./exported";
import { DEFAULT_SETUP } from "./messages";
import type { Setup } from "./messages";
import { LEAN, store } from "./store";
import { sentence, t, texts } from "./texts";

/** A knock of so many N s, or a control by its name. */
type Act = number | "size" | "tilt" | "curves" | "identify";

/** What the page does when a step's own controls are used: the same as by the real ones. */
export interface Tools {
  run(speed: number): void;
  knock(size: number): void;
  sizer(): HTMLElement;
  tilt(): void;
  curves(): void;
  identify(): void;
}

interface Scene {
  setup: Partial<Setup>;
  lean: number;
  speed?: number; // of a fall, which takes half a second
  ceiling?: number; // [rad] up to which the pitch is shown
  strike?: "front" | "back";
  live?: true; // the live lab alone has this step
  acts?: Act[]; // what its text names, at hand where the controls are out of sight
}

interface Words {
  do: string;
  watch: string;
  ask: string;
}

/** A step in words; `here`: what differs in a page without Python, and in the first step without the twin. */
type Step = Words & { title: string; here?: Partial<Words> };

const THREE: Setup["bodies"] = ["twin", "nonlinear", "linear"];
const SCENES: Scene[] = [
  { setup: {}, lean: 0, acts: [0.05, 0.3, "size"] },
  { setup: { controller: "off", bodies: THREE }, lean: LEAN, speed: 0.1, ceiling: 0.3 },
  { setup: { controller: "off", kit: "ideal", bodies: ["nonlinear", "linear"] }, lean: 0.03, speed: 0.1 },
  { setup: { controller: "lqr", bodies: THREE }, lean: 0.1, acts: ["tilt"] },
  { setup: { controller: "lqg", bodies: THREE }, lean: 0, strike: "front" },
  { setup: { controller: "lqg", bodies: THREE }, lean: 0, strike: "back", acts: ["curves"] },
  { setup: { controller: "lqg", bodies: THREE }, lean: 0, strike: "front", live: true, acts: ["identify"] },
  { setup: { controller: "lqr", bodies: THREE, payload: 0.2, payload_height: 0.3 }, lean: 0, acts: [0.05, 0.3] },
  { setup: { controller: "robust", bodies: THREE, payload: 0.2, payload_height: 0.3 }, lean: 0, live: true, acts: [0.05, 0.3, "tilt"] },
];
const STEPS = SCENES.map((scene, i) => ({ scene, i })).filter(({ scene }) => !(exported && scene.live));

export class Tour {
  root = h("div.panel-body.tour");
  private at = 0;
  private before: Setup | null = null; // the tour
  private awaits = false; // whether the run that was prepared begins once its controller is designed

  constructor(private tools: Tools) {}

  build(): void {
    const { i, scene } = STEPS[this.at];
    const { here, ...there }: Step = texts().tour[i];
    const models = i === 0 && !store.setup.bodies.includes("twin"); // as a class begins
    const step = { ...there, ...((exported || models) && here) };
    const part = (title: string, text: string, ...more: Node[]) => h("div.hint-part", h("h4", title), h("p", text), ...more);
    const acts = (scene.acts ?? []).map((act) => this.control(act));
    replace(
      this.root,
      h("div.column.wide",
        h("p.note", t("tourStep", { n: this.at + 1, all: STEPS.length })),
        h("h3", step.title),
        h("div.hints", part(t("tourDo"), step.do, h("div.acts", ...acts)), part(t("tourWatch"), step.watch), part(t("tourAsk"), step.ask)),
        h("div.row",
          button(t("previous"), () => this.move(-1, "previous"), "tour-previous", { disabled: this.at === 0 }),
          this.at || this.before ? button(t("tourSet"), () => this.set(), "tour-set", { className: this.at ? "main" : "" }) : null, // at first all is ready
          button(t("next"), () => this.move(1, "next"), "tour-next", { className: this.at ? "" : "main", disabled: this.at === STEPS.length - 1 })),
        this.before ? button(t("tourBack"), () => this.back(), "tour-back", { className: "quiet" }) : null),
    );
  }

  /** A control that the text names, by which the page does what the real one does. */
  private control(act: Act): HTMLElement {
    const { knock, sizer, tilt, curves, identify } = this.tools;
    const key = `act-${act}`;
    if (typeof act === "number") return button(sentence(t("mark_impulse", { size: act.toFixed(2) })), () => knock(act), key);
    switch (act) {
      case "size": return sizer();
      case "tilt": return button(t("tilt"), tilt, key, { title: t("tiltTip") });
      case "curves": return button(t("moreCurves"), curves, key);
      case "identify": return button(t("tabIdentify"), identify, key);
    }
  }

  /** Go on or back, and give the focus to the button that was used, or to what sets the step up. */
  move(by: number, used = "set"): void {
    this.at = Math.min(Math.max(this.at + by, 0), STEPS.length - 1);
    this.build();
    const key = (name: string) => this.root.querySelector<HTMLButtonElement>(`[data-key=tour-${name}]:enabled`);
    (key(used) ?? key("set") ?? key("next"))?.focus({ preventScroll: small.matches });
    const panel = this.root.parentElement;
    if (panel) panel.scrollTop = 0;
    if (small.matches) this.upward(panel?.parentElement?.querySelector(".tabs"));
  }

  /** Each step is seen from its title on: below the robot, where a phone docks it. */
  private upward(tabs?: Element | null): void {
    if (!tabs) return;
    const docked = Math.max(...[tabs, document.documentElement].map((one, i) => parseFloat(getComputedStyle(one)[i ? "scrollPaddingTop" : "scrollMarginTop"]) || 0));
    if (this.root.getBoundingClientRect().top < docked + tabs.clientHeight) (docked ? tabs : tabs.parentElement)?.scrollIntoView();
  }

  /** The robot, controller and speed as they were before the tour. */
  private back(): void {
    if (this.before) store.change(this.before);
    store.last.name(null); // of the tour
    this.before = null;
    this.tools.run(1);
    store.send({ kind: "StandUp", pitch: 0 });
    this.build();
  }

  /** The controller that was being designed drives now: what was prepared begins. */
  designed(): boolean {
    const begins = this.awaits && store.setup.controller === "robust";
    this.awaits = false;
    if (begins) store.send({ kind: "StandUp", pitch: 0 });
    return begins;
  }

  private set(): void {
    const { setup, lean, speed, strike, ceiling } = STEPS[this.at].scene;
    if (!this.before) {
      this.before = store.setup;
      this.build();
      this.root.querySelector<HTMLButtonElement>("[data-key=tour-set]")?.focus();
    }
    store.anew(() => {
      this.tools.run(speed ?? 1); // first, so that nothing of the robot before is seen
      store.change({ ...DEFAULT_SETUP, ...setup });
      store.ceiling = ceiling ?? null;
      store.send({ kind: "StandUp", pitch: lean });
    });
    this.awaits = setup.controller === "robust";
    if (strike) window.setTimeout(() => store.send({ kind: "Strike", what: strike, size: strike === "front" ? 0.1 : -0.12 }), 1000);
  }
}
