// What can be looked at: the loop, the phase portrait, voltages, the estimate, and the equations with their numbers.
import { Strip, around, inDegrees } from "./charts";
import { digits, h, replace, select, table } from "./dom";
import { ink, laneColour, laneDash } from "./palette";
import { drawing } from "./plots";
import { STATES, SYMBOLS, store } from "./store";
import { named, t } from "./texts";
import { judged } from "./verdict";

type View = "loop" | "portrait" | "voltages" | "estimate" | "equations";
const VIEWS: View[] = ["loop", "portrait", "voltages", "estimate", "equations"];
const SECONDS = 8;
const RATES = ["ψ̇", "ψ̈", "θ̇", "θ̈", "φ̇", "φ̈"];

export class See {
  root = h("div.see");
  private view: View = "loop";
  private stage = h("div.stage");
  private strips: Strip[] = [];

  build(): void {
    const choices = VIEWS.map((view): [string, string] => [view, t(view)]);
    const choice = select(t("viewLabel"), choices, this.view, (view) => {
      this.view = view as View;
      this.update();
    }, "view");
    replace(this.root, choice, this.stage);
    this.update();
  }

  /** What only changes when the session says so. */
  update(): void {
    this.strips = [];
    if (this.view === "loop") replace(this.stage, ...this.loop());
    else if (this.view === "equations") replace(this.stage, ...equations());
    else if (this.view === "voltages") this.voltages();
    else if (this.view === "estimate") this.estimate();
    else this.portrait();
  }

  /** What moves. */
  draw(): void {
    if (this.view === "portrait") this.portrait();
    if (!this.strips.length) return;
    const traces = store.traces;
    const end = traces.t.at(-1) ?? 0;
    const first = traces.since(end - SECONDS);
    const time = traces.t.slice(first);
    const cut = (line: number[]) => line.slice(first);
    if (this.view === "estimate") {
      this.strips[0].show(time, [traces.x[0]?.[0] ?? [], traces.estimate].map((line) => inDegrees(cut(line))), end - SECONDS, end);
    } else {
      const marks = [1, 2].map((bit, i) => cut(traces.saturated).map((s, k) => (s & bit ? traces.volts[i][first + k] : NaN)));
      this.strips.forEach((strip, i) => strip.show(time, [cut(traces.volts[i]), marks[i]], end - SECONDS, end));
    }
  }

  private voltages(): void {
    const { text, push } = ink();
    const { unit } = store;
    this.strips = [t("leftMotor"), t("rightMotor")].map(
      (side) => new Strip(side, unit, [{ label: side, colour: text, dash: [] }, { label: t("saturated"), colour: push, dash: [], width: 5 }], 150, 1),
    );
    const note = h("p.note", unit === "V" ? t("voltagesNote") : t("torquesNote"));
    replace(this.stage, note, ...this.strips.map((s) => s.root));
  }

  private estimate(): void {
    if (!store.snapshot?.e.length) {
      replace(this.stage, h("p.note", t("noEstimate")));
      return;
    }
    const { push } = ink();
    const lines = [
      { label: t("truth"), colour: laneColour(store.changed?.bodies[0] ?? "twin"), dash: [] },
      { label: t("opinion"), colour: push, dash: [4, 3] },
    ];
    this.strips = [new Strip(`ψ: ${t("truth")} ──  ${t("opinion")} ╌╌`, "°", lines, 190, 1)];
    replace(this.stage, h("p.note", t("estimateNote")), this.strips[0].root);
  }

  private portrait(): void {
    const { traces } = store;
    const { t: time, x } = traces;
    const first = traces.since((time.at(-1) ?? 0) - SECONDS);
    const plane = (state: number, least: [number, number]) => {
      const lines = x.map((body, i) => {
        const name = store.changed?.bodies[i] ?? "";
        return { x: inDegrees(body[state].slice(first)), y: inDegrees(body[state + 1].slice(first)), colour: laneColour(name), dash: laneDash(name, store.changed?.bodies ?? []) };
      });
      const span = (axis: "x" | "y", floor: number): [number, number] => {
        const all = lines.flatMap((l) => l[axis]);
        const [low, high] = [all.reduce((m, v) => Math.min(m, v), Infinity), all.reduce((m, v) => Math.max(m, v), -Infinity)];
        return around(low, high, floor);
      };
      const ends = lines.map((l) => ({ x: l.x.at(-1) ?? 0, y: l.y.at(-1) ?? 0, colour: l.colour }));
      const label = named(STATES[state]);
      return titled(label, drawing({ title: `${t("portrait")}: ${label}`, xLabel: `${SYMBOLS[state]} [°]`, yLabel: `${SYMBOLS[state + 1]} [°/s]`, lines, points: ends, x: span("x", least[0]), y: span("y", least[1]), square: true }));
    };
    replace(this.stage, plane(0, [2, 20]), plane(2, [30, 60]), plane(4, [3, 12]));
  }

  private loop(): Node[] {
    const { analysed } = store;
    const drawings: Node[] = judged();
    if (!analysed || store.off) return drawings;
    const colour = laneColour("twin");
    if (analysed.L.length === 3) drawings.push(...frequency(analysed.L, colour));
    if (analysed.poles.length) drawings.push(poles(analysed.poles, colour));
    return drawings;
  }
}

