// The region being edited: an immutable value and the verbs that make the next one.

import { arcThrough, asBezier, converted, pointOn, splitAt } from "./curve.js";
import { contains, crossings, deepPoint, distance, meetings, nearestOnBoundary, rightOf, sizeOf } from "./geometry.js";
import { flatten } from "../common/frame.js";
import { planePath } from "./path.js";
import { counterClockwise, edgeOf, edgesOn, outlineOf, placeOn, placed, polygonOf } from "./outline.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./curve.js").Curve} Curve */
/** @typedef {import("./outline.js").Outline} Outline */
/**
 * `toward` is kept as a place on an edge, so that it stays on the boundary when its edge moves. The outline may have `holes` in it;
 * points, and the edges after them, are counted through all outlines, the outer one first.
 * @typedef {Outline & { center: Point, toward: { edge: number, t: number }, holes?: Outline[] }} Region
 */
/** What shapes an edge besides its ends: a control point of a curve, or the middle of an arc. @typedef {"first" | "second" | "bow"} Handle */

/**
 * A region from its outline, counter-clockwise from here on; the vector is chosen where none is given: from the
 * boundary at the right to the point deepest inside.
 * @param {Outline | Point[]} outline @param {Point} [center] @param {Point} [toward] @param {Outline[]} [holes] @returns {Region}
 */
export function makeRegion(outline, center, toward, holes = []) {
  const drawn = counterClockwise(Array.isArray(outline) ? { boundary: outline } : outline);
  const polygon = polygonOf(drawn);
  const inside = center ?? deepPoint(polygon, holes.map(polygonOf));
  const place = toward ? nearestOnBoundary(polygon, toward) : rightOf(polygon, inside);
  const region = { ...outlineOf(drawn.boundary, drawn.curves), center: inside, toward: placeOn(drawn, place) };
  return holes.length ? { ...region, holes: holes.map(counterClockwise) } : region;
}

/** All outlines of a region, the outer one first. @param {Region} region @returns {Outline[]} */
export const outlinesOf = (region) => [region, ...(region.holes ?? [])];

/** All points of a region. @param {Region} region @returns {Point[]} */
export const pointsOf = (region) => outlinesOf(region).flatMap(({ boundary }) => boundary);

/** On which outline a point, or an edge, is, and which it is there. @param {Region} region @param {number} index @returns {[outline: number, index: number]} */
function placeOf(region, index) {
  const outlines = outlinesOf(region);
  let [k, at] = [0, index];
  while (k + 1 < outlines.length && at >= outlines[k].boundary.length) at -= outlines[k++].boundary.length;
  return [k, at];
}

/** The edge after a point. @param {Region} region @param {number} index @returns {[a: Point, b: Point, curve: Curve]} */
export function edgeAfter(region, index) {
  const [k, at] = placeOf(region, index);
  return edgeOf(outlinesOf(region)[k], at);
}

/** Whether a point lies in the region. @param {Region} region @param {Point} point */
export const isInside = (region, point) => outlinesOf(region).every((outline, k) => contains(polygonOf(outline), point) === (k === 0));

/** The outline on which a point is changes, or the hole's; the others stay. @param {Region} region @param {number} index @param {(outline: Region, index: number) => Region} change @returns {Region} */
function onOutline(region, index, change) {
  if (!region.holes) return change(region, index);
  const { holes, ...outer } = region;
  const [k, at] = placeOf(region, index);
  if (k === 0) return { ...change(outer, at), holes };
  const { boundary, curves } = change({ ...outer, ...holes[k - 1], curves: holes[k - 1].curves, toward: { edge: 0, t: 0 } }, at);
  return { ...region, holes: holes.with(k - 1, outlineOf(boundary, curves)) };
}

/** A hole more; a center that lies in it moves out. @param {Region} region @param {Outline} hole @returns {Region} */
export function addHole(region, hole) {
  return withCenterInside({ ...region, holes: [...(region.holes ?? []), counterClockwise(hole)] });
}

/** The hole that has this point, or null. @param {Region} region @param {number} index */
export function holeAt(region, index) {
  const [k] = placeOf(region, index);
  return k ? k - 1 : null;
}

