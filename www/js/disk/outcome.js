// What is drawn from a result: the edges of its triangles, the polar grid, and a way to carry points; each made when first shown.

import { Locator } from "../editor/locate.js";
import { meshEdges } from "../editor/overlay.js";
import { pulledBackGrid } from "./polar.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./pipeline.js").Result} Result */

export class Outcome {
  result;
  locator;
  /** @type {Uint32Array | undefined} */ #edges;
  /** @type {Point[][] | undefined} */ #grid;

  /** @param {Result} result */
  constructor(result) {
    this.result = result;
    this.locator = new Locator(result.mesh);
  }

  get edges() {
    return (this.#edges ??= meshEdges(this.result.mesh.triangles));
  }

  get grid() {
    return (this.#grid ??= pulledBackGrid(this.locator));
  }
}
