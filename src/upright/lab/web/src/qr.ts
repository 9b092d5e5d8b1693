// A link as a picture that telephones read (ISO/IEC 18004), black on white in every theme.
import { correction, generate } from "lean-qr";

const SVG = "http://www.w3.org/2000/svg";
const QUIET = 4; // modules of white that the standard wants on every side

export function qr(text: string, label: string): SVGSVGElement {
  const code = generate(text, { minCorrectionLevel: correction.M, maxCorrectionLevel: correction.M });
  const svg = document.createElementNS(SVG, "svg");
  const size = code.size + 2 * QUIET;
  svg.setAttribute("viewBox", `${-QUIET} ${-QUIET} ${size} ${size}`);
  svg.setAttribute("class", "qr");
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", label);
  const ground = document.createElementNS(SVG, "rect");
  for (const [name, value] of Object.entries({ x: -QUIET, y: -QUIET, width: size, height: size, fill: "#ffffff" })) ground.setAttribute(name, String(value));
  const black = document.createElementNS(SVG, "path");
  let d = "";
  for (let y = 0; y < code.size; y += 1) for (let x = 0; x < code.size; x += 1) if (code.get(x, y)) d += `M${x} ${y}h1v1h-1z`;
  black.setAttribute("d", d);
  black.setAttribute("fill", "#000000");
  black.setAttribute("shape-rendering", "crispEdges");
  svg.append(ground, black);
  return svg;
}
