// What the page of electric fields asks the package.

import { Electrostatics, Region } from "../../pkg/index.js";
import { flatten } from "../common/frame.js";
import { pointsOf } from "../flow/grid-field.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("./conductors.js").Conductors} Conductors */
/** @typedef {{ conductors: Conductors, potentials: number[], grid: Frame }} Question */
/**
 * @typedef {object} Answer
 * @property {Float64Array} potential on the grid, NaN inside conductors
 * @property {number[]} charges over ε₀
 * @property {number[]} capacitance Maxwell's matrix over ε₀, row by row
 * @property {number | undefined} impedance in ohms
 * @property {Point[]} seeds where lines of equal flux leave positively charged walls
 * @property {number} estimate
 * @property {number} unknowns
 */

/** For a picture; the estimate is shown. */
const TOLERANCE = 1e-4;
/** Places around a wall where the field is asked; how far outside, in shares of the way to the next. */
const PLACES = 400;
const AWAY = 0.5;
/** Lines that leave the conductor with the largest charge. */
const LINES = 28;

/** @param {Question} question @returns {Answer} */
export function answer({ conductors: { outlines, shield, curve }, potentials, grid }) {
  const holes = outlines.map(flatten);
  const region = shield ? new Region({ boundary: flatten(shield), holes, curve }) : Region.exterior({ holes, curve });
  const field = Electrostatics.solve(region, { potentials }, { tolerance: TOLERANCE });
  const charges = [...field.charges];
  const most = Math.max(...charges.map(Math.abs));
  const walls = [...(shield ? [{ outline: shield, inward: true }] : []), ...outlines.map((outline) => ({ outline, inward: false }))];
  const seeds = walls.flatMap(({ outline, inward }, k) => (charges[k] > 1e-9 * most ? seedsOn(field, outline, inward, Math.round((LINES * charges[k]) / most)) : []));
  const found = {
    potential: field.potential(pointsOf(grid)),
    charges,
    capacitance: [...field.capacitance],
    impedance: field.impedance,
    seeds,
    estimate: field.errorEstimate,
    unknowns: field.unknowns,
  };
  field.free();
  region.free();
  return found;
}

/** Places beside a wall between which the same flux leaves it. @param {Electrostatics} field @param {Point[]} outline @param {boolean} inward @param {number} count @returns {Point[]} */
function seedsOn(field, outline, inward, count) {
  const each = Math.ceil(PLACES / outline.length);
  const places = outline.flatMap((from, k) => {
    const to = outline[(k + 1) % outline.length];
    const along = [to[0] - from[0], to[1] - from[1]];
    const side = ((inward ? -1 : 1) * AWAY) / each;
    return Array.from({ length: each }, (_, j) => {
      const t = (j + 0.5) / each;
      const at = /** @type {Point} */ ([from[0] + t * along[0] + side * along[1], from[1] + t * along[1] - side * along[0]]);
      return { at, length: Math.hypot(...along) / each };
    });
  });
  const strengths = field.field(flatten(places.map(({ at }) => at)));
  let flux = 0;
  const risen = places.map(({ length }, k) => (flux += length * (Math.hypot(strengths[2 * k], strengths[2 * k + 1]) || 0)));
  return Array.from({ length: count }, (_, n) => places[Math.max(0, risen.findIndex((sum) => sum >= ((n + 0.5) / count) * flux))].at);
}
