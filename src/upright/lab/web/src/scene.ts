// The room: the robot with its shadow, the ghosts of the models beside it, and the hand that pushes.
import {
  AmbientLight, BoxGeometry, CanvasTexture, Color, CylinderGeometry, DirectionalLight, Fog, Group,
  HemisphereLight, Mesh, MeshBasicMaterial, MeshStandardMaterial, PCFSoftShadowMap, PerspectiveCamera, Plane, PlaneGeometry, Raycaster,
  RepeatWrapping, Scene, SRGBColorSpace, Vector2, Vector3, WebGLRenderer,
} from "three";
import type { Material } from "three";
import type { Look, Snapshot } from "./messages";
import { ink, laneColour } from "./palette";
import { forceOf, sizeOf } from "./stage";
import type { Hand, Stage } from "./stage";

const FOLLOWED = 120; // [ms] in which the camera makes up most of what it is behind
const CELL = 0.1; // [m] of the floor's grid
const REPEAT = 60;
const PICTURE = 1920; // [pixels] of the width of a picture that is kept

/** How far a ghost stands beside the robot [m]: in a row behind it, away from where the camera is at first. */
function ghostPlace(index: number, track: number): number {
  return -index * track * 1.55;
}

/** One robot: yaw round its axle's middle, body pitching, wheels rolling. */
class Figure {
  root = new Group();
  body = new Group();
  wheels: [Group, Group] = [new Group(), new Group()];
  x = 0;
  z = 0;
  private last: number | null = null;

  /** In the colour of its traces; what is not the first body is a ghost. */
  constructor(private look: Look, private own: string, ghost: boolean) {
    const solid = (colour: string, roughness = 0.7, metalness = 0) => {
      const made = new MeshStandardMaterial({ color: colour, roughness, metalness });
      if (ghost) {
        made.color.set(own);
        made.transparent = true;
        made.opacity = 0.3;
      }
      return made;
    };
    this.build(solid, !ghost);
    this.root.add(this.body, ...this.wheels);
    this.body.position.y = look.wheel_radius;
    this.root.traverse((part) => {
      if (part instanceof Mesh) {
        part.castShadow = part.receiveShadow = !ghost;
      }
    });
  }

  private build(solid: (colour: string, roughness?: number, metalness?: number) => Material, full: boolean): void {
    const { wheel_radius: R, track: W, body_height: H, body_depth: D } = this.look;
    const wide = Math.max(W * 0.62, 0.02);
    const base = R * 0.25;
    const part = (w: number, h: number, d: number, material: Material, x: number, y: number, z: number) => {
      const mesh = new Mesh(new BoxGeometry(d, h, w), material);
      mesh.position.set(x, y, z);
      this.body.add(mesh);
    };
    const shell = solid(this.own, 0.55);
    part(wide, H * 0.94, D, shell, 0, base + H * 0.5, 0);
    if (full) part(W * 0.8, R * 0.5, D * 0.55, solid("#3b424a", 0.6), 0, 0, 0);
    if (full && this.look.command_unit !== "V") {
      for (const up of [0.22, 0.5, 0.78]) part(wide * 1.01, H * 0.03, D * 1.02, solid("#20262c", 0.6), 0, base + H * up, 0); // shelves
    } else if (full) { // a brick with screen and buttons
      part(wide * 0.72, H * 0.26, D * 0.04, solid("#20262c", 0.25), D * 0.5, base + H * 0.72, 0);
      part(wide * 0.62, H * 0.18, D * 0.05, solid("#b9d8c4", 0.3), D * 0.505, base + H * 0.73, 0);
      part(wide * 0.16, H * 0.08, D * 0.08, solid("#f4f5f6", 0.5), D * 0.5, base + H * 0.42, 0);
      for (const side of [-1, 1]) part(wide * 0.14, H * 0.06, D * 0.07, solid("#8b949d", 0.5), D * 0.5, base + H * 0.42, side * wide * 0.22);
    }
    if (this.look.payload > 0 && full) {
      const side = Math.cbrt(this.look.payload / 2500);
      const mast = this.look.payload_height - side / 2 - base;
      if (mast > 0) part(0.008, mast, 0.008, solid("#5c656e", 0.6), 0, base + mast / 2, 0);
      part(side, side, side, solid("#8c5a2b", 0.8), 0, this.look.payload_height, 0);
    }
    this.wheels.forEach((wheel, i) => this.tyre(wheel, i === 0 ? -W / 2 : W / 2, solid, full));
  }

