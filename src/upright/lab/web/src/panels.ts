// The panels below: controller, robot, kit, what was found, what is kept. Each builds itself from the store.
import { button, degrees, digits, exchange, fresh, h, keepingFocus, numberField, replace, said, sayAgain, select, slider, table, throttled } from "./dom";
import type { Slider } from "./dom";
import type { BodyName, Job, JobResult, Keep, Light, Setup, ErrorParts } from "./messages";
import { exported } from "./exported";
import { ResultPage, first } from "./found";
import { JobBar } from "./job_bar";
import { address } from "./opening";
import { session } from "./remember";
import { DEGREES, LEAN, SHOWN_UNITS, STATES, SYMBOLS, store } from "./store";
import { language, named, spoken, t, told } from "./texts";
import { legendEntry } from "./charts";
import { judged, unstable } from "./verdict";

const HERE = ["127.0.0.1", "localhost", "[::1]"]; // an address that no other computer reaches

const change = throttled(120, (part: Partial<Setup>) => store.change(part));
let gathered: Partial<Setup> = {};
/** Changes by sliders are gathered, so that none is lost between two messages. */
function later(part: Partial<Setup>): void {
  gathered = { ...gathered, ...part };
  store.expect(part);
  change(gathered);
}

abstract class Panel {
  root = h("div", { className: "panel-body" });
  abstract build(): void;
  /** Follow what the session says without losing what has the focus. */
  update(): void {}
}

export class ControllerPanel extends Panel {
  private noCertificate = h("p", { className: "note column full" }); // in a page that has no certificate
  private weights = h("div", { className: "sliders" });
  private numbers = h("div", { className: "numbers" });
  private gain = h("div", {});
  private light = h("div", { className: "light", role: "status" });
  private reasons = h("div", {});
  private sliders: Slider[] = [];
  private shape = "";
  private bar: JobBar | null = null;
  private working = h("div", {});
  private reported: JobResult | null = null; // in `certified`
  private certified = h("div", { className: "column full certified", "aria-live": "polite" });
  private page = new ResultPage();

  build(): void {
    this.shape = "";
    this.reported = null;
    replace(this.certified);
    const families = (store.catalogue?.families ?? []).map((f): [string, string] => [f.name, named(f.name)]);
    const choice = select(t("family"), families, store.setup.controller, (v) => {
      store.change({ controller: v, gains: v === "gains" ? this.present() : store.setup.gains });
      if (v === "off") store.send({ kind: "StandUp", pitch: LEAN }); // or it would stand still for seconds
    }, "controller");
    const certify = button(t("fullCertificate"), () => store.send({ kind: "Start", job: "certify", file: "" }), { "data-key": "certify" });
    replace(
      this.root,
      h("div", { className: "column" }, choice, this.weights),
      h("div", { className: "column full" }, this.gain),
      h("div", { className: "column full" }, this.numbers),
      exported ? this.noCertificate : h("div", { className: "column full" }, this.light, certify, this.working, this.reasons),
      this.certified,
    );
    this.update();
  }

  /** The full certificate, right where it was asked for. */
  certify(): void {
    this.update();
    this.certified.scrollIntoView({ block: "nearest" });
  }

  /** How far the full certificate is. */
  certifying(share: number): void {
    const own = this.root.querySelector("[data-key=certify]");
    own?.toggleAttribute("aria-busy", share < 1);
    if (own) own.textContent = t("fullCertificate") + (share < 1 ? `: ${(100 * share).toFixed(0)} %` : "");
    if (share >= 1 && !this.bar) return;
    const begins = !this.bar;
    this.bar ??= new JobBar("certify");
    this.bar.to(share);
    replace(this.working, share < 1 ? this.bar.root : null);
    if (begins) this.working.scrollIntoView({ block: "nearest" });
    if (share >= 1) this.bar = null;
  }

  /** The gains of the present controller; none where it has none, and the session begins with the regulator's. */
  private present(): number[] {
    return store.analysed?.gain[0]?.slice(0, 6) ?? [];
  }