/** A hole less. @param {Region} region @param {number} hole @returns {Region} */
export function removeHole({ holes = [], ...region }, hole) {
  const rest = holes.toSpliced(hole, 1);
  return rest.length ? { ...region, holes: rest } : region;
}

/** A center that is not inside any more moves to where it is deep. @param {Region} region @returns {Region} */
function withCenterInside(region) {
  if (isInside(region, region.center)) return region;
  const [outer, ...holes] = outlinesOf(region).map(polygonOf);
  return moveCenter(region, deepPoint(outer, holes));
}

/** The outer end of the vector. @param {Region} region @returns {Point} */
export function towardPoint(region) {
  const { edge, t } = region.toward;
  return pointOn(...edgeOf(region, edge), t);
}

/** A region as a job carries it: `boundary` is the polygon that it looks like, `path` "" where it is one, `holes` paths. @typedef {{ boundary: Float64Array, corners: Float64Array, path: string, holes: string[], center: Point, toward: Point }} Carried */

/** @param {Region} region @returns {Carried} */
export function carried(region) {
  return { boundary: flatten(polygonOf(region)), corners: flatten(region.boundary), path: region.curves ? planePath(region) : "", holes: (region.holes ?? []).map((hole) => planePath(hole)), center: region.center, toward: towardPoint(region) };
}

/** A point moves, and the control points beside it with it. @param {Region} region @param {number} index @param {Point} to @returns {Region} */
export const moveVertex = (region, index, to) => onOutline(region, index, (outline, at) => vertexMoved(outline, at, to));

/** @param {Region} region @param {number} index @param {Point} to @returns {Region} */
function vertexMoved(region, index, to) {
  const { boundary, curves } = region;
  const [dx, dy] = [to[0] - boundary[index][0], to[1] - boundary[index][1]];
  /** @param {Point} p @returns {Point} */
  const shift = ([x, y]) => [x + dx, y + dy];
  const before = (index + boundary.length - 1) % boundary.length;
  const shifted = curves?.map((curve, k) => {
    if (curve?.kind !== "curve") return curve;
    return { ...curve, ...(k === index && { first: shift(curve.first) }), ...(k === before && { second: shift(curve.second) }) };
  });
  return { ...region, ...outlineOf(boundary.map((p, k) => (k === index ? to : p)), shifted) };
}

/** A vertex more, on `edge` where it is nearest to `at`; the outline stays as it is. @param {Region} region @param {number} edge @param {Point} at @returns {Region} */
export const splitEdge = (region, edge, at) => onOutline(region, edge, (outline, k) => edgeSplit(outline, k, at));

/** @param {Region} region @param {number} edge @param {Point} at @returns {Region} */
function edgeSplit(region, edge, at) {
  const [a, b, curve] = edgeOf(region, edge);
  const line = polygonOf({ boundary: [a, b], curves: [curve, null] }).slice(0, -1);
  // There and back again: the edge alone, closed without any other.
  const near = nearestOnBoundary([...line, b, ...line.slice(1).reverse()], at);
  const t = nearestShare(near, line.length);
  const { at: point, before, after } = splitAt(a, b, curve, t);
  return retie(region, outlineOf(region.boundary.toSpliced(edge + 1, 0, point), region.curves?.toSpliced(edge, 1, before, after)));
}

/** A new vertex keeps away from the ends of its edge. */
const END = 1e-3;

/** How far along a line that goes forth and back a place is. @param {{ edge: number, t: number }} place @param {number} chords */
function nearestShare({ edge, t }, chords) {
  const along = (edge + t) / chords;
  return Math.min(1 - END, Math.max(END, along > 1 ? 2 - along : along));
}

/** A vertex less, while enough remain; of a hole that has no more to lose, all. A center that is left outside moves inside. @param {Region} region @param {number} index @returns {Region} */
export function removeVertex(region, index) {
  const hole = holeAt(region, index);
  if (!hasSpare(outlinesOf(region)[hole === null ? 0 : hole + 1])) return hole === null ? region : removeHole(region, hole);
  const less = onOutline(region, index, vertexRemoved);
  return isInside(region, region.center) ? withCenterInside(less) : less;
}

