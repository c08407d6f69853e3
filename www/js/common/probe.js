// The linked cursor: a small figure under the pointer, or pinned to a place, and its image in the other panel.

import { scaleOf, toPixels, toPlane } from "./frame.js";
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
/** What the map does near the pointer: pixels per pixel along a line to the right, most, and least, and degrees counter-clockwise. @typedef {{ stretch: number, most: number, least: number, turn: number }} Reading */

/** What is carried: a small figure. @typedef {"circle" | "square" | "letter"} Figure */
/** Where it stays while no pointer leads it: `reach` is its size in the plane. @typedef {{ side: Side, at: Point, reach: number }} Pin */

/** Half its width, in pixels of the panel that the pointer is in. */
export const REACH = 15;
/** Images of neighbours that are farther apart than this lie on two sides of a branch cut; in pixels, for a figure of the usual size. */
const TEAR = 80;
/** The step of the difference quotient, in pixels. */
const STEP = 2;
/** A pin is taken hold of so near to its middle at least, in pixels. */
const HOLD = 16;
/** Arrow keys, in pixels. @type {Map<string, Point>} */
const KEYS = new Map([["ArrowLeft", [-2, 0]], ["ArrowRight", [2, 0]], ["ArrowUp", [0, -2]], ["ArrowDown", [0, 2]]]);

export class Probe {
  /** @type {Figure} */ figure = "circle";
  reach = REACH;
  /** @type {Pin | null} */ #pin = null;
  /** @type {Record<Side, View>} */ #views;
  /** @type {Record<Side, SVGPathElement>} */ #marks;
  #handle = svg("circle", { class: "pin", "data-part": "probe", role: "button", tabindex: 0, "aria-label": "The probe; arrow keys move it", visibility: "hidden" });
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
      root.addEventListener("pointermove", (event) => {
        if (!this.#pin) this.#look(side, toPlane(this.#views[side].frame, pixelOf(root, event)), this.reach / scaleOf(this.#views[side].frame));
      });
      root.addEventListener("pointerleave", () => !this.#pin && this.hide());
    }
    this.#followHandle();
  }

  get pinned() {
    return this.#pin !== null;
  }

