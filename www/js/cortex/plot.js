// Cortical magnification against eccentricity, on logarithmic axes.

import { pathData, svg } from "../common/svg.js";
import { eccentricities, HIGHEST_E, LOWEST_E } from "./plot-range.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {{ kind: string, name: string, magnification: ArrayLike<number> }} Curve its style; in mm a degree at `eccentricities` */

const [WIDTH, HEIGHT, LEFT, BOTTOM, MARGIN] = [560, 330, 52, 46, 14];
const [LOWEST_M, HIGHEST_M] = [0.03, 40];
/** Lines with a number, and those without. */
const NAMED_E = [0.1, 0.3, 1, 3, 10, 30, 90];
const NAMED_M = [0.03, 0.1, 0.3, 1, 3, 10, 30];

/** The published curve of Horton and Hoyt (1991), in mm a degree. */
export const hortonHoyt = eccentricities.map((e) => 17.3 / (e + 0.75));

/** @param {number} eccentricity @param {number} magnification @returns {Point} */
function place(eccentricity, magnification) {
  const x = Math.log(eccentricity / LOWEST_E) / Math.log(HIGHEST_E / LOWEST_E);
  const y = Math.log(magnification / LOWEST_M) / Math.log(HIGHEST_M / LOWEST_M);
  return [LEFT + x * (WIDTH - LEFT - MARGIN), HEIGHT - BOTTOM - y * (HEIGHT - BOTTOM - MARGIN)];
}

/** @param {SVGSVGElement} root @param {Curve[]} curves */
export function plotMagnification(root, curves) {
  root.setAttribute("viewBox", `0 0 ${WIDTH} ${HEIGHT}`);
  root.replaceChildren(
    ...NAMED_E.flatMap((e) => tick(`${e}°`, place(e, LOWEST_M), place(e, HIGHEST_M), "middle")),
    ...NAMED_M.flatMap((m) => tick(String(m), place(LOWEST_E, m), place(HIGHEST_E, m), "end")),
    label("distance from the fixation point", { x: (LEFT + WIDTH - MARGIN) / 2, y: HEIGHT - 6, "text-anchor": "middle" }),
    label("mm of cortex a degree", { x: 0, y: 0, "text-anchor": "middle", transform: `translate(12 ${(HEIGHT - BOTTOM + MARGIN) / 2}) rotate(-90)` }),
    ...curves.map(({ kind, magnification }) => {
      const points = eccentricities.flatMap((e, k) => (magnification[k] > LOWEST_M ? [place(e, magnification[k])] : []));
      return svg("path", { class: `curve ${kind}`, d: pathData(points, false) });
    }),
    ...curves.flatMap(({ kind, name }, k) => {
      const [x, y] = [LEFT + 14, HEIGHT - BOTTOM - 16 - 20 * (curves.length - 1 - k)];
      return [svg("path", { class: `curve ${kind}`, d: `M${x} ${y}h26` }), label(name, { x: x + 34, y: y + 4, class: "key" })];
    }),
  );
}

/** @param {string} words @param {Record<string, string | number>} attributes */
function label(words, attributes) {
  const text = svg("text", attributes);
  text.textContent = words;
  return text;
}

/** @param {string} name @param {Point} from @param {Point} to @param {"middle" | "end"} anchor */
function tick(name, from, to, anchor) {
  const [dx, dy] = anchor === "middle" ? [0, 18] : [-7, 4];
  return [svg("path", { class: "tick", d: pathData([from, to], false) }), label(name, { x: from[0] + dx, y: from[1] + dy, "text-anchor": anchor })];
}
