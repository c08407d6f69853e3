// The Riemann map of a region that is being edited: made anew for a new outline, moved for a new vector.

import { Region, RiemannMap } from "../../pkg/index.js";
import { unflatten } from "../common/frame.js";
import { readPath } from "./path.js";

/** @typedef {import("../common/serve.js").Progress} Progress */
/** @typedef {import("./region.js").Carried} Outline */
/** `corners`: points of the boundary, counter-clockwise: its corners, or where it has curves, as many points of it as it takes to look like it. `outline`: the same with its curves. @typedef {{ map: RiemannMap, corners: Float64Array, outline: import("./outline.js").Outline, ms: number }} Solved */

/** A map that is at least so loose is a draft's; where its vector is moved, it may be off by so much, still half a pixel. */
const [DRAFT, MOVED_DRAFT] = [1e-3, 4e-3];

export class SolvedMap {
  /** @type {(Solved & { drawn: string, vector: string }) | null} */
  #last = null;

  /** The region's map; it is valid until the next call. @param {Outline} region @param {number} tolerance @param {Progress} onProgress @returns {Solved} */
  solve(region, tolerance, onProgress) {
    const { boundary, path, center, toward } = region;
    const drawn = JSON.stringify([path || [...boundary], tolerance]);
    const vector = JSON.stringify([center, toward]);
    const last = this.#last;
    if (last?.drawn === drawn && last.vector === vector) return last;
    const begin = performance.now();
    const { map, corners, outline } =
      last?.drawn === drawn
        ? { map: last.map.withCenter({ center, toward, tolerance: tolerance < DRAFT ? tolerance : MOVED_DRAFT, onProgress }), corners: last.corners, outline: last.outline }
        : solveAfresh(region, tolerance, onProgress);
    last?.map.free();
    this.#last = { drawn, vector, map, corners, outline, ms: performance.now() - begin };
    return this.#last;
  }
}

/** @param {Outline} outline @param {number} tolerance @param {Progress} onProgress */
function solveAfresh({ boundary, path, center, toward }, tolerance, onProgress) {
  const region = new Region(path ? { path, center, toward } : { boundary, center, toward });
  try {
    const corners = path ? boundary : region.boundary;
    const outline = path ? readPath(path) : { boundary: unflatten(corners) };
    return { map: RiemannMap.solve(region, { tolerance, onProgress }), corners, outline };
  } finally {
    region.free();
  }
}