  override update(): void {
    const box = this.root.querySelector<HTMLSelectElement>("[data-key=controller]");
    if (box && document.activeElement !== box) box.value = store.setup.controller;
    const shape = `${store.setup.controller} ${store.changed?.look.command_unit} ${store.setup.controller === "gains" ? this.byHand().length : ""}`; // what is known of the loop comes and goes
    if (shape !== this.shape) this.shapeWeights(shape);
    this.sliders.forEach((s, i) => s.set(store.setup.controller === "gains" ? (this.byHand()[i] ?? 0) : this.sizes()[i]));
    const driven = store.setup.controller !== "off";
    exchange(this.gain, driven && !store.analysed, ...this.gains());
    exchange(this.numbers, driven && !store.analysed, ...this.analysis());
    replace(this.light, ...light());
    exchange(this.reasons, driven && !store.lit?.heads.en, reasons());
    this.noCertificate.textContent = t(["gains", "off"].includes(store.setup.controller) ? "noCertificateByHand" : "noCertificateHere");
    if (this.reported === store.certified) return;
    this.reported = store.certified;
    replace(this.certified, ...(this.reported ? [h("p", {}, t("certified")), this.page.show(this.reported)] : []));
  }

  private byHand(): number[] {
    return store.setup.gains.length ? store.setup.gains : this.present();
  }

  private sizes(): number[] {
    const unit = store.changed?.look.command_unit ?? "V";
    const usual = [...(store.catalogue?.largest ?? []), store.catalogue?.command[unit] ?? 1];
    return store.setup.largest.length === usual.length ? store.setup.largest : usual;
  }

  private shapeWeights(shape: string): void {
    this.shape = shape;
    const info = store.catalogue?.families.find((f) => f.name === store.setup.controller);
    this.sliders = [];
    if (store.setup.controller === "gains") {
      const present = this.byHand();
      const largest = Math.max(...present.map(Math.abs), 0.1);
      const unit = store.changed?.look.command_unit ?? "V";
      const per = (i: number) => `${unit}${i % 2 ? " s" : ""}/rad`;
      const reach = (i: number) => Math.max(4 * Math.abs(present[i] ?? 0), largest / 4); // there is room on both sides
      this.sliders = SYMBOLS.map((symbol, i) => slider(`${symbol} ${named(STATES[i])} →\u00a0u`, { low: -reach(i), high: reach(i), step: reach(i) / 500, show: (v) => `${digits(v, 4)} ${per(i)}`, typed: per(i), key: `gain-${i}` }, (v) => {
        const gains = [...(this.byHand().length ? this.byHand() : [0, 0, 0, 0, 0, 0])];
        gains[i] = v;
        later({ gains });
      }));
      replace(this.weights, ...this.sliders.map((s) => s.root));
    } else if (info?.weights && !exported) {
      const usual = [...(store.catalogue?.largest ?? []), store.catalogue?.command[store.changed?.look.command_unit ?? "V"] ?? 1];
      this.sliders = usual.map((size, i) => this.weight(size, i));
      const reset = button(t("ownWeights"), () => store.change({ largest: [] }), { className: "quiet", "data-key": "own-weights" });
      replace(this.weights, h("p", { className: "note" }, t("weights")), ...this.sliders.map((s) => s.root), reset);
    } else {
      replace(this.weights, store.setup.controller === "off" ? null : h("p", { className: "note" }, t(info?.weights ? "fixedWeights" : "noWeights")));
    }
  }

  private weight(size: number, i: number): Slider {
    const unit = i < 6 ? SHOWN_UNITS[i] : ` ${store.changed?.look.command_unit ?? "V"}`;
    const scale = i < 6 ? DEGREES : 1;
    const label = i < 6 ? `${SYMBOLS[i]} ${named(STATES[i])}` : t("command");
    return slider(label, { low: size / 10, high: size * 10, log: true, show: (v) => `${digits(scale * v, 2)}${unit}`, key: `weight-${i}` }, (v) => {
      const largest = [...this.sizes()];
      largest[i] = v;
      later({ largest });
    });
  }

