// In the worker: an outline from a text, or words why there is none.

import { Region } from "../../pkg/index.js";
import { unflatten } from "../common/frame.js";
import { chooseOutline } from "./outline-text.js";

/** @typedef {import("./outline-text.js").Chosen} Chosen */
/** What a page asks. @typedef {{ what: "outline", text: string }} OutlineQuestion */
/** @typedef {Chosen | { refusal: string }} OutlineAnswer */

/** @param {string} text @returns {OutlineAnswer} */
export function readOutline(text) {
  try {
    return chooseOutline(text, (curve, tolerance) => unflatten(Region.parseOutline(curve, { tolerance })));
  } catch (error) {
    return { refusal: error instanceof Error ? error.message : String(error) };
  }
}
