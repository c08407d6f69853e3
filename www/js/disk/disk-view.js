// The right panel: the warped picture on the unit disk, its rim, the images of the corners and of the inward vector.

import { deviceGrid, Layer, paint } from "../common/canvas.js";
import { diskFrame, onGrid, scaleOf, toPixels } from "../common/frame.js";
import { arrowLines, drawLayers } from "../common/layers.js";
import { drawWithin } from "../editor/photo-view.js";
import { match, set, svg } from "../common/svg.js";
import { Zoom } from "../common/zoom.js";
import { markVector, updateVector } from "../editor/vector.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../editor/store.js").Shown} Shown */
/** @typedef {import("./outcome.js").Outcome} Outcome */

export class DiskView {
  root;
  /** What is seen of the disk's plane, in CSS pixels of the panel. @type {Frame} */
  frame = diskFrame(1);
  /** All of the disk. @type {Frame} */
  home = this.frame;
  #zoom;
  #canvas;
  #layer;
  #rim = svg("circle", { class: "rim" });
  #corners = svg("g", { class: "corners" });
  #vector = markVector(false);
  #zero = svg("text", { class: "label zero" });
  #one = svg("text", { class: "label" });

  /** @param {HTMLCanvasElement} canvas of the picture @param {HTMLCanvasElement} lines @param {SVGSVGElement} root @param {() => void} onZoom called when another part is looked at */
  constructor(canvas, lines, root, onZoom) {
    this.root = root;
    // All ground of the disk is held by its own drags.
    this.#zoom = new Zoom(root, () => this, onZoom, ({ shiftKey }) => shiftKey);
    this.#canvas = canvas;
    this.#layer = new Layer(lines);
    this.#zero.textContent = "0";
    this.#one.textContent = "1";
    root.append(this.#rim, this.#corners, this.#vector, this.#zero, this.#one);
  }

  fit() {
    this.home = diskFrame(Math.max(1, this.root.getBoundingClientRect().width));
    this.frame = this.#zoom.within(this.home);
  }

  /** The frame to render in. @param {number} sharpness 1 for the screen's own pixels */
  view(sharpness) {
    return onGrid(this.frame, deviceGrid(this.frame.pixels, sharpness, 64));
  }

  /** @param {import("./pipeline.js").Result} result */
  paint({ pixels, view }) {
    paint(this.#canvas, pixels, view.pixels);
  }

  /** @param {Shown} shown @param {Outcome | null} outcome @param {Point | undefined} selected the corner to mark @param {boolean} quick while a hand moves */
  draw(shown, outcome, selected, quick) {
    const drawing = this.#layer.begin(this.frame);
    const way = outcome?.result.way;
    this.root.classList.toggle("between", Boolean(way));
    const [x, y] = toPixels(this.frame, [0, 0]);
    set(this.#rim, { cx: x, cy: y, r: scaleOf(this.frame) });
    const one = toPixels(this.frame, [1, 0]);
    updateVector(this.#vector, one, [x, y]);
    set(this.#zero, { x: x - 14, y: y + 18 });
    set(this.#one, { x: one[0] - 16, y: one[1] + 20 });
    match(this.#corners, [...(outcome?.result.angles ?? [])], () => svg("circle", { r: 3 }), (element, angle, k) => {
      const [cx, cy] = toPixels(this.frame, [Math.cos(angle), Math.sin(angle)]);
      const corners = outcome?.result.corners ?? [];
      const chosen = selected && corners[2 * k] === selected[0] && corners[2 * k + 1] === selected[1];
      set(element, { cx, cy, class: chosen ? "corner selected" : "corner" });
    });
    const walls = outcome?.result.walls;
    this.root.classList.toggle("ring", walls?.onto === "ring");
    if (!outcome) return;
    const heat = outcome.heat("target", shown);
    if (heat) drawWithin(drawing, heat.picture, heat.frame);
    drawLayers(drawing, outcome.layers("target", shown), quick);
    if (walls) drawLayers(drawing, [{ ink: "outline", lines: walls.lines, closed: true }]);
    if (way) drawLayers(drawing, [{ ink: "rim", lines: [way.outline], closed: true }, { ink: "vector", lines: arrowLines(way.toward, way.center, this.frame) }]);
  }
}
