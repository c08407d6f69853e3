// What is drawn from a result: its picture, the edges of its triangles once they are shown, and a way to carry points.

import { canvasOf } from "../common/canvas.js";
import { meshEdges } from "../common/layers.js";
import { Locator } from "../editor/locate.js";

/** @typedef {import("../common/probe.js").Carrier} Carrier */
/** @typedef {import("./pipeline.js").Result} Result */

export class Outcome {
  mesh;
  inside;
  /** @type {Carrier} */ carrier;
  /** @type {Uint32Array | undefined} */ #edges;

  /** @param {Result} result @param {Carrier} worker which carries points where there is no mesh */
  constructor({ mesh, pixels, view }, worker) {
    this.mesh = mesh;
    this.inside = { picture: canvasOf(pixels, view.pixels), frame: view };
    this.carrier = mesh ? new Locator(mesh) : worker;
  }

  /** The triangles of a side, where there are some. @param {import("../common/probe.js").Side} side @returns {import("../common/layers.js").Layer[]} */
  triangles(side) {
    return this.mesh ? [{ ink: "mesh", points: this.mesh[side], edges: (this.#edges ??= meshEdges(this.mesh.triangles)) }] : [];
  }
}
