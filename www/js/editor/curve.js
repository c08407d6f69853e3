// One edge of an outline, from a to b: a straight line, a Bézier curve, or an arc of a circle or an ellipse.

import { mix, plus } from "./geometry.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** Two control points. @typedef {{ kind: "curve", first: Point, second: Point }} Bezier */
/** `bulge`: tan of a quarter of the angle that it turns by, positive to the left. @typedef {{ kind: "arc", bulge: number }} Arc */
/** As SVG has it, with y upwards: `turn` of the first axis in degrees, `large`: more than half of it, `left`: counter-clockwise. @typedef {{ kind: "ellipse", radii: Point, turn: number, large: boolean, left: boolean }} Elliptic */
/** null: a straight line. @typedef {Bezier | Arc | Elliptic | null} Curve */
/** What an edge can be made. @typedef {"line" | "arc" | "curve"} Kind */

/** Of a bulge less than that nothing is seen; nor can more be held. */
const FLAT = 1e-4;
const FULLEST = 40;
/** An arc that a line is made: a sixth of its length high, outwards. */
const FIRST_BULGE = 1 / 3;

/** p turned by a right angle to the left. @param {Point} p @returns {Point} */
const left = ([x, y]) => [-y, x];

/** @param {number} bulge */
const held = (bulge) => Math.max(-FULLEST, Math.min(FULLEST, bulge));

/**
 * An ellipse as center + u cos φ + v sin φ, φ from `start` on by `sweep`.
 * @typedef {{ center: Point, u: Point, v: Point, start: number, sweep: number }} Round
 */

/** The middle of an arc's circle. @param {Point} a @param {Point} b @param {number} bulge @returns {Point} */
function middleOf(a, b, bulge) {
  return plus(mix(a, b, 0.5), left([b[0] - a[0], b[1] - a[1]]), (1 - bulge * bulge) / (4 * bulge));
}

