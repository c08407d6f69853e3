// Bodies in the wind: ready-made ones, and those that a visitor draws or loads.

import { area } from "../editor/geometry.js";

/** @typedef {import("../common/frame.js").Point} Point */
/**
 * @typedef {object} Bodies
 * @property {string} title
 * @property {Point[][]} outlines counter-clockwise
 * @property {"polygon" | "smooth"} curve
 * @property {number[] | null} trailing of each body the corner at which the fluid leaves it; null where none has an edge
 */

/** @type {(count: number, at: (turn: number) => Point) => Point[]} */
const around = (count, at) => Array.from({ length: count }, (_, k) => at((2 * Math.PI * k) / count));

/** A circle. @param {Point} center @param {number} radius @returns {Point[]} */
const circle = ([x, y], radius) => around(64, (t) => [x + radius * Math.cos(t), y + radius * Math.sin(t)]);

/** Points of each side of a wing. */
const SIDE = 36;

/**
 * A wing of the NACA's four-digit family, with a closed trailing edge, which comes first; counter-clockwise.
 * @param {string} digits @param {number} chord @param {Point} nose @param {number} [turn] nose up, in radians @returns {Point[]}
 */
export function naca(digits, chord, nose, turn = 0) {
  const [m, p, t] = [Number(digits[0]) / 100, Number(digits[1]) / 10, Number(digits.slice(2)) / 100];
  /** @param {number} x @param {1 | -1} side @returns {Point} */
  const at = (x, side) => {
    const half = 5 * t * (0.2969 * Math.sqrt(x) - 0.126 * x - 0.3516 * x ** 2 + 0.2843 * x ** 3 - 0.1036 * x ** 4);
    const before = x < p;
    const camber = m === 0 ? 0 : before ? (m / p ** 2) * (2 * p * x - x ** 2) : (m / (1 - p) ** 2) * (1 - 2 * p + 2 * p * x - x ** 2);
    const slope = m === 0 ? 0 : Math.atan(before ? ((2 * m) / p ** 2) * (p - x) : ((2 * m) / (1 - p) ** 2) * (p - x));
    return [x - side * half * Math.sin(slope), camber + side * half * Math.cos(slope)];
  };
  // Closer together at both ends, where the outline bends.
  const share = (/** @type {number} */ k) => 0.5 * (1 - Math.cos((Math.PI * k) / SIDE));
  const upper = Array.from({ length: SIDE }, (_, k) => at(share(SIDE - k), 1));
  const lower = Array.from({ length: SIDE }, (_, k) => at(share(k), -1));
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  return [...upper, ...lower].map(([x, y]) => [nose[0] + chord * (c * x + s * y), nose[1] + chord * (c * y - s * x)]);
}

/** Ready-made bodies by name. @type {Map<string, Bodies>} */
export const bodies = new Map(Object.entries({
  wing: { title: "Wing (NACA 4412)", outlines: [naca("4412", 2.2, [-1.1, 0])], curve: "polygon", trailing: [0] },
  symmetric: { title: "Symmetric wing (NACA 0012)", outlines: [naca("0012", 2.2, [-1.1, 0])], curve: "polygon", trailing: [0] },
  flap: {
    title: "Wing and flap",
    outlines: [naca("4412", 1.7, [-1.25, 0.1]), naca("0012", 0.62, [0.5, -0.02], 0.5)],
    curve: "polygon",
    trailing: [0, 0],
  },
  circle: { title: "Cylinder", outlines: [circle([0, 0], 0.75)], curve: "smooth", trailing: null },
  ellipse: { title: "Elliptic cylinder", outlines: [around(80, (t) => [1.1 * Math.cos(t), 0.45 * Math.sin(t)])], curve: "smooth", trailing: null },
  pair: { title: "Two cylinders", outlines: [circle([-0.1, 0.75], 0.5), circle([0.1, -0.7], 0.5)], curve: "smooth", trailing: null },
  three: { title: "Three cylinders", outlines: [circle([-0.8, 0], 0.4), circle([0.5, 0.7], 0.4), circle([0.5, -0.7], 0.4)], curve: "smooth", trailing: null },
  square: { title: "Square", outlines: [[[-0.7, -0.7], [0.7, -0.7], [0.7, 0.7], [-0.7, 0.7]]], curve: "polygon", trailing: null },
}));

/** One body from an outline: its sharpest outward corner is where the fluid leaves it. @param {string} title @param {Point[]} outline @returns {Bodies} */
export function bodyOf(title, outline) {
  const boundary = area(outline) < 0 ? [...outline].reverse() : outline;
  const n = boundary.length;
  /** @param {number} k */
  const turnAt = (k) => {
    const [[x0, y0], [x1, y1], [x2, y2]] = [boundary[(k + n - 1) % n], boundary[k], boundary[(k + 1) % n]];
    return Math.atan2((x1 - x0) * (y2 - y1) - (y1 - y0) * (x2 - x1), (x1 - x0) * (x2 - x1) + (y1 - y0) * (y2 - y1));
  };
  const turns = boundary.map((_, k) => turnAt(k));
  return { title, outlines: [boundary], curve: "polygon", trailing: [turns.indexOf(Math.max(...turns))] };
}

/** An outline moved and scaled to the middle of the wind. @param {Point[]} outline @returns {Point[]} */
export function placed(outline) {
  const [xs, ys] = [0, 1].map((k) => outline.map((p) => p[k]));
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const scale = Math.min(2.2 / (right - left), 1.9 / (high - low));
  return outline.map(([x, y]) => [scale * (x - (left + right) / 2), scale * (y - (low + high) / 2)]);
}
