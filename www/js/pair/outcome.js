// What is drawn from a result: its picture, the edges of its triangles once they are shown, and a way to carry points.

import { canvasOf } from "../common/canvas.js";
import { Locator } from "../editor/locate.js";
import { meshEdges } from "../editor/overlay.js";

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

  get edges() {
    return (this.#edges ??= meshEdges(this.mesh?.triangles ?? new Uint32Array()));
  }
}
