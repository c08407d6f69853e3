// Where the fluid rests on a body: between two points of its outline the velocity along it changes its sign.

import { scaleOf } from "../common/frame.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./wind.js").Wind} Wind */

/** How far outside of a wall the velocity is asked, in cells of the grid. */
const AWAY = 1.2;

/** @param {Wind} wind @param {Point[][]} outlines @returns {Point[]} */
export function restingPoints(wind, outlines) {
  const away = AWAY / scaleOf(wind.grid);
  return outlines.flatMap((outline) => {
    const speeds = outline.map((from, k) => {
      const to = outline[(k + 1) % outline.length];
      const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
      const [tx, ty] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
      const middle = /** @type {Point} */ ([(from[0] + to[0]) / 2 + away * ty, (from[1] + to[1]) / 2 - away * tx]);
      const velocity = wind.velocity(middle);
      return velocity ? velocity[0] * tx + velocity[1] * ty : NaN;
    });
    return outline.filter((_, k) => speeds[(k || outline.length) - 1] * speeds[k] < 0);
  });
}