  private tyre(wheel: Group, z: number, solid: (c: string, r?: number, m?: number) => Material, full: boolean): void {
    const R = this.look.wheel_radius;
    const wide = Math.min(this.look.track * 0.16, R * 0.7);
    const tyre = new Mesh(new CylinderGeometry(R, R, wide, 40), solid("#23272c", 0.95));
    const rim = new Mesh(new CylinderGeometry(R * 0.66, R * 0.66, wide * 1.04, 32), solid("#c9ced3", 0.45, 0.1));
    tyre.rotation.x = rim.rotation.x = Math.PI / 2;
    wheel.add(tyre);
    if (full) wheel.add(rim);
    for (let i = 0; full && i < 3; i += 1) {
      const spoke = new Mesh(new BoxGeometry(R * 1.2, R * 0.13, wide * 1.1), solid("#5c656e", 0.6));
      spoke.rotation.z = (i * Math.PI) / 3;
      wheel.add(spoke);
    }
    wheel.position.set(0, R, z);
  }

  /** Move to a row of a snapshot: ψ, ψ̇, θ, θ̇, φ, φ̇, … */
  move(row: number[], aside: number): void {
    const { wheel_radius: R, track: W } = this.look;
    const [pitch, , wheel, , yaw] = row;
    if (this.last !== null) {
      const way = R * (wheel - this.last);
      this.x += way * Math.cos(yaw);
      this.z -= way * Math.sin(yaw);
    }
    this.last = wheel;
    this.root.rotation.y = yaw;
    this.root.position.set(this.x + aside * Math.sin(yaw), 0, this.z + aside * Math.cos(yaw));
    this.body.rotation.z = -pitch;
    const turn = (W / (2 * R)) * yaw;
    this.wheels[0].rotation.z = -(wheel - turn);
    this.wheels[1].rotation.z = -(wheel + turn);
  }

  shift(dx: number, dz: number): void {
    this.x += dx;
    this.z += dz;
  }

  start(from: Figure | undefined): void {
    if (from) [this.x, this.z, this.last] = [from.x, from.z, from.last];
  }
}

function grid(dark: boolean): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 128;
  const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
  pen.fillStyle = dark ? "#252b32" : "#eeeeec";
  pen.fillRect(0, 0, 128, 128);
  pen.strokeStyle = dark ? "#39424b" : "#cfd1d2";
  pen.lineWidth = 2;
  pen.strokeRect(0, 0, 128, 128);
  const texture = new CanvasTexture(canvas);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.repeat.set(REPEAT, REPEAT);
  texture.anisotropy = 8;
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

export class Room implements Stage {
  private renderer: WebGLRenderer;
  private scene = new Scene();
  private camera = new PerspectiveCamera(32, 1, 0.02, 30);
  private sun = new DirectionalLight("#fffdf8", 2.4);
  private sky = new HemisphereLight("#ffffff", "#c4c6c8", 1.1);
  private floor: Mesh<PlaneGeometry, MeshStandardMaterial>;
  private ground = new Group(); // floor, robots and arrow: a slope tilts them all, since ψ counts from the floor's normal
  private figures: Figure[] = [];
  private bodies: string[] = [];
  private look: Look | null = null;
  private arrow = new Group(); // along y: a shaft of length 1 below a head
  private shaft: Mesh;
  private head: Mesh;
  private ink = new MeshBasicMaterial(); // of the arrow
  private eye = { azimuth: 0.5, height: 0.26, away: 1 };
  private grip: { at: Vector3; mouse: Vector2; height: number } | null = null; // `at` on the body, in its own axes
  private turning: { x: number; y: number } | null = null;
  private centre = new Vector3();
  private calm = matchMedia("(prefers-reduced-motion: reduce)");
  private slow = 0;
  private detail = 1;
  private seen = -1;
  private stale = true; // something has moved since the last drawing

