// What is drawn from a result: the picture in the second region, its layers on both sides, and a way to carry points.

import { canvasOf } from "../common/canvas.js";
import { Locator } from "../editor/locate.js";
import { Overlays } from "../editor/overlays.js";

/** @typedef {import("../common/probe.js").Carrier} Carrier */
/** @typedef {import("./pipeline.js").Result} Result */

export class Outcome extends Overlays {
  mesh;
  inside;
  dilatation;
  /** @type {Carrier} */ carrier;

  /** @param {Result} result @param {Carrier} worker which carries points where there is no mesh */
  constructor({ mesh, pixels, view, over, dilatation }, worker) {
    super(mesh, over);
    this.mesh = mesh;
    this.dilatation = dilatation;
    this.inside = { picture: canvasOf(pixels, view.pixels), frame: view };
    this.carrier = mesh ? new Locator(mesh) : worker;
  }
}
