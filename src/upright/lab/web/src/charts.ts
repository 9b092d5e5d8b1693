// Strip charts of the six states, every body in its colour and dash.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { button, h, keepingFocus, replace, svg } from "./dom";
import { Marks, ROOM } from "./marks";
import { ink, laneColour, laneDash } from "./palette";
import { ticks } from "./plots";
import { DEGREES, SHOWN_UNITS, STATES, SYMBOLS, store } from "./store";
import { remembered } from "./remember";
import { local, named, t } from "./texts";

/** A chart of lines over time that follows its own width. */
export class Strip {
  root: HTMLElement;
  private plot: uPlot;
  private marks = new Marks();
  private extent: [number, number] = [NaN, NaN]; // of what the scale is for

  constructor(title: string, unit: string, lines: { label: string; colour: string; dash: number[]; width?: number }[], height: number, floor: number, ceiling: () => number = () => Infinity) {
    const colours = ink();
    const scale = parseFloat(getComputedStyle(document.documentElement).fontSize) / 16; // larger on a wall
    const axis = { stroke: colours.soft, grid: { stroke: colours.grid, width: 1 }, ticks: { show: false }, font: `${11 * scale}px system-ui, sans-serif` };
    const box = h("div.plot", { "aria-hidden": "true" }, this.marks.root);
    box.style.setProperty("--height", `${height / 16}rem`);
    this.root = h("figure.strip", { role: "group", "aria-label": `${title} [${unit}]` }, h("figcaption", h("b", title), h("span", unit)), box);
    this.plot = new uPlot(
      {
        width: 300, height, padding: [ROOM * scale, 18 * scale, 0, 0],
        cursor: { show: false }, legend: { show: false }, hooks: { draw: [(u) => this.marks.draw(u, scale)] },
        scales: { x: { time: false }, y: { range: () => around(Math.max(this.extent[0], -ceiling()), Math.min(this.extent[1], ceiling()), floor) } },
        axes: [
          { ...axis, size: 20 * scale, values: (_u, ticks) => ticks.map((v) => (v < 0 ? "" : local(`${+v.toFixed(2)} s`))), space: 46 * scale },
          { ...axis, size: 46 * scale, splits: (u: uPlot, _axis: number, low: number, high: number) => labelled(low, high, u.bbox.height / devicePixelRatio / (18 * scale)), values: (_u, ticks) => ticks.map((v) => local(String(+v.toPrecision(4)).replace("-", "−"))) },
        ],
        series: [{}, ...lines.map((l) => ({ label: l.label, stroke: l.colour, width: (l.width ?? 1.6) * scale, dash: l.dash, points: { show: false }, spanGaps: false, gaps: (u: uPlot, _i: number, _from: number, _to: number, holes: [number, number][]) => [...holes, ...breaks(u)].sort(([a], [b]) => a - b) }))],
      },
      [[], ...lines.map(() => [])] as uPlot.AlignedData,
      box,
    );
    new ResizeObserver(() => this.fit(box)).observe(box);
  }

  private fit(box: HTMLElement): void {
    if (box.clientWidth > 40) this.plot.setSize({ width: box.clientWidth, height: box.clientHeight });
  }

  /** The lines over the times t [s] between two of them, on a scale for those that are `scaled`. */
  show(t: number[], lines: number[][], from: number, to: number, scaled = lines): void {
    const values = scaled.flat().filter(Number.isFinite);
    this.extent = values.length ? [Math.min(...values), Math.max(...values)] : [NaN, NaN];
    this.plot.batch(() => {
      this.plot.setData([t, ...lines] as uPlot.AlignedData, false);
      this.plot.setScale("x", { min: from, max: to });
    });
  }
}

/** Where the lines are broken [pixels of the canvas], wide enough to be seen. */
function breaks(plot: uPlot): [number, number][] {
  const { left, width } = plot.bbox;
  const wide = 2 * devicePixelRatio;
  return store.traces.breaks
    .map((pair) => pair.map((t) => plot.valToPos(t, "x", true)) as [number, number])
    .map(([from, to]): [number, number] => [from - wide / 2, Math.max(to, from + wide)])
    .filter(([from, to]) => from > left && to < left + width);
}

/** Ticks of a scale on which there is room for so many, and two at least. */
function labelled(low: number, high: number, room: number): number[] {
  let count = Math.max(1, Math.floor(room));
  let made = ticks([low, high], count);
  while (made.length < 2 && count < 12) made = ticks([low, high], (count += 1));
  return made;
}

export function around(low: number, high: number, floor: number): [number, number] {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return [-floor, floor];
  const middle = (low + high) / 2;
  const half = Math.max(((high - low) / 2) * 1.1, floor);
  return [middle - half, middle + half];
}

const FIRST = [0, 2]; // pitch and wheel angle, which tell the story; the others are shown when they are asked for
const FLOORS = [3, 20, 30, 60, 3, 12]; // [°, °/s] half heights below which noise would fill the chart

/** A phone, upright or on its side: the pitch stands by itself, right below the robot. */
export const small = matchMedia("(max-width: 40rem), (max-width: 62rem) and (max-height: 32rem)");
const narrow = matchMedia("(max-width: 40rem)"); // one upright
const sideways = matchMedia("(min-width: 40.01rem)"); // of a small one

export class Charts {
  root = h("section.charts");
  private strips: (Strip | null)[] = []; // of the six states; none where it is not shown
  private legend = h("div.legend");
  slot = h("div.slot"); // in the scene
  private large: number | null = null; // which curve a phone shows large

  constructor(private seconds: () => number) {
    for (const one of [small, sideways]) one.addEventListener("change", () => this.build());
  }