  readonly element: HTMLCanvasElement;

  constructor(private canvas: HTMLCanvasElement, private push: (hand: Hand) => void) {
    this.element = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFSoftShadowMap;
    this.floor = new Mesh(new PlaneGeometry(REPEAT * CELL, REPEAT * CELL), new MeshStandardMaterial({ roughness: 0.95 }));
    this.floor.rotation.x = -Math.PI / 2;
    this.floor.receiveShadow = true;
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.radius = 6;
    this.sun.shadow.bias = -0.0005;
    this.shaft = new Mesh(new CylinderGeometry(1, 1, 1, 16), this.ink);
    this.head = new Mesh(new CylinderGeometry(0, 1, 1, 24), this.ink);
    this.arrow.add(this.shaft, this.head);
    this.arrow.visible = false;
    this.ground.add(this.floor, this.arrow);
    this.scene.add(this.ground, this.sky, this.sun, this.sun.target, new AmbientLight("#ffffff", 0.35));
    this.paint();
    this.listen();
  }

  /** The colours of the theme that is on. */
  paint(): void {
    const dark = document.documentElement.dataset.theme === "dark";
    this.ink.color.set(ink().push);
    const air = new Color(dark ? "#1b2026" : "#f4f3ef");
    this.scene.background = air;
    this.scene.fog = new Fog(air, 1.2 * this.size() + 1.2, 3 * this.size() + 2.2);
    this.floor.material.map = grid(dark);
    this.floor.material.needsUpdate = true;
    this.sun.intensity = dark ? 1.7 : 1.9;
    this.stale = true;
    this.sky.intensity = dark ? 0.7 : 1.0;
    const [look, bodies] = [this.look, this.bodies];
    if (look) this.furnish(look, bodies);
  }

