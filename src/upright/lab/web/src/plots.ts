// Drawings that are no strip charts: Bode, Nyquist, poles and the phase portrait, as SVG.
import { svg } from "./dom";
import { ink } from "./palette";
import { local } from "./texts";

export interface Line {
  x: number[];
  y: number[];
  colour: string;
  dash?: number[];
}

export interface Drawing {
  title: string;
  xLabel: string;
  yLabel: string;
  lines?: Line[];
  points?: { x: number; y: number; colour: string; cross?: boolean }[];
  x: [number, number];
  y: [number, number];
  logX?: boolean;
  square?: boolean;
  circle?: boolean;
  marks?: { x?: number; y?: number }[];
  read?: true; // whether the pointer reads its line, as on a page of results
}

const W = 420;
const PAD = { left: 58, right: 10, top: 8, bottom: 34 };

export function drawing(d: Drawing): SVGSVGElement {
  const height = d.square ? W * 0.82 : 190;
  const root = svg("svg", { viewBox: `0 0 ${W} ${height}`, role: "img", "aria-label": d.title, class: "drawing" });
  const ix = (v: number) => (d.logX ? Math.log10(v) : v);
  const [x0, x1] = [ix(d.x[0]), ix(d.x[1])];
  const [inX, inY] = [W - PAD.left - PAD.right, height - PAD.top - PAD.bottom];
  const px = (v: number) => PAD.left + ((ix(v) - x0) / (x1 - x0)) * inX;
  const py = (v: number) => PAD.top + (1 - (v - d.y[0]) / (d.y[1] - d.y[0])) * inY;
  const colours = ink();
  const clip = `clip-${Math.random().toString(36).slice(2)}`;
  const frame = svg("clipPath", { id: clip });
  frame.append(svg("rect", { x: PAD.left, y: PAD.top, width: inX, height: inY }));
  root.append(frame);
  for (const v of d.logX ? decades(d.x) : ticks(d.x, 6)) {
    root.append(svg("line", { x1: px(v), x2: px(v), y1: PAD.top, y2: PAD.top + inY, stroke: colours.grid }));
    root.append(text(label(v), px(v), PAD.top + inY + 14, "middle", colours.soft));
  }
  for (const v of ticks(d.y, 5)) {
    root.append(svg("line", { x1: PAD.left, x2: W - PAD.right, y1: py(v), y2: py(v), stroke: colours.grid }));
    root.append(text(label(v), PAD.left - 6, py(v) + 4, "end", colours.soft));
  }
  root.append(text(d.xLabel, PAD.left + inX / 2, height - 4, "middle", colours.soft));
  const side = text(d.yLabel, 0, 0, "middle", colours.soft);
  side.setAttribute("transform", `translate(9 ${PAD.top + inY / 2}) rotate(-90)`);
  root.append(side);
  const inside = svg("g", { "clip-path": `url(#${clip})` });
  root.append(inside);
  if (d.circle) inside.append(svg("ellipse", { cx: px(0), cy: py(0), rx: px(1) - px(0), ry: py(0) - py(1), fill: "none", stroke: colours.soft, "stroke-dasharray": "4 3" }));
  for (const m of d.marks ?? []) {
    const at = m.y === undefined ? { x1: px(m.x ?? 0), x2: px(m.x ?? 0), y1: PAD.top, y2: PAD.top + inY } : { y1: py(m.y), y2: py(m.y), x1: PAD.left, x2: W - PAD.right };
    inside.append(svg("line", { ...at, stroke: colours.push, "stroke-width": 1.2, "stroke-dasharray": "5 3" }));
  }
  (d.lines ?? []).forEach((line, i) => {
    const curve = svg("g", { id: `line-0-${i}-${clip}` });
    curve.append(path(line, px, py));
    inside.append(curve);
  });
  if (d.read) {
    const panel = { row: 0, lines: [d.yLabel], left: PAD.left, right: W - PAD.right, top: PAD.top, bottom: PAD.top + inY, x: d.x, y: d.y, logx: d.logX, unit: d.xLabel };
    root.classList.add("lines");
    root.dataset.curves = JSON.stringify([panel]);
  }
  for (const p of d.points ?? []) inside.append(point(p.cross ?? false, px(p.x), py(p.y), p.colour));
  return root;
}

function text(content: string, x: number, y: number, anchor: string, fill: string): SVGElement {
  const element = svg("text", { x, y, "text-anchor": anchor, fill, "font-size": 11.5 });
  element.textContent = content;
  return element;
}

function path(line: Line, px: (v: number) => number, py: (v: number) => number): SVGElement {
  let d = "";
  let pen = false;
  line.x.forEach((x, i) => {
    const y = line.y[i];
    const fine = Number.isFinite(x) && Number.isFinite(y);
    if (fine) d += `${pen ? "L" : "M"}${px(x).toFixed(1)} ${py(y).toFixed(1)}`;
    pen = fine;
  });
  return svg("path", { d, fill: "none", stroke: line.colour, "stroke-width": 1.8, "stroke-dasharray": (line.dash ?? []).join(" "), "stroke-linejoin": "round" });
}

function point(cross: boolean, x: number, y: number, colour: string): SVGElement {
  if (!cross) return svg("circle", { cx: x, cy: y, r: 4, fill: colour });
  const r = 4.5;
  return svg("path", { d: `M${x - r} ${y - r}L${x + r} ${y + r}M${x - r} ${y + r}L${x + r} ${y - r}`, stroke: colour, "stroke-width": 1.8 });
}

export function ticks([low, high]: [number, number], wanted: number): number[] {
  const rough = (high - low) / wanted;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= rough) ?? rough;
  const found: number[] = [];
  for (let v = Math.ceil(low / step) * step; v <= high + step * 1e-6; v += step) found.push(Math.abs(v) < step * 1e-6 ? 0 : v);
  return found;
}

function decades([low, high]: [number, number]): number[] {
  const found: number[] = [];
  for (let p = Math.ceil(Math.log10(low)); 10 ** p <= high; p += 1) found.push(10 ** p);
  return found;
}

function label(v: number): string {
  return local(String(+v.toPrecision(6)).replace("-", "−"));
}