/** @param {Region} region @param {number} index @returns {Region} */
function vertexRemoved(region, index) {
  const count = region.boundary.length;
  const before = (index + count - 1) % count;
  const curves = region.curves?.toSpliced(before, 1, joined(region, before, index)).toSpliced(index, 1);
  return retie(region, outlineOf(region.boundary.toSpliced(index, 1), curves));
}

/** Whether an outline of a point less is one. @param {Outline} outline */
const hasSpare = ({ boundary, curves }) => boundary.length > (curves ? 2 : 3);

/** Whether a point can be removed: a hole goes with its last ones. @param {Region} region @param {number} index */
export const canRemove = (region, index) => holeAt(region, index) !== null || hasSpare(region);

/** One edge for two: straight if both are, an arc through the point between two arcs, or a curve that starts and ends like them. @param {Region} region @param {number} before @param {number} index @returns {Curve} */
function joined(region, before, index) {
  const [a, middle, one] = edgeOf(region, before);
  const [, b, other] = edgeOf(region, index);
  if (!one && !other) return null;
  if (one?.kind === "arc" && other?.kind === "arc") return arcThrough(a, b, middle);
  return { kind: "curve", first: asBezier(a, middle, one).first, second: asBezier(middle, b, other).second };
}

/** The handles of an edge. @param {Region} region @param {number} edge @returns {{ handle: Handle, at: Point }[]} */
export function handlesOf(region, edge) {
  const [a, b, curve] = edgeAfter(region, edge);
  if (curve?.kind === "arc") return [{ handle: "bow", at: pointOn(a, b, curve, 0.5) }];
  if (curve?.kind !== "curve") return [];
  return [{ handle: "first", at: curve.first }, { handle: "second", at: curve.second }];
}

/** An arc that is hardly one can still be bent. @type {Curve} */
const FLATTEST = { kind: "arc", bulge: 1e-4 };
/** Directions that differ by less are meant to be the same, as the sine of an angle. */
const SMOOTH = 2e-3;

/** A handle moves; where two curves join smoothly they go on to, unless that is to be broken. @param {Region} region @param {number} edge @param {Handle} handle @param {Point} to @param {boolean} [breaks] @returns {Region} */
export const moveHandle = (region, edge, handle, to, breaks = false) => onOutline(region, edge, (outline, k) => handleMoved(outline, k, handle, to, breaks));

/** @param {Region} region @param {number} edge @param {Handle} handle @param {Point} to @param {boolean} breaks @returns {Region} */
function handleMoved(region, edge, handle, to, breaks) {
  const [a, b, curve] = edgeOf(region, edge);
  if (handle === "bow") return withCurve(region, edge, arcThrough(a, b, to) ?? FLATTEST);
  if (curve?.kind !== "curve") return region;
  const next = withCurve(region, edge, { ...curve, [handle]: to });
  const count = region.boundary.length;
  const other = handle === "first" ? (edge + count - 1) % count : (edge + 1) % count;
  const beyond = region.curves?.[other];
  if (breaks || beyond?.kind !== "curve" || other === edge) return next;
  const [corner, opposite] = handle === "first" ? [a, "second"] : [b, "first"];
  const follows = turned(corner, curve[handle], to, beyond[/** @type {"first" | "second"} */ (opposite)]);
  return follows ? withCurve(next, other, { ...beyond, [opposite]: follows }) : next;
}

/** Where the control point beyond a smooth joint goes, its distance kept; null where the joint is none. @param {Point} joint @param {Point} from @param {Point} to @param {Point} beyond @returns {Point | null} */
function turned(joint, from, to, beyond) {
  const [u, v, w] = [from, to, beyond].map(([x, y]) => [x - joint[0], y - joint[1]]);
  const [before, after, reach] = [u, v, w].map(([x, y]) => Math.hypot(x, y));
  const sine = (u[0] * w[1] - u[1] * w[0]) / (before * reach);
  if (!(Math.abs(sine) < SMOOTH) || u[0] * w[0] + u[1] * w[1] > 0 || !after) return null;
  return [joint[0] - (v[0] * reach) / after, joint[1] - (v[1] * reach) / after];
}

