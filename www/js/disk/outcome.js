// What is drawn from a result: the edges of its triangles, the polar grid, and a way to carry points.

import { Locator } from "../editor/locate.js";
import { meshEdges } from "../editor/overlay.js";
import { pulledBackGrid } from "./polar.js";

/** @typedef {import("./pipeline.js").Result} Result */
/** @typedef {{ result: Result, edges: Uint32Array, grid: import("../common/frame.js").Point[][], locator: Locator }} Outcome */

/** @param {Result} result @returns {Outcome} */
export function outcomeOf(result) {
  const locator = new Locator(result.mesh);
  return { result, edges: meshEdges(result.mesh.triangles), grid: pulledBackGrid(locator), locator };
}
