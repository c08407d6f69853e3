// A point carried through a joint triangulation: found in a triangle of one copy, put at the same place in the other.

/** @typedef {import("../common/frame.js").Point} Point */
/** The two copies of a joint triangulation. @typedef {{ source: Float64Array, target: Float64Array, triangles: Uint32Array }} Mesh */
/** @typedef {import("../common/probe.js").Side} Side */

/** Triangles by the cells of a grid over them. */
class Index {
  /** @param {Float64Array} points @param {Uint32Array} triangles */
  constructor(points, triangles) {
    this.points = points;
    this.triangles = triangles;
    let [left, low, right, high] = [Infinity, Infinity, -Infinity, -Infinity];
    for (let k = 0; k < points.length; k += 2) {
      left = Math.min(left, points[k]);
      right = Math.max(right, points[k]);
      low = Math.min(low, points[k + 1]);
      high = Math.max(high, points[k + 1]);
    }
    this.cells = Math.max(1, Math.round(Math.sqrt(triangles.length / 6)));
    this.origin = [left, low];
    this.steps = [(right - left) / this.cells || 1, (high - low) / this.cells || 1];
    /** Where each cell's triangles begin in `found`, and end where the next one's begin. */
    this.begins = new Uint32Array(this.cells ** 2 + 1);
    this.#eachPlace((cell) => this.begins[cell + 1]++);
    for (let cell = 0; cell < this.cells ** 2; cell++) this.begins[cell + 1] += this.begins[cell];
    this.found = new Uint32Array(this.begins[this.cells ** 2]);
    const next = this.begins.slice();
    this.#eachPlace((cell, t) => (this.found[next[cell]++] = t));
  }

  /** Every cell that the box of a triangle meets. @param {(cell: number, triangle: number) => void} tell */
  #eachPlace(tell) {
    const { triangles, points } = this;
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [2 * triangles[t], 2 * triangles[t + 1], 2 * triangles[t + 2]];
      const [first, last] = [this.#cell(0, Math.min(points[a], points[b], points[c])), this.#cell(0, Math.max(points[a], points[b], points[c]))];
      const [under, over] = [this.#cell(1, Math.min(points[a + 1], points[b + 1], points[c + 1])), this.#cell(1, Math.max(points[a + 1], points[b + 1], points[c + 1]))];
      for (let j = under; j <= over; j++) {
        for (let i = first; i <= last; i++) tell(i + this.cells * j, t);
      }
    }
  }

  /** @param {0 | 1} axis @param {number} value */
  #cell(axis, value) {
    return Math.min(this.cells - 1, Math.max(0, Math.floor((value - this.origin[axis]) / this.steps[axis])));
  }

  /** The triangle that holds (x, y), with barycentric weights. @param {Point} point */
  find([x, y]) {
    const cell = this.#cell(0, x) + this.cells * this.#cell(1, y);
    const { points: p, triangles } = this;
    for (let k = this.begins[cell]; k < this.begins[cell + 1]; k++) {
      const t = this.found[k];
      const [a, b, c] = [2 * triangles[t], 2 * triangles[t + 1], 2 * triangles[t + 2]];
      const twice = (p[b] - p[a]) * (p[c + 1] - p[a + 1]) - (p[b + 1] - p[a + 1]) * (p[c] - p[a]);
      const u = ((x - p[a]) * (p[c + 1] - p[a + 1]) - (y - p[a + 1]) * (p[c] - p[a])) / twice;
      const v = ((p[b] - p[a]) * (y - p[a + 1]) - (p[b + 1] - p[a + 1]) * (x - p[a])) / twice;
      if (u >= -1e-9 && v >= -1e-9 && u + v <= 1 + 1e-9) return { corners: [a, b, c], weights: [1 - u - v, u, v] };
    }
    return null;
  }
}

export class Locator {
  #mesh;
  /** @type {Partial<Record<Side, Index>>} */
  #indices = {};

  /** @param {Mesh} mesh */
  constructor(mesh) {
    this.#mesh = mesh;
  }

  /** Points of one side → the other side; null outside. @param {Side} from @param {Point[]} points */
  carry(from, points) {
    return points.map((point) => this.at(from, point));
  }

  /** A point of one side → the other side; null outside. @param {Side} from @param {Point} point @returns {Point | null} */
  at(from, point) {
    const mesh = this.#mesh;
    this.#indices[from] ??= new Index(mesh[from], mesh.triangles);
    const found = this.#indices[from].find(point);
    if (!found) return null;
    const to = mesh[from === "source" ? "target" : "source"];
    /** @type {Point} */
    const image = [0, 0];
    found.corners.forEach((corner, k) => {
      image[0] += found.weights[k] * to[corner];
      image[1] += found.weights[k] * to[corner + 1];
    });
    return image;
  }
}
