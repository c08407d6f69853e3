// Lines on which a function on a grid has given values: marching squares.

/** @typedef {import("../common/frame.js").Frame} Frame */

/** Edges of a cell that a line joins, for each way in which its corners may lie: corners from the top left on, clockwise. @type {[number, number][][]} */
const CASES = [
  [], [[3, 0]], [[0, 1]], [[3, 1]], [[1, 2]], [[3, 2], [0, 1]], [[0, 2]], [[3, 2]],
  [[2, 3]], [[2, 0]], [[0, 3], [1, 2]], [[2, 1]], [[1, 3]], [[1, 0]], [[0, 3]], [],
];

/**
 * Pieces of the lines as x, y of both ends, in the grid's pixels.
 * @param {Float64Array} values @param {Frame} grid @param {number[]} levels @returns {number[]}
 */
export function levelPieces(values, { pixels: [columns, rows] }, levels) {
  /** @type {number[]} */
  const pieces = [];
  const sorted = [...levels].sort((a, b) => a - b);
  for (let row = 0; row + 1 < rows; row++) {
    for (let column = 0; column + 1 < columns; column++) {
      const at = row * columns + column;
      const corners = [values[at], values[at + 1], values[at + columns + 1], values[at + columns]];
      const [low, high] = [Math.min(...corners), Math.max(...corners)];
      for (let k = firstAbove(sorted, low); k < sorted.length && sorted[k] < high; k++) cell(pieces, corners, sorted[k], column, row);
    }
  }
  return pieces;
}

/** @param {number[]} pieces @param {number[]} corners @param {number} level @param {number} column @param {number} row */
function cell(pieces, corners, level, column, row) {
  let kind = 0;
  corners.forEach((value, k) => (kind |= value > level ? 1 << k : 0));
  for (const edges of CASES[kind]) {
    for (const edge of edges) {
      const [from, to] = [corners[edge], corners[(edge + 1) % 4]];
      const share = (level - from) / (to - from);
      const [x, y] = [[share, 0], [1, share], [1 - share, 1], [0, 1 - share]][edge];
      pieces.push(column + x + 0.5, row + y + 0.5);
    }
  }
}

/** The first of rising numbers that is not below a value. @param {number[]} sorted @param {number} value */
function firstAbove(sorted, value) {
  let [low, high] = [0, sorted.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle] < value) low = middle + 1;
    else high = middle;
  }
  return low;
}
