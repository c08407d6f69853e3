// An outline: points, and the edges that are not straight between them. Its polygon is what it looks like, for all that is asked of polygons.

import { chordsOf, moved, pointOn, reversed } from "./curve.js";
import { area } from "./geometry.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./curve.js").Curve} Curve */
/** Edge k runs from point k to the next one; `curves` is left out where all are straight. @typedef {{ boundary: Point[], curves?: Curve[] }} Outline */
/** A polygon, and where its corners lie on the outline: edge and parameter. @typedef {{ polygon: Point[], places: [edge: number, t: number][] | null }} Traced */

/** By their curves: another vector leaves an outline as it is. @type {WeakMap<Curve[], { boundary: Point[], trace: Traced }>} */
const known = new WeakMap();

/** The polygon that an outline looks like. @param {Outline} outline @returns {Traced} */
export function traced(outline) {
  const { boundary, curves } = outline;
  if (!curves) return { polygon: boundary, places: null };
  const before = known.get(curves);
  if (before?.boundary === boundary) return before.trace;
  const places = boundary.flatMap((_, edge) => {
    const [a, b, curve] = edgeOf(outline, edge);
    const chords = chordsOf(a, b, curve);
    return Array.from({ length: chords }, (_, k) => /** @type {[number, number]} */ ([edge, k / chords]));
  });
  const trace = { polygon: places.map(([edge, t]) => pointOn(...edgeOf(outline, edge), t)), places };
  known.set(curves, { boundary, trace });
  return trace;
}

/** The polygon alone. @param {Outline} outline */
export const polygonOf = (outline) => traced(outline).polygon;

/** An edge: from where, to where, and how. @param {Outline} outline @param {number} edge @returns {[a: Point, b: Point, curve: Curve]} */
export function edgeOf({ boundary, curves }, edge) {
  return [boundary[edge], boundary[(edge + 1) % boundary.length], curves?.[edge] ?? null];
}

/** A place on an edge of the polygon → edge and parameter of the outline. @param {Outline} outline @param {{ edge: number, t: number }} place */
export function placeOn(outline, { edge, t }) {
  const { places } = traced(outline);
  if (!places) return { edge, t };
  const [on, from] = places[edge];
  const [next, to] = places[(edge + 1) % places.length];
  return { edge: on, t: from + ((next === on && to > from ? to : 1) - from) * t };
}

/** Edges of the polygon → edges of the outline. @param {Outline} outline @param {Set<number>} edges @returns {Set<number>} */
export function edgesOn(outline, edges) {
  const { places } = traced(outline);
  return places ? new Set([...edges].map((edge) => places[edge][0])) : edges;
}

/** An outline of these edges: without `curves` where none is curved. @param {Point[]} boundary @param {Curve[] | undefined} curves @returns {Outline} */
export function outlineOf(boundary, curves) {
  return curves?.some(Boolean) ? { boundary, curves } : { boundary };
}

/** The same outline, counter-clockwise. @param {Outline} outline @returns {Outline} */
export function counterClockwise(outline) {
  if (area(polygonOf(outline)) >= 0) return outline;
  const { boundary, curves } = outline;
  // From the last point back to the first one; the edge that closes stays the last.
  const back = curves && [...curves.slice(0, -1).reverse(), curves[curves.length - 1]].map(reversed);
  return outlineOf([...boundary].reverse(), back);
}

/** The outline shifted after it was scaled. @param {Outline} outline @param {number} scale @param {Point} shift @returns {Outline} */
export function placed({ boundary, curves }, scale, [dx, dy]) {
  /** @param {Point} p @returns {Point} */
  const move = ([x, y]) => [scale * x + dx, scale * y + dy];
  return outlineOf(boundary.map(move), curves?.map((curve) => moved(curve, move, scale)));
}
