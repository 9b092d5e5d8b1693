// The page: puts its parts together, follows the session, and takes keys, mouse and gamepad.
import { Charts, small } from "./charts";
import { LocalSession, exported } from "./exported";
import { ExportedRobotPanel, PythonPanel, linkButton } from "./exported_panels";
import { button, degrees, digits, h, keepingFocus, keptBy, replace, said, sayAgain, select, slider, throttled } from "./dom";
import type { Slider } from "./dom";
import { isLink, tokenIn } from "./link";
import type { Notice, Recovered, ServerMessage } from "./messages";
import { Line } from "./net";
import type { State } from "./net";
import { address, open as openLink } from "./opening";
import { COMPARISON, ControllerPanel, IdentifyPanel, KeepPanel, KitPanel, lamplight, latestLog, lightWords, RobotPanel } from "./panels";
import type { Panel } from "./panels";
import { QUIET } from "./marks";
import { Replay } from "./replay";
import { Room } from "./scene";
import { Flat } from "./flat";
import type { Hand, Stage } from "./stage";
import { remembered, session } from "./remember";
import { See } from "./see";
import { Steering } from "./steering";
import { LEAN, store } from "./store";
import { ClassPanel } from "./board";
import "./style.css";
import { LANGUAGES, NAMES, choose, fixed, language, named, sentence, spoken, t, texts, told } from "./texts";
import { Tour } from "./tour";
import { designing } from "./verdict";

const TABS = ["Tour", "Controller", "Robot", "Kit", "See", "Identify", "Keep", "Class", "Python"] as const;
type Tab = (typeof TABS)[number];
const EXPORTED: readonly Tab[] = ["Tour", "Controller", "Robot", "See", "Keep", "Python"]; // the tabs of a page without Python

const PINNED = 0.19; // of the window's height that the room takes while it is pinned, as in the style sheet
const SIZES = [0.01, 0.5]; // [N s] of a knock by its button
const SHOWN = 10; // [s] of the clock that the curves show: in slow motion less of the robot's time, and more of what is quick
const SAME = 1e-6; // a record larger by less is the same one: sums of forces
const LEVELS = { good: "info", info: "info", unknown: "info", warn: "warn", bad: "warn" } as const; // of a verdict, and of what the corner says: red is for what went wrong
const SILENT = 1500; // [ms] without the lab before it is said what helps
const SEEN = 400; // [ms] from the first picture to the work on another one

/** Whether the browser draws in three dimensions, and whether by a processor that is made for it. */
function drawing(): { able: boolean; quick: boolean } {
  const context = document.createElement("canvas").getContext("webgl2");
  const named = context?.getExtension("WEBGL_debug_renderer_info");
  const name = context?.getParameter(named?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER) as string;
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return { able: context !== null, quick: !/swiftshader|llvmpipe|software|basic render/i.test(name) };
}

