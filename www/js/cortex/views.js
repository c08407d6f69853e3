// The two panels: a photo that is looked at, and both cortices laid out with their foveas together.

import { onGrid, toPixels } from "../common/frame.js";
import { match, pathData, set, svg } from "../common/svg.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./eye.js").Line} Line */

/** The panel spans a little more than both cortices. */
const MARGIN = 1.06;
/** Names of rings stand at least this far apart, in pixels. */
const NAME_WIDTH = 26;

/** An SVG with the lines of the visual field, and what is marked on them. */
class LinedView {
  root;
  /** In CSS pixels of the panel. @type {Frame} */
  frame = { center: [0, 0], width: 2, pixels: [1, 1] };
  #halo = svg("path", { class: "field-halo" });
  #lines = svg("path", { class: "field-lines" });
  #names = svg("g", { class: "field-names" });

  /** @param {SVGSVGElement} root */
  constructor(root) {
    this.root = root;
    root.append(this.#halo, this.#lines, this.#names);
  }

  /** @param {Point[][]} lines @param {[name: string, at: Point][]} names */
  drawLines(lines, names) {
    const data = lines.map((line) => pathData(line.map((p) => toPixels(this.frame, p)), false)).join("");
    for (const path of [this.#halo, this.#lines]) set(path, { d: data });
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

  /** @param {import("../common/images.js").Picture} picture @param {Point} fixation @param {Line[]} lines */
  show(picture, fixation, lines) {
    this.fitTo(picture.frame);
    const density = window.devicePixelRatio || 1;
    const [width, height] = this.frame.pixels.map((n) => Math.round(n * density));
    Object.assign(this.#canvas, { width, height });
    const context = this.#canvas.getContext("2d");
    if (context) {
      context.imageSmoothingQuality = "high";
      context.drawImage(picture.canvas, 0, 0, width, height);
    }
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
    this.drawLines(lines.map(({ picture: line }) => line), named);
  }
}

export class CortexView extends LinedView {
  #canvas;

  /** @param {HTMLCanvasElement} canvas @param {SVGSVGElement} root */
  constructor(canvas, root) {
    super(root);
    this.#canvas = canvas;
  }

  /** Width over height of the panel. @param {{ width: number, height: number }} half */
  static aspect({ width, height }) {
    return (2 * width * MARGIN) / (2 * height + 2 * width * (MARGIN - 1));
  }

  /** @param {{ width: number, height: number }} half of both cortices, in millimetres */
  fit(half) {
    this.fitTo({ center: [0, 0], width: 2 * half.width * MARGIN, pixels: [2, 1] });
  }

  /** @param {Line[]} lines */
  showLines(lines) {
    const named = lines.flatMap(({ name, cortex }) => {
      const middle = cortex[Math.floor(cortex.length / 2)];
      return name && middle ? [/** @type {[string, Point]} */ ([name, middle])] : [];
    });
    this.drawLines(lines.map(({ cortex }) => cortex), named);
  }

  /** The frames of the two halves. @param {number} sharpness 1 for the screen's own pixels @returns {Frame[]} */
  views(sharpness) {
    const density = (window.devicePixelRatio || 1) * sharpness;
    const [width, height] = this.frame.pixels.map((n) => Math.max(16, Math.round(n * density)));
    const half = Math.round(width / 2);
    const quarter = this.frame.width / 4;
    return [-quarter, quarter].map((x) => ({ center: /** @type {Point} */ ([x, 0]), width: 2 * quarter, pixels: /** @type {Point} */ ([half, height]) }));
  }

  /** @param {Uint8ClampedArray<ArrayBuffer>[]} pixels @param {Frame[]} views of the two halves */
  paint(pixels, views) {
    const [width, height] = views[0].pixels;
    Object.assign(this.#canvas, { width: 2 * width, height });
    const context = this.#canvas.getContext("2d");
    pixels.forEach((half, k) => context?.putImageData(new ImageData(half, width, height), k * width, 0));
  }
}
