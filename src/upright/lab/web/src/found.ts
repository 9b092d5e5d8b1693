// What a job has found, as the panels show it.
import { h, plainNumbers, table } from "./dom";
import type { JobResult } from "./messages";
import { sentence } from "./see";
import { t, translate, translated } from "./texts";

const OPEN = "The readings hardly change"; // begins each line on numbers that a log does not separate

/** What the doctor has found: where, on what evidence, and what to do. */
function finding([severity, , channel, evidence, repair]: string[]): HTMLElement {
  const where = translate(channel.replace(/^\w+\//, "").replaceAll("_", " "));
  return h("li", {}, h("b", {}, [translate(severity), where].filter(Boolean).join(", ")), h("p", {}, plainNumbers(sentence(translate(evidence)))), h("p", { className: "note" }, repair ? `→ ${plainNumbers(translate(repair))}` : ""));
}

/** The title, table or findings, and remarks of a result. */
export function reported(f: JobResult): (Node | null)[] {
  const lines = f.text.split("\n").filter(Boolean);
  const plain = (text: string) => text.replace(/\bin-(?=[\w.-]+\.\w+)/g, "").replace(/\b[a-z]+(_[a-z]+)+\b/g, (name) => translate(name.replaceAll("_", " "))); // names of files and parameters
  const item = (line: string) => h("li", { className: "note", lang: translated(line) ? "" : "en" }, plainNumbers(plain(translate(line))));
  const open = lines.filter((line) => line.startsWith(OPEN)), text = lines.filter((line) => !line.startsWith(OPEN)).map(item);
  const folded = open.length ? h("details", {}, h("summary", {}, t("notSeparated", { n: open.length })), h("ul", { className: "remarks" }, ...open.map(item))) : null;
  const refused = f.rows.some((row) => row.at(-1) === "refused") ? h("p", { className: "note" }, t("refusedMeans")) : null;
  const words = (cells: string[]) => cells.map((cell) => plainNumbers(translate(f.job === "calibrate" ? cell.replaceAll("_", " ") : cell)));
  const rows = f.job === "doctor" ? h("ul", { className: "findings" }, ...f.rows.map(finding)) : table(f.header.map(translate), f.rows.map(words), f.job);
  return [h("h4", {}, plainNumbers(plain(translate(f.title)))), f.rows.length ? rows : null, refused, text.length ? h("ul", { className: "remarks" }, ...text) : null, folded];
}
