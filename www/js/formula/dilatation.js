// What a map that need not be analytic does to small circles: f(z + h) ≈ f(z) + p h + q h̄, with p = ∂f/∂z, q = ∂f/∂z̄.
//
// It stretches by |p| + |q| one way and by | |p| − |q| | across it; μ = q/p, the complex dilatation, says how far and which
// way: where |μ| > 1 the sense of turning is reversed.

import { layOver } from "./portrait.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../../pkg/formula/index.js").FormulaMap} FormulaMap */
/** p and q at each point, as flat pairs; NaN where f is not defined. @typedef {{ p: Float64Array, q: Float64Array }} Slopes */
/** What is seen of it over a view: the most that a circle is drawn out, the largest and the least |μ|. @typedef {{ longest: number, most: number, least: number }} Dilatation */

/** Steps of the differences, in shares of the size of z; together they are exact to the fourth order. */
const STEP = 1e-3;
/** Places a side at which a view is looked at. */
const SIDE = 24;

/** @param {FormulaMap} map @param {Float64Array} points flat @returns {Slopes} */
export function slopes(map, points) {
  const p = map.derivative(points);
  const q = new Float64Array(points.length);
  if (map.isAnalytic) return { p, q };
  const steps = [1, -1, 0.5, -0.5].map((share) => points.map((x, k) => (k % 2 ? x : x + share * stepAt(points, k))));
  const [right, left, near, far] = steps.map((at) => map.eval(at));
  for (let k = 0; k < points.length; k++) {
    const step = stepAt(points, k - (k % 2));
    // ∂f/∂x = p + q, by Richardson's rule.
    q[k] = (4 * (near[k] - far[k])) / (3 * step) - (right[k] - left[k]) / (6 * step) - p[k];
  }
  return { p, q };
}

/** @param {Float64Array} points @param {number} k */
const stepAt = (points, k) => STEP * Math.max(0.05, Math.hypot(points[k], points[k + 1]));

/** h with p h + q h̄ = r. @param {Slopes} slopes @param {number} k @param {number} u @param {number} v r = u + iv @returns {Point} */
export function solved({ p, q }, k, u, v) {
  const [a, b, c, d] = [p[2 * k], p[2 * k + 1], q[2 * k], q[2 * k + 1]];
  const size = a * a + b * b - c * c - d * d;
  // (p̄ r − q r̄) / (|p|² − |q|²)
  return [(a * u + b * v - (c * u + d * v)) / size, (a * v - b * u - (d * u - c * v)) / size];
}

/** What a map does over a view. @param {FormulaMap} map @param {Frame} view @returns {Dilatation | null} */
export function dilatationOver(map, { center, width, pixels }) {
  if (map.isAnalytic) return null;
  const height = (width * pixels[1]) / pixels[0];
  const points = Float64Array.from({ length: 2 * SIDE * SIDE }, (_, n) => {
    const [k, share] = [n >> 1, (/** @type {number} */ j) => (j + 0.5) / SIDE - 0.5];
    return n % 2 ? center[1] + height * share(Math.floor(k / SIDE)) : center[0] + width * share(k % SIDE);
  });
  const { p, q } = slopes(map, points);
  const found = { longest: 1, most: 0, least: Infinity };
  for (let k = 0; k < points.length; k += 2) {
    const [size, turned] = [Math.hypot(p[k], p[k + 1]), Math.hypot(q[k], q[k + 1])];
    if (!(size + turned > 0 && size + turned < Infinity)) continue;
    found.longest = Math.max(found.longest, (size + turned) / Math.abs(size - turned));
    found.most = Math.max(found.most, turned / size);
    found.least = Math.min(found.least, turned / size);
  }
  return found;
}

/** Differences leave so much where there is nothing. */
const NOTHING = 1e-6;

/** |μ|, which no line's end may part. */
const SIZE = "|\u2060μ\u2060|";
/** Longer ellipses are as good as flat. */
const FLAT = 1000;

/** The evidence in words. @param {Dilatation} dilatation */
export function dilatationWords({ longest, most, least }) {
  if (most < NOTHING) return "Not written as an analytic formula, but angles are kept all over this view.";
  if (least > 1 / NOTHING) return "Not analytic: angles are kept, but the other way round (f_z = 0).";
  if (least > 1 - NOTHING && most < 1 + NOTHING) return `Not analytic: all is pressed onto curves (${SIZE} = 1).`;
  const sense = least > 1 ? ", turned the other way round" : most > 1 + NOTHING ? ", in places turned the other way round" : "";
  const length = longest < FLAT ? `up to ${longest.toFixed(longest < 10 ? 2 : 0)} times as long as wide` : `flat where ${SIZE} = 1`;
  const range = least > 1 ? `${SIZE} at least ${least.toFixed(2)}` : `${SIZE} up to ${most < FLAT ? most.toFixed(2) : "∞"}`;
  return `Not analytic: circles become ellipses${sense}, ${length} (${range}).`;
}

/** The two dilatations at a place. @param {Slopes} slopes of one point */
export function placeWords({ p, q }) {
  const [size, turned] = [Math.hypot(p[0], p[1]), Math.hypot(q[0], q[1])];
  if (!(size + turned < Infinity)) return "";
  const [most, least] = [size + turned, Math.abs(size - turned)];
  const mu = [(q[0] * p[0] + q[1] * p[1]) / size ** 2, (q[1] * p[0] - q[0] * p[1]) / size ** 2];
  const sense = turned > size * (1 + NOTHING) ? ", the other way round" : "";
  const dilatation = size > NOTHING * turned ? complex(mu) : "∞";
  return `f stretches ${short(most)} times along and ${short(least < NOTHING * most ? 0 : least)} across${sense}: |f_z| = ${short(size)}, |f_z̄| = ${short(turned < NOTHING * size ? 0 : turned)}, μ = ${dilatation}.`;
}

