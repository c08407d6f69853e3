// What is drawn from a result: its layers on both sides, and ways to carry points.

import { Locator } from "../editor/locate.js";
import { Overlays } from "../editor/overlays.js";

/** @typedef {import("./pipeline.js").Result} Result */

export class Outcome extends Overlays {
  result;
  /** Region to disk. */
  locator;
  /** Region to what is shown: the disk, or a step on the way there. @type {import("../common/probe.js").Carrier} */
  carrier;

  /** @param {Result} result @param {import("../common/probe.js").Carrier} worker which carries points where there is no mesh */
  constructor(result, worker) {
    const { mesh, way, over } = result;
    const shown = mesh && way ? { ...mesh, target: way.target } : mesh;
    super(shown, over);
    this.result = result;
    this.locator = mesh && new Locator(mesh);
    this.carrier = shown && way ? new Locator(shown) : (this.locator ?? worker);
  }
}
