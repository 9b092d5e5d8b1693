// The panels below: controller, robot, kit, what was found, what is kept. Each builds itself from the store.
import { button, degrees, digits, exchange, follow, fresh, h, keepingFocus, numberField, replace, said, sayAgain, select, slider, table, throttled } from "./dom";
import type { Range, Slider } from "./dom";
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

/** A slider of a number of the set-up, with its name. */
export function number(name: keyof Setup, label: string, options: Range): [keyof Setup, Slider] {
  return [name, slider(label, { ...options, key: name }, (value) => later({ [name]: value }))];
}

/** What stands in a tab: `update` follows what the session says without losing what has the focus. */
export interface Panel {
  root: HTMLElement;
  build(): void;
  update?(): void;
}

export class ControllerPanel implements Panel {
  root = h("div.panel-body");
  private noCertificate = h("p.note.column.full"); // in a page that has no certificate
  private weights = h("div.sliders");
  private numbers = h("div.numbers");
  private gain = h("div");
  private light = h("div.light", { role: "status" });
  private reasons = h("div");
  private sliders: Slider[] = [];
  private shape = "";
  private bar: JobBar | null = null;
  private working = h("div");
  private reported: JobResult | null = null; // in `certified`
  private certified = h("div.column.full.certified", { "aria-live": "polite" });
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
    const certify = button(t("fullCertificate"), () => store.send({ kind: "Start", job: "certify", file: "" }), "certify");
    replace(
      this.root,
      h("div.column", choice, this.weights),
      h("div.column.full", this.gain),
      h("div.column.full", this.numbers),
      exported ? this.noCertificate : h("div.column.full", this.light, certify, this.working, this.reasons),
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

  update(): void {
    follow(this.root, "controller", store.setup.controller);
    const shape = `${store.setup.controller} ${store.unit} ${store.byHand && this.byHand().length}`; // what is known of the loop comes and goes
    if (shape !== this.shape) this.shapeWeights(shape);
    this.sliders.forEach((s, i) => s.set(store.byHand ? (this.byHand()[i] ?? 0) : this.sizes()[i]));
    exchange(this.gain, !store.off && !store.analysed, ...this.gains());
    exchange(this.numbers, !store.off && !store.analysed, ...judged());
    replace(this.light, ...light());
    exchange(this.reasons, !store.off && !store.lit?.heads.en, reasons());
    this.noCertificate.textContent = t(store.byHand || store.off ? "noCertificateByHand" : "noCertificateHere");
    if (this.reported === store.certified) return;
    this.reported = store.certified;
    replace(this.certified, ...(this.reported ? [h("p", t("certified")), this.page.show(this.reported)] : []));
  }

  private byHand(): number[] {
    return store.setup.gains.length ? store.setup.gains : this.present();
  }

  private usual(): number[] {
    return [...(store.catalogue?.largest ?? []), store.catalogue?.command[store.unit] ?? 1];
  }

  private sizes(): number[] {
    return store.setup.largest.length ? store.setup.largest : this.usual();
  }

  private shapeWeights(shape: string): void {
    this.shape = shape;
    const info = store.catalogue?.families.find((f) => f.name === store.setup.controller);
    this.sliders = [];
    if (store.byHand) {
      const present = this.byHand();
      const largest = Math.max(...present.map(Math.abs), 0.1);
      const per = (i: number) => `${store.unit}${i % 2 ? " s" : ""}/rad`;
      const reach = (i: number) => Math.max(4 * Math.abs(present[i] ?? 0), largest / 4); // there is room on both sides
      this.sliders = SYMBOLS.map((symbol, i) => slider(`${symbol} ${named(STATES[i])} →\u00a0u`, { low: -reach(i), high: reach(i), step: reach(i) / 500, show: (v) => `${digits(v, 4)} ${per(i)}`, typed: per(i), key: `gain-${i}` }, (v) => {
        const gains = [...(this.byHand().length ? this.byHand() : [0, 0, 0, 0, 0, 0])];
        gains[i] = v;
        later({ gains });
      }));
      replace(this.weights, ...this.sliders.map((s) => s.root));
    } else if (info?.weights && !exported) {
      this.sliders = this.usual().map((size, i) => this.weight(size, i));
      const reset = button(t("ownWeights"), () => store.change({ largest: [] }), "own-weights", { className: "quiet" });
      replace(this.weights, h("p.note", t("weights")), ...this.sliders.map((s) => s.root), reset);
    } else {
      replace(this.weights, !store.off && h("p.note", t(info?.weights ? "fixedWeights" : "noWeights")));
    }
  }

  private weight(size: number, i: number): Slider {
    const unit = i < 6 ? SHOWN_UNITS[i] : ` ${store.unit}`;
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
    if (!gain.length || store.byHand || store.off) return [];
    return [h("h4", t("gain")), table(SYMBOLS, [gain[0].map((v) => digits(v, 3))], "gains"), h("p.note", t("gainNote", { unit: store.unit }))];
  }
}

/** The light's colour: without a controller, or with an unstable loop, it waits for no certificate. */
export function lamplight(): Light["light"] {
  const light = store.lit?.light ?? "none";
  return store.off || (light === "none" && store.analysed !== null && unstable(store.analysed)) ? "red" : light;
}

/** The light in words, or its colour alone, and of which robot: it is for the robot as its controller was designed. */
export function lightWords(colour = false): string {
  const { setup, lit, trying, jobs } = store;
  if (store.off) return t("unlitOff");
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
  return [h("h4", t("certificate")), h("p.lit", lamp, h("b", lightWords()))];
}

/** Why it has this colour, below the button, which does not move when they arrive; the full certificate says it itself. */
function reasons(): Node | null {
  if (store.off || store.certified) return null;
  if (store.lit?.heads.en) return first({ ...spoken(store.lit.heads), verdict: "" });
  return store.jobs.size ? null : h("p.note", t("lightNote"));
}

export class RobotPanel implements Panel {
  root = h("div.panel-body");
  private sliders: [keyof Setup, Slider][] = [];
  private table = h("div.parameters");
  private fields = new Map<string, ReturnType<typeof numberField>>();
  private shown = "";
  private opened = false;
  private title = h("p.note");

