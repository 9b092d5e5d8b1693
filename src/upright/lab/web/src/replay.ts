// A recorded session: the same messages with their time, played without a server.
import type { ClientMessage, ServerMessage, Snapshot } from "./messages";
import { store } from "./store";

export class Replay {
  private moments: Snapshot[];
  private at = 0;
  private paused = false;
  private speed = 1;
  private clock = performance.now();

  constructor(messages: ServerMessage[]) {
    const moments = messages.filter((m): m is Snapshot => m.kind === "Snapshot");
    this.moments = moments.map((m) => ({ ...m, t: m.t - moments[0].t }));
    store.recorded = Math.max(this.length(), 0.02);
    store.send = (message) => this.act(message);
    for (const message of messages) if (message.kind !== "Snapshot") store.hear(message);
    window.setInterval(() => this.tick(), 20);
  }

  static inPage(): ServerMessage[] | null {
    const data = document.getElementById("recording");
    return data ? (JSON.parse(data.textContent ?? "[]") as ServerMessage[]) : null;
  }

  private tick(): void {
    const now = performance.now();
    if (!this.paused && this.moments.length) {
      this.at += ((now - this.clock) / 1000) * this.speed;
      if (this.at > this.length()) this.rewind();
      this.show();
    }
    this.clock = now;
  }

  private length(): number {
    return this.moments.at(-1)?.t ?? 0;
  }

  private rewind(): void {
    this.at = 0;
    store.traces.reset(this.moments[0].x.length);
  }

  private show(): void {
    const t = this.at;
    const last = store.traces.t.at(-1) ?? -Infinity;
    if (t < last) store.traces.until(t);
    const due = this.moments.filter((m) => m.t > last && m.t <= t);
    const now = due.at(-1) ?? this.moments.findLast((m) => m.t <= t);
    for (const moment of due.slice(0, -1)) store.traces.add(moment);
    if (now) store.hear({ ...now, paused: this.paused, back: 0 });
  }

  private act(message: ClientMessage): void {
    if (message.kind === "Play") {
      this.paused = message.paused;
      this.speed = message.speed;
    } else if (message.kind === "Scrub") {
      this.at = Math.max(0, this.length() - message.back);
    } else if (message.kind === "Step") {
      this.paused = true;
      this.at = Math.min(this.at + 0.02 * message.periods, this.length());
    } else if (message.kind === "StandUp") {
      this.rewind();
    } else {
      return;
    }
    this.show();
  }
}