  private gains(): Node[] {
    const gain = store.analysed?.gain ?? [];
    if (!gain.length || ["gains", "off"].includes(store.setup.controller)) return [];
    return [h("h4", {}, t("gain")), table(SYMBOLS, [gain[0].map((v) => digits(v, 3))], "gains"), h("p", { className: "note" }, t("gainNote", { unit: store.changed?.look.command_unit ?? "V" }))];
  }

  private analysis(): Node[] {
    const a = store.analysed;
    if (store.setup.controller === "off") return [h("p", { className: "note" }, t("noLoop"))];
    if (!a) return [h("p", { className: "note" }, t("designing") + (store.setup.controller === "robust" ? " " + t("robustTakes") : ""))];
    return judged(a);
  }
}

/** The light's colour: without a controller, or with an unstable loop, it waits for no certificate. */
export function lamplight(): Light["light"] {
  const light = store.lit?.light ?? "none";
  return store.setup.controller === "off" || (light === "none" && store.analysed !== null && unstable(store.analysed)) ? "red" : light;
}

/** The light in words, or its colour alone, and of which robot: it is for the robot as its controller was designed. */
export function lightWords(colour = false): string {
  const { setup, lit, trying, jobs } = store;
  if (setup.controller === "off") return t("unlitOff");
  if (!lit?.heads.en) {
    if (!trying) return t(jobs.size ? "queued" : "none");
    return colour ? `${(100 * trying.fraction).toFixed(0)} % …` : t("tried", { n: Math.round(trying.fraction * trying.runs), all: trying.runs });
  }
  if (lit.light === "none") return t("noCertificate");
  const light = colour ? t(lit.light) : spoken(lit.heads).verdict;
  if (setup.payload > 0) return t(setup.slope && !colour ? "litBoth" : "litPayload", { light });
  return setup.slope ? t("litSlope", { light }) : light;
}

function light(): Node[] {
  const lamp = h("span", { className: `lamp ${lamplight()}`, "aria-hidden": "true" });
  return [h("h4", {}, t("certificate")), h("p", { className: "lit" }, lamp, h("b", {}, lightWords()))];
}

/** Why it has this colour, below the button, which does not move when they arrive; the full certificate says it itself. */
function reasons(): Node | null {
  if (store.setup.controller === "off" || store.certified) return null;
  if (store.lit?.heads.en) return first({ ...spoken(store.lit.heads), verdict: "" });
  return store.jobs.size ? null : h("p", { className: "note" }, t("lightNote"));
}

export class RobotPanel extends Panel {
  private sliders: [keyof Setup, Slider][] = [];
  private table = h("div", { className: "parameters" });
  private fields = new Map<string, ReturnType<typeof numberField>>();
  private shown = "";
  private opened = false;
  private title = h("p", { className: "note" });

  build(): void {
    this.shown = "";
    this.fields.clear();
    const robots = (store.catalogue?.robots ?? []).map((r): [string, string] => [r.name, r.name]);
    if (!robots.some(([name]) => name === store.setup.robot)) robots.push([store.setup.robot, store.setup.robot]);
    const preset = select(t("preset"), robots, store.setup.robot, (v) => this.choose(v), "robot");
    this.sliders = [
      ["payload", slider(t("payload"), { low: 0, high: this.weight(), step: 0.005, show: (v) => `${digits(v * 1000, 3)} g`, key: "payload" }, (v) => later({ payload: v }))],
      ["payload_height", slider(t("payloadHeight"), { low: 0, high: 0.5, step: 0.005, show: (v) => `${digits(v * 100, 3)} cm`, key: "payload_height" }, (v) => later({ payload_height: v }))],
      ["slope", slider(t("slope"), { low: -0.2, high: 0.2, step: 0.005, show: degrees, key: "slope" }, (v) => later({ slope: v }))],
      ["grip", slider(t("grip"), { low: 0.02, high: 10, log: true, show: (v) => digits(v, 2), key: "grip" }, (v) => later({ grip: v }))],
    ];
    const details = h("details", { open: this.opened, ontoggle: () => (this.opened = details.open) }, h("summary", {}, t("numbers")), h("p", { className: "note" }, t("numbersNote")), this.table);
    replace(
      this.root,
      h("div", { className: "column" }, preset, this.title, upload(t("openRobot"), ".toml", "robot")),
      h("div", { className: "column" }, h("div", { className: "sliders" }, ...this.sliders.map(([, s]) => s.root))),
      h("div", { className: "column" }, this.bodies()),
      h("div", { className: "column full" }, details),
    );
    this.update();
  }