  /** Other robots, or another look of them; where they stand is kept. */
  furnish(look: Look, bodies: string[]): void {
    const old = new Map(this.bodies.map((name, i) => [name, this.figures[i]]));
    for (const figure of this.figures) this.ground.remove(figure.root);
    const fresh = this.look === null;
    this.look = look;
    this.bodies = bodies;
    this.seen = -1;
    this.stale = true;
    this.figures = bodies.map((name, i) => new Figure(look, laneColour(name), i > 0));
    this.figures.forEach((figure, i) => figure.start(old.get(bodies[i])));
    for (const figure of this.figures) this.ground.add(figure.root);
    const size = this.size();
    const reach = size * 2.2;
    Object.assign(this.sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 0.01, far: size * 12 });
    this.sun.shadow.camera.updateProjectionMatrix();
    if (fresh) this.paint();
  }

  private size(): number {
    return this.look ? Math.max(sizeOf(this.look), this.look.payload > 0 ? 1.1 * (this.look.payload_height + this.look.wheel_radius) : 0) : 0.25;
  }

  move(s: Snapshot): void {
    if (!this.look || s.x.length !== this.figures.length || s.n === this.seen) return;
    this.seen = s.n;
    this.stale = true;
    const width = this.look.track;
    this.ground.rotation.z = s.f[2];
    this.figures.forEach((figure, i) => figure.move(s.x[i], ghostPlace(i, width)));
    const main = this.figures[0];
    if (Math.hypot(main.x, main.z) > 3) {
      const cells = (v: number) => -Math.round(v / CELL) * CELL; // whole cells, so that the floor does not jump
      const [dx, dz] = [cells(main.x), cells(main.z)];
      for (const figure of this.figures) figure.shift(dx, dz);
      this.centre.add(new Vector3(dx, 0, dz));
    }
    this.show(s.f[0], s.f[1], s.x[0][0], s.x[0][4]);
  }

  private show(force: number, height: number, pitch: number, yaw: number): void {
    const look = this.look as Look;
    const main = this.figures[0].root.position;
    this.arrow.visible = Math.abs(force) > 0.005;
    if (!this.arrow.visible) return;
    const length = Math.min(0.04 + (Math.abs(force) / look.weight) * this.size() * 1.2, this.size() * 1.6);
    const heading = new Vector3(Math.cos(yaw), 0, -Math.sin(yaw)).multiplyScalar(Math.sign(force));
    const lean = height * Math.sin(pitch);
    const at = new Vector3(main.x + lean * Math.cos(yaw), look.wheel_radius + height * Math.cos(pitch), main.z - lean * Math.sin(yaw));
    const surface = look.body_depth / 2 + 0.004;
    this.arrow.position.copy(at).addScaledVector(heading, -length - surface);
    this.arrow.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), heading);
    const [thick, tip] = [this.size() * 0.014, Math.min(length * 0.6, this.size() * 0.13)];
    this.shaft.scale.set(thick, length - tip, thick);
    this.shaft.position.y = (length - tip) / 2;
    this.head.scale.set(3 * thick, tip, 3 * thick);
    this.head.position.y = length - tip / 2;
  }

  /** Draw; `elapsed` [ms] since the last time tells whether this machine needs fewer pixels. */
  draw(elapsed: number): void {
    const { clientWidth: w, clientHeight: h } = this.canvas;
    if (!w || !h) return;
    this.pace(elapsed);
    const ratio = Math.min(devicePixelRatio, 2) * this.detail;
    const buffer = this.renderer.getDrawingBufferSize(new Vector2());
    if (Math.abs(buffer.x - w * ratio) > 1 || Math.abs(buffer.y - h * ratio) > 1) {
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(w, h, false);
      this.camera.aspect = w / h;
      this.camera.updateProjectionMatrix();
      this.stale = true;
    }
    if (!this.stale) return;
    this.stale = this.follow(elapsed);
    this.pull();
    this.renderer.render(this.scene, this.camera);
  }

  private pace(elapsed: number): void {
    this.slow = elapsed > 45 ? this.slow + 1 : Math.max(0, this.slow - 0.5);
    if (this.slow > 40 && this.detail > 0.8) {
      this.detail *= 0.75;
      this.slow = 0;
    }
  }

  /** Point camera and sun at the robot; whether they are still on their way. */
  private follow(elapsed: number): boolean {
    const main = this.figures[0];
    const size = this.size();
    if (main) this.centre.lerp(new Vector3(main.x, 0, main.z), this.calm.matches ? 1 : 1 - Math.exp(-elapsed / FOLLOWED));
    const portrait = this.camera.aspect < 1 ? 1.25 : 1;
    const away = size * 3.5 * this.eye.away * portrait;
    const { azimuth, height } = this.eye;
    const flat = away * Math.cos(height);
    this.ground.updateMatrixWorld();
    const at = this.ground.localToWorld(this.centre.clone());
    const target = at.clone().setY(at.y + size * 0.42);
    this.camera.position.set(target.x + flat * Math.sin(azimuth), target.y + away * Math.sin(height), target.z + flat * Math.cos(azimuth));
    this.camera.lookAt(target);
    this.sun.position.set(at.x - size * 2, at.y + size * 5, at.z + size * 2.4);
    this.sun.target.position.copy(at);
    const cell = (v: number) => Math.round(v / CELL) * CELL;
    this.floor.position.set(cell(this.centre.x), 0, cell(this.centre.z));
    return main ? Math.hypot(main.x - this.centre.x, main.z - this.centre.z) > 1e-3 : false;
  }

  /** A picture of what is seen, as PNG: large enough to be shown, with a line of words below it. */
  picture(words: string): Promise<Blob | null> {
    const { clientWidth: w, clientHeight: h } = this.canvas;
    this.renderer.setPixelRatio(PICTURE / w);
    this.renderer.setSize(w, h, false);
    this.renderer.render(this.scene, this.camera);
    const { width, height } = this.canvas;
    const [whole, line] = [document.createElement("canvas"), Math.round(PICTURE / 28)];
    Object.assign(whole, { width, height: height + line });
    const pen = whole.getContext("2d") as CanvasRenderingContext2D;
    const style = getComputedStyle(document.documentElement);
    pen.fillStyle = style.getPropertyValue("--card");
    pen.fillRect(0, 0, width, height + line);
    pen.drawImage(this.canvas, 0, 0);
    Object.assign(pen, { fillStyle: style.getPropertyValue("--ink"), font: `${0.45 * line}px system-ui, sans-serif`, textBaseline: "middle" });
    pen.fillText(words, 0.4 * line, height + line / 2, width - 0.8 * line);
    this.stale = true;
    this.draw(0); // as it was
    return new Promise((done) => whole.toBlob(done));
  }

  turn(azimuth: number, height: number): void {
    this.stale = true;
    this.eye.azimuth += azimuth;
    this.eye.height = Math.min(1.2, Math.max(0.03, this.eye.height + height));
  }

  zoom(factor: number): void {
    this.stale = true;
    this.eye.away = Math.min(3, Math.max(0.45, this.eye.away * factor));
  }

  /** Where the middle of the robot's body is on the canvas [CSS pixels], for whoever wants to grasp it. */
  grasp(): { x: number; y: number } {
    const look = this.look;
    if (!look) return { x: 0, y: 0 };
    const at = this.figures[0].body.localToWorld(new Vector3(0, look.body_height * 0.6, 0)).project(this.camera);
    return { x: ((at.x + 1) / 2) * this.canvas.clientWidth, y: ((1 - at.y) / 2) * this.canvas.clientHeight };
  }

  /** Where the pointer is, from −1 to 1. */
  private pointer(event: PointerEvent): Vector2 {
    const box = this.canvas.getBoundingClientRect();
    return new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
  }

  private ray(at: Vector2): Raycaster {
    const caster = new Raycaster();
    caster.setFromCamera(at, this.camera);
    return caster;
  }

  private listen(): void {
    this.canvas.addEventListener("pointerdown", (event) => this.down(event));
    this.canvas.addEventListener("pointermove", (event) => this.moved(event));
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) this.canvas.addEventListener(end, () => this.up());
    this.canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY / 900));
    }, { passive: false });
  }

  private down(event: PointerEvent): void {
    if (!this.look || !this.figures.length) return;
    this.canvas.setPointerCapture(event.pointerId);
    const mouse = this.pointer(event);
    const hit = this.ray(mouse).intersectObject(this.figures[0].root, true)[0];
    if (!hit) {
      this.turning = { x: event.clientX, y: event.clientY };
      return;
    }
    const at = this.figures[0].body.worldToLocal(hit.point.clone());
    this.grip = { at, mouse, height: Math.max(0, at.y) };
    this.pull();
    this.canvas.classList.add("holding");
  }

  private moved(event: PointerEvent): void {
    if (this.turning) {
      this.turn((this.turning.x - event.clientX) / 160, (event.clientY - this.turning.y) / 260);
      this.turning = { x: event.clientX, y: event.clientY };
    }
    if (!this.grip) return;
    this.grip.mouse = this.pointer(event);
    this.pull();
  }

  /** A rubber band from where the robot was grasped to where the mouse is now. */
  private pull(): void {
    const [grip, look] = [this.grip, this.look];
    if (!grip || !look) return;
    const figure = this.figures[0];
    const held = figure.body.localToWorld(grip.at.clone());
    const toEye = this.camera.position.clone().sub(held).setY(0).normalize();
    const plane = new Plane().setFromNormalAndCoplanarPoint(toEye, held);
    const mouse = this.ray(grip.mouse).ray.intersectPlane(plane, new Vector3());
    if (!mouse) return;
    const yaw = figure.root.rotation.y;
    const along = mouse.sub(held).dot(new Vector3(Math.cos(yaw), 0, -Math.sin(yaw)).applyQuaternion(this.ground.quaternion));
    this.push({ force: forceOf(along, look), height: grip.height });
  }

  private up(): void {
    this.turning = null;
    if (!this.grip) return;
    this.grip = null;
    this.canvas.classList.remove("holding");
    this.push({ force: 0, height: 0 });
  }
}
