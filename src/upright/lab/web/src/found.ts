// What a job, a certificate or an analysis has found: the page of its result, as the server renders it.
import { button, h } from "./dom";
import "./hover.js";
import type { Head, Job, JobResult } from "./messages";
import { language, spoken } from "./texts";

/** The first screen of a page. */
export function first({ verdict, level, title, lead, numbers }: Head): HTMLElement {
  return h("div.first",
    verdict && h("p", { className: `badge ${level}` }, verdict), title && h("p", h("b", title)),
    ...lead.map((one) => h("p.note", one)),
    numbers.length > 0 && h("dl.facts", ...numbers.flatMap(([value, meaning]) => [h("dt", value), h("dd", meaning)])));
}

/** The whole page of a result, in the colours of this one, with its folds as the reader has left them; what it names
 * next is at hand where the lab has a button for it. */
export class ResultPage {
  private host = h("div.page");
  private root = this.host.attachShadow({ mode: "open" });
  private shown: JobResult | null = null;

  constructor(private acts: (job: Job) => Record<string, [string, () => void]> = () => ({})) {}

  show(result: JobResult): HTMLElement {
    if (result === this.shown && this.host.lang === language()) return this.host;
    const open = result === this.shown ? [...this.root.querySelectorAll("details")].map((fold) => fold.open) : [];
    this.shown = result;
    this.host.lang = language();
    this.host.replaceChildren();
    this.root.innerHTML = spoken(result.html);
    this.root.querySelectorAll("details").forEach((fold, i) => (fold.open = open[i] ?? false));
    const acts = this.acts(result.job);
    for (const next of this.root.querySelectorAll<HTMLElement>("[data-verb]")) {
      const { verb = "" } = next.dataset;
      if (!Object.hasOwn(acts, verb)) continue;
      const [label, act] = acts[verb];
      next.append(Object.assign(document.createElement("slot"), { name: verb }));
      this.host.append(button(label, act, `next-${verb}`, { slot: verb }));
    }
    return this.host;
  }
}
