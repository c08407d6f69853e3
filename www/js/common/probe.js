// The linked cursor: a small cross-haired circle under the pointer, and its image in the other panel.

import { toPixels, toPlane } from "./frame.js";
import { pathData, pixelOf, set, svg } from "./svg.js";

/** @typedef {import("./frame.js").Frame} Frame */
/** @typedef {import("./frame.js").Point} Point */
/** @typedef {"source" | "target"} Side */
/**
 * A map as far as it is known both ways: points of one side → the other side, null where it has none; at once, or after
 * a worker was asked.
 * @typedef {{ carry(from: Side, points: Point[]): (Point | null)[] | Promise<(Point | null)[] | null> }} Carrier
 */
/** @typedef {{ root: SVGSVGElement, frame: Frame }} View */
/** What the map does near the pointer: pixels per pixel, and degrees counter-clockwise. @typedef {{ stretch: number, turn: number }} Reading */

/** In pixels of the panel that the pointer is in. */
const RADIUS = 15;
/** Images of neighbours that are farther apart than this lie on two sides of a branch cut. */
const TEAR = 80;
/** The step of the difference quotient, in pixels. */
const STEP = 2;

export class Probe {
  /** @type {Record<Side, View>} */ #views;
  /** @type {Record<Side, SVGPathElement>} */ #marks;
  #carrier;
  #onReading;
  /** Counts the places: an answer to an older one is late. */
  #place = 0;

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
      root.addEventListener("pointermove", (event) => this.#look(side, pixelOf(root, event)));
      root.addEventListener("pointerleave", () => this.hide());
    }
  }

  hide() {
    this.#place++;
    for (const mark of Object.values(this.#marks)) set(mark, { d: "" });
    this.#onReading(null);
  }

  /** @param {Side} side @param {Point} pixel */
  async #look(side, pixel) {
    const place = ++this.#place;
    const other = side === "source" ? "target" : "source";
    const [here, there] = [this.#views[side].frame, this.#views[other].frame];
    const lines = probeLines(pixel);
    const points = [pixel, /** @type {Point} */ ([pixel[0] + STEP, pixel[1]]), ...lines.flat()].map((p) => toPlane(here, p));
    const carried = this.#carrier()?.carry(side, points);
    const images = carried instanceof Promise ? await carried : carried;
    if (place !== this.#place) return;
    const [middle, right, ...rest] = (images ?? []).map((p) => p && toPixels(there, p));
    if (!middle) return this.hide();
    set(this.#marks[side], { d: lines.map((line) => pathData(line, false)).join("") });
    const parts = lines.flatMap((line) => runs(rest.splice(0, line.length)));
    set(this.#marks[other], { d: parts.map((line) => pathData(line, false)).join("") });
    this.#onReading(right ? reading(side, middle, right) : null);
  }
}

/** @param {Side} side @param {Point} middle @param {Point} right the image of what is `STEP` pixels to the right @returns {Reading} */
function reading(side, [u, v], [u1, v1]) {
  const [du, dv] = [(u1 - u) / STEP, (v1 - v) / STEP];
  const stretch = Math.hypot(du, dv);
  const turn = (Math.atan2(-dv, du) * 180) / Math.PI;
  return side === "source" ? { stretch, turn } : { stretch: 1 / stretch, turn: -turn };
}

/** What the map does under the pointer. @param {Reading} reading @param {string} what is warped */
export function readingWords({ stretch, turn }, what) {
  const size = stretch >= 1 ? `enlarged ${stretch.toFixed(1)} times` : `shrunk ${(1 / stretch).toFixed(1)} times`;
  const angle = Math.round(Math.abs(turn));
  return `Here the ${what} is ${size} and turned ${angle}°${angle ? (turn > 0 ? " to the left" : " to the right") : ""}.`;
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
