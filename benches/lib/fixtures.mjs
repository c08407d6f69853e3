// The regions of tests/fixtures, and some that need no file.

import { readFileSync } from "node:fs";
import { Region } from "conformal-warp";

/**
 * @typedef {object} Fixture
 * @property {[number, number][]} vertices
 * @property {[number, number]} center
 * @property {[number, number]} toward
 * @property {number[]} [angles] exact, where they are known
 */

/**
 * @param {string} name of a file in tests/fixtures
 * @returns {Fixture}
 */
export function fixture(name) {
  return JSON.parse(readFileSync(new URL(`../../tests/fixtures/${name}.json`, import.meta.url), "utf8"));
}

/** @type {Fixture} The square [−1, 1]², whose vertices are a quarter turn apart. */
export const square = {
  vertices: [[-1, -1], [1, -1], [1, 1], [-1, 1]],
  center: [0, 0],
  toward: [-1, -1],
  angles: [0, 1, 2, 3].map((k) => (k * Math.PI) / 2),
};

/** @param {Fixture} given */
export function regionOf({ vertices, center, toward }) {
  return new Region({ boundary: new Float64Array(vertices.flat()), center, toward });
}

/**
 * The largest difference of two lists of angles, whole turns ignored.
 *
 * @param {ArrayLike<number>} a
 * @param {ArrayLike<number>} b
 */
export function largestAngle(a, b) {
  let largest = 0;
  for (let k = 0; k < a.length; k++) {
    const turns = (a[k] - b[k]) / (2 * Math.PI);
    largest = Math.max(largest, Math.abs(turns - Math.round(turns)) * 2 * Math.PI);
  }
  return largest;
}
