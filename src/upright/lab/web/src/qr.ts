// A link as a picture that telephones read (ISO/IEC 18004), black on white in every theme.
import { correction, generate } from "lean-qr";
import { svg } from "./dom";

const QUIET = 4; // modules of white that the standard wants on every side

export function qr(text: string, label: string): SVGSVGElement {
  const code = generate(text, { minCorrectionLevel: correction.M, maxCorrectionLevel: correction.M });
  const size = code.size + 2 * QUIET;
  let d = "";
  for (let y = 0; y < code.size; y += 1) for (let x = 0; x < code.size; x += 1) if (code.get(x, y)) d += `M${x} ${y}h1v1h-1z`;
  return svg("svg", { viewBox: `${-QUIET} ${-QUIET} ${size} ${size}`, class: "qr", role: "img", "aria-label": label },
    svg("rect", { x: -QUIET, y: -QUIET, width: size, height: size, fill: "#ffffff" }),
    svg("path", { d, fill: "#000000", "shape-rendering": "crispEdges" }));
}