  private weight(): number {
    return Math.max(0.3, ((store.changed?.look.weight ?? 6) / 9.81) * 0.6);
  }

  private choose(name: string): void {
    const info = store.catalogue?.robots.find((r) => r.name === name);
    if (info) store.change({ robot: name, numbers: {}, drive: "", kit: info.kit, largest: [], gains: [], payload: 0, delay: -1, voltage: -1, dead_zone: -1 });
  }

  private bodies(): HTMLElement {
    const names: BodyName[] = ["twin", "nonlinear", "linear", "published", ...(store.changed?.bodies.includes("calibrated") ? (["calibrated"] as BodyName[]) : [])];
    const boxes = names.map((name) => {
      const id = fresh("body");
      const box = h("input", { type: "checkbox", id, checked: store.setup.bodies.includes(name), "data-key": `body-${name}`, onchange: () => {
        const chosen = names.filter((n) => (n === name ? box.checked : store.setup.bodies.includes(n)));
        if (chosen.length) store.change({ bodies: chosen });
        else box.checked = true;
      } });
      return h("label", { "for": id, className: "check" }, box, legendEntry(name));
    });
    return h("fieldset", {}, h("legend", {}, t("bodies")), ...boxes);
  }

  override update(): void {
    for (const [name, s] of this.sliders) s.set(store.setup[name] as number);
    const info = store.catalogue?.robots.find((r) => r.name === store.setup.robot);
    this.title.textContent = info ? spoken(info.title) : "";
    const shown = JSON.stringify([store.setup.robot, store.setup.numbers, store.changed?.bodies]);
    if (shown === this.shown) return;
    const again = this.shown !== "";
    this.shown = shown;
    if (again && !this.root.contains(document.activeElement)) this.build();
    this.parameters();
  }

  private parameters(): void {
    const base = store.catalogue?.robots.find((r) => r.name === store.setup.robot)?.numbers ?? {};
    const values = { ...base, ...store.setup.numbers };
    if (Object.keys(values).join() === [...this.fields.keys()].join()) return this.fields.forEach((field, name) => field.set(values[name])); // who types in one goes on
    this.fields.clear();
    const rows = Object.keys(values).map((name) => {
      const id = fresh("number");
      const field = numberField((v) => store.change({ numbers: { ...store.setup.numbers, [name]: v } }), { id, "data-key": `number-${name}` });
      this.fields.set(name, field);
      const symbol = store.catalogue?.symbols[name] ?? "";
      return h("div", { className: "parameter" }, h("label", { "for": id }, `${spoken(store.catalogue?.names ?? {})?.[name] ?? name} ${symbol}`), field.root, h("span", {}, (store.catalogue?.units[name] ?? "").replace(/^1$/, "")));
    });
    this.fields.forEach((field, name) => field.set(values[name]));
    replace(this.table, ...rows, button(t("ownNumbers"), () => store.change({ numbers: {}, drive: "" }), { className: "quiet", "data-key": "own-numbers" }));
  }
}

export class KitPanel extends Panel {
  private sliders: [string, Slider][] = [];
  private anew = h("p", { className: "note" });