/** With three digits, and none beyond four places. @param {number} x */
const short = (x) => String(Math.abs(x) < 0.1 ? Number(x.toFixed(4)) : Number(x.toPrecision(3))).replace("-", "−");

/** @param {number[]} z */
function complex([x, y]) {
  const small = NOTHING * Math.hypot(x, y);
  if (Math.abs(y) <= small || Math.hypot(x, y) < NOTHING) return short(Math.hypot(x, y) < NOTHING ? 0 : x);
  return Math.abs(x) <= small ? `${short(y)}i` : `${short(x)} ${y < 0 ? "−" : "+"} ${short(Math.abs(y))}i`;
}

/** Sizes of the ellipses, in shares of their distance: a circle's radius, the longest half axis, the shortest one. */
const [RADIUS, LONGEST, FLATTEST] = [0.34, 0.46, 0.02];
/** Those that are turned the other way round are filled so far. */
const FILL = 0.45;
/** Around each there is so much of the opposite colour. */
const HALO = 0.4;

/**
 * Small ellipses that f takes to circles, all of the same area unless they are too long, laid over rows of a view.
 * @param {FormulaMap} map @param {{ view: Frame, out: Uint8ClampedArray, rows: [number, number] }} place
 * @param {{ spacing: number, width: number, ink: import("./portrait.js").Ink }} look
 */
export function drawEllipses(map, { view: { center, width, pixels }, out, rows: [from, to] }, { spacing, width: thick, ink: [red, green, blue, alpha] }) {
  const size = width / pixels[0];
  const [left, top] = [center[0] - width / 2, center[1] + (pixels[1] / 2) * size];
  const cell = Math.max(spacing, 12 * size);
  const [firstColumn, firstRow] = [Math.floor(left / cell), Math.floor((top - to * size) / cell)];
  const columns = Math.floor((left + width) / cell) - firstColumn + 1;
  const lines = Math.floor((top - from * size) / cell) - firstRow + 1;
  const middles = Float64Array.from({ length: 2 * columns * lines }, (_, n) => ((n % 2 ? firstRow + Math.floor((n >> 1) / columns) : firstColumn + ((n >> 1) % columns)) + 0.5) * cell);
  const shapes = ellipses(slopes(map, middles), cell);
  for (let row = from; row < to; row++) {
    const y = top - (row + 0.5) * size;
    const line = Math.floor(y / cell) - firstRow;
    for (let column = 0; column < pixels[0]; column++) {
      const x = left + (column + 0.5) * size;
      const k = line * columns + Math.floor(x / cell) - firstColumn;
      const shape = shapes[k];
      if (!shape) continue;
      const away = distance(shape, x - middles[2 * k], y - middles[2 * k + 1]) / size;
      const [rim, halo] = [thick / 2, thick].map((half) => within(Math.abs(away) - half));
      const share = (alpha / 255) * Math.max(rim, shape.over ? FILL * within(away) : 0);
      const at = 4 * ((row - from) * pixels[0] + column);
      if (halo > 0) layOver(out, at, 255 - red, 255 - green, 255 - blue, HALO * halo);
      if (share > 0) layOver(out, at, red, green, blue, share);
    }
  }
}

/** How much of a pixel is covered that lies so far outside. @param {number} away in pixels */
const within = (away) => Math.min(1, Math.max(0, 0.5 - away));

/** Half axes of an ellipse, the way of the shorter one, whether it is turned over. @typedef {{ long: number, short: number, cos: number, sin: number, over: boolean }} Ellipse */

/** What f makes small circles of: along the shorter axis it stretches most. @param {Slopes} slopes @param {number} cell @returns {(Ellipse | null)[]} */
function ellipses({ p, q }, cell) {
  return Array.from({ length: p.length / 2 }, (_, n) => {
    const k = 2 * n;
    const [keeps, turns] = [Math.hypot(p[k], p[k + 1]), Math.hypot(q[k], q[k + 1])];
    if (!(keeps + turns > 0 && keeps + turns < Infinity)) return null;
    const ratio = Math.sqrt(Math.abs(keeps - turns) / (keeps + turns));
    const long = cell * Math.min(RADIUS / ratio, LONGEST);
    const angle = Math.atan2(q[k + 1] * p[k] - q[k] * p[k + 1], q[k] * p[k] + q[k + 1] * p[k + 1]) / 2;
    return { long, short: Math.max(long * ratio * ratio, FLATTEST * cell), cos: Math.cos(angle), sin: Math.sin(angle), over: turns > keeps * (1 + NOTHING) };
  });
}

/** How far outside an ellipse a place lies, to first order. @param {Ellipse} ellipse @param {number} x @param {number} y */
function distance({ long, short, cos, sin }, x, y) {
  const [u, v] = [(x * cos + y * sin) / short, (y * cos - x * sin) / long];
  const size = Math.hypot(u, v) || 1e-9;
  const near = ((size - 1) * size) / (Math.hypot(u / short, v / long) || 1e-9);
  // Beyond its ends a flat one's first order is too near.
  return Math.max(near, Math.abs(v * long) - long);
}
