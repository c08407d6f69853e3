// The Riemann map of a region that is being edited: made anew for a new outline, moved for a new vector.

import { Region, RiemannMap } from "../../pkg/index.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/serve.js").Progress} Progress */
/** A region as a job carries it. @typedef {{ boundary: Float64Array, center: Point, toward: Point }} Outline */
/** `corners`: the boundary as the library keeps it, counter-clockwise. @typedef {{ map: RiemannMap, corners: Float64Array, ms: number }} Solved */

export class SolvedMap {
  /** @type {(Solved & { outline: string, vector: string }) | null} */
  #last = null;

  /** The region's map; it is valid until the next call. @param {Outline} region @param {number} tolerance @param {Progress} onProgress @returns {Solved} */
  solve(region, tolerance, onProgress) {
    const { boundary, center, toward } = region;
    const outline = JSON.stringify([[...boundary], tolerance]);
    const vector = JSON.stringify([center, toward]);
    const last = this.#last;
    if (last?.outline === outline && last.vector === vector) return last;
    const begin = performance.now();
    const { map, corners } =
      last?.outline === outline
        ? { map: last.map.withCenter({ center, toward, onProgress }), corners: last.corners }
        : solveAfresh(region, tolerance, onProgress);
    last?.map.free();
    this.#last = { outline, vector, map, corners, ms: performance.now() - begin };
    return this.#last;
  }
}

/** @param {Outline} outline @param {number} tolerance @param {Progress} onProgress */
function solveAfresh({ boundary, center, toward }, tolerance, onProgress) {
  const region = new Region({ boundary, center, toward });
  try {
    return { map: RiemannMap.solve(region, { tolerance, onProgress }), corners: region.boundary };
  } finally {
    region.free();
  }
}