class Page {
  private deeper: (() => Stage) | null = null; // the room that takes the side view's place
  private room: Stage = this.furnish();
  private charts = new Charts(() => SHOWN * this.speed);
  private see = new See();
  private controller = new ControllerPanel();
  private local: LocalSession | null = null;
  private robot = exported ? new ExportedRobotPanel(() => this.local) : new RobotPanel();
  private python = new PythonPanel();
  private kit = new KitPanel();
  private identify = new IdentifyPanel();
  private keep = new KeepPanel(() => this.picture());
  private tour = new Tour({
    run: (speed) => (this.greeted(), this.run(speed)),
    knock: (size) => (this.sizeTo(size), this.strike()),
    sizer: () => this.sizer("act-size").root,
    tilt: () => this.tilt(),
    curves: () => this.charts.more(),
    identify: () => this.bring("Identify"),
  });
  private classes = new ClassPanel();
  private newcomer = !remembered.getItem("toured") && !isLink(location.hash);
  private tab: Tab = this.newcomer ? "Tour" : "Controller";
  private knock = 0.05; // [N s]
  private sizers: Slider[] = [];
  private sized = h("span.of"); // the same on the button
  private speed = 1;
  private scrub = h("input", { type: "range", min: "-60", max: "0", step: "0.02", value: "0", className: "scrub", "data-key": "scrub" });
  private pauseButton = h("button", { type: "button", "data-key": "pause" });
  private status = h("span.status", { role: "status" });
  private light = h("button", { type: "button", className: "headlight", "data-key": "headlight", onclick: () => this.certificate() });
  private force = h("div.force", { "aria-hidden": "true" });
  private fell = h("div.fell", { role: "status" });
  private toasts = h("div.toasts", { role: "log", "aria-live": "polite" });
  private spoken = h("p.hidden", { "aria-live": "off" });
  private tabs = h("div.tabs", { role: "tablist" });
  private panel = h("div.panel", { role: "tabpanel", tabIndex: -1, id: "panel" });
  private clock = h("span.clock");
  private state: State = "connecting";
  private drawn = 0;
  private down: boolean | null = null; // whether the robot lies, as the page says; not known before it is seen
  private lost: (() => string) | null = null; // what made it fall
  private best: Record<string, number> = {}; // [N s] the largest push that was recovered from, of each robot under each controller
  private most = h("span.most");
  private telling = 0;
  private waits = 0;
  private busy = false; // whether a controller was being designed
  private prepared = false; // whether that controller drives now, and nobody has pushed the robot since
  private begun = false; // whether there is a session
  private timing = false; // whether it has yet to hear how fast the time of this page goes
  drawnFirst = false; // whether a robot has been seen
  private seen = 0; // [ms] when
  private plotted = 0;
  private said = 0;
  private shape = "";
  private steering = new Steering();
  private pinned: IntersectionObserver | null = null;

  constructor(private app: HTMLElement) {
    this.theme(remembered.getItem("theme") ?? "");
    const asked = new URLSearchParams(location.hash.slice(1)).get("lang") ?? "";
    choose(Object.hasOwn(LANGUAGES, asked) ? asked : remembered.getItem("language") ?? (navigator.language.startsWith("es") ? "es" : "en"));
    store.listen((message) => this.hear(message));
    store.say = (words, level = "info") => this.toast(words, level);
    store.corrected = () => this.toasts.querySelectorAll(".toast.error").forEach((toast) => toast.remove());
    this.scrub.addEventListener("input", () => store.send({ kind: "Scrub", back: Number(this.scrub.max) - Number(this.scrub.value) }));
    this.equip();
    this.measure("--toasts", this.toasts);
    this.measure("--fell", this.fell, 8);
    window.addEventListener("keydown", (event) => this.key(event));
    window.addEventListener("hashchange", () => store.recorded || this.link()); // pasted behind the address of an open page
    this.begin();
  }

  private begin(): void {
    const recording = Replay.inPage();
    const token = tokenIn(location.hash) || (session.getItem("token") ?? "");
    if (token) session.setItem("token", token);
    if (location.hash.includes("token=")) history.replaceState(null, "", location.pathname);
    this.build();
    if (exported) {
      document.body.classList.add("exported");
      this.local = new LocalSession(exported);
      this.link();
      this.says("connected");
    } else if (recording) {
      this.says("replaying");
      new Replay(recording);
      document.body.classList.add("replay");
    } else if (token && !session.getItem("name") && token.length < 12) {
      this.join(token);
    } else {
      this.connect(token, session.getItem("name") ?? "");
    }
    requestAnimationFrame((now) => this.frame(now));
  }

  private connect(token: string, name: string): void {
    new Line({ token, name }, (state, reason) => this.says(state, reason));
  }

  /** In a class everybody has a name. */
  private join(token: string): void {
    const name = h("input", { type: "text", id: "name", maxLength: 40, required: true, autocomplete: "name" });
    const dialog = h("dialog.join", { "aria-label": t("joinTitle") },
      h("form", { method: "dialog", onsubmit: (event: Event) => {
        event.preventDefault();
        if (!name.value.trim()) return;
        session.setItem("name", name.value.trim());
        dialog.remove();
        this.connect(token, name.value.trim());
      } }, h("h2", t("joinTitle")), h("label", { "for": "name" }, t("yourName")), name, h("button.main", t("enter"))));
    this.app.append(dialog);
    dialog.showModal();
  }

