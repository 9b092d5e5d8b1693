// Every word of the page, from one file for each language.
import en from "./texts/en.json";
import es from "./texts/es.json";

export type Texts = typeof en;
type Plain = { [K in keyof Texts]: Texts[K] extends string ? K : never }[keyof Texts];

export const LANGUAGES: Record<string, Texts> = { en, es };

let chosen: Texts = en;

export function language(): string {
  return Object.keys(LANGUAGES).find((key) => LANGUAGES[key] === chosen) ?? "en";
}

export function choose(key: string): void {
  chosen = LANGUAGES[key] ?? en;
  document.documentElement.lang = language();
  document.title = chosen.title;
}

export function texts(): Texts {
  return chosen;
}

/** A text, with {names} replaced by values. */
export function t(key: Plain, values: Record<string, string | number> = {}): string {
  return chosen[key].replace(/\{(\w+)\}/g, (_, name: string) => String(values[name] ?? ""));
}

/** A text by a key that comes from the server, or the key itself. */
export function named(key: string): string {
  const found = (chosen as unknown as Record<string, unknown>)[key];
  return typeof found === "string" ? found : key;
}
