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
    /** @type {number[][]} */
    this.buckets = Array.from({ length: this.cells ** 2 }, () => []);
    for (let t = 0; t < triangles.length; t += 3) this.#add(t);
  }

  /** @param {number} t */
  #add(t) {
    const xs = [0, 1, 2].map((k) => this.#cell(0, this.points[2 * this.triangles[t + k]]));
    const ys = [0, 1, 2].map((k) => this.#cell(1, this.points[2 * this.triangles[t + k] + 1]));
    for (let i = Math.min(...xs); i <= Math.max(...xs); i++) {
      for (let j = Math.min(...ys); j <= Math.max(...ys); j++) this.buckets[i + this.cells * j].push(t);
    }
  }

  /** @param {0 | 1} axis @param {number} value */
  #cell(axis, value) {
    return Math.min(this.cells - 1, Math.max(0, Math.floor((value - this.origin[axis]) / this.steps[axis])));
  }

  /** The triangle that holds (x, y), with barycentric weights. @param {Point} point */
  find([x, y]) {
    for (const t of this.buckets[this.#cell(0, x) + this.cells * this.#cell(1, y)]) {
      const [a, b, c] = [0, 1, 2].map((k) => 2 * this.triangles[t + k]);
      const p = this.points;
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
