// The lines of a grid on a ring.

import { flatten } from "../common/frame.js";

/** Points along a line, and of drafts. */
const [STEPS, DRAFT_STEPS] = [240, 80];
/** Lines of a ring end so near to its circles, as a share of the way between them in log |w|. */
const EDGE = 2e-4;

/** The grid's lines on a ring. @param {import("../editor/field.js").Grid} grid @param {number} innerRadius of the ring, whose outer one is 1 @param {boolean} [fine] @returns {Float64Array[]} */
export function ringLines({ field, density }, innerRadius, fine = true) {
  const depth = Math.log(1 / innerRadius);
  const steps = fine ? STEPS : DRAFT_STEPS;
  // Squares between the rays as on the disk, or as many circles as fit where the disk would have them.
  const gap = field ? (2 * Math.PI) / density : depth / (1 + Math.max(1, Math.round((density / 3) * (1 - innerRadius))));
  const circles = Array.from({ length: Math.max(0, Math.ceil(depth / gap - EDGE) - 1) }, (_, k) => Math.exp(-gap * (k + 1)));
  /** @type {(at: (share: number) => [radius: number, angle: number]) => Float64Array} */
  const line = (at) => flatten(Array.from({ length: steps + 1 }, (_, k) => at(k / steps)).map(([radius, angle]) => [radius * Math.cos(angle), radius * Math.sin(angle)]));
  // Denser towards both circles.
  const across = (/** @type {number} */ s) => Math.exp(-depth * (EDGE + (1 - 2 * EDGE) * 0.5 * (1 - Math.cos(Math.PI * s))));
  return [
    ...circles.map((radius) => line((s) => [radius, 2 * Math.PI * s])),
    ...Array.from({ length: density }, (_, n) => line((s) => [across(s), (2 * Math.PI * n) / density])),
  ];
}
