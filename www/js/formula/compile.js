// What a visitor types → whether it can be read, and its parameters; found in a worker, while typing.

import { FormulaMap } from "../../pkg/formula/index.js";
import { PRINCIPAL, turned } from "./cut.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {Record<string, Point>} Params */
/** `branching`: whether there are cuts to be turned. @typedef {{ analytic: boolean, branching: boolean, params: Params }} Compiled */
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
    const found = { analytic: map.isAnalytic, branching: canTurn(map, text, params), params };
    map.free();
    return found;
  } catch (error) {
    return mistake(error);
  }
}

/** Places that belong to no pattern. */
const PLACES = Float64Array.from({ length: 64 }, (_, k) => 4 * ((0.13 + 0.7548776662466927 * k) % 1) - 2);
/** Two ways to the same value differ by no more, in shares of it. */
const SAME = 1e-9;

/** Whether the formula has cuts, and is the same when it is written with them where they are. @param {FormulaMap} map @param {string} text @param {Params} params */
function canTurn(map, text, params) {
  const again = turned(text, Object.keys(params), PRINCIPAL);
  if (!again) return false;
  try {
    const other = new FormulaMap(again.formula, { params });
    const [values, same] = [map.eval(PLACES), other.eval(PLACES)];
    other.free();
    return values.every((value, k) => (Number.isNaN(value) ? Number.isNaN(same[k]) : Math.abs(value - same[k]) <= SAME * (1 + Math.abs(value))));
  } catch {
    // It has become too long.
    return false;
  }
}

/** @param {unknown} error @returns {Mistake} */
function mistake(error) {
  const { message, position } = /** @type {{ message: string, position?: number }} */ (error);
  return { message, position };
}
