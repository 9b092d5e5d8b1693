// Every word of the page, from one file for each language.
import en from "./texts/en.json";
import es from "./texts/es.json";
import phrases from "./texts/phrases.es.json";

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
  return chosen[key].replace(/\{(\w+)\}/g, (_, name: string) => numeral(String(values[name] ?? "")));
}

/** A text by a key that comes from the server, or the key itself. */
export function named(key: string): string {
  const found = (chosen as unknown as Record<string, unknown>)[key];
  return typeof found === "string" ? found : key;
}

/** Numbers in a text as this language writes them: with its decimal mark. */
export function local(text: string): string {
  return chosen.decimal === "." ? text : text.replace(/(\d)\.(?=\d)/g, `$1${chosen.decimal}`);
}

/** A number of so many decimals. */
export function fixed(value: number, decimals: number): string {
  return local(value.toFixed(decimals).replace("-", "−"));
}

/** A value that is nothing but a number; names and files keep their dots. */
function numeral(text: string): string {
  return /^[−-]?\d+\.\d+$/.test(text) ? local(text) : text;
}

const escaped = (text: string) => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
/** How many letters of a pattern are its own. */
const fixedPart = (pattern: string) => pattern.replace(/\{\d\}/g, "").length;
/** Those with most words of their own come first, so that "{0} by {1}" takes no longer sentence apart.
 *  What stands for a part is as short as it can be, but before " at ", since the name of a push has an "at" of its own. */
const PHRASES = [...phrases].sort(([a], [b]) => fixedPart(b) - fixedPart(a)).map(([english, spanish]): [RegExp, string] =>
  [new RegExp(`^${escaped(english).replace(/\\\{\d\\\}(?= at )/g, "(.+)").replace(/\\\{\d\\\}/g, "(.+?)")}$`, "s"), spanish]);

/** A sentence of the server in the chosen language, part by part; what has no translation stays as it is. */
export function translate(text: string): string {
  if (chosen === en) return text;
  for (const [pattern, words] of PHRASES) {
    const parts = pattern.exec(text);
    if (parts) return words.replace(/\{(\d)\}/g, (_, i: string) => listed(parts[Number(i) + 1]));
  }
  return local(text);
}

/** A part of a sentence: what it lists one by one, where each has a translation of its own. */
function listed(text: string): string {
  const parts = text.split(/, | and /).map((part) => part.replaceAll("_", " "));
  if (!parts.every((part) => translated(part) || /^[\d.…]+$/.test(part))) return translate(text);
  const last = text.includes(" and ") ? parts.pop() : undefined;
  return [parts.map(translate).join(", "), ...(last === undefined ? [] : [translate(last)])].join(" y ");
}

/** Whether the chosen language has words for a sentence of the server. */
export function translated(text: string): boolean {
  return chosen === en || PHRASES.some(([pattern]) => pattern.test(text));
}

/** What stopped a job, with its name, in the chosen language. */
export function stopped(job: string, text: string): string {
  const why = noticed(text);
  return t("jobStopped", { job: named(job), why: /[.!?…]$/.test(why) ? why : `${why}.` });
}

/** A notice of the server in the chosen language, or as it is, with a word on that. */
export function noticed(text: string): string {
  return translated(text) ? translate(text) : t("original", { text });
}
