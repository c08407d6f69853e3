// What a Riemann map says of its region besides the picture: level lines of Green's function, |f'|, harmonic measure.

import { Texture } from "../../pkg/index.js";
import { flatten, onGrid, toPixels, toPlane, unflatten } from "../common/frame.js";
import { pointOn } from "./curve.js";
import { distance } from "./geometry.js";
import { edgeOf } from "./outline.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../../pkg/index.js").RiemannMap} RiemannMap */
/** @typedef {import("./outline.js").Outline} Outline */
/** Circles and rays of the disk; those of equal steps of Green's function and of its conjugate where `field`. @typedef {{ field: boolean, density: number }} Grid */

/** Points along a ring, and along a ray; of drafts fewer. */
const RING_STEPS = 240;
const RAY_STEPS = 100;
const FEWER = 3;
/** Rays end so near to the rim; the rings of a field begin so near to the centre. */
const RIM = 0.9995;
const INNERMOST = 0.03;

/** Radii of the rings. @param {Grid} grid */
function ringsOf({ field, density }) {
  if (!field) return Array.from({ length: Math.round(density / 3) }, (_, k, n = Math.round(density / 3) + 1) => (k + 1) / n);
  // Between rays 2π/n apart, steps of 2π/n in log |w| make squares.
  const count = Math.floor((density * Math.log(1 / INNERMOST)) / (2 * Math.PI));
  return Array.from({ length: count }, (_, k) => Math.exp((-2 * Math.PI * (k + 1)) / density));
}

/** The grid's lines on the disk. @param {Grid} grid @param {boolean} [fine] @returns {Float64Array[]} */
export function diskLines(grid, fine = true) {
  const [ringSteps, raySteps] = [RING_STEPS, RAY_STEPS].map((steps) => (fine ? steps : Math.round(steps / FEWER)));
  const rings = ringsOf(grid);
  const start = grid.field ? INNERMOST : 0;
  /** @type {(steps: number, at: (share: number) => [radius: number, angle: number]) => Float64Array} */
  const line = (steps, at) =>
    flatten(Array.from({ length: steps + 1 }, (_, k) => at(k / steps)).map(([radius, angle]) => [radius * Math.cos(angle), radius * Math.sin(angle)]));
  return [
    ...rings.map((radius) => line(ringSteps, (s) => [radius, 2 * Math.PI * s])),
    // Denser towards the rim, where a region may be far away.
    ...Array.from({ length: grid.density }, (_, n) => line(raySteps, (s) => [start + (RIM - start) * (1 - (1 - s) ** 1.5), (2 * Math.PI * n) / grid.density])),
  ];
}

/** The grid's lines in the region. @param {RiemannMap} map @param {Grid} grid @param {boolean} [fine] @returns {Float64Array[]} */
export function regionLines(map, grid, fine = true) {
  const lines = diskLines(grid, fine);
  const ends = lines.map(({ length }) => length);
  const all = new Float64Array(ends.reduce((sum, n) => sum + n, 0));
  let at = 0;
  for (const line of lines) {
    all.set(line, at);
    at += line.length;
  }
  const carried = map.fromDisk(all);
  at = 0;
  return ends.map((length) => carried.slice(at, (at += length)).filter(Number.isFinite));
}

/** Pixels of |f'| as colours, along the longer side of the region. */
export const DRAFT_HEAT = 96;
export const FINE_HEAT = 320;
/** Doublings of |f'|, up or down from the centre's, to the strongest colours. */
const DOUBLINGS = 4;
/** Colours from shrunk to enlarged: light in the middle, told apart by all eyes. @type {[number, number, number][]} */
const COLOURS = [[5, 48, 97], [67, 147, 195], [247, 247, 247], [230, 130, 80], [103, 0, 31]];
const HEAT_ALPHA = 185;