  /** Stays in a place; null lets the pointer lead again. @param {{ side: Side, at: Point } | null} place */
  pin(place) {
    this.#pin = place && { ...place, reach: this.reach / scaleOf(this.#views[place.side].frame) };
    set(this.#handle, { visibility: place ? "visible" : "hidden" });
    if (place) this.#views[place.side].root.append(this.#handle);
    else this.hide();
    this.refresh();
  }

  /** Another figure, or another size. @param {Figure} figure @param {number} reach in pixels */
  become(figure, reach) {
    this.figure = figure;
    this.reach = reach;
    if (this.#pin) this.pin(this.#pin);
  }

  hide() {
    this.#place++;
    for (const mark of Object.values(this.#marks)) set(mark, { d: "" });
    this.#onReading(null);
  }

  /** What is pinned, anew: the map or a view has changed. */
  refresh() {
    if (!this.#pin) return;
    const { side, at, reach } = this.#pin;
    const { frame } = this.#views[side];
    const [cx, cy] = toPixels(frame, at);
    set(this.#handle, { cx, cy, r: Math.max(HOLD, reach * scaleOf(frame)) });
    this.#look(side, at, reach);
  }

  /** @param {Side} side @param {Point} at @param {number} reach both in the plane */
  async #look(side, [x, y], reach) {
    const place = ++this.#place;
    const other = side === "source" ? "target" : "source";
    const [here, there] = [this.#views[side].frame, this.#views[other].frame];
    const lines = FIGURES[this.figure].map((line) => line.map(([u, v]) => /** @type {Point} */ ([x + reach * u, y + reach * v])));
    const step = STEP / scaleOf(here);
    const points = [/** @type {Point} */ ([x, y]), /** @type {Point} */ ([x + step, y]), /** @type {Point} */ ([x, y + step]), ...lines.flat()];
    const carried = this.#carrier()?.carry(side, points);
    const images = carried instanceof Promise ? await carried : carried;
    if (place !== this.#place) return;
    const [middle, right, up, ...rest] = (images ?? []).map((p) => p && toPixels(there, p));
    if (!middle && !this.#pin) return this.hide();
    set(this.#marks[side], { d: lines.map((line) => pathData(line.map((p) => toPixels(here, p)), false)).join("") });
    const tear = TEAR * Math.max(1, (reach * scaleOf(here)) / REACH);
    const parts = lines.flatMap((line) => runs(rest.splice(0, line.length), tear));
    set(this.#marks[other], { d: parts.map((line) => pathData(line, false)).join("") });
    this.#onReading(middle && right ? reading(side, middle, right, up) : null);
  }

  #followHandle() {
    const handle = this.#handle;
    /** @type {{ pointer: number, grip: Point } | null} */
    let hold = null;
    handle.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || !this.#pin) return;
      // It lies over what else would be taken hold of.
      event.stopPropagation();
      event.preventDefault();
      handle.setPointerCapture(event.pointerId);
      handle.focus();
      const { root, frame } = this.#views[this.#pin.side];
      const [[x, y], [cx, cy]] = [pixelOf(root, event), toPixels(frame, this.#pin.at)];
      hold = { pointer: event.pointerId, grip: [cx - x, cy - y] };
    });
    handle.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
    handle.addEventListener("pointermove", (event) => {
      if (hold?.pointer !== event.pointerId || !this.#pin) return;
      event.stopPropagation();
      const [x, y] = pixelOf(this.#views[this.#pin.side].root, event);
      this.#moveTo([x + hold.grip[0], y + hold.grip[1]]);
    });
    for (const end of /** @type {const} */ (["pointerup", "pointercancel"])) handle.addEventListener(end, () => (hold = null));
    handle.addEventListener("keydown", (event) => {
      const step = KEYS.get(event.key);
      if (!step || !this.#pin) return;
      event.preventDefault();
      event.stopPropagation();
      const times = event.shiftKey ? 8 : 1;
      const [x, y] = toPixels(this.#views[this.#pin.side].frame, this.#pin.at);
      this.#moveTo([x + times * step[0], y + times * step[1]]);
    });
  }

  /** @param {Point} pixel of the panel in which it is pinned */
  #moveTo([x, y]) {
    if (!this.#pin) return;
    const { frame } = this.#views[this.#pin.side];
    this.#pin.at = toPlane(frame, [Math.min(frame.pixels[0], Math.max(0, x)), Math.min(frame.pixels[1], Math.max(0, y))]);
    this.refresh();
  }
}

/** @param {Side} side @param {Point} middle @param {Point} right the image of what is `STEP` pixels to the right @param {Point | null} up of what is as far above, if that has one @returns {Reading} */
function reading(side, [u, v], [u1, v1], up) {
  const [du, dv] = [(u1 - u) / STEP, (v - v1) / STEP];
  const [eu, ev] = up ? [(up[0] - u) / STEP, (v - up[1]) / STEP] : [-dv, du];
  const stretch = Math.hypot(du, dv);
  const turn = (Math.atan2(dv, du) * 180) / Math.PI;
  // |∂f/∂z| and |∂f/∂z̄|: the most is their sum, the least their difference.
  const [keeps, turns] = [Math.hypot(du + ev, dv - eu) / 2, Math.hypot(du - ev, dv + eu) / 2];
  const [most, least] = [keeps + turns, Math.abs(keeps - turns)];
  return side === "source" ? { stretch, most, least, turn } : { stretch: 1 / stretch, most: 1 / least, least: 1 / most, turn: -turn };
}

/** What the map does under the pointer. @param {Reading} reading @param {string} what is warped */
export function readingWords({ stretch, turn }, what) {
  const size = stretch >= 1 ? `enlarged ${stretch.toFixed(1)} times` : `shrunk ${(1 / stretch).toFixed(1)} times`;
  const angle = Math.round(Math.abs(turn));
  return `Here the ${what} is ${size} and turned ${angle}°${angle ? (turn > 0 ? " to the left" : " to the right") : ""}.`;
}

/** A line with points so close together that its image looks smooth. @param {Point[]} corners @param {number} [steps] a piece @returns {Point[]} */
function dense(corners, steps = 12) {
  return corners.flatMap((a, k) => {
    const b = corners[k + 1];
    return b ? Array.from({ length: steps }, (_, n) => /** @type {Point} */ ([a[0] + ((b[0] - a[0]) * n) / steps, a[1] + ((b[1] - a[1]) * n) / steps])) : [a];
  });
}

const HAIRS = [dense([[-1, 0], [1, 0]]), dense([[0, -1], [0, 1]])];

/** The lines of each figure, within [−1, 1]². @type {Record<Figure, Point[][]>} */
const FIGURES = {
  circle: [Array.from({ length: 65 }, (_, k) => [Math.cos((2 * Math.PI * k) / 64), Math.sin((2 * Math.PI * k) / 64)]), ...HAIRS],
  square: [dense([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]], 16), ...HAIRS],
  letter: [dense([[-0.6, -1], [-0.6, 1], [0.7, 1], [0.7, 0.6], [-0.15, 0.6], [-0.15, 0.2], [0.45, 0.2], [0.45, -0.2], [-0.15, -0.2], [-0.15, -1], [-0.6, -1]], 10)],
};

/** The stretches of a line that have an image, parted where the map tears. @param {(Point | null)[]} line @param {number} tear @returns {Point[][]} */
function runs(line, tear) {
  /** @type {Point[][]} */
  const found = [[]];
  for (const p of line) {
    const last = found[found.length - 1].at(-1);
    if (!p || (last && Math.hypot(p[0] - last[0], p[1] - last[1]) > tear)) found.push([]);
    if (p) found[found.length - 1].push(p);
  }
  return found.filter((run) => run.length > 1);
}