function frequency([omega, re, im]: number[][], colour: string): Node[] {
  const magnitude = omega.map((_, k) => 20 * Math.log10(Math.hypot(re[k], im[k])));
  const phase = unwrapped(omega.map((_, k) => (Math.atan2(im[k], re[k]) * 180) / Math.PI));
  const x: [number, number] = [omega[0], omega.at(-1) as number];
  const range = (v: number[], pad: number): [number, number] => [Math.min(...v) - pad, Math.max(...v) + pad];
  const bode = (yLabel: string, y: number[], pad: number, mark: number): Node[] => [
    drawing({ title: t("bode"), xLabel: "ω [rad/s]", yLabel, lines: [{ x: omega, y, colour }], x, y: range(y, pad), logX: true, marks: [{ y: mark }], read: true }),
    h("output"),
  ];
  const mirrored = im.map((v) => -v);
  const nyquist = drawing({
    title: t("nyquist"), xLabel: "Re L", yLabel: "Im L", square: true, x: [-3.2, 1.6], y: [-2, 2], circle: true,
    lines: [{ x: re, y: im, colour }, { x: re, y: mirrored, colour, dash: [4, 3] }], points: [{ x: -1, y: 0, colour: ink().push, cross: true }],
  });
  return [titled(t("bode"), ...bode("|L| [dB]", magnitude, 3, 0), ...bode("∠L [°]", phase, 8, -180)), titled(t("nyquist"), nyquist)];
}

function poles(all: number[][], colour: string): HTMLElement {
  const points = all.map(([x, y]) => ({ x, y, colour: Math.hypot(x, y) >= 1 ? ink().push : colour, cross: true }));
  const reach = Math.max(1.15, ...all.map(([x, y]) => Math.max(Math.abs(x), Math.abs(y)) * 1.1));
  const wide = reach * 1.2;
  return titled(t("poles"), drawing({ title: t("poles"), xLabel: "Re z", yLabel: "Im z", points, x: [-wide, wide], y: [-reach, reach], square: true, circle: true }));
}

function titled(title: string, ...drawings: Node[]): HTMLElement {
  return h("figure.titled", { "aria-label": title }, h("figcaption", title), ...drawings);
}

function unwrapped(phase: number[]): number[] {
  let turn = 0;
  return phase.map((v, k) => {
    if (k) turn += Math.round((phase[k - 1] - v) / 360) * 360;
    return v + turn;
  }).map((v, _k, all) => v - Math.round((all[0] + 180) / 360) * 360);
}

function equations(): Node[] {
  const e = store.equations;
  if (!e) return [];
  const [a11, , a22, a33] = e.inertias.map((v) => digits(v, 4));
  const [alpha, beta, weight, lever] = [e.alpha, e.beta, e.weight, e.lever].map((v) => digits(v, 4));
  const [swing, half] = [digits(e.swing, 4), digits(e.half_track, 4)];
  const a12 = `(${lever} cos ψ − ${digits(e.lever - e.inertias[1], 3)})`;
  const held = store.unit === "rad/s"; // wheels turn as commanded, and torques follow
  const [gain, left, right] = held ? ["", "τ_l", "τ_r"] : [`${alpha} `, "v_l", "v_r"];
  const [volts, slip] = [`${gain}(${left} + ${right})`, `2·${beta} (θ̇ − ψ̇)`];
  const lines = [
    `${a11} θ̈ + ${a12} ψ̈ = ${volts} − ${slip} + ${lever} (ψ̇² + φ̇²) sin ψ`,
    `${a12} θ̈ + ${a22} ψ̈ = −${volts} + ${slip} + (${weight} + ${swing} φ̇² cos ψ) sin ψ`,
    `(${a33} + ${swing} sin² ψ) φ̈ = ${half}·${gain}(${right} − ${left}) − 2·${half}²·${beta} φ̇ − (2·${swing} ψ̇ cos ψ + ${lever} θ̇) φ̇ sin ψ`,
    `${held ? "τ: (θ̇ − ψ̇)˙ = (v − θ̇ + ψ̇)/T" : `α = ${alpha}   β = ${beta}`}   M g L = ${weight} N m   M L R = ${lever} kg m²   W/2R = ${half}`,
  ];
  const matrix = (name: string, M: number[][]) => table([name, ...M[0].map((_, i) => (name === "A" ? SYMBOLS[i] : ["v_l", "v_r"][i]))], M.map((row, i) => [RATES[i], ...row.map((v) => digits(v, 4))]), "matrix");
  const open = e.poles.map(([re, im]) => digits(re, 4) + (im ? ` ± ${digits(Math.abs(im), 3)}j` : "")).join(";  ");
  return [
    h("div.equations", ...lines.map((line) => h("div", line))),
    h("p.note", t("equationsNote")),
    h("p", `${t("openPoles")}: ${open} 1/s`),
    h("h4", t("linearised")), matrix("A", e.A), matrix("B", e.B),
  ];
}
