// The drawings over the panels: a photo that is looked at, and both hemispheres laid out with their foveas together.

import { onGrid, scaleOf, toPixels } from "../common/frame.js";
import { match, pathData, set, svg } from "../common/svg.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./eye.js").Line} Line */
/** @typedef {import("./models.js").Landmark} Landmark */
/** @typedef {{ width: number, height: number }} Half half of the size of both hemispheres, in mm */

/** The panel spans a little more than both hemispheres. */
const MARGIN = 1.06;
/** Names of rings stand at least this far apart, in pixels. */
const NAME_WIDTH = 26;
/** Of the bar that shows the scale, in mm. */
const BAR = 10;
/** Length of the landmark's arrow, in pixels. */
const ARROW = 34;

/** An SVG with the lines of the visual field, and what is marked on them. */
class LinedView {
  root;
  /** In CSS pixels of the panel. @type {Frame} */
  frame = { center: [0, 0], width: 2, pixels: [1, 1] };
  #circles = svg("path", { class: "field-circles" });
  #halo = svg("path", { class: "field-halo" });
  #lines = svg("path", { class: "field-lines" });
  #names = svg("g", { class: "field-names" });

  /** @param {SVGSVGElement} root */
  constructor(root) {
    this.root = root;
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
    this.frame = onGrid(frame, [Math.max(1, width), Math.max(1, height)]);
  }

  /** The panel's frame on the screen's own pixels, or on fewer. @protected @param {number} sharpness @returns {Point} */
  grid(sharpness) {
    const density = (window.devicePixelRatio || 1) * sharpness;
    return [Math.max(16, Math.round(this.frame.pixels[0] * density)), Math.max(16, Math.round(this.frame.pixels[1] * density))];
  }
}

export class SeenView extends LinedView {
  #canvas;
  #fixation = svg("g", { class: "fixation" }, [svg("circle", { r: 11 }), svg("circle", { r: 2.5 }), svg("path", { d: "M-18 0h9M9 0h9M0 -18v9M0 9v9" })]);

  /** @param {HTMLCanvasElement} canvas @param {SVGSVGElement} root */
  constructor(canvas, root) {
    super(root);
    this.#canvas = canvas;
    root.append(this.#fixation);
  }

  /** @param {import("../common/images.js").Picture} picture @param {Point} fixation @param {Line[]} lines @param {Line[]} circles @param {boolean} bare whether the photo itself is to be drawn */
  show(picture, fixation, lines, circles, bare) {
    this.fitTo(picture.frame);
    if (bare) this.drawPhoto(picture);
    const [x, y] = toPixels(this.frame, fixation);
    set(this.#fixation, { transform: `translate(${x} ${y})` });
    const [w, h] = this.frame.pixels;
    let last = x;
    /** @type {[string, Point][]} */
    const named = [];
    for (const { name, picture: line } of lines) {
      const middle = line[Math.floor(line.length / 2)];
      if (!name || !middle) continue;
      const [px, py] = toPixels(this.frame, middle);
      if (px < last + NAME_WIDTH || px > w - NAME_WIDTH || py < 12 || py > h) continue;
      last = px;
      named.push([name, middle]);
    }
    this.drawLines(lines.map(({ picture: line }) => line), named, circles.map(({ picture: line }) => line));
  }

  /** @param {import("../common/images.js").Picture} picture */
  drawPhoto({ canvas }) {
    const [width, height] = this.grid(1);
    Object.assign(this.#canvas, { width, height });
    const context = this.#canvas.getContext("2d");
    if (!context) return;
    context.imageSmoothingQuality = "high";
    context.drawImage(canvas, 0, 0, width, height);
  }

  /** The frame for a picture that fills the panel. @param {number} sharpness @returns {Frame} */
  view(sharpness) {
    return onGrid(this.frame, this.grid(sharpness));
  }

  /** @param {Uint8ClampedArray<ArrayBuffer>} pixels @param {Point} size */
  paint(pixels, [width, height]) {
    Object.assign(this.#canvas, { width, height });
    this.#canvas.getContext("2d")?.putImageData(new ImageData(pixels, width, height), 0, 0);
  }
}

export class CortexView extends LinedView {
  #canvas;
  #outlines = svg("path", { class: "cortex-outline" });
  #bar = svg("g", { class: "bar" }, [svg("path"), svg("text", { "text-anchor": "middle", y: -6 })]);
  /** The landmark's place and the end of its arrow, to be dragged. */
  #landmark = svg("g", { class: "landmark" }, [
    svg("path", { class: "arrow" }),
    svg("circle", { class: "handle", "data-part": "direction", r: 6, tabindex: 0 }),
    svg("circle", { class: "handle place", "data-part": "center", r: 7, tabindex: 0 }),
    svg("text", { class: "landmark-name" }),
  ]);

  /** @param {HTMLCanvasElement} canvas @param {SVGSVGElement} root */
  constructor(canvas, root) {
    super(root);
    this.#canvas = canvas;
    root.prepend(this.#outlines);
    root.append(this.#bar, this.#landmark);
    const [, name] = this.#bar.children;
    name.textContent = `${BAR} mm`;
    this.#landmark.lastElementChild?.append("blind spot");
  }

  /** Width over height of the panel. @param {Half} half */
  static aspect({ width, height }) {
    return (2 * width * MARGIN) / (2 * height + 2 * width * (MARGIN - 1));
  }

  /** @param {Half} half */
  fit({ width }) {
    this.fitTo({ center: [0, 0], width: 2 * width * MARGIN, pixels: [2, 1] });
    const [columns, rows] = this.frame.pixels;
    const length = BAR * scaleOf(this.frame);
    set(this.#bar.children[0], { d: `M${-length / 2} -4v4h${length}v-4` });
    set(this.#bar, { transform: `translate(${columns / 2} ${rows - 6})` });
  }

  /** @param {Point[][]} outlines @param {Line[]} lines @param {Line[]} circles @param {Landmark | null} landmark */
  show(outlines, lines, circles, landmark) {
    set(this.#outlines, { d: outlines.map((line) => pathData(line.map((p) => toPixels(this.frame, p)), true)).join("") });
    /** @type {[string, Point][]} */
    const named = [];
    let last = Infinity;
    for (const { name, cortex } of lines) {
      const middle = cortex[Math.floor(cortex.length / 2)];
      if (!name || !middle) continue;
      const [x] = toPixels(this.frame, middle);
      if (Math.abs(x - last) < NAME_WIDTH) continue;
      last = x;
      named.push([name, middle]);
    }
    this.drawLines(lines.map(({ cortex }) => cortex), named, circles.map(({ cortex }) => cortex));
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

  /** The frames of the two halves. @param {number} sharpness 1 for the screen's own pixels @returns {Frame[]} */
  views(sharpness) {
    const [width, height] = this.grid(sharpness);
    const half = Math.round(width / 2);
    const quarter = this.frame.width / 4;
    return [-quarter, quarter].map((x) => ({
      center: /** @type {Point} */ ([x, 0]),
      width: 2 * quarter,
      pixels: /** @type {Point} */ ([half, height]),
    }));
  }

  /** @param {Uint8ClampedArray<ArrayBuffer>[]} pixels @param {Frame[]} views of the two halves */
  paint(pixels, views) {
    const [width, height] = views[0].pixels;
    Object.assign(this.#canvas, { width: 2 * width, height });
    const context = this.#canvas.getContext("2d");
    pixels.forEach((half, k) => context?.putImageData(new ImageData(half, width, height), k * width, 0));
  }

  get canvas() {
    return this.#canvas;
  }
}
