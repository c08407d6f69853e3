// The flow at hand: a sum of the basic ones, added up on the grid as the wind turns.

import { GridField } from "./grid-field.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./answers.js").Basis} Basis */
/** @typedef {import("../common/frame.js").Frame} Frame */
/** Circulations of the bodies; "kutta": those with which the fluid leaves at the trailing corners. @typedef {number[] | "kutta"} Circulation */

/** Its values are those of the stream function ψ. */
export class Wind extends GridField {
  #basis;
  /** @type {number[]} */ circulation = [];
  /** ψ on each body. @type {number[]} */ walls = [];

  /** @param {Frame} grid @param {Basis} basis */
  constructor(grid, basis) {
    super(grid, Float64Array.from(basis.flows[0].psi));
    this.#basis = basis;
  }

  get canLeave() {
    return this.#basis.kutta !== null;
  }

  /** Turns the wind of speed 1. @param {number} angle @param {Circulation} circulation @param {(k: number) => number} bodyAt which body a solid point belongs to */
  turn(angle, circulation, bodyAt) {
    const { flows, kutta } = this.#basis;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    this.circulation = circulation === "kutta" ? (kutta?.[0] ?? []).map((x, k) => c * x + s * (kutta?.[1][k] ?? 0) + (kutta?.[2][k] ?? 0)) : circulation;
    const weights = [c, s, ...this.circulation, 1];
    const { values } = this;
    values.fill(0);
    flows.forEach((flow, j) => {
      const weight = weights[j];
      if (!weight) return;
      for (let k = 0; k < values.length; k++) values[k] += weight * flow.psi[k];
    });
    this.walls = flows[0].walls.map((_, body) => flows.reduce((sum, flow, j) => sum + (weights[j] ?? 0) * flow.walls[body], 0));
    this.differentiate();
    this.fill((k) => this.walls[bodyAt(k)]);
  }

  /** The velocity (∂ψ/∂y, −∂ψ/∂x) at a point; null outside of the grid and inside bodies. @param {Point} point @returns {Point | null} */
  velocity(point) {
    const slopes = this.slopes(point);
    return slopes && [slopes[1], -slopes[0]];
  }
}
