// Canvases: their context, their size in device pixels, pixels put on them.

import { imageOf, SPACE } from "./colours.js";
import { onGrid } from "./frame.js";

/** @typedef {import("./frame.js").Frame} Frame */
/** @typedef {import("./frame.js").Point} Point */

/** The 2d context of a canvas. @param {HTMLCanvasElement} canvas @param {CanvasRenderingContext2DSettings} [settings] */
export function contextOf(canvas, settings) {
  const context = canvas.getContext("2d", { colorSpace: SPACE, ...settings });
  if (!context) throw new Error("This browser gives no 2d canvas.");
  return context;
}

/** A new canvas with something drawn on it, and its pixels. @param {Point} size @param {(context: CanvasRenderingContext2D) => void} draw */
export function drawnCanvas([width, height], draw) {
  const canvas = Object.assign(document.createElement("canvas"), { width, height });
  const context = contextOf(canvas, { willReadFrequently: true });
  context.imageSmoothingQuality = "high";
  draw(context);
  return { canvas, pixels: context.getImageData(0, 0, width, height).data };
}

/** Device pixels a CSS pixel. */
export const density = () => window.devicePixelRatio || 1;

/** No picture has more pixels along a side: a screen shows no more. */
const MOST = 1600;

/**
 * The pixel grid of a panel at a sharpness: 1 for all of the screen's own pixels.
 * @param {Point} size in CSS pixels @param {number} sharpness @param {number} [least] pixels along a side @returns {Point}
 */
export function deviceGrid([width, height], sharpness, least = 32) {
  /** @param {number} side */
  const count = (side) => Math.min(MOST, Math.max(least, Math.round(side * density() * sharpness)));
  return [count(width), count(height)];
}

/** Shows pixels on a canvas, which becomes as large as they are. @param {HTMLCanvasElement} canvas @param {Uint8ClampedArray<ArrayBuffer>} pixels @param {Point} size @param {PredefinedColorSpace} [space] another than photos have */
export function paint(canvas, pixels, [width, height], space) {
  paintBeside(canvas, [pixels], [[width, height]], space);
}

/** Shows pictures of one height side by side; one may have no width. @param {HTMLCanvasElement} canvas @param {Uint8ClampedArray<ArrayBuffer>[]} pictures @param {Point[]} sizes @param {PredefinedColorSpace} [space] */
export function paintBeside(canvas, pictures, sizes, space) {
  Object.assign(canvas, { width: sizes.reduce((sum, [width]) => sum + width, 0), height: sizes[0][1] });
  const context = contextOf(canvas);
  let left = 0;
  pictures.forEach((pixels, k) => {
    const [width, height] = sizes[k];
    if (width) context.putImageData(imageOf(pixels, width, height, space), left, 0);
    left += width;
  });
}

/** A canvas with pixels on it. @param {Uint8ClampedArray<ArrayBuffer>} pixels @param {Point} size @param {PredefinedColorSpace} [space] */
export function canvasOf(pixels, size, space) {
  const canvas = document.createElement("canvas");
  paint(canvas, pixels, size, space);
  return canvas;
}

/** How much thicker lines are on a projector. */
const boldness = () => (document.body.classList.contains("projector") ? 2 : 1);

/** A canvas sized to its box in device pixels, cleared, with the frame to draw in. */
export class Layer {
  #canvas;
  #context;

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#canvas = canvas;
    this.#context = contextOf(canvas);
  }

  /** Fits the canvas to `frame` at the screen's density, and clears it. @param {Frame} frame in CSS pixels */
  begin(frame) {
    const [width, height] = frame.pixels.map((n) => Math.max(1, Math.round(n * density())));
    if (this.#canvas.width !== width) this.#canvas.width = width;
    if (this.#canvas.height !== height) this.#canvas.height = height;
    this.#context.clearRect(0, 0, width, height);
    return { context: this.#context, frame: onGrid(frame, [width, height]), density: density() * boldness() };
  }
}

/** @typedef {ReturnType<Layer["begin"]>} Drawing */
