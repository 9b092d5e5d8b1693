// Every word of the page: the English ones from texts/en.json, the others from the catalogue of all pages, of which
// lab/typescript.py makes texts/es.json.
import en from "./texts/en.json";
import es from "./texts/es.json";
import type { Language, ErrorParts } from "./messages";

export type Texts = typeof en;
type Plain = { [K in keyof Texts]: Texts[K] extends string ? K : never }[keyof Texts];

export const LANGUAGES: Record<string, Texts> = { en, es };
export const NAMES = [["en", "English"], ["es", "Español"]] as [string, string][]; // each in its own language

let chosen: Texts = en;

export function language(): Language {
  return chosen === es ? "es" : "en";
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
  return filled(chosen[key], values);
}

/** A template, with {names} replaced by values. */
export function filled(template: string, values: Record<string, string | number>): string {
  return template.replace(/\{(\w+)\}/g, (_, name: string) => numeral(String(values[name] ?? "")));
}

/** A text by a key that comes from the server, or the key itself. */
export function named(key: string): string {
  const found = (chosen as unknown as Record<string, unknown>)[key];
  return typeof found === "string" ? found : key;
}

/** Numbers in a text as this language writes them: with its decimal mark. */
export function local(text: string): string {
  return chosen === en ? text : text.replace(/(\d)\.(?=\d)/g, "$1,");
}

/** A number of so many decimals. */
export function fixed(value: number, decimals: number): string {
  return local(value.toFixed(decimals).replace("-", "−"));
}

/** A value that is nothing but a number; names and files keep their dots. */
function numeral(text: string): string {
  return /^[−-]?\d+\.\d+$/.test(text) ? local(text) : text;
}

/** What `say` makes of words, by language. */
export function inEach<T>(say: () => T): Record<string, T> {
  const before = chosen;
  const made = Object.entries(LANGUAGES).map(([key, words]): [string, T] => {
    chosen = words;
    return [key, say()];
  });
  chosen = before;
  return Object.fromEntries(made);
}

/** What was said in each language, in the chosen one. */
export function spoken<T>(each: Record<string, T>): T {
  return each[language()] ?? each.en;
}

/** With a capital. */
export function sentence(words: string): string {
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** An error by its parts, each a sentence. */
export function told(parts: Record<string, ErrorParts>): string {
  const { came, expected, likely, hint } = spoken(parts);
  const ended = /[.!?…]$/.test(came) ? came : `${came}.`;
  return [sentence(ended), expected && t("expected", { what: expected }), likely && t("likely", { what: likely }), hint && t("tryThis", { what: hint })].filter(Boolean).join(" ");
}