  /** New charts: other bodies, another language or theme. */
  build(): void {
    this.root.setAttribute("aria-label", t("charts"));
    const bodies = store.changed?.bodies ?? [];
    const lines = bodies.map((name) => ({ label: named(name), colour: laneColour(name), dash: laneDash(name, bodies) }));
    const more = remembered.getItem("curves") === "all";
    if (!narrow.matches) this.large = null;
    this.strips = STATES.map((name, i) => (more || FIRST.includes(i) ? new Strip(`${SYMBOLS[i]}  ${named(name)}`, SHOWN_UNITS[i], lines, 104, FLOORS[i], i ? undefined : () => DEGREES * (store.ceiling ?? Infinity)) : null));
    replace(this.legend, ...bodies.map((name) => legendEntry(name)));
    const first = small.matches ? (sideways.matches ? FIRST.slice(0, 1) : FIRST) : [];
    const near = this.strips.filter((_, i) => first.includes(i)).map((strip) => strip?.root);
    const rest = this.strips.map((strip) => strip?.root).filter((root) => !near.includes(root));
    this.strips.forEach((strip, i) => strip && this.enlargeable(strip.root, i));
    const name = t(more ? "fewerCurves" : "moreCurves");
    const other = button(narrow.matches ? t(more ? "fewer" : "more") : name, () => (more ? this.shown("first") : this.more()), "curves", { className: "quiet", "aria-label": name, "aria-expanded": String(more) });
    const strips = (roots: (HTMLElement | undefined)[]) => (roots.some(Boolean) ? h("div", { className: `strips${more ? " all" : ""}` }, ...roots) : null);
    const above = h("div.above", this.legend, other);
    replace(this.slot, ...(near.length ? [above, strips(near)] : []));
    replace(this.root, near.length ? null : above, strips(rest));
    this.root.hidden = !this.root.childElementCount; // a phone has its first curves in the scene
  }

  /** Every curve; on a phone the others, which are below, come into sight. */
  more(): void {
    this.shown("all");
    if (small.matches) this.root.scrollIntoView();
  }

  private shown(which: "all" | "first"): void {
    remembered.setItem("curves", which);
    keepingFocus(() => this.build());
  }

  /** On a phone a tap makes a curve large, over the same seconds, and another one small again. */
  private enlargeable(root: HTMLElement, i: number): void {
    const enlarge = h("button", { type: "button", className: "enlarge", "data-key": `enlarge-${i}` }, h("span", { "aria-hidden": "true" }, "⤢"), h("span.hidden", t("large", { what: named(STATES[i]) })));
    root.classList.toggle("large", this.large === i);
    enlarge.setAttribute("aria-expanded", String(this.large === i));
    root.querySelector("figcaption")?.append(enlarge);
    root.addEventListener("click", () => {
      if (!narrow.matches) return;
      this.large = this.large === i ? null : i;
      keepingFocus(() => this.build());
    });
  }

  draw(): void {
    const { t: time, x } = store.traces;
    if (!time.length || x.length !== store.changed?.bodies.length) return;
    const [seconds, last] = [this.seconds(), time.at(-1) as number];
    const still = store.lain === null ? last : Math.min(last, store.lain + 0.1 * seconds); // where all lie, nothing moves: the fall stays in sight
    const end = store.snapshot?.back ? store.snapshot.t : Math.max(still, time[0] + seconds); // from left to right at first
    const start = end - seconds;
    const first = Math.max(0, store.traces.since(start) - 1);
    const t = time.slice(first);
    const since = store.traces.marks.findLast((mark) => ["stood", "tilt"].includes(mark.what) && mark.t <= end)?.t ?? -Infinity;
    const from = t.findIndex((at) => at >= Math.max(start, since));
    const lies = store.snapshot?.x.map((row) => row[8] === 1) ?? [];
    const counted = x.map((_, b) => lies.every(Boolean) || !lies[b]); // by those that stand, where any does
    const clip = this.clipped(t, x[0] && x.map((body) => body[0].slice(first)));
    this.strips.forEach((strip, i) => {
      const lines = x.map((body) => inDegrees(body[i].slice(first)));
      const scaled = from < 0 ? lines : lines.filter((_, b) => counted[b]).map((line) => line.slice(from));
      const shown: [number, number] = clip && i === 0 && i === this.large ? clip : [start, end];
      strip?.show(t, lines, ...shown, scaled);
    });
  }

  /** From the first time shown to where the pitch of every body has left its scale [s]; null where one is within it. */
  private clipped(t: number[], pitch: number[][]): [number, number] | null {
    const { ceiling } = store;
    if (ceiling === null || !t.length) return null;
    const last = Math.max(...pitch.map((line) => line.findIndex((v) => Math.abs(v) > ceiling) + 1 || Infinity));
    return last <= t.length && last > 1 ? [t[0], t[last - 1]] : null;
  }
}

export function inDegrees(angles: number[]): number[] {
  return angles.map((angle) => DEGREES * angle);
}

export function legendEntry(name: string): HTMLElement {
  const dashes = laneDash(name, store.changed?.bodies ?? []).join(" ");
  const line = svg("line", { x1: 0, x2: 28, y1: 5, y2: 5, stroke: laneColour(name), "stroke-width": 2.5, "stroke-dasharray": dashes });
  const sample = svg("svg", { width: 28, height: 10, "aria-hidden": "true" }, line);
  const title = named(`${name}Note`);
  const first = name === store.changed?.bodies[0];
  return h("span.key", { title }, sample, first ? t("robotIs", { body: named(name) }) : named(name));
}
