// Small helpers round the DOM; text goes in as text, never as markup.
import { local } from "./texts";

type Child = Node | string | null | undefined | false;
type Props = Record<string, unknown>;

type Tags = HTMLElementTagNameMap;

/** An element of a tag with classes ("p.note"), with properties (`on…` are listeners, `aria-…` and `data-…` attributes) and
 * children. */
export function h<K extends keyof Tags>(kind: K | `${K}.${string}`, first?: Props | Child, ...rest: Child[]): Tags[K] {
  const [tag, ...classes] = kind.split(".");
  const element = document.createElement(tag) as Tags[K];
  if (classes.length) element.className = classes.join(" ");
  const bare = !first || typeof first === "string" || first instanceof Node;
  for (const [name, value] of Object.entries(bare ? {} : first)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value as EventListener);
    else if (name.includes("-") || name === "role" || name === "for" || name === "list") element.setAttribute(name, String(value));
    else if (value !== undefined) (element as unknown as Props)[name] = value;
  }
  element.append(...shown(bare ? [first, ...rest] : rest));
  return element;
}

function shown(children: Child[]): (Node | string)[] {
  return children.filter((child): child is Node | string => Boolean(child));
}

/** An element of a drawing. */
export function svg<K extends keyof SVGElementTagNameMap>(tag: K, attributes: Record<string, string | number> = {}, ...children: Node[]): SVGElementTagNameMap[K] {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

export function replace(parent: Element, ...children: Child[]): void {
  keepingFocus(() => parent.replaceChildren(...shown(children)));
}

/** Exchange what stands in a place; what is awaited there takes the room of what was before, so that nothing moves. */
export function exchange(place: HTMLElement, awaited: boolean, ...children: Child[]): void {
  place.style.minHeight = awaited ? `${place.getBoundingClientRect().height}px` : "";
  replace(place, awaited && h("div"), ...children); // an empty place would not be shown
}

/** Do what exchanges elements; where the one with the focus goes, the new one with its key gets it. */
export function keepingFocus(act: () => void): void {
  const key = (document.activeElement as HTMLElement | null)?.dataset?.key;
  act();
  if (key && document.activeElement === document.body) document.querySelector<HTMLElement>(`[data-key="${key}"]`)?.focus({ preventScroll: true });
}

const sayings = new WeakMap<Element, () => string>();

/** Words that follow the language for as long as they stand on the page. */
export function said(words: () => string): HTMLElement {
  const element = h("span.said", words());
  sayings.set(element, words);
  return element;
}

/** Say in the chosen language what stands there. */
export function sayAgain(root: ParentNode): void {
  for (const element of root.querySelectorAll(".said")) element.textContent = sayings.get(element)?.() ?? "";
}

export function button(text: string, act: () => void, key: string, props: Props = {}): HTMLButtonElement {
  return h("button", { type: "button", onclick: act, "data-key": key, ...props }, text);
}

/** Whether a key is the browser's, or of what has the focus and matches the selector, also in the page of a result. */
export function keptBy(event: KeyboardEvent, selector: string): boolean {
  return event.ctrlKey || event.metaKey || event.altKey || (event.composedPath()[0] as Element).matches(selector);
}

let counter = 0;
export function fresh(prefix: string): string {
  counter += 1;
  return `${prefix}-${counter}`;
}

/** A field for a number, with a decimal point or a comma; what is no number is marked and changes nothing. */
export function numberField(act: (value: number) => void, attributes: Record<string, unknown>): { root: HTMLInputElement; set(value: number): void } {
  const input = h("input", { type: "text", inputMode: "decimal", autocomplete: "off", className: "number", ...attributes, onchange: () => {
    const text = input.value.trim().replace("−", "-").replace(",", ".");
    const fine = text !== "" && Number.isFinite(Number(text));
    input.setAttribute("aria-invalid", String(!fine));
    if (!fine) return;
    write(Number(text));
    act(Number(text));
  } });
  const write = (value: number) => (input.value = local(String(value).replace("-", "−")));
  return { root: input, set: (value) => {
    if (document.activeElement === input) return;
    write(value);
    input.removeAttribute("aria-invalid");
  } };
}

export interface Slider {
  root: HTMLElement;
  set(value: number): void;
}

/** From where to where a slider goes, in which steps, and its value in words; where that is `typed`, it is a field before
 * this unit. */
export interface Range {
  low: number;
  high: number;
  step?: number;
  log?: boolean;
  show: (value: number) => string;
  typed?: string;
  key?: string;
}

/** A labelled slider that says its value with its unit, linear or logarithmic. */
export function slider(label: string, options: Range, act: (value: number) => void): Slider {
  const id = fresh("slider");
  const to = (v: number) => (options.log ? Math.log(v) : v);
  const from = (v: number) => (options.log ? Math.exp(v) : v);
  const span = to(options.high) - to(options.low);
  const input = h("input", {
    type: "range", id, min: String(to(options.low)), max: String(to(options.high)),
    step: String(options.step ?? span / 200), "data-key": options.key ?? "",
  });
  const whole = (value: number) => (!options.log && Math.abs(value) < 1e-6 * span ? 0 : value); // steps do not add up to 0
  const field = options.typed === undefined ? null : numberField((value) => {
    input.value = String(to(value));
    input.setAttribute("aria-valuetext", options.show(value));
    act(value);
  }, { "aria-label": label, "data-key": `${options.key ?? ""}-typed` });
  const output = field ? h("span.typed", field.root, ` ${options.typed}`) : h("output", { "for": id });
  const say = (value: number) => {
    if (field) field.set(Number(value.toPrecision(4)));
    else output.textContent = options.show(value);
    input.setAttribute("aria-valuetext", options.show(value));
  };
  input.addEventListener("input", () => {
    const value = whole(from(Number(input.value)));
    say(value);
    act(value);
  });
  const set = (value: number) => {
    if (document.activeElement !== input) input.value = String(to(Math.max(value, options.log ? options.low : -Infinity)));
    say(value);
  };
  return { root: h("div.slider", h("label", { "for": id }, label), output, input), set };
}

export function select(label: string, choices: [string, string][], value: string, act: (v: string) => void, key = ""): HTMLElement {
  const id = fresh("select");
  const box = h(
    "select",
    { id, "data-key": key, onchange: () => act(box.value) },
    ...choices.map(([v, text]) => h("option", { value: v, selected: v === value }, text)),
  );
  return h("div.choice", h("label", { "for": id }, label), box);
}

/** Follow the session in a select or a field, unless it has the focus. */
export function follow(root: ParentNode, key: string, value: string): void {
  const field = root.querySelector<HTMLSelectElement>(`[data-key=${key}]`);
  if (field && document.activeElement !== field) field.value = value;
}

export function digits(value: number, count = 3): string {
  if (!Number.isFinite(value)) return "∞";
  return local(plainNumbers(String(Number(value.toPrecision(count)))));
}

/** An angle of so many radians, as people say it. */
export function degrees(angle: number): string {
  return `${local(plainNumbers(String(Number(((angle * 180) / Math.PI).toFixed(1)))))}°`;
}

/** Numbers as people write them: −4.2 ×10⁻⁵ for -4.2e-05, which would break at its hyphens. */
export function plainNumbers(text: string): string {
  const raised = (sign: string, power: string) => `\u202f×10${sign === "-" ? "⁻" : ""}${power.replace(/\d/g, (d) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(d)])}`;
  return text.replace(/(?<=\d)e([+-]?)0*(\d+)\b/g, (_, sign: string, power: string) => raised(sign, power)).replace(/(?<=^|[\s(…])-(?=\.?\d)/g, "−");
}

export function table(header: string[], rows: string[][], className = ""): HTMLElement {
  const head = header.length ? h("thead", h("tr", ...header.map((text) => h("th", { scope: "col" }, text)))) : null;
  const body = h("tbody", ...rows.map((row) => h("tr", ...row.map((text) => h("td", text)))));
  return h("div.table", { tabIndex: 0, "data-key": className && `table-${className}` }, h("table", { className }, head, body));
}

/** At most one call each `wait` ms, the last one always. */
export function throttled<A extends unknown[]>(wait: number, act: (...args: A) => void): (...args: A) => void {
  let timer = 0;
  let last: A | null = null;
  return (...args) => {
    last = args;
    if (timer) return;
    act(...args);
    last = null;
    timer = window.setTimeout(function again() {
      timer = 0;
      if (last) {
        const pending = last;
        last = null;
        act(...pending);
        timer = window.setTimeout(again, wait);
      }
    }, wait);
  };
}
