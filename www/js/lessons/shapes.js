// A region of the lessons, and the lines of the disk.

import { around } from "./board.js";
import { contains, nearestOnBoundary } from "../editor/geometry.js";

/** @typedef {import("../common/frame.js").Point} Point */

/** A room with a niche: five corners point outward, one inward. @type {Point[]} */
export const ROOM = [[-0.9, -0.8], [0.9, -0.8], [0.9, 0.1], [0.2, 0.1], [0.2, 0.85], [-0.9, 0.85]];

/** Circles and rays of the disk. @type {{ circles: Point[][], rays: Point[][] }} */
export const POLAR = {
  circles: [0.2, 0.4, 0.6, 0.8, 0.95].map((r) => closed(around([0, 0], r, 480))),
  rays: Array.from({ length: 24 }, (_, k) => {
    const turn = (2 * Math.PI * k) / 24;
    return Array.from({ length: 60 }, (_, j) => {
      // Closer to the wall in smaller steps: there the rays bend.
      const r = 1 - 0.999 * (1 - (j + 1) / 60) ** 2;
      return /** @type {Point} */ ([r * Math.cos(turn), r * Math.sin(turn)]);
    });
  }),
};

/** A line back to where it began. @param {Point[]} line */
export function closed(line) {
  return [...line, line[0]];
}

/** Points of the circle. @param {number[]} angles @returns {Point[]} */
export const onCircle = (angles) => angles.map((angle) => [Math.cos(angle), Math.sin(angle)]);

/** A point, if it is far enough inside to be a centre. @param {Point[]} polygon @param {Point} point */
export function deepEnough(polygon, point) {
  return contains(polygon, point) && nearestOnBoundary(polygon, point).distance > 0.02 ? point : null;
}
