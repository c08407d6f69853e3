// Specks that the fluid carries along.

import { toPlane } from "../common/frame.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./wind.js").Wind} Wind */
/** A speck's way so far, the newest place last. @typedef {{ trail: Point[], age: number, life: number }} Speck */

/** Places that a trail has. */
const TRAIL = 14;
/** Steps that a speck lives at most; they begin and end at different times. */
const LIFE = 240;

export class Particles {
  /** @type {Speck[]} */ specks = [];
  #random;

  /** @param {() => number} [random] */
  constructor(random = Math.random) {
    this.#random = random;
  }

  /** Carries so many specks along for a time. @param {Wind} wind @param {number} time in units of the plane over the wind's speed @param {number} count */
  step(wind, time, count) {
    if (this.specks.length !== count) this.specks = Array.from({ length: count }, () => this.#begin(wind, this.#random() * LIFE));
    this.specks.forEach((speck, k) => {
      const at = speck.trail[speck.trail.length - 1];
      const next = ++speck.age < speck.life ? carried(wind, at, time) : null;
      if (!next) this.specks[k] = this.#begin(wind, 0);
      else speck.trail = [...speck.trail.slice(1 - TRAIL), next];
    });
  }

  /** Forgets them: another body, another wind. */
  scatter() {
    this.specks = [];
  }

  /** @param {Wind} wind @param {number} age @returns {Speck} */
  #begin({ grid }, age) {
    const at = toPlane(grid, /** @type {Point} */ (grid.pixels.map((count) => this.#random() * count)));
    return { trail: [at], age, life: LIFE * (0.5 + 0.5 * this.#random()) };
  }
}

/** Heun's method; null where the fluid leaves the picture, or there is none. @param {Wind} wind @param {Point} at @param {number} time @returns {Point | null} */
function carried(wind, [x, y], time) {
  const first = wind.velocity([x, y]);
  if (!first) return null;
  const second = wind.velocity([x + time * first[0], y + time * first[1]]) ?? first;
  return [x + (time / 2) * (first[0] + second[0]), y + (time / 2) * (first[1] + second[1])];
}
