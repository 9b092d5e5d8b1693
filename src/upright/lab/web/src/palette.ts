// Okabe and Ito's colours, which colour-blind people tell apart; dashes say the same once more.
const LIGHT: Record<string, string> = {
  twin: "#0072b2", nonlinear: "#d55e00", linear: "#00805c", calibrated: "#a0478a", published: "#6b6b00",
};
const DARK: Record<string, string> = {
  twin: "#56b4e9", nonlinear: "#f2843c", linear: "#2fc79b", calibrated: "#dd93bd", published: "#c9c95a",
};
const DASHES: Record<string, number[]> = { nonlinear: [7, 4], linear: [2, 3], calibrated: [9, 3, 2, 3], published: [12, 5] };

export function dark(): boolean {
  return document.documentElement.dataset.theme === "dark";
}

export function laneColour(name: string): string {
  const shown = name === "nonlinear" && "uprightExport" in globalThis ? "twin" : name; // a page without Python has no twin: its robot is as blue
  return (dark() ? DARK : LIGHT)[shown] ?? "#888888";
}

/** The first body's line is whole. */
export function laneDash(name: string, bodies: string[]): number[] {
  return name === bodies[0] ? [] : (DASHES[name] ?? []);
}

export function ink(): { text: string; soft: string; grid: string; push: string } {
  const style = getComputedStyle(document.documentElement);
  const get = (name: string) => style.getPropertyValue(name).trim();
  return { text: get("--ink"), soft: get("--soft"), grid: get("--grid"), push: get("--push") };
}
