// A job that takes its time: what it does, how far it is, and how long it still takes by its own pace so far.
import { fresh, h, said } from "./dom";
import type { ClientMessage, Job } from "./messages";
import { store } from "./store";
import { named, t } from "./texts";

const SOON = 1000; // [ms] after the first share before its pace says anything
const AGAIN = 500; // [ms] between two looks at the clock

export class JobBar {
  readonly root: HTMLElement;
  private done = h("progress", { max: 1 });
  private words = h("span.note");
  private first = { share: 0, at: 0 };
  private left = NaN; // [ms] at the last share
  private share = 0;
  private began = performance.now();
  private at = this.began;

  constructor(readonly job: Job) {
    const keeping = job.startsWith("keep ");
    const label = said(() => (keeping ? t("writing") : named(job)));
    label.id = fresh("job");
    this.done.setAttribute("aria-labelledby", label.id);
    const what = said(() => (keeping ? "" : named(`doing_${job}`)));
    const stop: ClientMessage = { kind: "Cancel", job };
    this.root = h("div.bar", h("b", label), h("button", { type: "button", onclick: () => store.send(stop), "data-key": `stop-${job}` }, said(() => t("stop"))), this.done, this.words, h("p.note", what));
    const timer = window.setInterval(() => (this.share < 1 ? this.say() : window.clearInterval(timer)), AGAIN);
    this.say();
  }

  /** It has come so far, from 0 to 1: the pace counts from its first word, since its process has to start. */
  to(share: number): void {
    const now = performance.now();
    if (share > 0 && !this.first.share) this.first = { share, at: now };
    if (share > this.first.share && now > this.first.at + SOON) this.left = ((1 - share) * (now - this.first.at)) / (share - this.first.share);
    [this.share, this.at] = [share, now];
    this.done.value = share;
    this.say();
  }

  private say(): void {
    const [now, seconds] = [performance.now(), (ms: number) => String(Math.ceil(ms / 1000))];
    const left = this.left - (now - this.at);
    const time = Number.isNaN(left) ? t("soFar", { seconds: seconds(now - this.began) }) : left > 0 ? t("stillTakes", { seconds: seconds(left) }) : t("overdue", { seconds: seconds(now - this.began) });
    this.words.textContent = this.share ? `${(100 * this.share).toFixed(0)} % · ${time}` : t("oneAtATime");
  }
}
