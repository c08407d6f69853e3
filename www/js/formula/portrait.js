// A function as colours: arg f as an even hue, |f| as lightness, their contours; and level lines of its parts.
//
// Everything is averaged over the pixel: how much log f changes from a pixel to its neighbours says over which stretch. So
// contours keep their place and fade where they would beat with the pixels, and a hue is grey where all are met in one pixel.

import { evenHue, labToBytes } from "./oklab.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../../pkg/formula/index.js").FormulaMap} FormulaMap */
/** @typedef {"hue" | "shaded" | "contours" | "gold" | "chess"} Scheme */
/** Level lines of one part of f. @typedef {"real" | "imaginary" | "modulus" | "phase"} Part */
/** Values of f, a column and a row more than the pixels of a band; what a pixel is wide. @typedef {{ values: Float64Array, columns: number, rows: number }} Grid */

const { PI, log, hypot, atan2, cos, sin, floor, max, min, round } = Math;
const TURN = 2 * PI;

/** f over a band of rows, and a row and a column beyond, to know how it changes. @param {FormulaMap | null} map null: the points themselves @param {Frame} view @param {[number, number]} band @returns {Grid} */
export function valuesOver(map, { center, width, pixels }, [from, to]) {
  const size = width / pixels[0];
  const [columns, rows] = [pixels[0], to - from];
  const points = new Float64Array(2 * (columns + 1) * (rows + 1));
  for (let row = 0, at = 0; row <= rows; row++) {
    const y = center[1] + (0.5 * pixels[1] - (from + row + 0.5)) * size;
    for (let column = 0; column <= columns; column++) {
      points[at++] = center[0] + (column + 0.5 - 0.5 * columns) * size;
      points[at++] = y;
    }
  }
  return { values: map ? map.eval(points) : points, columns, rows };
}

/**
 * The colours of a band: RGBA, nothing where f is not defined.
 * @param {Grid} grid @param {Scheme} scheme @param {number} density contours of arg f, and of |f| so that they make squares
 * @param {Uint8ClampedArray} out
 */
export function portray({ values, columns, rows }, scheme, density, out) {
  const paint = PAINTS[scheme];
  const stride = 2 * (columns + 1);
  const step = TURN / density;
  for (let row = 0, at = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++, at += 4) {
      const k = row * stride + 2 * column;
      const [u, v] = [values[k], values[k + 1]];
      const squared = u * u + v * v;
      if (!(squared < Infinity)) {
        out[at + 3] = 0;
        continue;
      }
      // log(f there / f here), to the right and below: its real part is the change of log |f|, its imaginary one that of arg f.
      const [x, y, z, w] = [values[k + 2], values[k + 3], values[k + stride], values[k + stride + 1]];
      const du = hypot(growth(x, y, squared), growth(z, w, squared));
      const dv = hypot(atan2(y * u - x * v, x * u + y * v), atan2(w * u - z * v, z * u + w * v)) || 0;
      paint(0.5 * log(squared), atan2(v, u), du, dv, step, out, at);
      out[at + 3] = 255;
    }
  }
}

/** How much log |f| changes from |f|² to the value at x + iy. @param {number} x @param {number} y @param {number} squared */
function growth(x, y, squared) {
  const change = 0.5 * log((x * x + y * y) / squared);
  return change > -Infinity && change < Infinity ? change : 0;
}

/** @typedef {(level: number, angle: number, du: number, dv: number, step: number, out: Uint8ClampedArray, at: number) => void} Paint */

/** What the mean of all hues in a pixel keeps of its chroma, when they span so much. @param {number} span */
const kept = (span) => (span < 1e-3 ? 1 : max(0, sin(min(span, TURN) / 2) / (min(span, TURN) / 2)));

/** Lightness of the hues, and how far contours take it up and down. */
const LIGHT = 0.74;
const [CONTOUR, RIDGE] = [0.11, 0.09];

