// A function on a grid of points around bodies, and its slopes, between points too.

/** @typedef {import("../common/frame.js").Point} Point */
/** Its points are the middles of square cells, rows from above. @typedef {{ center: Point, width: number, columns: number, rows: number }} Grid */

export class GridField {
  grid;
  /** The function; inside bodies what it is on their walls. @type {Float64Array} */ values;
  /** Its slopes along x and y, 0 inside bodies. @type {Float64Array} */ alongX;
  /** @type {Float64Array} */ alongY;
  /** Whether a point of the grid lies inside a body. @type {Uint8Array} */ solid;

  /** @param {Grid} grid @param {Float64Array} values NaN inside bodies */
  constructor(grid, values) {
    this.grid = grid;
    this.values = values;
    [this.alongX, this.alongY] = [new Float64Array(values.length), new Float64Array(values.length)];
    this.solid = Uint8Array.from(values, (value) => (Number.isNaN(value) ? 1 : 0));
  }

  /** Slopes by differences between points outside of bodies alone. */
  differentiate() {
    const { values, alongX, alongY, solid, grid: { width, columns, rows } } = this;
    const size = width / columns;
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
  slopes([x, y]) {
    const { center, width, columns, rows } = this.grid;
    const size = width / columns;
    const [i, j] = [(x - center[0]) / size + columns / 2 - 0.5, rows / 2 - (y - center[1]) / size - 0.5];
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

/** The place of a grid's point. @param {Grid} grid @param {number} k @returns {Point} */
export function placeOf({ center, width, columns, rows }, k) {
  const size = width / columns;
  return [center[0] + ((k % columns) + 0.5 - columns / 2) * size, center[1] + (rows / 2 - Math.floor(k / columns) - 0.5) * size];
}

/** The points of a grid, x, y, x, y, … @param {Grid} grid */
export function pointsOf(grid) {
  return Float64Array.from({ length: 2 * grid.columns * grid.rows }, (_, n) => placeOf(grid, n >> 1)[n & 1]);
}
