// Cortical magnification against eccentricity, on logarithmic axes.

import { pathData, svg } from "../common/svg.js";

/** @typedef {import("../common/frame.js").Point} Point */

const [WIDTH, HEIGHT, LEFT, BOTTOM, MARGIN] = [420, 190, 46, 34, 10];
const [LOWEST_E, HIGHEST_E] = [0.1, 90];
const [LOWEST_M, HIGHEST_M] = [0.02, 40];

/** Eccentricities at which the curve is drawn. */
export const eccentricities = Array.from({ length: 80 }, (_, k) => LOWEST_E * (HIGHEST_E / LOWEST_E) ** (k / 79));

/** @param {number} eccentricity @param {number} magnification @returns {Point} */
function place(eccentricity, magnification) {
  const x = Math.log(eccentricity / LOWEST_E) / Math.log(HIGHEST_E / LOWEST_E);
  const y = Math.log(magnification / LOWEST_M) / Math.log(HIGHEST_M / LOWEST_M);
  return [LEFT + x * (WIDTH - LEFT - MARGIN), HEIGHT - BOTTOM - y * (HEIGHT - BOTTOM - MARGIN)];
}

/** @param {SVGSVGElement} root @param {ArrayLike<number>} magnification at `eccentricities`, in mm a degree */
export function plotMagnification(root, magnification) {
  root.setAttribute("viewBox", `0 0 ${WIDTH} ${HEIGHT}`);
  const curve = eccentricities.flatMap((e, k) => (magnification[k] > LOWEST_M ? [place(e, magnification[k])] : []));
  root.replaceChildren(
    ...[0.1, 1, 10].flatMap((e) => tick(`${e}°`, place(e, LOWEST_M), place(e, HIGHEST_M), "middle")),
    ...[0.1, 1, 10].flatMap((m) => tick(String(m), place(LOWEST_E, m), place(HIGHEST_E, m), "end")),
    svg("path", { class: "curve", d: pathData(curve, false) }),
  );
}

/** @param {string} name @param {Point} from @param {Point} to @param {"middle" | "end"} anchor */
function tick(name, from, to, anchor) {
  const [dx, dy] = anchor === "middle" ? [0, 18] : [-7, 4];
  const text = svg("text", { x: from[0] + dx, y: from[1] + dy, "text-anchor": anchor });
  text.textContent = name;
  return [svg("path", { class: "tick", d: pathData([from, to], false) }), text];
}
