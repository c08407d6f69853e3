// Lines that the package traced, as a sheet draws them.

/** @typedef {import("../common/frame.js").Point} Point */

/** Takes the lines; a closed one ends where it began. @param {import("../../pkg/index.js").LevelLines} lines @returns {Point[][]} */
export function pointsOfLines(lines) {
  const { points, starts, closed } = lines;
  lines.free();
  /** @param {number} k @returns {Point} */
  const point = (k) => [points[2 * k], points[2 * k + 1]];
  return [...closed].map((joined, n) => {
    const line = Array.from({ length: starts[n + 1] - starts[n] }, (_, k) => point(starts[n] + k));
    return joined ? [...line, point(starts[n])] : line;
  });
}