/**
 * |f'| over the region's box as colours, white where it is as at the centre: a picture of `side` pixels.
 * @param {{ derivative(points: Float64Array): Float64Array }} map @param {number} radius 1/|f'| at the centre
 * @param {Float64Array} boundary @param {number} side @returns {{ pixels: Uint8ClampedArray<ArrayBuffer>, frame: Frame }}
 */
export function heatOf(map, radius, boundary, side) {
  const frame = boxFrame(boundary, side);
  const [columns, rows] = frame.pixels;
  // Only what lies inside is asked: a map takes its time to say that a point lies outside.
  const places = insidePlaces(boundary, frame);
  const slopes = map.derivative(flatten(places.map((k) => toPlane(frame, [(k % columns) + 0.5, Math.floor(k / columns) + 0.5]))));
  const values = new Float64Array(columns * rows).fill(NaN);
  places.forEach((place, k) => (values[place] = Math.log2(Math.hypot(slopes[2 * k], slopes[2 * k + 1]) * radius)));
  spread(values, columns, rows);
  const pixels = new Uint8ClampedArray(4 * columns * rows);
  values.forEach((value, k) => Number.isFinite(value) && pixels.set([...colourOf(value), HEAT_ALPHA], 4 * k));
  return { pixels, frame };
}

/** 1/|f'| at a point. @param {{ derivative(points: Float64Array): Float64Array }} map @param {Point} point */
export function radiusAt(map, point) {
  const [a, b] = map.derivative(Float64Array.from(point));
  return 1 / Math.hypot(a, b);
}

/** @param {Float64Array} boundary @param {number} side @returns {Frame} */
function boxFrame(boundary, side) {
  let [left, low, right, high] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let k = 0; k < boundary.length; k += 2) {
    [left, right] = [Math.min(left, boundary[k]), Math.max(right, boundary[k])];
    [low, high] = [Math.min(low, boundary[k + 1]), Math.max(high, boundary[k + 1])];
  }
  // A pixel more all around: outlines run through the outermost.
  const size = Math.max(right - left, high - low) / (side - 2);
  const columns = Math.ceil((right - left) / size) + 2;
  const rows = Math.ceil((high - low) / size) + 2;
  return onGrid({ center: [(left + right) / 2, (low + high) / 2], width: columns * size, pixels: [1, 1] }, [columns, rows]);
}

/** The pixels whose middles lie inside, row by row. @param {Float64Array} boundary @param {Frame} frame @returns {number[]} */
function insidePlaces(boundary, frame) {
  const [columns, rows] = frame.pixels;
  const corners = unflatten(boundary).map((point) => toPixels(frame, point));
  /** @type {number[]} */
  const places = [];
  for (let row = 0; row < rows; row++) {
    const y = row + 0.5;
    const crossings = corners.flatMap(([x0, y0], k) => {
      const [x1, y1] = corners[(k + 1) % corners.length];
      return y0 > y === y1 > y ? [] : [x0 + ((y - y0) / (y1 - y0)) * (x1 - x0)];
    }).sort((a, b) => a - b);
    for (let k = 0; k + 1 < crossings.length; k += 2) {
      for (let column = Math.max(0, Math.ceil(crossings[k] - 0.5)); column + 0.5 < crossings[k + 1] && column < columns; column++) places.push(row * columns + column);
    }
  }
  return places;
}

/** Values a pixel beyond the region, so that nothing is missing at its edge. @param {Float64Array} values @param {number} columns @param {number} rows */
function spread(values, columns, rows) {
  const before = values.slice();
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      if (Number.isFinite(before[row * columns + column])) continue;
      let [sum, count] = [0, 0];
      for (let y = Math.max(0, row - 1); y <= Math.min(rows - 1, row + 1); y++) {
        for (let x = Math.max(0, column - 1); x <= Math.min(columns - 1, column + 1); x++) {
          const value = before[y * columns + x];
          if (Number.isFinite(value)) [sum, count] = [sum + value, count + 1];
        }
      }
      if (count) values[row * columns + column] = sum / count;
    }
  }
}