  build(): void {
    const kits = (store.catalogue?.kits ?? []).map((name): [string, string] => [name, name === "ideal" ? t("ideal") : name]);
    const choice = select(t("kit"), kits, store.setup.kit, (v) => store.change({ kit: v, delay: -1, voltage: -1, dead_zone: -1, noise: 1 }), "kit");
    const unit = store.changed?.look.command_unit ?? "V";
    this.sliders = [
      ["noise", slider(t("noise"), { low: 0, high: 10, step: 0.1, show: (v) => `× ${digits(v, 2)}`, key: "noise" }, (v) => later({ noise: v }))],
      ["delay", slider(t("delay"), { low: 0, high: 0.04, step: 0.002, show: (v) => `${digits(v * 1000, 2)} ms`, key: "delay" }, (v) => later({ delay: v }))],
      ["voltage", slider(t("voltage"), { low: 1, high: 14, step: 0.1, show: (v) => (v > 0 ? `${digits(v, 3)} V` : t("unlimited")), key: "voltage" }, (v) => later({ voltage: v }))],
      ["dead_zone", slider(t("deadZone"), { low: 0, high: unit === "V" ? 2 : 0.1, show: (v) => `${digits(v, 2)} ${unit}`, key: "dead_zone" }, (v) => later({ dead_zone: v }))],
    ];
    const own = button(t("ownKit"), () => store.change({ noise: 1, delay: -1, voltage: -1, dead_zone: -1 }), { className: "quiet", "data-key": "own-kit" });
    replace(this.root, h("div", { className: "column" }, choice, own), h("div", { className: "column wide" }, h("div", { className: "sliders" }, ...this.sliders.map(([, s]) => s.root)), this.anew));
    this.update();
  }

  override update(): void {
    const kit = store.changed?.kit ?? {};
    for (const [name, s] of this.sliders) s.set(name === "noise" ? store.setup.noise : kit[name]);
    this.anew.textContent = ["gains", "off"].includes(store.setup.controller) ? "" : t("redesigned");
    const box = this.root.querySelector<HTMLSelectElement>("[data-key=kit]");
    if (box && document.activeElement !== box) box.value = store.setup.kit;
  }
}

/** Have a file made, which is downloaded then. */
function save(what: Keep, name = ""): void {
  store.send({ kind: "Save", what, name, language: language() });
}

/** A file to be sent to the session's folder. */
function upload(label: string, accept: string, what: "log" | "robot"): HTMLElement {
  const id = fresh("file");
  const input = h("input", { type: "file", id, accept, className: "file", "data-key": `open-${what}`, onchange: () => {
    const file = input.files?.[0];
    input.value = "";
    if (file) void send(file, what);
  } });
  return h("div", { className: "upload" }, input, h("label", { "for": id, className: "button" }, label));
}

export let latestLog = "";
let opened: () => void = () => undefined; // called where a log was opened

async function send(file: File, what: "log" | "robot"): Promise<void> {
  const address = `upload/${store.session}?what=${what}&name=${encodeURIComponent(file.name)}`;
  store.say(() => t("uploaded", { name: file.name }));
  try {
    const answer = await fetch(address, { method: "POST", body: file });
    const { name, error } = (await answer.json()) as { name?: string; error?: Record<string, ErrorParts> };
    if (error) store.say(() => told(error), "error");
    else if (what === "log") {
      latestLog = name ?? "";
      opened();
    }
  } catch {
    store.say(() => t("lost"), "error");
  }
}

export const COMPARISON = "compare.html"; // as lab/recording.py names it

export class IdentifyPanel extends Panel {
  private bars = h("div", { className: "bars" });
  private result = h("div", { className: "result", role: "region", "aria-live": "polite" });
  private shares = new Map<Job, number>();
  private running = new Map<Job, JobBar>();
  private source = "";
  private comparison = h("p", { className: "comparison", role: "status" });
  private robot = ""; // of the comparison, and of what failed
  private failed = h("p", { className: "failed", role: "alert" });
  private load = 0; // [kg] that the run carried whose calibration was begun
  private page = new ResultPage((job) => this.next(job));

