// What a visitor types → a map on the page's own thread, for the pointer and for errors while typing.

import { FormulaMap } from "../../pkg/index.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {Record<string, Point>} Params */
/** @typedef {{ map: FormulaMap, params: Params }} Compiled */
/** @typedef {{ message: string, position: number | undefined }} Mistake */

/** Letters with a meaning of their own. */
const TAKEN = ["z", "i", "e"];

/**
 * The map of a formula. Single letters that it does not know become parameters, with the values in `known`, or 1.
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
  if ("map" in plain || Object.keys(params).length === 0) return plain;
  const parametric = attempt(text, params);
  return "map" in parametric ? parametric : plain;
}

/** @param {string} text @param {Params} params @returns {Compiled | Mistake} */
function attempt(text, params) {
  try {
    return { map: new FormulaMap(text, { params }), params };
  } catch (error) {
    const { message, position } = /** @type {{ message: string, position?: number }} */ (error);
    return { message, position };
  }
}

/** @typedef {import("../common/probe.js").Side} Side */

/**
 * The map as the pointer needs it: from the plane on which it is evaluated to the other.
 * @param {FormulaMap} map @param {import("../../pkg/index.js").Direction} direction @returns {import("../common/probe.js").Carrier}
 */
export function carrierOf(map, direction) {
  const from = direction === "pull-back" ? "target" : "source";
  return {
    carry(side, point) {
      if (side !== from) return null;
      const [x, y] = map.eval(new Float64Array(point));
      return Number.isFinite(x) && Number.isFinite(y) ? [x, y] : null;
    },
  };
}
