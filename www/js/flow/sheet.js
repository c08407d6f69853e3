// What flows and fields are drawn on: the colours of a function on a grid, its lines, outlines.

import { contextOf, Layer } from "../common/canvas.js";
import { toPixels } from "../common/frame.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {[red: number, green: number, blue: number]} Colour */
/** Colours for −1, 0 and 1, in the light and in the dark. @typedef {Record<"light" | "dark", [Colour, Colour, Colour]>} Scale */

const DARK = matchMedia("(prefers-color-scheme: dark)");

export class Sheet {
  #canvas;
  #layer;
  /** The colours, one pixel a point of the grid. */
  #plate = document.createElement("canvas");
  /** @type {import("../common/canvas.js").Drawing | null} */ #drawing = null;

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#canvas = canvas;
    this.#layer = new Layer(canvas);
  }

  /** The colour of lines. */
  get ink() {
    return DARK.matches ? "#eceae5" : "#1c1e23";
  }

  /** The colour of bodies. */
  get body() {
    return DARK.matches ? "#3a3f49" : "#e6e2d8";
  }

  /** The colour of what is being drawn. */
  get accent() {
    return DARK.matches ? "#9db2ff" : "#2b4bc8";
  }

  /** Prepares the colours of numbers from −1 to 1 on a grid. @param {Frame} grid @param {Float32Array} shares @param {Scale} scale */
  colour({ pixels: [width, height] }, shares, scale) {
    Object.assign(this.#plate, { width, height });
    const context = contextOf(this.#plate);
    const image = context.createImageData(width, height);
    const [low, zero, high] = scale[DARK.matches ? "dark" : "light"];
    shares.forEach((share, k) => {
      const end = share > 0 ? high : low;
      for (let channel = 0; channel < 3; channel++) image.data[4 * k + channel] = zero[channel] + Math.abs(share) * (end[channel] - zero[channel]);
      image.data[4 * k + 3] = 255;
    });
    context.putImageData(image, 0, 0);
  }

  /** Clears the sheet, which shows the plane of a grid. @param {Frame} grid */
  begin(grid) {
    const [columns, rows] = grid.pixels;
    const width = this.#canvas.clientWidth;
    this.#drawing = this.#layer.begin({ ...grid, pixels: [width, (width * rows) / columns] });
    Object.assign(this.#drawing.context, { imageSmoothingQuality: "high", lineCap: "round", lineJoin: "round" });
    return this.#drawing;
  }

  /** What was begun. */
  get drawing() {
    if (!this.#drawing) throw new Error("The sheet has not been begun.");
    return this.#drawing;
  }

  /** Lays the colours on. */
  lay() {
    const { context, frame } = this.drawing;
    context.drawImage(this.#plate, 0, 0, ...frame.pixels);
  }

  /** Draws pieces of lines, given in the pixels of a grid. @param {number[]} pieces @param {Frame} grid @param {number} width in CSS pixels @param {number} opacity */
  pieces(pieces, grid, width, opacity) {
    const { context, frame, density } = this.drawing;
    const scale = frame.pixels[0] / grid.pixels[0];
    context.beginPath();
    for (let k = 0; k < pieces.length; k += 4) {
      context.moveTo(pieces[k] * scale, pieces[k + 1] * scale);
      context.lineTo(pieces[k + 2] * scale, pieces[k + 3] * scale);
    }
    Object.assign(context, { strokeStyle: this.ink, lineWidth: width * density, globalAlpha: opacity });
    context.stroke();
    context.globalAlpha = 1;
  }

  /** Draws lines. @param {Point[][]} lines @param {number} width in CSS pixels @param {number} opacity @param {string} [colour] */
  lines(lines, width, opacity, colour = this.ink) {
    const { context, density } = this.drawing;
    context.beginPath();
    for (const line of lines) this.#trace(line);
    Object.assign(context, { strokeStyle: colour, lineWidth: width * density, globalAlpha: opacity });
    context.stroke();
    context.globalAlpha = 1;
  }

  /** Draws an outline. @param {Point[]} outline @param {boolean} filled */
  outline(outline, filled) {
    const { context, density } = this.drawing;
    this.#close(outline);
    Object.assign(context, { fillStyle: this.body, strokeStyle: this.ink, lineWidth: 2 * density });
    if (filled) context.fill();
    context.stroke();
  }

  /** Keeps what is drawn next within an outline; `restore` of the context ends that. @param {Point[]} outline */
  within(outline) {
    this.drawing.context.save();
    this.#close(outline);
    this.drawing.context.clip();
  }

  /** @param {Point[]} outline */
  #close(outline) {
    this.drawing.context.beginPath();
    this.#trace(outline);
    this.drawing.context.closePath();
  }

  /** @param {Point[]} line */
  #trace(line) {
    const { context, frame } = this.drawing;
    line.forEach((point, k) => (k ? context.lineTo(...toPixels(frame, point)) : context.moveTo(...toPixels(frame, point))));
  }
}
