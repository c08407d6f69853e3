// The drawings over the panels: a photo that is looked at, and both hemispheres laid out with their foveas together.

import { contextOf, deviceGrid, paint, paintBeside } from "../common/canvas.js";
import { onGrid, scaleOf, toPixels, unflatten } from "../common/frame.js";
import { match, pathData, set, svg } from "../common/svg.js";
import { Zoom } from "../common/zoom.js";
import { drawWithin } from "../editor/photo-view.js";
import { panelFrame } from "./layout.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/images.js").Picture} Picture */
/** @typedef {import("./layout.js").Half} Half */
/** @typedef {import("./maps.js").Line} Line */
/** @typedef {import("./models.js").Landmark} Landmark */

/** Names of rings stand at least this far apart, in pixels. */
const NAME_WIDTH = 26;
/** Of the bar that shows the scale, in mm. */
const BAR = 10;
/** Length of the landmark's arrow, in pixels. */
const ARROW = 34;

/** An SVG with the lines of the visual field, and what is marked on them. */
class LinedView {
  root;
  /** What is seen, in CSS pixels of the panel. @type {Frame} */
  frame = { center: [0, 0], width: 2, pixels: [1, 1] };
  /** All that can be seen. @type {Frame} */
  home = this.frame;
  /** @protected */ zoom;
  #circles = svg("path", { class: "field-circles" });
  #halo = svg("path", { class: "field-halo" });
  #lines = svg("path", { class: "field-lines" });
  #names = svg("g", { class: "field-names" });

