// How both hemispheres lie in a panel: their foveas together in the middle, a little room around.

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {{ width: number, height: number }} Half half of the size of both hemispheres, in mm */

/** The panel spans a little more than both hemispheres. */
const MARGIN = 1.06;

/** What is shown before any map is known. @type {Half} */
export const NO_HALF = { width: 70, height: 25 };

/** Width over height of a panel. @param {Half} half */
export const aspectOf = ({ width, height }) => (2 * width * MARGIN) / (2 * height + 2 * width * (MARGIN - 1));

/** A panel's frame. @param {Half} half @param {Point} pixels @returns {Frame} */
export const panelFrame = ({ width }, pixels) => ({ center: [0, 0], width: 2 * width * MARGIN, pixels });

/** The frames of the right and the left hemisphere, on a panel so many pixels wide that looks at a part of both; one may be out of sight. @param {Half} half @param {number} columns @param {import("../common/placement.js").Placement | null} [place] @returns {Frame[]} */
export function hemisphereFrames(half, columns, place) {
  const { center, width } = place ?? panelFrame(half, [1, 1]);
  const rows = Math.max(16, Math.round(columns / aspectOf(half)));
  const size = width / columns;
  const left = center[0] - width / 2;
  const middle = Math.min(columns, Math.max(0, Math.round(-left / size)));
  return [[0, middle], [middle, columns]].map(([from, to]) => ({ center: [left + ((from + to) / 2) * size, center[1]], width: (to - from) * size, pixels: [to - from, rows] }));
}
