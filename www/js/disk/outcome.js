// What is drawn from a result: the edges of its triangles, its layers on both sides, and a way to carry points; each made when first shown.

import { canvasOf } from "../common/canvas.js";
import { meshEdges } from "../common/layers.js";
import { Locator } from "../editor/locate.js";

/** @typedef {import("../common/layers.js").Layer} Layer */
/** @typedef {import("../common/probe.js").Side} Side */
/** @typedef {import("../editor/photo-view.js").Placed} Placed */
/** @typedef {import("../editor/store.js").Shown} Shown */
/** @typedef {import("./pipeline.js").Result} Result */

export class Outcome {
  result;
  locator;
  /** @type {Uint32Array | undefined} */ #edges;
  /** @type {Partial<Record<Side, Placed>>} */ #heats = {};

  /** @param {Result} result */
  constructor(result) {
    this.result = result;
    this.locator = new Locator(result.mesh);
  }

  /** The lines of a side. @param {Side} side @param {Shown} shown @returns {Layer[]} */
  layers(side, shown) {
    const { mesh, over } = this.result;
    const { lines, fence } = over[side];
    return [
      ...(shown.measure && fence ? [/** @type {Layer} */ ({ ink: "fence", lines: [fence], closed: true })] : []),
      ...(shown.mesh ? [/** @type {Layer} */ ({ ink: "mesh", points: mesh[side], edges: (this.#edges ??= meshEdges(mesh.triangles)) })] : []),
      ...(shown.grid || shown.field ? [/** @type {Layer} */ ({ ink: "lines", lines })] : []),
    ];
  }

  /** |f'| as colours. @param {Side} side @param {Shown} shown @returns {Placed | null} */
  heat(side, shown) {
    const { heat } = this.result.over[side];
    if (!shown.heat || !heat) return null;
    return (this.#heats[side] ??= { picture: canvasOf(heat.pixels, heat.frame.pixels), frame: heat.frame });
  }
}
