// What a page without Python has in place of the live lab's panels: robot and room, the link, and what needs Python.
import { button, degrees, digits, follow, h, replace, select } from "./dom";
import type { Slider } from "./dom";
import type { LocalSession } from "./exported";
import type { Setup } from "./messages";
import { address } from "./opening";
import { number } from "./panels";
import { store } from "./store";
import { spoken, t, texts } from "./texts";

const BRISK = 8; // [rad/s] of the wheels: enough motion for an inertia of each robot of ours, and none of them falls

/** The robot, its floor and its electronics; the controller stays as it was designed. */
export class ExportedRobotPanel {
  root = h("div.panel-body");
  private sliders: [keyof Setup, Slider][] = [];
  private title = h("p.note");

  private ghost: HTMLInputElement | null = null;
  private load: HTMLInputElement | null = null;

  constructor(private session: () => LocalSession | null) {}

  build(): void {
    const robots = (store.catalogue?.robots ?? []).map((r): [string, string] => [r.name, r.name]);
    const choice = select(t("preset"), robots, store.setup.robot, (robot) => store.change({ robot, gains: [], delay: -1 }), "robot");
    this.sliders = [
      number("slope", t("slope"), { low: -0.2, high: 0.2, step: 0.005, show: degrees }),
      number("noise", t("noise"), { low: 0, high: 10, step: 0.1, show: (v) => `× ${digits(v, 2)}` }),
      number("delay", t("delay"), { low: 0, high: 0.05, step: 0.001, show: (v) => `${digits(v * 1000, 2)} ms` }),
    ];
    const ghost = h("input", { type: "checkbox", id: "ghost", "data-key": "ghost", onchange: () => store.change({ bodies: ghost.checked ? ["nonlinear", "linear"] : ["nonlinear"] }) });
    this.ghost = ghost;
    const load = h("input", { type: "checkbox", id: "load", "data-key": "load", onchange: () => store.change({ payload: load.checked ? 1 : 0 }) });
    this.load = load;
    const own = button(t("ownKit"), () => store.change({ slope: 0, noise: 1, delay: -1, payload: 0 }), "own-kit", { className: "quiet" });
    replace(
      this.root,
      h("div.column", choice, this.title, h("label", { "for": "ghost", className: "check" }, ghost, t("ghost")), this.carried),
      h("div.column.wide", h("div.sliders", ...this.sliders.map(([, s]) => s.root), h("p.note", t("stays")), own)),
    );
    this.update();
  }

  private carried = h("label", { "for": "load", className: "check" });

  update(): void {
    follow(this.root, "robot", store.setup.robot);
    if (this.ghost) this.ghost.checked = store.setup.bodies.length > 1;
    const facts = this.session()?.facts;
    const laden = facts?.laden?.look;
    replace(this.carried, ...(laden && this.load ? [this.load, t("carries", { mass: digits(laden.payload * 1000, 3), height: digits(laden.payload_height * 100, 3) })] : []));
    if (this.load) this.load.checked = store.setup.payload > 0;
    this.title.textContent = facts ? `${spoken(facts.title)} (${t("kit")}: ${facts.kit_name})` : "";
    const longest = this.sliders.find(([name]) => name === "delay")?.[1].root.querySelector("input");
    if (longest) longest.max = String(Math.max(0.05, 2 * (facts?.delay_own ?? 0))); // there is room on both sides of the kit's own
    for (const [name, s] of this.sliders) s.set(name === "delay" ? (store.changed?.kit.delay ?? 0) : (store.setup[name] as number));
  }
}

/** A command with a button that copies it. */
function shell(command: string): HTMLElement {
  const tokens = command.split(" ").flatMap((token, i) => [i ? " " : "", h("span.token", token)]);
  const code = h("code", { tabIndex: 0 }, ...tokens);
  const copy = button(t("copy"), () => {
    getSelection()?.selectAllChildren(code); // to be copied by hand where this may not be done
    void navigator.clipboard?.writeText(command).then(() => (copy.textContent = t("copied")), () => undefined);
  }, `copy-${command.replace(/\W+/g, "-")}`, { "aria-label": `${t("copy")}: ${command}` });
  return h("div.shell", code, copy);
}

/** What needs Python, each with its command. */
export class PythonPanel {
  root = h("div.panel-body");

  private shown = "";

  build(): void {
    const { robot, controller } = store.setup;
    this.shown = JSON.stringify([robot, controller]);
    const speed = String(parseFloat((BRISK * (store.changed?.look.wheel_radius ?? 0.04)).toPrecision(2)));
    const values: Record<string, string> = { robot, controller, speed };
    const bare = ["off", "gains"].includes(controller); // which no command knows by name
    const other = robot === "nxtway-gs" ? "--drive" : "upright example"; // of two ways to a log that one can calibrate from
    const own = texts().python.filter(([, command]) => !command.includes(other)).map(([what, command]) => [what, bare ? command.replace(" -c {controller}", "") : command]);
    const rows = own.filter(([, command]) => !(bare && command.includes("{controller}"))).flatMap(([what, command]) => [
      h("dt", what),
      h("dd", shell(command.replace(/\{(\w+)\}/g, (_, name: string) => values[name] ?? ""))),
    ]);
    replace(this.root, h("div.column.full", h("p.note", t("pythonNote")), shell(t("install")), h("dl.commands", ...rows)));
  }

  update(): void {
    if (this.shown !== JSON.stringify([store.setup.robot, store.setup.controller])) this.build();
  }
}

/** Copies the link to this robot, controller and push; where that is not allowed, shows it to be copied by hand. */
export function linkButton(say: (words: () => string) => void): HTMLElement {
  return button(t("lookAtThis"), () => {
    const [link, { kept }] = [address(), store.last];
    const shown = () => window.prompt(t("lookAtThis"), link);
    const words = () => `${t(location.protocol === "file:" ? "lookHere" : "lookCopied")} ${t(kept)}`;
    if (navigator.clipboard) navigator.clipboard.writeText(link).then(() => say(words), shown);
    else shown();
  }, "look", { title: t("lookTip") });
}
