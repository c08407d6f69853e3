// In the worker: an outline from a text, or words why there is none.

import { Region } from "../../pkg/index.js";
import { unflatten } from "../common/frame.js";
import { chooseOutline } from "./outline-text.js";

/** @typedef {import("./outline-text.js").Chosen} Chosen */
/** What a page asks. @typedef {{ what: "outline", text: string }} OutlineQuestion */
/** @typedef {Chosen | { refusal: string }} OutlineAnswer */

/** The largest outline of a text; throws words where there is none. @param {string} text */
export const chosenFrom = (text) => chooseOutline(text, (curve, tolerance) => unflatten(Region.parseOutline(curve, { tolerance })));

/** @param {string} text @returns {OutlineAnswer} */
export function readOutline(text) {
  try {
    return chosenFrom(text);
  } catch (error) {
    return { refusal: error instanceof Error ? error.message : String(error) };
  }
}
