// A panel that looks at a part of the plane: dragged to move, wheel or two fingers to zoom, or steered by keys.

import { deviceGrid, paint } from "./canvas.js";
import { onGrid, scaleOf, toPixels } from "./frame.js";
import { onEscape } from "./keys.js";
import { shifted, steered, wheelRatio, zoomed } from "./placement.js";
import { pixelOf, set, svg } from "./svg.js";

/** @typedef {import("./frame.js").Frame} Frame */
/** @typedef {import("./frame.js").Point} Point */
/** @typedef {import("./placement.js").Placement} Placement */

export class PlaneView {
  root;
  /** In CSS pixels of the panel. @type {Frame} */
  frame = { center: [0, 0], width: 4, pixels: [1, 1] };
  #canvas;
  #outside = svg("path", { class: "outside", "fill-rule": "evenodd" });
  #axes = svg("path", { class: "axes" });
  #ticks = svg("g", { class: "ticks" });
  /** @type {Map<number, Point>} */ #fingers = new Map();
  /** Where it looked when it was taken hold of. @type {Placement} */ #before = this.frame;

  /**
   * @param {HTMLCanvasElement} canvas @param {SVGSVGElement} root
   * @param {(place: Placement) => void} onMove called when it is dragged or zoomed @param {() => Placement} home where 0 leads
   */
  constructor(canvas, root, onMove, home) {
    this.root = root;
    this.#canvas = canvas;
    root.append(this.#outside, this.#axes, this.#ticks);
    this.#follow(onMove, home);
  }

  /** Looks at a part of the plane. @param {Placement} place */
  look({ center, width }) {
    const side = Math.max(1, this.root.getBoundingClientRect().width);
    this.frame = { center, width, pixels: [side, side] };
    this.#drawAxes();
  }

  /** Sets a square of the plane off from its surroundings. @param {Placement} place */
  outline({ center: [x, y], width }) {
    const [left, top] = toPixels(this.frame, [x - width / 2, y + width / 2]);
    const side = width * scaleOf(this.frame);
    const [w, h] = this.frame.pixels;
    set(this.#outside, { d: `M-2 -2H${w + 2}V${h + 2}H-2ZM${left} ${top}h${side}v${side}h${-side}Z` });
  }

  /** The frame to render in. @param {number} sharpness 1 for the screen's own pixels @returns {Frame} */
  view(sharpness) {
    return onGrid(this.frame, deviceGrid(this.frame.pixels, sharpness));
  }

  /** Shows pixels rendered for a view, which may have moved since. @param {Uint8ClampedArray<ArrayBuffer>} pixels @param {Frame} view @param {PredefinedColorSpace} [space] another than photos have */
  paint(pixels, view, space) {
    paint(this.#canvas, pixels, view.pixels, space);
  }

  /** The two axes, and the points ±1, ±i. */
  #drawAxes() {
    const [width, height] = this.frame.pixels;
    const [x, y] = toPixels(this.frame, [0, 0]);
    set(this.#axes, { d: `M0 ${y}H${width}M${x} 0V${height}` });
    /** @type {[string, Point][]} */
    const marks = [["1", [1, 0]], ["−1", [-1, 0]], ["i", [0, 1]], ["−i", [0, -1]], ["0", [0, 0]]];
    const shown = scaleOf(this.frame) > 25 ? marks : [];
    this.#ticks.replaceChildren(
      ...shown.flatMap(([name, point]) => {
        const [cx, cy] = toPixels(this.frame, point);
        const text = svg("text", { x: cx + 5, y: cy - 5 });
        text.textContent = name;
        return [svg("circle", { cx, cy, r: 2.2 }), text];
      }),
    );
  }

  /** @param {(place: Placement) => void} onMove @param {() => Placement} home */
  #follow(onMove, home) {
    const { root } = this;
    root.addEventListener("wheel", (event) => {
      // Without Ctrl the wheel scrolls the page, unless the plane was taken hold of first.
      if (!event.ctrlKey && !event.metaKey && document.activeElement !== root) return;
      event.preventDefault();
      onMove(zoomed(this.frame, pixelOf(root, event), wheelRatio(event)));
    }, { passive: false });
    root.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      root.setPointerCapture(event.pointerId);
      if (!this.#fingers.size) this.#before = { center: this.frame.center, width: this.frame.width };
      this.#fingers.set(event.pointerId, pixelOf(root, event));
      root.classList.add("held");
    });
    root.addEventListener("pointermove", (event) => {
      const last = this.#fingers.get(event.pointerId);
      if (!last) return;
      const at = pixelOf(root, event);
      const [other] = [...this.#fingers].filter(([id]) => id !== event.pointerId).map(([, point]) => point);
      this.#fingers.set(event.pointerId, at);
      if (!other) return onMove(shifted(this.frame, last, at));
      const ratio = Math.hypot(last[0] - other[0], last[1] - other[1]) / Math.hypot(at[0] - other[0], at[1] - other[1]);
      if (Number.isFinite(ratio)) onMove(zoomed(this.frame, other, ratio));
    });
    for (const end of /** @type {const} */ (["pointerup", "pointercancel"])) {
      root.addEventListener(end, (event) => {
        this.#fingers.delete(event.pointerId);
        if (!this.#fingers.size) root.classList.remove("held");
      });
    }
    root.addEventListener("keydown", (event) => {
      const place = steered(this.frame, event, home());
      if (!place) return;
      event.preventDefault();
      onMove(place);
    });
    onEscape(() => {
      if (!this.#fingers.size) return false;
      this.#fingers.clear();
      root.classList.remove("held");
      onMove(this.#before);
      return true;
    });
  }
}