  private build(): void {
    const header = h("header",
      h("a.skip", { href: "#panel", onclick: () => this.panel.focus() }, t("skip")),
      h("h1", h("span.mark", { "aria-hidden": "true" }), t("title")),
      h("p.what", t("what")), this.light, h("span.grow"), this.clock, this.status,
      exported ? linkButton((words) => this.toast(words, "info")) : null,
      select("", NAMES, language(), (key) => this.speak(key), "language"),
      button("◐", () => this.theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"), "theme", { "aria-label": t("theme"), title: t("theme") }),
      button("?", () => this.help(), "help", { "aria-label": t("help"), title: t("help") }));
    header.querySelector("select")?.setAttribute("aria-label", "Language / Idioma");
    const scene = h("section.scene", { "aria-label": t("scene") }, this.room.element, this.force, this.fell, h("p.hint", h("span", t("hint")), this.invitation()), this.charts.slot, this.pushes(), this.transport());
    this.pin(scene);
    replace(this.app, header, h("main", scene, this.panels(), this.charts.root), this.toasts, this.spoken);
    this.lamp();
    if (!store.snapshot && !store.recorded) this.tell(said(() => t("starting")));
    if (store.changed) this.rebuild();
  }

  /** For a phone: where the tabs come up to where the room and the pitch would be pinned, they are. */
  private pin(scene: HTMLElement): void {
    const line = PINNED * innerHeight + 8 * parseFloat(getComputedStyle(document.documentElement).fontSize);
    const above = { rootMargin: `1000000px 0px ${line - innerHeight}px` }; // so far up that no jump passes it by
    const pinned = new IntersectionObserver((seen) => scene.classList.toggle("pinned", seen.at(-1)?.isIntersecting ?? false), above);
    this.pinned?.disconnect();
    this.pinned = pinned;
    pinned.observe(this.tabs);
  }

  /** The room, or its side view in a browser without WebGL; where a page without Python would have to draw the room
   * without a GPU, which takes seconds to begin, the side view comes first. */
  private furnish(): Stage {
    const push = throttled(33, (hand: Hand) => store.push({ kind: "Drag", force: hand.force, height: hand.height }));
    const room = () => new Room(h("canvas.room", { tabIndex: 0, role: "img" }), push);
    const { able, quick } = drawing();
    if (able && (quick || !exported)) return room();
    this.deeper = able ? room : null;
    return new Flat(push);
  }

  /** How high something is that others make way for, with a gap [px]; 0 while it is empty. */
  private measure(name: string, element: HTMLElement, gap = 0): void {
    const high = () => document.documentElement.style.setProperty(name, `${element.childElementCount && element.offsetHeight + gap}px`);
    new ResizeObserver(high).observe(element);
  }

  private equip(): void {
    this.room.element.setAttribute("aria-label", t("scene"));
    this.room.element.addEventListener("keydown", (event) => this.look(event as KeyboardEvent));
  }

  /** The room takes the place of the side view, which somebody has seen and nobody holds now. */
  private deepen(): void {
    const [changed, before] = [store.changed, this.room.element];
    if (!this.deeper || !changed || store.snapshot?.f[0]) return;
    this.room = this.deeper();
    this.deeper = null;
    this.equip();
    this.room.furnish(changed.look, changed.bodies);
    before.replaceWith(this.room.element);
    if (store.snapshot) this.room.move(store.snapshot);
    this.room.draw?.(0); // at once, so that no empty room is seen
  }

  /** Do what the address says, as fast as the clock: in slow motion its push would come late. */
  private link(): void {
    if (isLink(location.hash) && this.speed !== 1) this.run(1);
    openLink();
    const [what, size] = store.last.push ?? ["", 0];
    if (what === "impulse" && size >= SIZES[0] && size <= SIZES[1]) this.sizeTo(size); // as its push
  }

  /** From now on so many times as fast as the clock. */
  private run(speed: number, paused = false): void {
    this.speed = speed;
    const box = this.app.querySelector<HTMLSelectElement>("[data-key=speed]");
    if (box) box.value = String(speed);
    store.send({ kind: "Play", paused, speed });
  }

  private transport(): HTMLElement {
    this.pauseButton.onclick = () => this.pause();
    const speeds: [string, string][] = [["0.05", "× 1/20"], ["0.1", "× 1/10"], ["0.25", "× 1/4"], ["0.5", "× 1/2"], ["1", "× 1"]];
    const speed = select(t("speed"), speeds, String(this.speed), (v) => this.run(Number(v), store.snapshot?.paused), "speed");
    speed.querySelector("select")?.setAttribute("aria-label", t("speed"));
    const step = button(t("step"), () => store.send({ kind: "Step", periods: 1 }), "step", { title: t("stepTip") });
    const line = t(store.recorded ? "timeLine" : "back");
    this.scrub.setAttribute("aria-label", line);
    if (store.recorded) [this.scrub.min, this.scrub.max] = ["0", String(store.recorded)];
    const stand = button(t("standUp"), () => this.stand(), "stand");
    return h("div.transport", this.pauseButton, step, stand, speed, h("label.scrubbing", h("span", line), this.scrub));
  }

  private pushes(): HTMLElement {
    const strike = (what: "front" | "back" | "pull_left" | "pull_right", size: number) => () => store.push({ kind: "Strike", what, size });
    const weight = () => store.changed?.look.weight ?? 6;
    const size = this.sizer("knock");
    const knock = button(t("impulse"), () => this.strike(), "impulse", { title: t("impulseTip"), className: "main" });
    knock.append(this.sized);
    size.root.insertBefore(this.most, size.root.lastChild);
    this.champion();
    return h("div.pushes", { role: "group", "aria-label": t("pushes") },
      knock, size.root,
      button(t("front"), strike("front", 0.1), "front", { title: t("frontTip") }),
      button(t("backPush"), strike("back", -0.12), "back", { title: t("backTip") }),
      button(t("pullLeft"), () => strike("pull_left", 0.25 * weight())(), "pull_left", { title: t("pullTip") }),
      button(t("pullRight"), () => strike("pull_right", 0.25 * weight())(), "pull_right", { title: t("pullTip") }),
      button(t("tilt"), () => this.tilt(), "tilt", { title: t("tiltTip") }));
  }

  /** A slider of the knock's size; every other one goes with it. */
  private sizer(key: string): Slider {
    const [low, high] = SIZES;
    const made = slider(t("size"), { low, high, step: 0.01, show: (v) => `${fixed(v, 2)} N s`, key }, (v) => this.sizeTo(v));
    made.root.title = t("sizeTip");
    this.sizers = [...this.sizers.filter(({ root }) => root.isConnected), made];
    this.sizeTo(this.knock);
    return made;
  }

  private sizeTo(size: number): void {
    this.knock = size;
    for (const one of this.sizers) one.set(size);
    this.sized.textContent = ` ${fixed(size, 2)} N s`;
  }

  private strike(): void {
    store.push({ kind: "Strike", what: "impulse", size: this.knock });
  }

  private tilt(): void {
    store.send({ kind: "StandUp", pitch: 0.1 });
  }

  private panels(): HTMLElement {
    const there = exported ? EXPORTED : TABS.filter((tab) => tab !== "Python" && (tab !== "Class" || store.role !== "alone"));
    this.tabs.setAttribute("aria-label", t("tabs"));
    replace(this.tabs, ...there.map((tab) => button(t(`tab${tab}`), () => this.bring(tab), `tab-${tab}`, { role: "tab", id: `tab-${tab}`, "aria-selected": String(tab === this.tab), "aria-controls": "panel", tabIndex: tab === this.tab ? 0 : -1, onkeydown: (event: KeyboardEvent) => this.along(event, there, tab) })));
    return h("section.below", this.tabs, this.panel);
  }

  private along(event: KeyboardEvent, there: readonly Tab[], tab: Tab): void {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    const next = there[(there.indexOf(tab) + by + there.length) % there.length];
    this.open(next);
    document.getElementById(`tab-${next}`)?.focus();
  }

  /** For who is here for the first time, where the tour is below the robot. */
  private invitation(): HTMLElement | null {
    return this.newcomer ? button(t("newHere"), () => this.bring("Tour"), "invitation") : null;
  }

  /** Open a tab; on a phone, where it is below the robot, its first lines come into sight. */
  private bring(tab: Tab): void {
    this.open(tab);
    if (small.matches) this.tabs.scrollIntoView();
    document.getElementById(`tab-${tab}`)?.scrollIntoView({ block: "nearest", inline: "center" }); // in its row
  }

  /** Where the light's colour comes from: its heading comes into sight. */
  private certificate(): void {
    this.open("Controller");
    this.panel.querySelector(".light h4")?.scrollIntoView({ block: small.matches ? "start" : "center" });
  }

  /** Whoever has found the tabs, or is on the tour, needs no invitation. */
  private greeted(): void {
    this.newcomer = false;
    remembered.setItem("toured", "yes");
    this.app.querySelector("[data-key=invitation]")?.remove();
  }

  private open(tab: Tab): void {
    this.tab = tab;
    this.greeted();
    for (const one of this.tabs.querySelectorAll<HTMLElement>("[role=tab]")) {
      const chosen = one.id === `tab-${tab}`;
      one.setAttribute("aria-selected", String(chosen));
      one.tabIndex = chosen ? 0 : -1;
    }
    this.panel.setAttribute("aria-labelledby", `tab-${tab}`);
    this.fill();
  }

  /** Build the panel of the open tab. */
  private fill(): void {
    if (!store.catalogue || !store.changed) return;
    const panel = this.opened();
    keepingFocus(() => {
      panel.build();
      replace(this.panel, panel.root);
    });
  }

  private opened(): Panel {
    return { Controller: this.controller, Robot: this.robot, Kit: this.kit, See: this.see, Identify: this.identify, Keep: this.keep, Tour: this.tour, Class: this.classes, Python: this.python }[this.tab];
  }

  private rebuild(): void {
    this.shape = "";
    this.follow();
    this.fill();
    this.lamp();
  }

  /** The robots and charts that the session has now. */
  private follow(): void {
    const changed = store.changed;
    if (!changed) return;
    const shape = JSON.stringify([changed.bodies, changed.look]);
    if (shape === this.shape) return;
    this.shape = shape;
    this.room.furnish(changed.look, changed.bodies);
    this.charts.build();
  }

  private hear(message: ServerMessage): void {
    switch (message.kind) {
      case "Welcome": this.timing = !exported && !store.recorded; keepingFocus(() => this.build()); break;
      case "Catalogue": this.fill(); break;
      case "Changed": {
        const first = !this.panel.firstChild;
        this.follow();
        if (!this.begun && !exported) this.link();
        this.begun = true;
        if (first) this.fill();
        else this.opened().update?.();
        this.lamp();
        this.champion();
        this.identify.changed();
        const ready = this.busy && !message.busy;
        this.prepared = ready && this.tour.designed();
        if (message.busy !== this.busy) this.rest();
        break;
      }
      case "Analysed": case "Light": this.lamp(); this.opened().update?.(); break;
      case "Equations": if (this.tab === "See") this.see.update(); break;
      case "Snapshot": this.transported(); break;
      case "Progress": if (message.job === "light") { this.lamp(); this.opened().update?.(); break; } this.identify.progress(message.job, message.fraction); if (message.job === "certify") this.controller.certifying(message.fraction); break;
      case "JobResult": this.identify.found(); if (message === store.certified) this.controller.certify(); if (message !== store.certified || this.tab !== "Controller") this.toast(() => `${named(message.job)} – ${spoken(message.heads).verdict}`, LEVELS[message.heads.en.level]); if (latestLog && this.tab === "Identify") keepingFocus(() => this.identify.build()); break;
      case "Made": if (message.name === COMPARISON) { this.compared(store.files + message.url); break; } this.keep.made(message.name, message.url.startsWith("blob:") ? message.url : store.files + message.url); this.toast(() => t("made", { name: message.name }), "info"); break;
      case "Notice": message.key === "lies" ? this.lie(() => t("lies")) : message.job ? this.failed(message) : this.toast(() => (message.key ? named(message.key) : told(message.parts)), message.level); break;
      case "Recovered": this.recovered(message); break;
      case "Board": if (this.tab === "Class") this.classes.update(); break;
    }
  }

  private lamp(): void {
    const light = lamplight();
    this.app.classList.toggle("loose", store.falls || (store.changed?.busy ?? false)); // nothing balances it
    if (store.recorded && (store.lit?.light ?? "none") === "none") return replace(this.light);
    this.light.title = `${sentence(lightWords())}. ${t("lightNote")}`;
    replace(this.light, h("span", { className: `lamp ${light}`, "aria-hidden": "true" }), h("span.word", { "aria-hidden": "true" }, light === "none" ? "…" : t(light)), h("span", `${t("certificate")}:`), h("span", lightWords(true)));
  }

  /** Above the robot: what became of a push, for a while; that it fell, until it stands. */
  private recovered({ impulse, fell, single }: Recovered): void {
    const key = this.driven();
    const before = this.best[key] ?? 0;
    const best = Math.max(before, single && !fell ? impulse : 0);
    this.prepared = false;
    if (best) this.best[key] = best;
    this.champion();
    const values = () => ({ impulse: digits(impulse), best: digits(best) });
    if (fell) this.lost = () => t(single ? "lostPush" : "lostPushes", values());
    if (this.down) return this.lie();
    if (fell) return;
    this.tell(said(() => t(!single ? "recoveredSeveral" : best < before * (1 + SAME) ? "recovered" : "recoveredMost", values())));
    this.telling = window.setTimeout(() => this.rest(), 6000);
  }

  /** A comparison is ready: its line in Identify stays, and whoever looks elsewhere is sent there. */
  private compared(url: string): void {
    this.identify.compared(url);
    if (this.tab !== "Identify") this.toast(() => t("comparedThere"), "info");
  }

  /** A job has stopped: said in Identify where it was begun there, and to whoever looks elsewhere. */
  private failed({ job, parts, level }: Notice): void {
    const button = job.startsWith("keep compar") ? "compare" : job;
    const known = ["doctor", "calibrate", "compare"].includes(button);
    const why = () => (known || job === "certify" ? t("jobStopped", { job: named(button), why: told(parts) }) : told(parts));
    const words = () => (parts.en ? why() : t("wasStopped", { job: named(button) }));
    if (known && parts.en) this.identify.fail(words, parts.en.verb);
    if (!known || !parts.en || this.tab !== "Identify") this.toast(words, level);
  }

  private driven(): string {
    return `${store.setup.robot} ${store.setup.controller}`;
  }

  /** The largest so far, which stays beside the size of a knock. */
  private champion(): void {
    const best = this.best[this.driven()];
    this.most.textContent = best ? t("best", { best: digits(best) }) : "";
    this.most.title = t("bestTip");
  }

  private tell(...words: (Node | false)[]): void {
    window.clearTimeout(this.telling);
    replace(this.fell, ...words);
  }

  /** Nothing became of a push: what holds it up meanwhile is not yet the controller that was chosen, or nothing is said. */
  private rest(): void {
    this.busy = store.changed?.busy ?? false;
    if (this.down) return;
    this.tell((this.busy || this.prepared) && said(() => (this.busy ? designing() : t("designed"))));
  }

  /** It lies: in whose words, and with the button that helps. */
  private lie(words = this.lost ?? (() => t("fallen"))): void {
    const stand = h("button", { type: "button", className: "main", onclick: () => this.stand() }, said(() => t("standUp")));
    this.tell(said(words), !store.recorded && stand);
  }

  private transported(): void {
    const s = store.snapshot;
    if (!s) return;
    if (this.timing) store.send({ kind: "Play", paused: s.paused, speed: this.speed }); // a session may go on from before, in slow motion
    this.timing = false;
    const text = s.paused ? t("play") : t("pause");
    if (this.pauseButton.textContent !== text) this.pauseButton.textContent = text;
    if (store.recorded) this.timed(s.t);
    else if (document.activeElement !== this.scrub) {
      this.scrub.min = String(-Math.min(Math.max(Math.ceil(s.t + s.back - (store.traces.t[0] ?? s.t)), 1), 60)); // no further than there is something
      this.scrub.value = String(-s.back);
    }
    this.clock.textContent = `${fixed(s.t, 1)} ${store.recorded ? `/ ${fixed(store.recorded, 1)} ` : ""}s`;
    const fell = Boolean(s.x[0][8]);
    if (fell !== this.down) {
      if (!fell) this.lost = null;
      this.down = fell;
      if (fell) this.lie();
      else this.rest();
      this.app.querySelector("[data-key=impulse]")?.classList.toggle("main", !fell); // then one button leads
    }
    const force = s.f[0];
    const slope = s.f[2] ? `${t("slope")}: ${degrees(s.f[2])}` : "";
    if (store.traces.marks.some(({ what }) => !QUIET.includes(what))) this.app.classList.add("pushed"); // who has pushed it knows how
    this.force.textContent = Math.abs(force) > 0.005 ? t("newtons", { force: fixed(force, 2) }) : slope;
    this.force.classList.toggle("slope", !(Math.abs(force) > 0.005));
  }

  /** A recording has come so far, which its time line shows unless it is held. */
  private timed(t: number): void {
    if (!this.scrub.matches(":active")) this.scrub.value = String(t);
    this.scrub.setAttribute("aria-valuetext", `${fixed(t, 1)} s`);
  }

  /** Go so far in time [s]: back from now, or along a recording. */
  private seek(by: number): void {
    const [s, whole] = [store.snapshot, store.recorded || 60];
    const back = (store.recorded ? store.recorded - (s?.t ?? 0) : (s?.back ?? 0)) - by;
    store.send({ kind: "Scrub", back: Math.max(0, Math.min(whole, back)) });
  }

  private stand(): void {
    store.send({ kind: "StandUp", pitch: store.falls ? LEAN : 0 });
    store.send({ kind: "Play", paused: false, speed: this.speed });
  }

  private pause(): void {
    store.send({ kind: "Play", paused: !store.snapshot?.paused, speed: this.speed });
  }

  private says(state: State, reason = () => ""): void {
    if (state === "lost" && this.state !== "lost") this.waits = window.setTimeout(() => this.tell(said(() => t("gone"))), SILENT);
    if (state === "connected" && this.state === "lost") this.back();
    this.state = state;
    this.status.className = `status ${state}`;
    this.status.textContent = t(state);
    if (state !== "refused") return;
    session.removeItem("name");
    replace(this.app, h("main.refused", { role: "alert" }, h("h1", t("refused")), h("p", reason()), button("↻", () => location.reload(), "reload")));
  }

  /** The lab answers again. */
  private back(): void {
    window.clearTimeout(this.waits);
    if (this.down) this.lie();
    else this.rest();
  }

  private toast(words: () => string, level: "info" | "warn" | "error"): void {
    if (this.toasts.lastElementChild?.firstElementChild?.textContent === words()) return;
    const close = h("button", { type: "button", onclick: () => toast.remove() }, h("span", { "aria-hidden": "true" }, "×"), h("span.hidden", said(() => t("close"))));
    const toast = h("div", { className: `toast ${level}` }, said(words), close);
    this.toasts.querySelectorAll(level === "error" ? ".toast.error" : ".toast:not(.error)").forEach((one) => one.remove()); // at most one, and an error
    this.toasts.append(toast);
    window.setTimeout(() => toast.remove(), level === "error" ? 15000 : 6000);
  }

  private speak(key: string): void {
    choose(key);
    remembered.setItem("language", key);
    this.build();
    this.says(this.state);
    sayAgain(this.app);
    this.describe();
    this.app.querySelector<HTMLElement>("[data-key=language]")?.focus();
  }

  private theme(wanted: string): void {
    const dark = wanted ? wanted === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
    document.documentElement.dataset.theme = dark ? "dark" : "light";
    if (wanted) remembered.setItem("theme", wanted);
    this.room.paint?.();
    if (store.changed) this.charts.build();
    if (this.panel.firstChild) this.fill();
  }

  private help(): void {
    const pushes = (["impulse", "size", "front", "back", "pull", "tilt", "step"] as const).map((key) => [t(key === "pull" ? "pullBoth" : key === "back" ? "backPush" : key), t(`${key}Tip`)]);
    const [robot, floor, finger, ...keys] = texts().keys; // a telephone has neither mouse nor keys
    const hands = matchMedia("(hover: none)").matches ? [finger, ...pushes] : [...pushes, robot, floor, finger, ...keys];
    const rows = hands.map(([key, what]) => h("tr", h("th", { scope: "row" }, key), h("td", what)));
    const title = h("h2", { tabIndex: -1 }, t("help"));
    const dialog = h("dialog.help", { "aria-label": t("help"), onclose: () => dialog.remove() },
      title, h("table", h("tbody", ...rows)), h("div.foot", button(t("close"), () => dialog.close(), "close", { className: "main" })));
    this.app.append(dialog);
    dialog.showModal();
    title.focus(); // its first line is seen, not its button at the end
    dialog.scrollTop = 0;
  }

  /** Keys of the whole page; what has the focus keeps its own. */
  private key(event: KeyboardEvent): void {
    if (keptBy(event, "input, select, textarea, dialog") || (event.key === " " && keptBy(event, "button, summary"))) return;
    if (event.key === "?") this.help();
    else if (event.key === " ") this.pause();
    else if (event.key === ".") store.send({ kind: "Step", periods: 1 });
    else if (event.key === "," || event.key === "/") this.seek(event.key === "," ? -0.25 : 0.25);
    else if (event.key === "s") this.stand();
    else if (event.key === "n" || event.key === "p") this.toured(event.key === "n" ? 1 : -1);
    else if (event.key === "k") this.strike();
    else if (/^[1-8]$/.test(event.key) && document.getElementById(`tab-${this.tabAt(event.key)}`)) this.open(this.tabAt(event.key));
    else return;
    event.preventDefault();
  }

  private tabAt(key: string): Tab {
    return (exported ? EXPORTED : TABS)[Number(key) - 1];
  }

  /** Open the tour, or go on or back in it. */
  private toured(by: number): void {
    const open = this.tab === "Tour";
    if (!open) this.open("Tour");
    this.tour.move(open ? by : 0);
  }

  /** Keys of the room alone. */
  private look(event: KeyboardEvent): void {
    const turns: Record<string, [number, number]> = { "[": [-0.15, 0], "]": [0.15, 0], "{": [0, -0.1], "}": [0, 0.1] };
    if (event.key in turns) this.room.turn?.(...turns[event.key]);
    if (event.key === "+") this.room.zoom?.(0.9);
    if (event.key === "-") this.room.zoom?.(1.1);
  }

  private frame(now: number): void {
    if (store.snapshot) this.room.move(store.snapshot);
    this.room.draw?.(now - this.drawn);
    if (this.drawnFirst && now > this.seen + SEEN) this.deepen();
    else if (store.snapshot && !this.drawnFirst) [this.drawnFirst, this.seen] = [true, now];
    this.drawn = now;
    if (now - this.plotted > 45) {
      this.charts.draw();
      if (this.tab === "See") this.see.draw();
      this.plotted = now;
    }
    if (now - this.said > 2000) {
      this.describe();
      this.said = now;
    }
    this.steering.tick(now);
    requestAnimationFrame((next) => this.frame(next));
  }

  /** The scene in words, for whoever does not see it. */
  private describe(): void {
    const [s, changed] = [store.snapshot, store.changed];
    if (!s || !changed) return;
    const body = named(changed.bodies[0]);
    const way = fixed(changed.look.wheel_radius * s.x[0][2] * 100, 0);
    const words = s.x[0][8] ? t("fellNow", { body }) : t("sceneNow", { body, pitch: fixed((s.x[0][0] * 180) / Math.PI, 1), way });
    this.spoken.textContent = words;
    this.room.element.setAttribute("aria-label", `${t("scene")} ${words}`);
  }

  picture(): Promise<Blob | null> {
    return this.room.picture([store.setup.robot, named(store.setup.controller), `${fixed(store.snapshot?.t ?? 0, 1)} s`, "upright lab"].join("  ·  "));
  }

  address(): string {
    return address();
  }

  /** For tests and curious people: where the robot is on the canvas. */
  grasp(): { x: number; y: number } {
    return this.room.grasp();
  }
}

const page = new Page(document.getElementById("app") as HTMLElement);
Object.assign(window, { upright: { store, page, exported } });
