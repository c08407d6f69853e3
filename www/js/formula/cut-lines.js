// Where the cuts of a formula lie in its plane: on the lines on which what stands in a logarithm, root or power has one angle.

import { flatten, toPlane } from "../common/frame.js";
import { levelPieces } from "../flow/levels.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/placement.js").Placement} Placement */
/** @typedef {import("../../pkg/formula/index.js").FormulaMap} FormulaMap */
/** A short piece of a cut. @typedef {[Point, Point]} Piece */

/** Points a side of the grid on which lines are looked for, at least and at most: as many as can be had in so many milliseconds. */
const [COARSEST, FINEST] = [31, 121];
const PATIENCE = 80;
/** A piece is on the line if its middle has the angle within this; else it is a jump, or a pole. */
const NEAR = 0.05;

/** @param {FormulaMap} map what stands in there @param {number} angle in degrees @param {Placement} view square @returns {Piece[]} */
export function cutLines(map, angle, { center, width }) {
  const side = sideFor(map, { center, width });
  /** @type {Frame} */
  const grid = { center, width, pixels: [side, side] };
  const places = Array.from({ length: side * side }, (_, k) => toPlane(grid, [(k % side) + 0.5, Math.floor(k / side) + 0.5]));
  const flat = levelPieces(fromRay(map, angle, places).across, grid, [0]);
  /** @type {Piece[]} */
  const pieces = [];
  for (let k = 0; k < flat.length; k += 4) pieces.push([toPlane(grid, [flat[k], flat[k + 1]]), toPlane(grid, [flat[k + 2], flat[k + 3]])]);
  const { along, across } = fromRay(map, angle, pieces.map(([[x, y], [u, v]]) => [(x + u) / 2, (y + v) / 2]));
  return pieces.filter((_, k) => along[k] > 0 && Math.abs(across[k]) < NEAR * along[k]);
}

/** How fine a grid may be, by how long its diagonal takes. @param {FormulaMap} map @param {Placement} view */
function sideFor(map, { center: [x, y], width }) {
  const begin = performance.now();
  map.eval(Float64Array.from({ length: 2 * FINEST }, (_, n) => (n % 2 ? y : x) + width * ((n >> 1) / FINEST - 0.5)));
  const each = (performance.now() - begin) / FINEST;
  return Math.max(COARSEST, Math.min(FINEST, Math.floor(Math.sqrt(PATIENCE / each))));
}

/** Where values lie, seen from 0 along the ray at that angle. @param {FormulaMap} map @param {number} angle @param {Point[]} places */
function fromRay(map, angle, places) {
  const values = map.eval(flatten(places));
  const [cos, sin] = [Math.cos((angle * Math.PI) / 180), Math.sin((angle * Math.PI) / 180)];
  const along = Float64Array.from(places, (_, k) => values[2 * k] * cos + values[2 * k + 1] * sin);
  const across = Float64Array.from(places, (_, k) => values[2 * k + 1] * cos - values[2 * k] * sin);
  return { along, across };
}

/** The angle of a value, in degrees; null for 0 and what is not defined. @param {FormulaMap} map @param {Point} at */
export function angleAt(map, at) {
  const [x, y] = map.eval(flatten([at]));
  return Number.isFinite(x + y) && (x !== 0 || y !== 0) ? (Math.atan2(y, x) * 180) / Math.PI : null;
}
