// A function on a grid of points around bodies, and its slopes, between points too.

import { flatten, scaleOf, toPixels, toPlane } from "../common/frame.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */

/** The points are the middles of a frame's pixels. */
export class GridField {
  grid;
  /** The function; inside bodies what it is on their walls. @type {Float64Array} */ values;
  /** Its slopes along x and y, 0 inside bodies. @type {Float64Array} */ alongX;
  /** @type {Float64Array} */ alongY;
  /** Whether a point of the grid lies inside a body. @type {Uint8Array} */ solid;

  /** @param {Frame} grid @param {Float64Array} values NaN inside bodies */
  constructor(grid, values) {
    this.grid = grid;
    this.values = values;
    [this.alongX, this.alongY] = [new Float64Array(values.length), new Float64Array(values.length)];
    this.solid = Uint8Array.from(values, (value) => (Number.isNaN(value) ? 1 : 0));
  }

  /** Slopes by differences between points outside of bodies alone. */
  differentiate() {
    const { values, alongX, alongY, solid, grid } = this;
    const [columns, rows] = grid.pixels;
    const size = 1 / scaleOf(grid);
    /** @param {number} at @param {number} back @param {number} on */
    const slope = (at, back, on) => (on === back ? 0 : (values[on] - values[back]) / (size * (back !== at && on !== at ? 2 : 1)));
    for (let row = 0; row < rows; row++) {
      for (let column = 0; column < columns; column++) {
        const at = row * columns + column;
        if (solid[at]) {
          alongX[at] = alongY[at] = 0;
          continue;
        }
        /** @param {boolean} there @param {number} neighbour */
        const free = (there, neighbour) => (there && !solid[neighbour] ? neighbour : at);
        alongX[at] = slope(at, free(column > 0, at - 1), free(column + 1 < columns, at + 1));
        alongY[at] = slope(at, free(row + 1 < rows, at + columns), free(row > 0, at - columns));
      }
    }
  }

  /** Gives the points inside of bodies the values of their walls. @param {(k: number) => number} wallAt */
  fill(wallAt) {
    for (let k = 0; k < this.values.length; k++) if (this.solid[k]) this.values[k] = wallAt(k);
  }

  /** The slopes at a point, between those of the grid; null outside of it and inside bodies. @param {Point} point @returns {Point | null} */
  slopes(point) {
    const [columns, rows] = this.grid.pixels;
    const [i, j] = toPixels(this.grid, point).map((pixel) => pixel - 0.5);
    const [left, top] = [Math.floor(i), Math.floor(j)];
    if (left < 0 || top < 0 || left + 1 >= columns || top + 1 >= rows) return null;
    const at = top * columns + left;
    const [a, b] = [i - left, j - top];
    let [sumX, sumY, sum] = [0, 0, 0];
    for (const [k, weight] of [[at, (1 - a) * (1 - b)], [at + 1, a * (1 - b)], [at + columns, (1 - a) * b], [at + columns + 1, a * b]]) {
      if (this.solid[k]) continue;
      sumX += weight * this.alongX[k];
      sumY += weight * this.alongY[k];
      sum += weight;
    }
    // Beside a wall the slopes are those of its free side alone.
    return sum > 0.25 ? [sumX / sum, sumY / sum] : null;
  }
}

/** The place of a grid's point. @param {Frame} grid @param {number} k */
export function placeOf(grid, k) {
  const [columns] = grid.pixels;
  return toPlane(grid, [(k % columns) + 0.5, Math.floor(k / columns) + 0.5]);
}

/** The points of a grid, x, y, x, y, … @param {Frame} grid */
export function pointsOf(grid) {
  const [columns, rows] = grid.pixels;
  return flatten(Array.from({ length: columns * rows }, (_, k) => placeOf(grid, k)));
}
