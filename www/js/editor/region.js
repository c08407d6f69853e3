// The region being edited: an immutable value and the verbs that make the next one.

import { area, contains, crossingEdges, deepPoint, mix, nearestOnBoundary, rightOf } from "./geometry.js";

/** @typedef {import("../common/frame.js").Point} Point */
/**
 * `toward` is kept as a place on an edge, so that it stays on the boundary when its edge moves.
 * @typedef {{ boundary: Point[], center: Point, toward: { edge: number, t: number } }} Region
 */

/**
 * A region from its outline, counter-clockwise from here on; the vector is chosen where none is given: from the
 * boundary at the right to the point deepest inside.
 * @param {Point[]} outline @param {Point} [center] @param {Point} [toward] @returns {Region}
 */
export function makeRegion(outline, center, toward) {
  const boundary = area(outline) < 0 ? [...outline].reverse() : outline;
  const inside = center ?? deepPoint(boundary);
  const { edge, t } = toward ? nearestOnBoundary(boundary, toward) : rightOf(boundary, inside);
  return { boundary, center: inside, toward: { edge, t } };
}

/** The outer end of the vector. @param {Region} region @returns {Point} */
export function towardPoint({ boundary, toward: { edge, t } }) {
  return mix(boundary[edge], boundary[(edge + 1) % boundary.length], t);
}

/** @param {Region} region @param {number} index @param {Point} to @returns {Region} */
export function moveVertex(region, index, to) {
  return { ...region, boundary: region.boundary.map((p, k) => (k === index ? to : p)) };
}

/** A vertex more, on `edge`. @param {Region} region @param {number} edge @param {Point} at @returns {Region} */
export function insertVertex(region, edge, at) {
  return retie(region, region.boundary.toSpliced(edge + 1, 0, at));
}

/** A vertex less, while three remain; a center that is left outside moves inside. @param {Region} region @param {number} index @returns {Region} */
export function removeVertex(region, index) {
  if (region.boundary.length <= 3) return region;
  const less = retie(region, region.boundary.toSpliced(index, 1));
  const lost = contains(region.boundary, region.center) && !contains(less.boundary, less.center);
  return lost ? moveCenter(less, deepPoint(less.boundary)) : less;
}

/** @param {Region} region @param {Point} center @returns {Region} */
export const moveCenter = (region, center) => ({ ...region, center });

/** The vector's outer end goes to the boundary point nearest to `point`. @param {Region} region @param {Point} point @returns {Region} */
export function moveToward(region, point) {
  const { edge, t } = nearestOnBoundary(region.boundary, point);
  return { ...region, toward: { edge, t } };
}

/** @param {Region} region @param {Point} by @returns {Region} */
export function translate({ boundary, center, toward }, [dx, dy]) {
  /** @param {Point} p @returns {Point} */
  const shift = ([x, y]) => [x + dx, y + dy];
  return { boundary: boundary.map(shift), center: shift(center), toward };
}

/**
 * What is visibly wrong, to be shown in red; the words come from the library.
 * @param {Region} region @returns {{ edges: Set<number>, center: boolean }}
 */
export function faults({ boundary, center }) {
  return { edges: crossingEdges(boundary), center: !contains(boundary, center) };
}

/** The same vector tied to another boundary. @param {Region} region @param {Point[]} boundary @returns {Region} */
function retie(region, boundary) {
  return moveToward({ ...region, boundary }, towardPoint(region));
}
