// What the page of electric fields asks the package.

import { Electrostatics, Region } from "../../pkg/index.js";
import { flatten } from "../common/frame.js";
import { pointsOf } from "../flow/grid-field.js";
import { pointsOfLines } from "../flow/level-lines.js";

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
 * @property {Point[][]} equal lines of equal potential
 * @property {Point[][]} force lines of force, between neighbours of which the same flux lies
 * @property {number} estimate
 * @property {number} unknowns
 */

/** For a picture; the estimate is shown. */
const TOLERANCE = 1e-4;
/** Lines that leave the conductor with the largest charge. */
const LINES = 28;
/** Lines of equal potential between the lowest and the highest. */
const LEVELS = 21;

/** @param {Question} question @returns {Answer} */
export function answer({ conductors: { outlines, shield, curve }, potentials, grid }) {
  const holes = outlines.map(flatten);
  const region = shield ? new Region({ boundary: flatten(shield), holes, curve }) : Region.exterior({ holes, curve });
  const field = Electrostatics.solve(region, { potentials }, { tolerance: TOLERANCE });
  const highest = Math.max(...potentials.map(Math.abs));
  const levels = Float64Array.from({ length: LEVELS }, (_, k) => highest * ((2 * (k + 0.5)) / LEVELS - 1));
  const found = {
    potential: field.potential(pointsOf(grid)),
    charges: [...field.charges],
    capacitance: [...field.capacitance],
    impedance: field.impedance,
    equal: pointsOfLines(field.levelLines(levels, grid)),
    force: pointsOfLines(field.forceLines(LINES, grid)),
    estimate: field.errorEstimate,
    unknowns: field.unknowns,
  };
  field.free();
  region.free();
  return found;
}
