// What is drawn from a result: its layers on both sides, and a way to carry points.

import { Locator } from "../editor/locate.js";
import { Overlays } from "../editor/overlays.js";

/** @typedef {import("./pipeline.js").Result} Result */

export class Outcome extends Overlays {
  result;
  locator;

  /** @param {Result} result */
  constructor(result) {
    super(result.mesh, result.over);
    this.result = result;
    this.locator = new Locator(result.mesh);
  }
}
