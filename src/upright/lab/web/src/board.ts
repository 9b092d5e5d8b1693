// The class: everybody's robot at a glance, and the board by largest recovered push.
import { button, h } from "./dom";
import type { Student } from "./messages";
import type { Store } from "./store";
import { named, t } from "./texts";

const SVG = "http://www.w3.org/2000/svg";

export function board(store: Store): Node[] {
  const students = store.board?.students ?? [];
  const parts: Node[] = [];
  if (store.role === "teacher") {
    parts.push(h("div", { className: "row" }, button(t("broadcast"), () => store.send({ kind: "Broadcast", setup: store.setup }), { className: "main", "data-key": "broadcast" })));
    parts.push(h("div", { className: "wall" }, ...students.map(tile)));
  }
  const head = h("thead", {}, h("tr", {}, ...["", t("name"), t("bestPush"), t("effort"), t("family")].map((text) => h("th", { scope: "col" }, text))));
  const rows = students.map((s, i) =>
    h("tr", { className: s.here ? "" : "away" }, h("td", {}, String(i + 1)), h("td", {}, s.name), h("td", {}, s.best.toFixed(3)), h("td", {}, s.effort.toFixed(0)), h("td", {}, named(s.controller).split(":")[0])));
  parts.push(h("div", { className: "table" }, h("table", { className: "board", "aria-label": t("board") }, head, h("tbody", {}, ...rows))));
  return [h("div", { className: "column wide" }, ...parts)];
}

function tile(student: Student): HTMLElement {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", "-30 -48 60 60");
  svg.setAttribute("aria-hidden", "true");
  const add = (tag: string, attributes: Record<string, string>) => {
    const part = document.createElementNS(SVG, tag);
    for (const [name, value] of Object.entries(attributes)) part.setAttribute(name, value);
    svg.append(part);
  };
  const lean = ((student.pitch * 180) / Math.PI).toFixed(1);
  add("rect", { x: "-6", y: "-40", width: "12", height: "38", rx: "3", class: "stick", transform: `rotate(${lean})` });
  add("circle", { r: "8", cx: "0", cy: "0", class: "wheel" });
  add("line", { x1: "-30", x2: "30", y1: "8.5", y2: "8.5", class: "ground" });
  return h("figure", { className: `tile${student.fallen ? " down" : ""}${student.here ? "" : " away"}` }, svg, h("figcaption", {}, student.name));
}
