// What a visitor types → whether it can be read, and its parameters; found in a worker, while typing.

import { FormulaMap } from "../../pkg/index.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {Record<string, Point>} Params */
/** @typedef {{ analytic: boolean, params: Params }} Compiled */
/** @typedef {{ message: string, position: number | undefined }} Mistake */

/**
 * Reads a formula. Letters that it does not know become parameters, with the values in `known`, or 1.
 * @param {string} text @param {Params} known @returns {Compiled | Mistake}
 */
export function compile(text, known) {
  try {
    const names = FormulaMap.parameters(text);
    return attempt(text, Object.fromEntries(names.map((name) => [name, Object.hasOwn(known, name) ? known[name] : [1, 0]])));
  } catch (error) {
    return mistake(error);
  }
}

/** @param {string} text @param {Params} params @returns {Compiled | Mistake} */
function attempt(text, params) {
  try {
    const map = new FormulaMap(text, { params });
    const analytic = map.isAnalytic;
    map.free();
    return { analytic, params };
  } catch (error) {
    return mistake(error);
  }
}

/** @param {unknown} error @returns {Mistake} */
function mistake(error) {
  const { message, position } = /** @type {{ message: string, position?: number }} */ (error);
  return { message, position };
}
