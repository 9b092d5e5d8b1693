// The class: everybody's robot at a glance, the board by largest recovered push, and how to come in.
import { button, h, replace, svg } from "./dom";
import type { Student } from "./messages";
import { qr } from "./qr";
import { store } from "./store";
import { fixed, named, t } from "./texts";

export class ClassPanel {
  root = h("div.panel-body");
  private wall = h("div.wall");
  private scores = h("div.table");

  build(): void {
    const column = h("div.column.wide");
    if (store.role === "teacher") {
      column.append(
        h("div.row",
          button(t("broadcast"), () => store.send({ kind: "Broadcast", setup: store.setup }), "broadcast", { className: "main" }),
          button(t("results"), () => save(results()), "results")),
        invitation(), this.wall);
    }
    column.append(this.scores);
    replace(this.root, column);
    this.update();
  }

  /** What changes a few times a second; the buttons stay what they are. */
  update(): void {
    const students = store.board?.students ?? [];
    replace(this.wall, ...students.map(tile));
    const head = h("thead", h("tr", ...["", t("name"), t("bestPush"), t("effort"), t("family")].map((text) => h("th", { scope: "col" }, text))));
    const rows = students.map((s, i) =>
      h("tr", { className: s.here ? "" : "away" }, h("td", String(i + 1)), h("td", s.name), h("td", fixed(s.best, 3)), h("td", fixed(s.effort, 0)), h("td", named(s.controller).split(":")[0])));
    replace(this.scores, h("table.board", { "aria-label": t("board") }, head, h("tbody", ...rows)));
  }
}

/** The students' address, for the blackboard and for their telephones. */
function invitation(): HTMLElement {
  const address = new URL(`#token=${store.invite}`, location.href.split("#")[0]).href;
  return h("figure.invite", qr(address, t("invite")), h("figcaption", h("b", t("invite")), h("code", address)));
}

/** The board as CSV (RFC 4180): names in quotes, and none that a spreadsheet takes for a formula. */
function results(): string {
  const quoted = (text: string) => `"${text.replace(/^[=+\-@\t]/, "'$&").replaceAll('"', '""')}"`;
  const lines = (store.board?.students ?? []).map((s, i) =>
    [i + 1, quoted(s.name), s.best.toFixed(4), s.effort.toFixed(1), quoted(s.controller), s.here].join(","));
  return ["place,name,best_push_Ns,effort_u2s,controller,here", ...lines, ""].join("\r\n");
}

function save(text: string): void {
  const url = URL.createObjectURL(new Blob(["\ufeff", text], { type: "text/csv" }));
  h("a", { href: url, download: "results.csv" }).click();
  window.setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

function tile(student: Student): HTMLElement {
  const lean = ((student.pitch * 180) / Math.PI).toFixed(1);
  const drawn = svg("svg", { viewBox: "-30 -48 60 60", "aria-hidden": "true" },
    svg("rect", { x: -6, y: -40, width: 12, height: 38, rx: 3, class: "stick", transform: `rotate(${lean})` }),
    svg("circle", { r: 8, class: "wheel" }), svg("line", { x1: -30, x2: 30, y1: 8.5, y2: 8.5, class: "ground" }));
  return h("figure", { className: `tile${student.fallen ? " down" : ""}${student.here ? "" : " away"}` }, drawn, h("figcaption", student.name));
}
