// What a visitor types → whether it can be read, and its parameters; found on the page's own thread, while typing.

import { FormulaMap } from "../../pkg/index.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {Record<string, Point>} Params */
/** @typedef {{ analytic: boolean, params: Params }} Compiled */
/** @typedef {{ message: string, position: number | undefined }} Mistake */

/** Letters with a meaning of their own. */
const TAKEN = ["z", "i", "e"];

/**
 * Reads a formula. Single letters that it does not know become parameters, with the values in `known`, or 1.
 * @param {string} text @param {Params} known @returns {Compiled | Mistake}
 */
export function compile(text, known) {
  const letters = new Set(text.match(/(?<![a-z])[a-z](?![a-z])/gi) ?? []);
  /** @type {Params} */
  const params = {};
  for (const letter of letters) {
    if (!TAKEN.includes(letter)) params[letter] = known[letter] ?? [1, 0];
  }
  const plain = attempt(text, {});
  if ("params" in plain || Object.keys(params).length === 0) return plain;
  const parametric = attempt(text, params);
  return "params" in parametric ? parametric : plain;
}

/** @param {string} text @param {Params} params @returns {Compiled | Mistake} */
function attempt(text, params) {
  try {
    const map = new FormulaMap(text, { params });
    const analytic = map.isAnalytic;
    map.free();
    return { analytic, params };
  } catch (error) {
    const { message, position } = /** @type {{ message: string, position?: number }} */ (error);
    return { message, position };
  }
}
