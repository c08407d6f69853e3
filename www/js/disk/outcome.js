// What is drawn from a result: its layers on both sides, and ways to carry points.

import { Locator } from "../editor/locate.js";
import { Overlays } from "../editor/overlays.js";

/** @typedef {import("./pipeline.js").Result} Result */

export class Outcome extends Overlays {
  result;
  /** Region to disk. */
  locator;
  /** Region to what is shown: the disk, or a step on the way there. */
  carrier;

  /** @param {Result} result */
  constructor(result) {
    const { mesh, way, over } = result;
    const shown = way ? { ...mesh, target: way.target } : mesh;
    super(shown, over);
    this.result = result;
    this.locator = new Locator(mesh);
    this.carrier = way ? new Locator(shown) : this.locator;
  }
}
