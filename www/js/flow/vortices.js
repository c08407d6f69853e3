// Vortices that a visitor puts into the fluid.

import { contains } from "../editor/geometry.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** What turns the fluid around a point, in m²/s counter-clockwise. @typedef {{ at: Point, circulation: number }} Vortex */

/** So many can be seen beside each other. */
export const MOST = 6;
/** How much the fluid turns around a new one. */
const STRENGTH = 2;
/** Beyond this the picture ends. */
const REACH = /** @type {Point} */ ([3, 1.8]);
/** Where the next one goes if the place is free, first of all before and above a body. @type {Point[]} */
const PLACES = [[-1.9, 0.7], [-1.9, -0.7], [1.9, 0.7], [1.9, -0.7], [0, 1.4], [0, -1.4], [-2.6, 0], [2.6, 0]];
/** Nearer than this they are in each other's way. */
const APART = 0.2;

/** Kept to what an address says of it. @param {Point} at @returns {Point} */
const rounded = ([x, y]) => [Math.round(x * 1000) / 1000, Math.round(y * 1000) / 1000];

/** Whether a vortex can be there: in the fluid, and in the picture. @param {Point} at @param {Point[][]} outlines */
const isFree = (at, outlines) => at.every((x, k) => Math.abs(x) < REACH[k]) && !outlines.some((outline) => contains(outline, at));

/** One more, where there is room; null if there is none. @param {Vortex[]} vortices @param {Point[][]} outlines @returns {Vortex[] | null} */
export function withOne(vortices, outlines) {
  const place = PLACES.find((at) => isFree(at, outlines) && vortices.every((other) => Math.hypot(at[0] - other.at[0], at[1] - other.at[1]) > APART));
  return place && vortices.length < MOST ? [...vortices, { at: place, circulation: STRENGTH }] : null;
}

/** One of them elsewhere; null where it cannot be. @param {Vortex[]} vortices @param {number} k @param {Point} to @param {Point[][]} outlines @returns {Vortex[] | null} */
export function moved(vortices, k, to, outlines) {
  const at = rounded(to);
  return isFree(at, outlines) ? vortices.map((each, j) => (j === k ? { ...each, at } : each)) : null;
}

/** Those that another body leaves in the fluid. @param {Vortex[]} vortices @param {Point[][]} outlines */
export const remaining = (vortices, outlines) => vortices.filter(({ at }) => isFree(at, outlines));

/** The one nearest to a point within a distance, or null. @param {Vortex[]} vortices @param {Point} point @param {number} within @returns {number | null} */
export function nearest(vortices, [x, y], within) {
  const away = vortices.map(({ at }) => Math.hypot(at[0] - x, at[1] - y));
  const least = Math.min(...away);
  return least <= within ? away.indexOf(least) : null;
}

/** From an address: x,y,circulation;… @param {string} text @returns {Vortex[]} */
export function readVortices(text) {
  const all = text.split(";").map((each) => each.split(",").map(Number));
  const fits = (/** @type {number[]} */ [x, y, turn]) => Math.abs(x) < REACH[0] && Math.abs(y) < REACH[1] && Math.abs(turn) <= 8;
  if (all.length > MOST || !all.every((each) => each.length === 3 && fits(each))) throw new Error(`must be 1 to ${MOST} of x,y,circulation;… in the picture`);
  return all.map(([x, y, circulation]) => ({ at: [x, y], circulation }));
}

/** @param {Vortex[]} vortices */
export const writeVortices = (vortices) => vortices.map(({ at, circulation }) => [...at, circulation].join(",")).join(";");