  build(): void {
    this.shown = "";
    this.fields.clear();
    const robots = (store.catalogue?.robots ?? []).map((r): [string, string] => [r.name, r.name]);
    if (!robots.some(([name]) => name === store.setup.robot)) robots.push([store.setup.robot, store.setup.robot]);
    const preset = select(t("preset"), robots, store.setup.robot, (v) => this.choose(v), "robot");
    this.sliders = [
      number("payload", t("payload"), { low: 0, high: this.weight(), step: 0.005, show: (v) => `${digits(v * 1000, 3)} g` }),
      number("payload_height", t("payloadHeight"), { low: 0, high: 0.5, step: 0.005, show: (v) => `${digits(v * 100, 3)} cm` }),
      number("slope", t("slope"), { low: -0.2, high: 0.2, step: 0.005, show: degrees }),
      number("grip", t("grip"), { low: 0.02, high: 10, log: true, show: (v) => digits(v, 2) }),
    ];
    const details = h("details", { open: this.opened, ontoggle: () => (this.opened = details.open) }, h("summary", t("numbers")), h("p.note", t("numbersNote")), this.table);
    replace(
      this.root,
      h("div.column", preset, this.title, upload(t("openRobot"), ".toml", "robot")),
      h("div.column", h("div.sliders", ...this.sliders.map(([, s]) => s.root))),
      h("div.column", this.bodies()),
      h("div.column.full", details),
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
    return h("fieldset", h("legend", t("bodies")), ...boxes);
  }

  update(): void {
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
      return h("div.parameter", h("label", { "for": id }, `${spoken(store.catalogue?.names ?? {})?.[name] ?? name} ${symbol}`), field.root, h("span", (store.catalogue?.units[name] ?? "").replace(/^1$/, "")));
    });
    this.fields.forEach((field, name) => field.set(values[name]));
    replace(this.table, ...rows, button(t("ownNumbers"), () => store.change({ numbers: {}, drive: "" }), "own-numbers", { className: "quiet" }));
  }
}

export class KitPanel implements Panel {
  root = h("div.panel-body");
  private sliders: [keyof Setup, Slider][] = [];
  private anew = h("p.note");

  build(): void {
    const kits = (store.catalogue?.kits ?? []).map((name): [string, string] => [name, name === "ideal" ? t("ideal") : name]);
    const choice = select(t("kit"), kits, store.setup.kit, (v) => store.change({ kit: v, delay: -1, voltage: -1, dead_zone: -1, noise: 1 }), "kit");
    const { unit } = store;
    this.sliders = [
      number("noise", t("noise"), { low: 0, high: 10, step: 0.1, show: (v) => `× ${digits(v, 2)}` }),
      number("delay", t("delay"), { low: 0, high: 0.04, step: 0.002, show: (v) => `${digits(v * 1000, 2)} ms` }),
      number("voltage", t("voltage"), { low: 1, high: 14, step: 0.1, show: (v) => (v > 0 ? `${digits(v, 3)} V` : t("unlimited")) }),
      number("dead_zone", t("deadZone"), { low: 0, high: unit === "V" ? 2 : 0.1, show: (v) => `${digits(v, 2)} ${unit}` }),
    ];
    const own = button(t("ownKit"), () => store.change({ noise: 1, delay: -1, voltage: -1, dead_zone: -1 }), "own-kit", { className: "quiet" });
    replace(this.root, h("div.column", choice, own), h("div.column.wide", h("div.sliders", ...this.sliders.map(([, s]) => s.root)), this.anew));
    this.update();
  }

