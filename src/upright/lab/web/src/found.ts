// What a job, a certificate or an analysis has found: the page of its result, as the server renders it.
import { button, h } from "./dom";
import type { Head, JobResult } from "./messages";
import { spoken } from "./texts";

/** The first screen of a page. */
export function first({ verdict, level, title, lead, numbers }: Head): HTMLElement {
  return h("div", { className: "first" },
    verdict && h("p", { className: `badge ${level}` }, verdict), title && h("p", {}, h("b", {}, title)),
    ...lead.map((one) => h("p", { className: "note" }, one)),
    numbers.length > 0 && h("dl", { className: "facts" }, ...numbers.flatMap(([value, meaning]) => [h("dt", {}, value), h("dd", {}, meaning)])));
}

/** The whole page of a result, in the colours of this one; what it names next is at hand where the lab has a button for it. */
export function whole(result: JobResult, acts: Record<string, [string, () => void]> = {}): HTMLElement {
  const host = h("div", { className: "page" });
  const root = host.attachShadow({ mode: "open" });
  root.innerHTML = spoken(result.html);
  for (const next of root.querySelectorAll<HTMLElement>("[data-verb]")) {
    const { verb = "" } = next.dataset;
    if (!Object.hasOwn(acts, verb)) continue;
    const [label, act] = acts[verb];
    next.append(Object.assign(document.createElement("slot"), { name: verb }));
    host.append(button(label, act, { slot: verb, "data-key": `next-${verb}` }));
  }
  return host;
}