/** @param {number} doublings @returns {[number, number, number]} */
function colourOf(doublings) {
  const place = (Math.max(-1, Math.min(1, doublings / DOUBLINGS)) + 1) * 2;
  const from = Math.min(3, Math.floor(place));
  const [a, b] = [COLOURS[from], COLOURS[from + 1]];
  return /** @type {[number, number, number]} */ (a.map((value, k) => value + (b[k] - value) * (place - from)));
}

/** Colours over the region → colours where the map takes it. @param {{ warp: import("../../pkg/index.js").RegionMap["warp"] }} map @param {{ pixels: Uint8ClampedArray, frame: Frame }} heat @param {Frame} view @returns {{ pixels: Uint8ClampedArray<ArrayBuffer>, frame: Frame }} */
export function carriedHeat(map, { pixels, frame }, view) {
  const texture = new Texture(pixels, ...frame.pixels);
  const warped = map.warp(texture, { texture: frame, view, direction: "push-forward", quality: "bilinear" });
  texture.free();
  return { pixels: /** @type {Uint8ClampedArray<ArrayBuffer>} */ (warped), frame: view };
}

/** Places along an edge at which the measure is looked at: dense at both ends, where corners make it large or small. */
const PLACES = Array.from({ length: 16 }, (_, k) => (1 - Math.cos((Math.PI * (k + 0.5)) / 16)) / 2);
/** They lie inside by this share of the way between the edge's ends; its direction is that between places so near in its parameter. */
const INSIDE = 1e-5;
const NEARBY = 1e-4;
/** The fence is as high as this share of the region's conformal radius where the density is that of a circle seen from its middle, and never higher than five times that. */
const HEIGHT = 0.12;
const HIGHEST = 5;

/**
 * The density of harmonic measure |f'|/2π on the boundary, as a fence: from the outline outwards.
 * @param {RiemannMap} map @param {Outline} outline counter-clockwise @returns {Float64Array} a closed line: along the outline, and back along the fence's top
 */
export function fenceOf(map, outline) {
  const count = outline.boundary.length;
  /** @type {Point[]} */
  const feet = [];
  /** @type {Point[]} */
  const normals = [];
  const looked = new Float64Array(2 * count * PLACES.length);
  for (let k = 0, n = 0; k < count; k++) {
    const edge = edgeOf(outline, k);
    for (const t of PLACES) {
      const [x, y] = pointOn(...edge, t);
      const [[ux, uy], [vx, vy]] = [pointOn(...edge, t - NEARBY), pointOn(...edge, t + NEARBY)];
      const length = Math.hypot(vx - ux, vy - uy) || 1;
      const normal = /** @type {Point} */ ([(vy - uy) / length, (ux - vx) / length]);
      const inside = INSIDE * distance(edge[0], edge[1]);
      feet.push([x, y]);
      normals.push(normal);
      looked[n++] = x - inside * normal[0];
      looked[n++] = y - inside * normal[1];
    }
  }
  const slopes = map.derivative(looked);
  const radius = map.conformalRadius;
  const tops = feet.map(([x, y], k) => {
    const density = Math.hypot(slopes[2 * k], slopes[2 * k + 1]) * radius;
    const height = HEIGHT * radius * (Number.isFinite(density) ? Math.min(HIGHEST, density) : 0);
    return /** @type {Point} */ ([x + height * normals[k][0], y + height * normals[k][1]]);
  });
  return flatten([...feet, feet[0], tops[0], ...tops.reverse()]);
}

/** A circle about 0. @param {number} radius @returns {Float64Array} */
export const circleLine = (radius) => flatten(Array.from({ length: 361 }, (_, k) => [radius * Math.cos((2 * Math.PI * k) / 360), radius * Math.sin((2 * Math.PI * k) / 360)]));

/** The unit circle. */
export const UNIT_CIRCLE = circleLine(1);

/** The fence of the circle, where the measure is spread evenly. */
export const CIRCLE_FENCE = new Float64Array([...UNIT_CIRCLE, ...circleLine(1 + HEIGHT / 3)]);
