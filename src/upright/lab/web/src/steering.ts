// Arrow keys and a gamepad's stick drive and turn; F and B push for as long as they are held.
import { keptBy } from "./dom";
import { store } from "./store";

const SPEED = 0.25; // [m/s]
const RATE = 1.5; // [rad/s]
const PUSH = 0.12; // weights of the robot
const DEAD = 0.15; // of a stick

export class Steering {
  private held = new Set<string>();
  private last = "";
  private asked = 0;
  private padded = false; // whether a gamepad is what drives

  constructor() {
    window.addEventListener("keydown", (event) => this.down(event));
    window.addEventListener("keyup", (event) => this.up(event));
    window.addEventListener("blur", () => this.release());
  }

  private down(event: KeyboardEvent): void {
    if (event.repeat || keptBy(event, "input, select, textarea, [role=tab], .table, dialog, dialog *")) return;
    if (!/^(Arrow(Up|Down|Left|Right)|f|b)$/.test(event.key)) return;
    event.preventDefault();
    this.held.add(event.key);
    this.push();
    this.steer(...this.keys());
  }

  private up(event: KeyboardEvent): void {
    if (!this.held.delete(event.key)) return;
    this.push();
    this.steer(...this.keys());
  }

  private release(): void {
    if (!this.held.size) return;
    this.held.clear();
    this.push();
    this.steer(0, 0);
  }

  private keys(): [number, number] {
    const key = (name: string) => (this.held.has(name) ? 1 : 0);
    return [SPEED * (key("ArrowUp") - key("ArrowDown")), RATE * (key("ArrowLeft") - key("ArrowRight"))];
  }

  private pushing = false;

  private push(): void {
    const way = (this.held.has("b") ? 1 : 0) - (this.held.has("f") ? 1 : 0);
    if (!way && !this.pushing) return;
    this.pushing = way !== 0;
    const look = store.changed?.look;
    store.push({ kind: "Drag", force: way * PUSH * (look?.weight ?? 6), height: look?.com_height ?? 0.07 });
  }

  private steer(speed: number, rate: number): void {
    const now = `${speed.toFixed(2)} ${rate.toFixed(2)}`;
    if (now === this.last) return;
    this.last = now;
    store.send({ kind: "Steer", speed, rate });
  }

  /** Ask the gamepad, a few times a second. */
  tick(now: number): void {
    if (now - this.asked < 60) return;
    this.asked = now;
    const pad = navigator.getGamepads?.().find((p) => p?.connected);
    if (this.held.size || (!pad && !this.padded)) return;
    this.padded = Boolean(pad); // one that was unplugged lets go
    const live = (axis: number) => {
      const v = pad?.axes[axis] ?? 0;
      return Math.abs(v) < DEAD ? 0 : -v;
    };
    this.steer(SPEED * live(1), RATE * live(0));
  }
}