  update(): void {
    const kit = store.changed?.kit ?? {};
    for (const [name, s] of this.sliders) s.set(name === "noise" ? store.setup.noise : kit[name]);
    this.anew.textContent = store.byHand || store.off ? "" : t("redesigned");
    follow(this.root, "kit", store.setup.kit);
  }
}

/** Have a file made, which is downloaded then. */
function save(what: Keep, name = ""): void {
  store.send({ kind: "Save", what, name, language: language() });
}

function kept(what: Keep, text: string): HTMLElement {
  return button(text, () => save(what), `keep-${what}`);
}

/** A file to be sent to the session's folder. */
function upload(label: string, accept: string, what: "log" | "robot"): HTMLElement {
  const id = fresh("file");
  const input = h("input", { type: "file", id, accept, className: "file", "data-key": `open-${what}`, onchange: () => {
    const file = input.files?.[0];
    input.value = "";
    if (file) void send(file, what);
  } });
  return h("div.upload", input, h("label", { "for": id, className: "button" }, label));
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

export class IdentifyPanel implements Panel {
  root = h("div.panel-body");
  private bars = h("div.bars");
  private result = h("div.result", { role: "region", "aria-live": "polite" });
  private running = new Map<Job, JobBar>();
  private source = "";
  private comparison = h("p.comparison", { role: "status" });
  private robot = ""; // of the comparison, and of what failed
  private failed = h("p.failed", { role: "alert" });
  private load = 0; // [kg] that the run carried whose calibration was begun
  private page = new ResultPage((job) => this.next(job));

  constructor() {
    opened = () => keepingFocus(() => this.build());
  }

  build(): void {
    const choices: [string, string][] = [["", t("thisRun")]];
    if (latestLog) choices.push([latestLog, latestLog.replace(/^in-/, "")]);
    if (latestLog) this.source = latestLog;
    const source = select(t("source"), choices, this.source, (v) => (this.source = v), "source");
    const row = h(
      "div.row",
      button(t("doctor"), () => this.start("doctor"), "doctor", { title: t("doctorTip") }),
      button(t("calibrate"), () => this.start("calibrate"), "calibrate", { title: t("calibrateTip") }),
      button(t("compare"), () => this.compare(), "compare", { title: t("compareTip") }),
    );
    const logs = ".csv,.txt,.log,.tsv,.dat,.json,.mat,.parquet,.mcap";
    this.changed();
    for (const words of [this.comparison, this.failed]) sayAgain(words);
    replace(
      this.root,
      h("div.column", source, upload(t("openLog"), logs, "log"), row, this.failed, this.comparison, h("p.note", t("calibrateNote")), this.bars),
      h("div.column.wide", this.result),
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
    replace(this.failed, said(words), verb === "doctor" && button(t("doctor"), () => this.start("doctor"), "next-doctor"));
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
    const key = store.jobs.size ? "compareWaits" : "comparing";
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
    if (job === "design") return;
    const bar = this.running.get(job) ?? new JobBar(job);
    bar.to(share);
    if (share >= 1) {
      bar.root.remove();
      this.running.delete(job);
    } else if (!this.running.has(job)) {
      this.bars.append(bar.root); // it stays where it is: so does its Stop
      this.running.set(job, bar);
    }
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
    replace(this.result, laden && h("p.verdict.bad", h("b", t("calibratedLaden", { mass: digits(this.load * 1000, 3) }))), this.page.show(f));
  }
}

export class KeepPanel implements Panel {
  root = h("div.panel-body");
  private files = new Map<string, HTMLElement>();
  private saved = h("p.saved");
  private linked = h("div");
  private links = h("div.links", { role: "status" }, this.linked, this.saved);

  constructor(private picture: () => Promise<Blob | null>) {}

  build(): void {
    sayAgain(this.links);
    const there = exported ? this.withoutPython() : this.withPython();
    replace(this.root, h("div.column.wide", ...there, h("p.note", t("handInNote")), this.handIn(), this.links));
  }

  private withoutPython(): Node[] {
    return [h("p.note", t("csvNote")), h("div.row", kept("csv", t("csv")), this.pictureButton()), h("p.note", t("keepLive"))];
  }

  private withPython(): Node[] {
    const group = (title: string, ...buttons: Node[]) => h("div", h("h4", title), h("div.row", ...buttons));
    return [
      h("p.note", t("keepNote")),
      group(t("keepData"), kept("csv", t("csv")), kept("parquet", t("parquet"))),
      group(t("keepPages"), kept("report", t("report")), kept("replay", t("replay"))),
      group(t("keepFiles"), kept("controller", t("controllerFile")), kept("robot", t("robotFile"))),
      group(t("keepShow"), this.pictureButton(), button(t("link"), () => void this.copy(), "link")),
    ];
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
    return h("div.row.hand-in", h("label", { "for": id }, t("yourName")), name, button(t("handIn"), send, "keep-handin"));
  }

  private pictureButton(): HTMLElement {
    return button(t("picture"), () => void this.photograph(), "picture");
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
    replace(this.linked, h("p.note", said(words)), field);
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
