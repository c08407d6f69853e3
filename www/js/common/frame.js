// Where a picture lies in the plane. Pixel centres are at +0.5, rows count downwards, the plane has y up.

/** @typedef {[number, number]} Point a point of the plane, or of the pixel grid */
/** @typedef {{ center: Point, width: number, pixels: Point }} Frame plane units across `pixels` = [columns, rows] */

/** The disk's picture spans a little more than [−1, 1], so that its rim and labels are seen. */
const DISK_WIDTH = 2.12;

/** Pixel coordinates → plane. @param {Frame} frame @param {Point} pixel @returns {Point} */
export function toPlane(frame, [x, y]) {
  const size = frame.width / frame.pixels[0];
  return [
    frame.center[0] + (x - 0.5 * frame.pixels[0]) * size,
    frame.center[1] + (0.5 * frame.pixels[1] - y) * size,
  ];
}

/** Plane → pixel coordinates; the inverse of `toPlane`. @param {Frame} frame @param {Point} point @returns {Point} */
export function toPixels(frame, [x, y]) {
  const size = frame.width / frame.pixels[0];
  return [
    (x - frame.center[0]) / size + 0.5 * frame.pixels[0],
    0.5 * frame.pixels[1] - (y - frame.center[1]) / size,
  ];
}

/** Pixels per plane unit. @param {Frame} frame */
export function scaleOf(frame) {
  return frame.pixels[0] / frame.width;
}

/**
 * The frame of a photo: its longer side spans [−1, 1]. A region keeps its place when a photo is stored larger or smaller.
 * @param {number} width @param {number} height @returns {Frame}
 */
export function photoFrame(width, height) {
  return { center: [0, 0], width: (2 * width) / Math.max(width, height), pixels: [width, height] };
}

/** The same part of the plane on another pixel grid. @param {Frame} frame @param {Point} pixels @returns {Frame} */
export function onGrid(frame, pixels) {
  return { ...frame, pixels };
}

/** The same, with so many pixels along the longer side. @param {Frame} frame @param {number} side @returns {Frame} */
export function scaledTo(frame, side) {
  const scale = side / Math.max(...frame.pixels);
  return { ...frame, pixels: [Math.max(1, Math.round(frame.pixels[0] * scale)), Math.max(1, Math.round(frame.pixels[1] * scale))] };
}

/** The frame of the unit disk's picture. @param {number} side pixels @returns {Frame} */
export function diskFrame(side) {
  return { center: [0, 0], width: DISK_WIDTH, pixels: [side, side] };
}

/** [[x0, y0], [x1, y1], …] → [x0, y0, x1, y1, …]. @param {Point[]} points */
export function flatten(points) {
  return new Float64Array(points.flat());
}

/** [x0, y0, x1, y1, …] → [[x0, y0], [x1, y1], …]. @param {ArrayLike<number>} flat @returns {Point[]} */
export function unflatten(flat) {
  /** @type {Point[]} */
  const points = [];
  for (let k = 0; k + 1 < flat.length; k += 2) points.push([flat[k], flat[k + 1]]);
  return points;
}

/** The same, with null for points that are none. @param {ArrayLike<number>} flat @returns {(Point | null)[]} */
export const known = (flat) => unflatten(flat).map((p) => (Number.isFinite(p[0]) ? p : null));