  constructor() {
    super();
    opened = () => keepingFocus(() => this.build());
  }

  build(): void {
    const choices: [string, string][] = [["", t("thisRun")]];
    if (latestLog) choices.push([latestLog, latestLog.replace(/^in-/, "")]);
    if (latestLog) this.source = latestLog;
    const source = select(t("source"), choices, this.source, (v) => (this.source = v), "source");
    const row = h(
      "div", { className: "row" },
      button(t("doctor"), () => this.start("doctor"), { title: t("doctorTip"), "data-key": "doctor" }),
      button(t("calibrate"), () => this.start("calibrate"), { title: t("calibrateTip"), "data-key": "calibrate" }),
      button(t("compare"), () => this.compare(), { title: t("compareTip"), "data-key": "compare" }),
    );
    const logs = ".csv,.txt,.log,.tsv,.dat,.json,.mat,.parquet,.mcap";
    this.changed();
    for (const words of [this.comparison, this.failed]) sayAgain(words);
    replace(
      this.root,
      h("div", { className: "column" }, source, upload(t("openLog"), logs, "log"), row, this.failed, this.comparison, h("p", { className: "note" }, t("calibrateNote")), this.bars),
      h("div", { className: "column wide" }, this.result),
    );
    this.found();
  }

  private start(job: Job): void {
    replace(this.failed);
    this.load = this.source ? 0 : store.setup.payload;
    store.send({ kind: "Start", job, file: this.source });
  }

  /** A job has stopped; it is said under its button until another one begins. */
  fail(words: () => string, verb: string): void {
    this.robot = store.setup.robot;
    replace(this.failed, said(words), verb === "doctor" && button(t("doctor"), () => this.start("doctor"), { "data-key": "next-doctor" }));
    this.failed.scrollIntoView({ block: "nearest" });
  }

  /** What was of another robot goes. */
  changed(): void {
    if (this.robot !== store.setup.robot) for (const words of [this.comparison, this.failed]) replace(words);
  }

  private compare(): void {
    this.robot = store.setup.robot;
    replace(this.failed);
    save("compare", this.source);
    const key = [...this.shares.keys()].some((job) => job !== "design") ? "compareWaits" : "comparing";
    replace(this.comparison, said(() => t(key)));
  }

  /** The page of the comparison can be had; it stays so until the next one is asked for. */
  compared(url: string): void {
    this.robot = store.setup.robot;
    const open = h("a", { href: url, target: "_blank", rel: "noopener", "data-key": "open-comparison" }, said(() => t("open")));
    const save = h("a", { href: url, download: COMPARISON, "data-key": "save-comparison" }, said(() => t("saveAs", { name: COMPARISON })));
    replace(this.comparison, said(() => t("compared")), " ", open, " · ", save);
  }

  progress(job: Job | "keep compare", share: number): void {
    if (job === "keep compare") {
      if (share >= 1 && !this.comparison.querySelector("a")) replace(this.comparison); // it failed, as a notice says
      return;
    }
    if (share >= 1) this.shares.delete(job);
    else this.shares.set(job, share);
    if (job === "design") return;
    const bar = this.running.get(job) ?? new JobBar(job);
    bar.to(share);
    if (share >= 1) bar.root.remove();
    else if (!this.running.has(job)) this.bars.append(bar.root); // it stays where it is: so does its Stop
    if (share >= 1) this.running.delete(job);
    else this.running.set(job, bar);
  }

  /** What a page may name next and the lab has a button for: a calibration that is to be written is there already. */
  private next(job: Job): Record<string, [string, () => void]> {
    const again: [string, () => void] = [t("calibrate"), () => this.start("calibrate")];
    return { calibrate: job === "calibrate" ? [t("robotFile"), () => save("robot")] : again, ...(job === "doctor" ? {} : { doctor: [t("doctor"), () => this.start("doctor")] }) };
  }