/** @param {Point} a @param {Point} b @param {Arc | Elliptic} curve @returns {Round} */
function roundOf(a, b, curve) {
  if (curve.kind === "arc") {
    const center = middleOf(a, b, curve.bulge);
    const u = plus(a, center, -1);
    return { center, u, v: left(u), start: 0, sweep: 4 * Math.atan(curve.bulge) };
  }
  // In the ellipse's own axes, scaled, it is a circle.
  const angle = (curve.turn * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const [rx, ry] = curve.radii;
  /** @param {Point} p @returns {Point} */
  const own = ([x, y]) => [(cos * x + sin * y) / rx, (cos * y - sin * x) / ry];
  const [p, q] = [own(a), own(b)];
  const half = Math.hypot(q[0] - p[0], q[1] - p[1]) / 2;
  // Radii that are too small to reach are enlarged.
  const grown = Math.max(1, half);
  const away = Math.sqrt(Math.max(0, (grown / half) ** 2 - 1)) / 2;
  const side = curve.large === curve.left ? -1 : 1;
  const middle = plus(mix(p, q, 0.5), left([q[0] - p[0], q[1] - p[1]]), side * away);
  const [start, end] = [p, q].map((point) => Math.atan2(point[1] - middle[1], point[0] - middle[0]));
  const around = 2 * Math.PI;
  const turned = (((end - start) % around) + around) % around || around;
  const sweep = curve.left ? turned : turned - around;
  const [mx, my] = [middle[0] * rx, middle[1] * ry];
  return {
    center: [cos * mx - sin * my, sin * mx + cos * my],
    u: [grown * rx * cos, grown * rx * sin],
    v: [-grown * ry * sin, grown * ry * cos],
    start,
    sweep: sweep || around,
  };
}

/** @param {Round} round @param {number} phi @returns {Point} */
const onRound = ({ center, u, v }, phi) => plus(plus(center, u, Math.cos(phi)), v, Math.sin(phi));

/** The edge's point at t, from 0 to 1. @param {Point} a @param {Point} b @param {Curve} curve @param {number} t @returns {Point} */
export function pointOn(a, b, curve, t) {
  if (!curve) return mix(a, b, t);
  if (t === 0 || t === 1) return t ? b : a;
  if (curve.kind === "curve") {
    const [ab, bc, cd] = [mix(a, curve.first, t), mix(curve.first, curve.second, t), mix(curve.second, b, t)];
    return mix(mix(ab, bc, t), mix(bc, cd, t), t);
  }
  const round = roundOf(a, b, curve);
  return onRound(round, round.start + round.sweep * t);
}

/** Chords that look like the edge. @param {Point} a @param {Point} b @param {Curve} curve */
export function chordsOf(a, b, curve) {
  if (!curve) return 1;
  if (curve.kind === "curve") return 24;
  return Math.max(6, Math.ceil((Math.abs(roundOf(a, b, curve).sweep) * 32) / Math.PI));
}

/** The parts before and after t. @param {Point} a @param {Point} b @param {Curve} curve @param {number} t @returns {{ at: Point, before: Curve, after: Curve }} */
export function splitAt(a, b, curve, t) {
  const at = pointOn(a, b, curve, t);
  if (!curve) return { at, before: null, after: null };
  if (curve.kind === "arc") {
    const [before, after] = [t, 1 - t].map((share) => /** @type {Arc} */ ({ kind: "arc", bulge: Math.tan(Math.atan(curve.bulge) * share) }));
    return { at, before, after };
  }
  if (curve.kind === "ellipse") {
    const { sweep } = roundOf(a, b, curve);
    const [before, after] = [t, 1 - t].map((share) => ({ ...curve, large: Math.abs(sweep) * share > Math.PI }));
    return { at, before, after };
  }
  const middle = mix(curve.first, curve.second, t);
  const [start, end] = [mix(a, curve.first, t), mix(curve.second, b, t)];
  return { at, before: { kind: "curve", first: start, second: mix(start, middle, t) }, after: { kind: "curve", first: mix(middle, end, t), second: end } };
}

/** The same edge from b to a. @param {Curve} curve @returns {Curve} */
export function reversed(curve) {
  switch (curve?.kind) {
    case "curve":
      return { kind: "curve", first: curve.second, second: curve.first };
    case "arc":
      return { kind: "arc", bulge: -curve.bulge };
    case "ellipse":
      return { ...curve, left: !curve.left };
    default:
      return null;
  }
}

/** The same edge, its points moved to others and lengths scaled. @param {Curve} curve @param {(point: Point) => Point} move @param {number} scale @returns {Curve} */
export function moved(curve, move, scale) {
  switch (curve?.kind) {
    case "curve":
      return { kind: "curve", first: move(curve.first), second: move(curve.second) };
    case "ellipse":
      return { ...curve, radii: [curve.radii[0] * scale, curve.radii[1] * scale] };
    default:
      return curve;
  }
}

/** The arc from a to b through a third point; a line where that is on it. @param {Point} a @param {Point} b @param {Point} through @returns {Curve} */
export function arcThrough(a, b, through) {
  const [p, q] = [plus(a, through, -1), plus(b, through, -1)];
  // The angle that a and b are seen under from there: π less half of what the arc turns by.
  const angle = Math.atan2(p[0] * q[1] - p[1] * q[0], p[0] * q[0] + p[1] * q[1]);
  const bulge = held(-Math.sign(angle) / Math.tan(Math.abs(angle) / 2));
  return Math.abs(bulge) < FLAT ? null : { kind: "arc", bulge };
}

/** The edge as a Bézier curve: itself, or as near to it as one comes. @param {Point} a @param {Point} b @param {Curve} curve @returns {Bezier} */
export function asBezier(a, b, curve) {
  if (!curve) return { kind: "curve", first: mix(a, b, 1 / 3), second: mix(a, b, 2 / 3) };
  if (curve.kind === "curve") return curve;
  const { u, v, start, sweep } = roundOf(a, b, curve);
  const reach = (4 / 3) * Math.tan(sweep / 4);
  /** The direction at an angle. @param {number} phi @returns {Point} */
  const along = (phi) => plus([-u[0] * Math.sin(phi), -u[1] * Math.sin(phi)], v, Math.cos(phi));
  return { kind: "curve", first: plus(a, along(start), reach), second: plus(b, along(start + sweep), -reach) };
}

/** The edge made a line, an arc or a curve: like what it was. @param {Point} a @param {Point} b @param {Curve} curve @param {Kind} kind @returns {Curve} */
export function converted(a, b, curve, kind) {
  if (kind === "line") return null;
  if (kind === "curve") return asBezier(a, b, curve);
  // Outlines run with the inside to their left: to the right of them is outwards.
  const arc = curve && arcThrough(a, b, pointOn(a, b, curve, 0.5));
  return arc ?? { kind: "arc", bulge: FIRST_BULGE };
}

/** @param {Curve} curve @returns {Kind} */
export const kindOf = (curve) => (curve ? (curve.kind === "curve" ? "curve" : "arc") : "line");

/** Radius of an arc. @param {Point} a @param {Point} b @param {Arc} arc */
export const radiusOf = (a, b, { bulge }) => (Math.hypot(b[0] - a[0], b[1] - a[1]) * (1 + bulge * bulge)) / (4 * Math.abs(bulge));

/** The edge that an arc of SVG's language is, with y upwards. @param {Point} a @param {Point} b @param {Elliptic} arc @returns {Curve} */
export function arcOfPath(a, b, arc) {
  const [rx, ry] = arc.radii.map(Math.abs);
  if (!rx || !ry) return null;
  if (Math.abs(rx - ry) > 1e-9 * rx) {
    const { u, v } = roundOf(a, b, { ...arc, radii: [rx, ry] });
    return { ...arc, radii: [Math.hypot(...u), Math.hypot(...v)] };
  }
  const half = Math.asin(Math.min(1, Math.hypot(b[0] - a[0], b[1] - a[1]) / 2 / rx));
  const bulge = Math.tan((arc.large ? Math.PI - half : half) / 2);
  return { kind: "arc", bulge: held(arc.left ? bulge : -bulge) };
}
