// The flow at hand: a sum of the basic ones, added up on the grid as the wind turns.

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./answers.js").Basis} Basis */
/** @typedef {import("./answers.js").Grid} Grid */
/** Circulations of the bodies; "kutta": those with which the fluid leaves at the trailing corners. @typedef {number[] | "kutta"} Circulation */

export class Wind {
  grid;
  #basis;
  /** Stream function; inside bodies that of their walls. @type {Float64Array} */ psi;
  /** Velocity, 0 inside bodies. @type {Float32Array} */ u;
  /** @type {Float32Array} */ v;
  /** Whether a point of the grid lies inside a body. */ solid;
  /** @type {number[]} */ circulation = [];
  /** ψ on each body. @type {number[]} */ walls = [];

  /** @param {Grid} grid @param {Basis} basis */
  constructor(grid, basis) {
    this.grid = grid;
    this.#basis = basis;
    const count = grid.columns * grid.rows;
    [this.psi, this.u, this.v] = [new Float64Array(count), new Float32Array(count), new Float32Array(count)];
    this.solid = Uint8Array.from(basis.flows[0].psi, (value) => (Number.isNaN(value) ? 1 : 0));
  }

  get canLeave() {
    return this.#basis.kutta !== null;
  }

  /** Turns the wind of speed 1. @param {number} angle @param {Circulation} circulation @param {(k: number) => number} bodyAt which body a solid point belongs to */
  turn(angle, circulation, bodyAt) {
    const { flows, kutta } = this.#basis;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    this.circulation = circulation === "kutta" ? (kutta?.[0] ?? []).map((x, k) => c * x + s * (kutta?.[1][k] ?? 0)) : circulation;
    const weights = [c, s, ...this.circulation];
    const { psi, solid } = this;
    psi.fill(0);
    flows.forEach((flow, j) => {
      const weight = weights[j];
      if (!weight) return;
      for (let k = 0; k < psi.length; k++) psi[k] += weight * flow.psi[k];
    });
    this.walls = flows[0].walls.map((_, body) => flows.reduce((sum, flow, j) => sum + (weights[j] ?? 0) * flow.walls[body], 0));
    this.#differentiate();
    for (let k = 0; k < psi.length; k++) if (solid[k]) psi[k] = this.walls[bodyAt(k)];
  }

  /** u = ∂ψ/∂y, v = −∂ψ/∂x by differences between points of the fluid alone. */
  #differentiate() {
    const { psi, u, v, solid, grid: { width, columns, rows } } = this;
    const size = width / columns;
    /** @param {number} at @param {number} back @param {number} on */
    const slope = (at, back, on) => (on === back ? 0 : (psi[on] - psi[back]) / (size * (back !== at && on !== at ? 2 : 1)));
    for (let row = 0; row < rows; row++) {
      for (let column = 0; column < columns; column++) {
        const at = row * columns + column;
        if (solid[at]) {
          u[at] = v[at] = 0;
          continue;
        }
        /** @param {boolean} there @param {number} neighbour */
        const fluid = (there, neighbour) => (there && !solid[neighbour] ? neighbour : at);
        u[at] = slope(at, fluid(row + 1 < rows, at + columns), fluid(row > 0, at - columns));
        v[at] = -slope(at, fluid(column > 0, at - 1), fluid(column + 1 < columns, at + 1));
      }
    }
  }

  /** The velocity at a point, between those of the grid; null outside of it and inside bodies. @param {Point} point @returns {Point | null} */
  velocity([x, y]) {
    const { center, width, columns, rows } = this.grid;
    const size = width / columns;
    const [i, j] = [(x - center[0]) / size + columns / 2 - 0.5, rows / 2 - (y - center[1]) / size - 0.5];
    const [left, top] = [Math.floor(i), Math.floor(j)];
    if (left < 0 || top < 0 || left + 1 >= columns || top + 1 >= rows) return null;
    const at = top * columns + left;
    const [a, b] = [i - left, j - top];
    let [su, sv, sum] = [0, 0, 0];
    for (const [k, weight] of [[at, (1 - a) * (1 - b)], [at + 1, a * (1 - b)], [at + columns, (1 - a) * b], [at + columns + 1, a * b]]) {
      if (this.solid[k]) continue;
      su += weight * this.u[k];
      sv += weight * this.v[k];
      sum += weight;
    }
    // Beside a wall the velocity is that of the fluid's side alone.
    return sum > 0.25 ? [su / sum, sv / sum] : null;
  }
}