  found(): void {
    const f = store.found;
    if (!f) return;
    const laden = f.job === "calibrate" && this.load > 0;
    replace(this.result, laden && h("p", { className: "verdict bad" }, h("b", {}, t("calibratedLaden", { mass: digits(this.load * 1000, 3) }))), this.page.show(f));
  }
}

export class KeepPanel extends Panel {
  private files = new Map<string, HTMLElement>();
  private saved = h("p", { className: "saved" });
  private linked = h("div", {});
  private links = h("div", { className: "links", role: "status" }, this.linked, this.saved);

  constructor(private picture: () => Promise<Blob | null>) {
    super();
  }

  /** Without Python there are the traces, the picture and the hand-in to keep. */
  buildExported(): void {
    sayAgain(this.links);
    const csv = button(t("csv"), () => save("csv"), { "data-key": "keep-csv" });
    replace(this.root, h("div", { className: "column wide" },
      h("p", { className: "note" }, t("csvNote")), h("div", { className: "row" }, csv, this.pictureButton()), h("p", { className: "note" }, t("keepLive")),
      h("p", { className: "note" }, t("handInNote")), this.handIn(), this.links));
  }

  build(): void {
    sayAgain(this.links);
    const kinds: [string, [Keep, string][]][] = [
      [t("keepData"), [["csv", t("csv")], ["parquet", t("parquet")]]], [t("keepPages"), [["report", t("report")], ["replay", t("replay")]]],
      [t("keepFiles"), [["controller", t("controllerFile")], ["robot", t("robotFile")]]],
    ];
    const kept = ([what, text]: [Keep, string]) => button(text, () => save(what), { "data-key": `keep-${what}` });
    const group = (title: string, ...buttons: Node[]) => h("div", {}, h("h4", {}, title), h("div", { className: "row" }, ...buttons));
    const link = button(t("link"), () => void this.copy(), { "data-key": "link" });
    replace(this.root, h("div", { className: "column wide" },
      h("p", { className: "note" }, t("keepNote")), ...kinds.map(([title, some]) => group(title, ...some.map(kept))), group(t("keepShow"), this.pictureButton(), link),
      h("p", { className: "note" }, t("handInNote")), this.handIn(), this.links));
  }

  /** The run as set-up and actions, under the student's name. */
  private handIn(): HTMLElement {
    const id = fresh("student");
    const name = h("input", { type: "text", id, maxLength: 40, autocomplete: "name", value: session.getItem("name") ?? "", "data-key": "student" });
    const send = () => {
      if (name.value.trim()) save("handin", name.value.trim());
      else {
        name.focus();
        store.say(() => t("nameMissing"));
      }
    };
    return h("div", { className: "row hand-in" }, h("label", { "for": id }, t("yourName")), name, button(t("handIn"), send, { "data-key": "keep-handin" }));
  }

  private pictureButton(): HTMLElement {
    return button(t("picture"), () => void this.photograph(), { "data-key": "picture" });
  }

  private async photograph(): Promise<void> {
    const blob = await this.picture();
    if (blob) this.made(blob.type.includes("svg") ? "upright.svg" : "upright.png", URL.createObjectURL(blob));
  }

  private async copy(): Promise<void> {
    const [link, { kept }] = [address(), store.last];
    history.replaceState(null, "", link);
    await navigator.clipboard?.writeText(link).catch(() => undefined);
    const words = () => `${t(HERE.includes(location.hostname) ? "linkHere" : "linkCopied")} ${t(kept)}`;
    store.say(words);
    const field = h("input", { readOnly: true, value: link, "aria-label": t("link"), className: "address" });
    replace(this.linked, h("p", { className: "note" }, said(words)), field);
    field.select();
  }

  /** Saved at once; the newest of each name can be had again. */
  made(name: string, url: string): void {
    const link = h("a", { href: url, download: name }, name);
    this.files.set(name, link);
    replace(this.saved, said(() => t("saved")), ...[...this.files.values()].flatMap((one) => [" ", one]));
    link.click();
  }
}