/** @type {Record<Scheme, Paint>} */
const PAINTS = {
  hue(_level, angle, _du, dv, _step, out, at) {
    evenHue(LIGHT, angle, kept(dv), out, at);
  },
  // 0 is black, 1 as light as the even hues, ∞ white.
  shaded(level, angle, _du, dv, _step, out, at) {
    const light = 0.5 + 0.5 * Math.tanh(0.45 * level);
    evenHue(0.06 + 0.92 * (light < 0.5 ? light * 2 * 0.74 : 0.74 + (light - 0.5) * 2 * 0.26), angle, kept(dv), out, at);
  },
  // Each contour is an edge from dark to light, |f| growing, arg f growing.
  contours(level, angle, du, dv, step, out, at) {
    const light = LIGHT + CONTOUR * (saw(level / step, du / step) - 0.5) + RIDGE * (saw(angle / step, dv / step) - 0.5);
    evenHue(light, angle, kept(dv), out, at);
  },
  // Around an ellipse of lightness and of blue against yellow: told apart without red and green.
  gold(level, angle, du, dv, step, out, at) {
    const soft = kept(dv);
    const light = 0.68 + 0.17 * soft * cos(angle) + 0.06 * (saw(level / step, du / step) - 0.5);
    labToBytes(light, 0, 0.11 * soft * sin(angle), out, at);
  },
  chess(level, angle, du, dv, step, out, at) {
    const light = 0.57 + 0.37 * square(level / step, du / step) * square(angle / step, dv / step);
    labToBytes(light, 0, 0, out, at);
  },
};

/** x − ⌊x⌋, its mean over a stretch about x. @param {number} x @param {number} stretch */
export function saw(x, stretch) {
  if (stretch < 1e-6) return x - floor(x);
  const integral = (/** @type {number} */ t) => 0.5 * (floor(t) + (t - floor(t)) ** 2);
  return min(1, max(0, (integral(x + stretch / 2) - integral(x - stretch / 2)) / stretch));
}

/** 1 and −1 by turns, its mean over a stretch about x. @param {number} x @param {number} stretch */
export function square(x, stretch) {
  const near = max(stretch, 1e-6);
  const integral = (/** @type {number} */ t) => {
    const rest = t - 2 * floor(t / 2);
    return rest < 1 ? rest : 2 - rest;
  };
  return (integral(x + near / 2) - integral(x - near / 2)) / near;
}

/** What a line's colour is laid over. @typedef {[red: number, green: number, blue: number, alpha: number]} Ink */

/**
 * Lines where a part of f is a multiple of `spacing` (for log |f| and arg f, of 2π/`spokes`), laid over a band.
 * @param {Grid} grid @param {Part} part @param {{ spacing: number, spokes: number, width: number, ink: Ink }} look @param {Uint8ClampedArray} out
 */
export function drawLevels({ values, columns, rows }, part, { spacing, spokes, width, ink: [red, green, blue, alpha] }, out) {
  const [stride, count] = [columns + 1, values.length / 2];
  const apart = part === "real" || part === "imaginary" ? spacing : TURN / spokes;
  const parts = new Float64Array(count);
  for (let k = 0; k < count; k++) parts[k] = partOf(part, values[2 * k], values[2 * k + 1]);
  const around = part === "phase" ? TURN : Infinity;
  /** @param {number} d */
  const shortest = (d) => (around < Infinity ? d - around * round(d / around) : d);
  for (let row = 0, at = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++, at += 4) {
      const k = row * stride + column;
      const slope = hypot(shortest(parts[k + 1] - parts[k]), shortest(parts[k + stride] - parts[k]));
      if (!(slope > 0 && slope < Infinity)) continue;
      const away = Math.abs(parts[k] - apart * round(parts[k] / apart)) / slope;
      // Lines that would run together fade out.
      const fade = min(1, max(0, (apart / slope - 2 * width) / (4 * width)));
      const share = (alpha / 255) * fade * min(1, max(0, 0.5 * width + 0.5 - away));
      if (share > 0) layOver(out, at, red, green, blue, share);
    }
  }
}

/** @param {Part} part @param {number} u @param {number} v */
function partOf(part, u, v) {
  if (part === "real") return u;
  if (part === "imaginary") return v;
  return part === "modulus" ? 0.5 * log(u * u + v * v) : atan2(v, u);
}

/** Straight alpha over straight alpha. @param {Uint8ClampedArray} out @param {number} at @param {number} red @param {number} green @param {number} blue @param {number} share */
export function layOver(out, at, red, green, blue, share) {
  const below = (out[at + 3] / 255) * (1 - share);
  const alpha = share + below;
  out[at] = (red * share + out[at] * below) / alpha;
  out[at + 1] = (green * share + out[at + 1] * below) / alpha;
  out[at + 2] = (blue * share + out[at + 2] * below) / alpha;
  out[at + 3] = 255 * alpha;
}
