// The linked cursor: a small cross-haired circle under the pointer, and its image in the other panel.

import { toPixels, toPlane } from "./frame.js";
import { pathData, pixelOf, set, svg } from "./svg.js";

/** @typedef {import("./frame.js").Frame} Frame */
/** @typedef {import("./frame.js").Point} Point */
/** @typedef {"source" | "target"} Side */
/** A map as far as it is known both ways: a point of one side → the other side. @typedef {{ carry(from: Side, point: Point): Point | null }} Carrier */
/** @typedef {{ root: SVGSVGElement, frame: Frame }} View */
/** What the map does near the pointer: pixels per pixel, and degrees counter-clockwise. @typedef {{ stretch: number, turn: number }} Reading */

/** In pixels of the panel that the pointer is in. */
const RADIUS = 15;
/** Images of neighbours that are farther apart than this lie on two sides of a branch cut. */
const TEAR = 80;

export class Probe {
  /** @type {Record<Side, View>} */ #views;
  /** @type {Record<Side, SVGPathElement>} */ #marks;
  #carrier;
  #onReading;

  /**
   * @param {View} source @param {View} target @param {() => Carrier | null} carrier
   * @param {(reading: Reading | null) => void} onReading
   */
  constructor(source, target, carrier, onReading) {
    this.#views = { source, target };
    this.#marks = { source: svg("path"), target: svg("path") };
    this.#carrier = carrier;
    this.#onReading = onReading;
    for (const side of /** @type {Side[]} */ (["source", "target"])) {
      const { root } = this.#views[side];
      this.#marks[side].classList.add("probe");
      root.append(this.#marks[side]);
      root.addEventListener("pointermove", (event) => this.#show(side, pixelOf(root, event)));
      root.addEventListener("pointerleave", () => this.hide());
    }
  }

  hide() {
    for (const mark of Object.values(this.#marks)) set(mark, { d: "" });
    this.#onReading(null);
  }

  /** @param {Side} side @param {Point} pixel */
  #show(side, pixel) {
    const carrier = this.#carrier();
    const other = side === "source" ? "target" : "source";
    const [here, there] = [this.#views[side].frame, this.#views[other].frame];
    /** @param {Point} p */
    const carry = (p) => {
      const image = carrier?.carry(side, toPlane(here, p));
      return image ? toPixels(there, image) : null;
    };
    const middle = carry(pixel);
    if (!middle) return this.hide();
    const lines = probeLines(pixel);
    set(this.#marks[side], { d: lines.map((line) => pathData(line, false)).join("") });
    const images = lines.flatMap((line) => runs(line.map(carry)));
    set(this.#marks[other], { d: images.map((line) => pathData(line, false)).join("") });
    this.#onReading(this.#reading(side, pixel, middle, carry));
  }

  /** @param {Side} side @param {Point} pixel @param {Point} middle @param {(p: Point) => Point | null} carry */
  #reading(side, [x, y], [u, v], carry) {
    const right = carry([x + 2, y]);
    if (!right) return null;
    const [du, dv] = [(right[0] - u) / 2, (right[1] - v) / 2];
    const stretch = Math.hypot(du, dv);
    const turn = (Math.atan2(-dv, du) * 180) / Math.PI;
    return side === "source" ? { stretch, turn } : { stretch: 1 / stretch, turn: -turn };
  }
}

/** The circle and its two hairs. @param {Point} middle @returns {Point[][]} */
function probeLines([x, y]) {
  /** @type {(count: number, at: (s: number) => Point) => Point[]} */
  const sample = (count, at) => Array.from({ length: count + 1 }, (_, k) => at(k / count));
  return [
    sample(48, (s) => [x + RADIUS * Math.cos(2 * Math.PI * s), y + RADIUS * Math.sin(2 * Math.PI * s)]),
    sample(12, (s) => [x + RADIUS * (2 * s - 1), y]),
    sample(12, (s) => [x, y + RADIUS * (2 * s - 1)]),
  ];
}

/** The stretches of a line that have an image, parted where the map tears. @param {(Point | null)[]} line @returns {Point[][]} */
function runs(line) {
  /** @type {Point[][]} */
  const found = [[]];
  for (const p of line) {
    const last = found[found.length - 1].at(-1);
    if (!p || (last && Math.hypot(p[0] - last[0], p[1] - last[1]) > TEAR)) found.push([]);
    if (p) found[found.length - 1].push(p);
  }
  return found.filter((run) => run.length > 1);
}
