// A link that restores the whole set-up: what differs from the usual one, in the part of the address no server sees.
import { DEFAULT_SETUP } from "./messages";
import type { Setup } from "./messages";

export function toLink(setup: Setup): string {
  const entries = Object.entries(setup).filter(
    ([key, value]) => JSON.stringify(value) !== JSON.stringify(DEFAULT_SETUP[key as keyof Setup]),
  );
  if (!entries.length) return "";
  const text = JSON.stringify(Object.fromEntries(entries));
  const bytes = Array.from(new TextEncoder().encode(text), (b) => String.fromCharCode(b)).join("");
  return "#setup=" + btoa(bytes).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

export function fromLink(hash: string): Setup | null {
  const found = /[#&]setup=([\w-]+)/.exec(hash);
  if (!found) return null;
  try {
    const bytes = Uint8Array.from(atob(found[1].replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));
    const part = JSON.parse(new TextDecoder().decode(bytes)) as Partial<Setup>;
    return { ...DEFAULT_SETUP, ...part };
  } catch {
    return null;
  }
}

export function tokenIn(hash: string): string {
  return /[#&]token=([\w-]+)/.exec(hash)?.[1] ?? "";
}
