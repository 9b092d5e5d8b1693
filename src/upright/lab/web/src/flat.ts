// The room where there is no WebGL: the robot from its side, drawn as SVG, and pushed by dragging all the same.
import { svg } from "./dom";
import type { Look, Snapshot } from "./messages";
import { laneColour } from "./palette";
import type { Hand, Stage } from "./stage";
import { forceOf } from "./stage";

const FLOOR = 170; // of 200 units of height
const TALL = 110; // units for the robot's height
const WIDE = 600; // units of the floor to either side: a room may be wide

interface Side {
  root: SVGElement;
  body: SVGElement;
  wheel: SVGElement;
}

export class Flat implements Stage {
  readonly element = svg("svg", { viewBox: "-200 0 400 200", class: "room flat", role: "img", tabindex: "0" });
  private sides: Side[] = [];
  private ground = svg("g"); // floor, robots and arrow, which a slope tilts
  private arrow = svg("path", { class: "arrow" });
  private look: Look | null = null;
  private grip: { x: number; height: number } | null = null;

  constructor(private push: (hand: Hand) => void) {
    this.element.addEventListener("pointerdown", (event) => this.down(event));
    this.element.addEventListener("pointermove", (event) => this.moved(event));
    for (const end of ["pointerup", "pointercancel"]) this.element.addEventListener(end, () => this.up());
  }

  furnish(look: Look, bodies: string[]): void {
    this.look = look;
    this.element.replaceChildren(this.ground);
    this.ground.replaceChildren(svg("line", { x1: -WIDE, x2: WIDE, y1: FLOOR, y2: FLOOR, class: "ground" }));
    this.sides = bodies.map((name, i) => this.side(look, name, i > 0)).reverse();
    for (const side of this.sides) this.ground.append(side.root);
    this.sides.reverse();
    this.ground.append(this.arrow);
  }

  private scale(look: Look): number {
    return TALL / (Math.max(look.body_height, look.payload > 0 ? look.payload_height : 0) + look.wheel_radius);
  }

  private side(look: Look, name: string, ghost: boolean): Side {
    const unit = this.scale(look);
    const [R, H, D] = [look.wheel_radius * unit, look.body_height * unit, look.body_depth * unit];
    const style: Record<string, string | number> = ghost ? { fill: "none", stroke: laneColour(name), "stroke-width": 2, opacity: 0.7 } : {};
    const own: Record<string, string> = ghost ? {} : { fill: laneColour(name) };
    const body = svg("g");
    body.append(svg("rect", { x: -D / 2, y: -H - R * 0.25, width: D, height: H, rx: 3, class: ghost ? "" : "shell", ...style, ...own }));
    if (look.payload > 0 && !ghost) {
      const [size, up] = [Math.cbrt(look.payload / 2500) * unit, look.payload_height * unit];
      body.append(svg("path", { d: `M0 0V${-up}`, class: "carrier" }), svg("rect", { x: -size / 2, y: -up - size / 2, width: size, height: size, class: "payload" }));
    }
    const wheel = svg("g");
    wheel.append(svg("circle", { r: R, class: ghost ? "" : "tyre", ...style }), svg("path", { d: `M${-R * 0.6} 0H${R * 0.6}M0 ${-R * 0.6}V${R * 0.6}`, class: ghost ? "" : "spokes", ...style }));
    const root = svg("g");
    root.append(body, wheel);
    return { root, body, wheel };
  }

  move(s: Snapshot): void {
    const look = this.look;
    if (!look || s.x.length !== this.sides.length) return;
    const unit = this.scale(look);
    const degrees = 180 / Math.PI;
    this.ground.setAttribute("transform", `rotate(${-s.f[2] * degrees} 0 ${FLOOR})`);
    this.sides.forEach((side, i) => {
      const [pitch, , wheel] = s.x[i];
      const apart = (wheel - s.x[0][2]) * look.wheel_radius * unit;
      side.root.setAttribute("transform", `translate(${apart} ${FLOOR - look.wheel_radius * unit})`);
      side.body.setAttribute("transform", `rotate(${pitch * degrees})`);
      side.wheel.setAttribute("transform", `rotate(${wheel * degrees})`);
    });
    const [force, height] = s.f;
    const length = (force / look.weight) * 150;
    const [x, y] = [height * Math.sin(s.x[0][0]) * unit, FLOOR - (look.wheel_radius + height * Math.cos(s.x[0][0])) * unit];
    const tip = Math.sign(force) * 7;
    this.arrow.setAttribute("d", Math.abs(force) > 0.005 ? `M${x - length - tip} ${y}H${x}m${-tip} -5L${x} ${y}l${-tip} 5` : "");
  }

  picture(): Promise<Blob | null> {
    return Promise.resolve(new Blob([new XMLSerializer().serializeToString(this.element)], { type: "image/svg+xml" }));
  }

  grasp(): { x: number; y: number } {
    const box = (this.sides[0]?.body.firstElementChild ?? this.element).getBoundingClientRect();
    const whole = this.element.getBoundingClientRect();
    return { x: box.x - whole.x + box.width / 2, y: box.y - whole.y + box.height * 0.4 };
  }

  private down(event: PointerEvent): void {
    const side = this.sides[0];
    if (!this.look || !side?.root.contains(event.target as Node)) return;
    this.element.setPointerCapture(event.pointerId);
    const pixels = this.element.getBoundingClientRect().height / 200;
    const axle = this.element.getBoundingClientRect().y + (FLOOR - this.look.wheel_radius * this.scale(this.look)) * pixels;
    this.grip = { x: event.clientX, height: Math.max(0, (axle - event.clientY) / pixels / this.scale(this.look)) };
    this.push({ force: 0, height: this.grip.height });
  }

  private moved(event: PointerEvent): void {
    if (!this.grip || !this.look) return;
    const unit = (this.scale(this.look) * this.element.getBoundingClientRect().height) / 200;
    this.push({ force: forceOf((event.clientX - this.grip.x) / unit, this.look), height: this.grip.height });
  }

  private up(): void {
    if (!this.grip) return;
    this.grip = null;
    this.push({ force: 0, height: 0 });
  }
}
