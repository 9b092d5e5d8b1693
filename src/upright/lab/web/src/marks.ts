// Where each push began, in a strip chart: a dashed line through it, and its name and size at the same place above the curve.
import type uPlot from "uplot";
import { digits, h } from "./dom";
import { ink } from "./palette";
import { DEGREES, store } from "./store";
import type { Mark } from "./store";
import { named } from "./texts";

export const ROOM = 13; // [px] above the curve for one row of labels
const LETTER = 10.5; // [px]
export const QUIET = ["stood", "self"]; // what is no push
const GAP = 5; // [px] at least between two labels
const NEAR = 2; // [px] between a label and the line of another push

/** A push in words, and without its unit for where there is no room for more. */
function words({ what, size }: Mark): string[] {
  const text = named(size || what !== "hand" ? `mark_${what}` : "mark_held");
  const short = text.replace(/(?<=\{size\}).*/, "");
  const shown = Math.abs(what === "tilt" ? DEGREES * size : size);
  return [...new Set([text, short])].map((one) => one.replace("{size}", digits(shown, 2)));
}

export class Marks {
  root = h("div.marks");
  private shown = "";

  /** Draw the lines of the pushes in sight, the newest first, and label as many as have room. */
  draw(plot: uPlot, scale: number): void {
    const { ctx, bbox: { left, top, width, height } } = plot;
    const pixels = scale * devicePixelRatio;
    const { push, soft } = ink();
    let room = left + width + 16 * pixels; // up to which nothing is written yet: the margin on the right is free
    const labels: [string, string, number][] = [];
    const seen = store.traces.marks.map((mark) => ({ mark, x: plot.valToPos(mark.t, "x", true) })).filter(({ x }) => x >= left && x <= left + width);
    ctx.save();
    ctx.lineWidth = pixels;
    ctx.setLineDash([3 * pixels, 3 * pixels]);
    ctx.font = `${LETTER * pixels}px system-ui, sans-serif`;
    for (const { mark, x } of seen.reverse()) {
      ctx.strokeStyle = QUIET.includes(mark.what) ? soft : push;
      ctx.beginPath();
      ctx.moveTo(x, top);
      ctx.lineTo(x, top + height);
      ctx.stroke();
      const apart = NEAR * pixels;
      const after = Math.min(...seen.map((other) => other.x).filter((other) => other > x + apart)) - apart; // between the lines
      const before = Math.max(left, ...seen.map((other) => other.x).filter((other) => other < x - apart).map((other) => other + apart)); // beside it
      for (const text of words(mark)) {
        const wide = ctx.measureText(text).width + 3 * pixels;
        const at = Math.min(x, room - wide, after - wide);
        if (at < before || at + wide < x) continue; // it would stand at another line
        labels.push([text, mark.what, at / devicePixelRatio]);
        room = at - GAP * pixels;
        break;
      }
    }
    ctx.restore();
    this.label(labels);
  }

  private label(labels: [string, string, number][]): void {
    const shown = JSON.stringify(labels.map(([text, what]) => [text, what]));
    if (shown !== this.shown) this.root.replaceChildren(...labels.map(([text, what]) => h("span", { className: `event ${QUIET.includes(what) ? "quiet" : ""}` }, text)));
    this.shown = shown;
    labels.forEach(([, , x], i) => ((this.root.children[i] as HTMLElement).style.left = `${x.toFixed(1)}px`));
  }
}
