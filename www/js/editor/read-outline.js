// In the worker: an outline from a text, or words why there is none.

import { Region } from "../../pkg/index.js";
import { unflatten } from "../common/frame.js";
import { chooseOutline, curvesIn } from "./outline-text.js";
import { readPath } from "./path.js";

/** @typedef {import("./outline-text.js").Chosen} Chosen */
/** What a page asks. @typedef {{ what: "outline", text: string }} OutlineQuestion */
/** `curves` between the points of the outline, where there are any, and what holes are drawn in it. @typedef {Chosen & { curves?: import("./curve.js").Curve[], holes?: import("./outline.js").Outline[] }} Drawn */
/** @typedef {Drawn | { refusal: string }} OutlineAnswer */

/** An outline as it was drawn, curves and all; null where a text draws none, or several. @param {string} text @returns {Drawn | null} */
function drawnIn(text) {
  const kind = curvesIn(text.trim());
  if (!kind) return null;
  try {
    const { path, holes } = Region.parseShape(text);
    const { boundary, curves } = readPath(path);
    if (!curves && !holes.length) return null;
    return { outline: boundary, curves, holes: holes.map(readPath), said: `Read ${kind}, ${curves ? "its curves" : "its corners"} as they are.` };
  } catch {
    return null;
  }
}

/** The largest outline of a text; throws words where there is none. @param {string} text */
export const chosenFrom = (text) => chooseOutline(text, (curve, tolerance) => unflatten(Region.parseOutline(curve, { tolerance })));

/** @param {string} text @param {boolean} [curved] whether curves are to be kept @returns {OutlineAnswer} */
export function readOutline(text, curved = false) {
  try {
    return (curved && drawnIn(text)) || chosenFrom(text);
  } catch (error) {
    return { refusal: error instanceof Error ? error.message : String(error) };
  }
}