  /** @param {SVGSVGElement} root @param {() => void} onLook called when another part is looked at @param {(event: PointerEvent) => boolean} isEmpty whether a press takes hold of nothing */
  constructor(root, onLook, isEmpty) {
    this.root = root;
    this.zoom = new Zoom(root, () => this, onLook, isEmpty);
    root.append(this.#circles, this.#halo, this.#lines, this.#names);
  }

  /** @protected @param {Point[][]} lines @param {[name: string, at: Point][]} names @param {Point[][]} circles */
  drawLines(lines, names, circles) {
    /** @param {Point[]} line */
    const data = (line) => pathData(line.map((p) => toPixels(this.frame, p)), false);
    for (const path of [this.#halo, this.#lines]) set(path, { d: lines.map(data).join("") });
    set(this.#circles, { d: circles.map(data).join("") });
    match(this.#names, names, () => svg("text"), (text, [name, at]) => {
      const [x, y] = toPixels(this.frame, at);
      set(text, { x: x + 4, y: y - 4 });
      text.textContent = name;
    });
  }

  /** @protected @param {Frame} frame */
  fitTo(frame) {
    const { width, height } = this.root.getBoundingClientRect();
    this.home = onGrid(frame, [Math.max(1, width), Math.max(1, height)]);
    this.frame = this.zoom.within(this.home);
  }

  /** What is looked at; null for all. */
  get place() {
    return this.zoom.place;
  }

  /** The panel's own pixels on the screen, or fewer. @param {number} sharpness @returns {Point} */
  grid(sharpness) {
    return deviceGrid(this.frame.pixels, sharpness, 16);
  }
}

export class SeenView extends LinedView {
  #canvas;
  #fixation = svg("g", { class: "fixation" }, [svg("circle", { r: 11 }), svg("circle", { r: 2.5 }), svg("path", { d: "M-18 0h9M9 0h9M0 -18v9M0 9v9" })]);

  /** The picture that is looked at. */
  #picture = "";

  /** @param {HTMLCanvasElement} canvas @param {SVGSVGElement} root @param {() => void} onLook */
  constructor(canvas, root, onLook) {
    // Elsewhere a press moves the gaze.
    super(root, onLook, ({ shiftKey }) => shiftKey);
    this.#canvas = canvas;
    root.append(this.#fixation);
  }

  /** @param {Picture} picture @param {Point} fixation @param {boolean} bare whether the photo itself is to be drawn */
  show(picture, fixation, bare) {
    if (picture.id !== this.#picture) this.zoom.reset();
    this.#picture = picture.id;
    this.fitTo(picture.frame);
    if (bare) this.drawPhoto(picture);
    const [x, y] = toPixels(this.frame, fixation);
    set(this.#fixation, { transform: `translate(${x} ${y})` });
  }

  /** The lines of the field around the fixation point. @param {Point} fixation @param {Line[]} lines @param {Line[]} circles */
  overlay(fixation, lines, circles) {
    const points = lines.map(({ at }) => unflatten(at));
    const [w, h] = this.frame.pixels;
    let [last] = toPixels(this.frame, fixation);
    /** @type {[string, Point][]} */
    const named = [];
    points.forEach((line, k) => {
      const middle = line[Math.floor(line.length / 2)];
      if (!lines[k].name || !middle) return;
      const [x, y] = toPixels(this.frame, middle);
      if (x < last + NAME_WIDTH || x > w - NAME_WIDTH || y < 12 || y > h) return;
      last = x;
      named.push([lines[k].name, middle]);
    });
    this.drawLines(points, named, circles.map(({ at }) => unflatten(at)));
  }

  /** @param {Picture} picture */
  drawPhoto({ canvas, frame: whole }) {
    const [width, height] = this.grid(1);
    const frame = onGrid(this.frame, [width, height]);
    Object.assign(this.#canvas, { width, height });
    const context = contextOf(this.#canvas);
    context.imageSmoothingQuality = "high";
    drawWithin({ context, frame }, canvas, whole);
  }

  /** The frame for a picture that fills the panel. @param {number} sharpness @returns {Frame} */
  view(sharpness) {
    return onGrid(this.frame, this.grid(sharpness));
  }

  /** @param {Uint8ClampedArray<ArrayBuffer>} pixels @param {Point} size */
  paint(pixels, size) {
    paint(this.#canvas, pixels, size);
  }
}

export class CortexView extends LinedView {
  #canvas;
  #outlines = svg("path", { class: "cortex-outline" });
  #bar = svg("g", { class: "bar" }, [svg("path"), svg("text", { "text-anchor": "middle", y: -6 })]);
  /** What was drawn last. */
  #shown = "";
  /** The landmark's place and the end of its arrow, to be dragged. */
  #landmark = svg("g", { class: "landmark" }, [
    svg("path", { class: "arrow" }),
    svg("circle", { class: "handle", "data-part": "direction", r: 6, role: "button", tabindex: 0 }),
    svg("circle", { class: "handle place", "data-part": "center", r: 7, role: "button", tabindex: 0 }),
    svg("text", { class: "landmark-name" }),
  ]);

  /** @param {HTMLCanvasElement} canvas @param {SVGSVGElement} root @param {() => void} onLook */
  constructor(canvas, root, onLook) {
    super(root, onLook, ({ target }) => !root.classList.contains("drawing") && !(target instanceof Element && target.closest("[data-part]")));
    this.#canvas = canvas;
    root.prepend(this.#outlines);
    root.append(this.#bar, this.#landmark);
    const [, name] = this.#bar.children;
    name.textContent = `${BAR} mm`;
    this.#landmark.lastElementChild?.append("blind spot");
  }

  /** @param {Half} half */
  fit(half) {
    this.fitTo(panelFrame(half, [1, 1]));
    const [columns, rows] = this.frame.pixels;
    const length = BAR * scaleOf(this.frame);
    set(this.#bar.children[0], { d: `M${-length / 2} -4v4h${length}v-4` });
    set(this.#bar, { transform: `translate(${columns / 2} ${rows - 6})` });
  }

  /** @param {number} id of the map @param {Float64Array} outline of the left hemisphere @param {Line[]} lines @param {Line[]} circles */
  show(id, outline, lines, circles) {
    // All this is the same wherever one looks.
    const key = JSON.stringify([id, lines.length, circles.length, this.frame]);
    if (key === this.#shown) return;
    this.#shown = key;
    const left = unflatten(outline);
    const right = left.map(([x, y]) => /** @type {Point} */ ([-x, y]));
    set(this.#outlines, { d: [left, right].map((line) => pathData(line.map((p) => toPixels(this.frame, p)), true)).join("") });
    const points = lines.map(({ at }) => unflatten(at));
    /** @type {[string, Point][]} */
    const named = [];
    let last = Infinity;
    points.forEach((line, k) => {
      const middle = line[Math.floor(line.length / 2)];
      if (!lines[k].name || !middle) return;
      const [x] = toPixels(this.frame, middle);
      if (Math.abs(x - last) < NAME_WIDTH) return;
      last = x;
      named.push([lines[k].name, middle]);
    });
    this.drawLines(points, named, circles.map(({ at }) => unflatten(at)));
  }

  /** Where the blind spot is, and which way the meridian runs there, if that can be chosen. @param {Landmark | null} landmark */
  mark(landmark) {
    set(this.#landmark, { visibility: landmark ? "visible" : "hidden" });
    if (landmark) this.#showLandmark(landmark);
  }

  /** @param {Landmark} landmark */
  #showLandmark({ center, direction }) {
    const [x, y] = toPixels(this.frame, center);
    const [dx, dy] = [ARROW * Math.cos(direction), -ARROW * Math.sin(direction)];
    const [arrow, end, place, name] = this.#landmark.children;
    set(arrow, { d: `M${x} ${y}l${dx} ${dy}` });
    set(end, { cx: x + dx, cy: y + dy, "aria-label": "Direction of the horizontal meridian" });
    set(place, { cx: x, cy: y, "aria-label": "Place of the blind spot" });
    set(name, { x: x - 10, y: y + 22 });
  }

  /** @param {Uint8ClampedArray<ArrayBuffer>[]} pixels of the two hemispheres @param {Point[]} sizes */
  paint(pixels, sizes) {
    paintBeside(this.#canvas, pixels, sizes);
  }

  get canvas() {
    return this.#canvas;
  }
}
