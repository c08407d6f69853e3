// Which part of a plane a panel looks at, and how hands and keys move it.

import { toPlane } from "./frame.js";
import { ARROWS } from "./keys.js";

/** @typedef {import("./frame.js").Frame} Frame */
/** @typedef {import("./frame.js").Point} Point */
/** @typedef {{ center: Point, width: number }} Placement */

/** A notch of the wheel zooms by about this. */
const ZOOM = 1.0015;
/** What a key does: the share of the width that it moves by, and how much it zooms. */
const KEY_STEP = 0.02;
export const KEY_ZOOM = 1.25;
/** Widths beyond these are of no use, and run out of digits. */
const [NARROWEST, WIDEST] = [1e-9, 1e9];

/** How much wider the view becomes by a turn of the wheel. @param {WheelEvent} event */
export const wheelRatio = ({ deltaMode, deltaY }) => ZOOM ** (deltaMode === WheelEvent.DOM_DELTA_LINE ? 20 * deltaY : deltaY);

/** The place in which the point seen at `from` is seen at `to`. @param {Frame} frame @param {Point} from @param {Point} to @returns {Placement} */
export function shifted(frame, from, to) {
  const [[x0, y0], [x1, y1]] = [toPlane(frame, from), toPlane(frame, to)];
  const { center, width } = frame;
  return { center: [center[0] + x0 - x1, center[1] + y0 - y1], width };
}

/** Wider by `ratio`, with the point under `pixel` where it is. @param {Frame} frame @param {Point} pixel @param {number} ratio @returns {Placement} */
export function zoomed(frame, pixel, ratio) {
  const { center, width } = frame;
  const [x, y] = toPlane(frame, pixel);
  const wanted = Math.min(WIDEST, Math.max(NARROWEST, width * ratio));
  const r = wanted / width;
  return { center: [x + (center[0] - x) * r, y + (center[1] - y) * r], width: wanted };
}

/** The middle of a panel. @param {Frame} frame @returns {Point} */
export const middleOf = ({ pixels }) => [pixels[0] / 2, pixels[1] / 2];

/** Where a key leads: arrows move, + and − zoom, 0 goes home. @param {Frame} frame @param {KeyboardEvent} event @param {Placement} home @returns {Placement | null} */
export function steered(frame, { key, shiftKey, ctrlKey, metaKey, altKey }, home) {
  if (ctrlKey || metaKey || altKey) return null;
  if (key === "0") return home;
  if (key === "+" || key === "=") return zoomed(frame, middleOf(frame), 1 / KEY_ZOOM);
  if (key === "-") return zoomed(frame, middleOf(frame), KEY_ZOOM);
  const direction = ARROWS.get(key);
  const step = (shiftKey ? 5 : 1) * KEY_STEP * frame.width;
  return direction ? { center: [frame.center[0] + step * direction[0], frame.center[1] + step * direction[1]], width: frame.width } : null;
}