/** An edge is made a line, an arc or a curve. @param {Region} region @param {number} edge @param {import("./curve.js").Kind} kind @returns {Region} */
export const convertEdge = (region, edge, kind) => onOutline(region, edge, (outline, k) => edgeConverted(outline, k, kind));

/** @param {Region} region @param {number} edge @param {import("./curve.js").Kind} kind @returns {Region} */
function edgeConverted(region, edge, kind) {
  const [a, b, curve] = edgeOf(region, edge);
  // Two points with a line between them bound nothing else.
  if (kind === "line" && region.boundary.length < 3) return region;
  const place = towardPoint(region);
  return moveToward(withCurve(region, edge, converted(a, b, curve, kind)), place);
}

/** @param {Region} region @param {number} edge @param {Curve} curve @returns {Region} */
function withCurve({ boundary, curves, center, toward }, edge, curve) {
  const all = curves ?? boundary.map(() => null);
  return { ...outlineOf(boundary, all.with(edge, curve)), center, toward };
}

/** @param {Region} region @param {Point} center @returns {Region} */
export const moveCenter = (region, center) => ({ ...region, center });

/** The vector's outer end goes to the boundary point nearest to `point`. @param {Region} region @param {Point} point @returns {Region} */
export function moveToward(region, point) {
  return { ...region, toward: placeOn(region, nearestOnBoundary(polygonOf(region), point)) };
}

/** @param {Region} region @param {Point} by @returns {Region} */
export function translate({ center, toward, holes, ...outline }, by) {
  return { ...placed(outline, 1, by), center: [center[0] + by[0], center[1] + by[1]], toward, ...(holes && { holes: holes.map((hole) => placed(hole, 1, by)) }) };
}

/** A hole alone is shifted. @param {Region} region @param {number} hole @param {Point} by @returns {Region} */
export const translateHole = (region, hole, by) => ({ ...region, holes: region.holes?.map((outline, k) => (k === hole ? placed(outline, 1, by) : outline)) });

/** As near to a corner of curves, a share of their size, their polygons may meet where they themselves do not: in a tip without an angle. */
const TIP = 0.05;

/**
 * What is visibly wrong, to be shown in red; the words come from the library.
 * @param {Region} region @returns {{ edges: Set<number>, center: boolean }}
 */
export function faults(region) {
  const outlines = outlinesOf(region);
  /** @type {Set<number>} */
  const edges = new Set();
  let first = 0;
  for (const outline of outlines) {
    for (const edge of meetingEdges(outline)) edges.add(first + edge);
    first += outline.boundary.length;
  }
  for (const edge of meetingOutlines(outlines)) edges.add(edge);
  return { edges, center: !isInside(region, region.center) };
}

/** The edges of an outline that meet others of it. @param {Outline} outline @returns {Set<number>} */
export function meetingEdges(outline) {
  const polygon = polygonOf(outline);
  const near = outline.curves ? TIP * sizeOf(polygon) : 0;
  const wrong = meetings(polygon).filter(({ at }) => !near || outline.boundary.every((corner) => distance(corner, at) > near));
  return edgesOn(outline, new Set(wrong.flatMap(({ first, second }) => [first, second])));
}

/** The edges at which outlines meet each other, counted through all. @param {Outline[]} outlines @returns {Set<number>} */
function meetingOutlines(outlines) {
  const begins = outlines.map((_, k) => outlines.slice(0, k).reduce((sum, { boundary }) => sum + boundary.length, 0));
  /** @type {Set<number>} */
  const edges = new Set();
  outlines.forEach((one, k) => {
    for (let other = k + 1; other < outlines.length; other++) {
      const [here, there] = crossings(polygonOf(one), polygonOf(outlines[other]));
      for (const edge of edgesOn(one, here)) edges.add(begins[k] + edge);
      for (const edge of edgesOn(outlines[other], there)) edges.add(begins[other] + edge);
    }
  });
  return edges;
}

/** The same vector tied to another outline. @param {Region} region @param {Outline} outline @returns {Region} */
function retie(region, outline) {
  const { center, toward } = region;
  return moveToward({ ...outline, center, toward }, towardPoint(region));
}
