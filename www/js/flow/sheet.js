// What scenes are drawn on: a canvas of the page.

import { canvasOf, Layer } from "../common/canvas.js";
import { drawScene, PALETTES } from "./scene.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("./scene.js").Plate} Plate */
/** @typedef {import("./scene.js").Scene} Scene */
/** @typedef {[red: number, green: number, blue: number]} Colour */
/** Colours for −1, 0 and 1, in the light and in the dark. @typedef {Record<"light" | "dark", [Colour, Colour, Colour]>} Scale */

const DARK = matchMedia("(prefers-color-scheme: dark)");
const theme = () => (DARK.matches ? "dark" : "light");

/** The colours of the page. */
export const palette = () => PALETTES[theme()];

/** The colours of numbers from −1 to 1 on a grid. @param {Frame} grid @param {Float32Array} shares @param {Scale} scale @returns {Plate} */
export function plateOf({ pixels: size }, shares, scale) {
  const pixels = new Uint8ClampedArray(4 * shares.length);
  const [low, zero, high] = scale[theme()];
  shares.forEach((share, k) => {
    const end = share > 0 ? high : low;
    for (let channel = 0; channel < 3; channel++) pixels[4 * k + channel] = zero[channel] + Math.abs(share) * (end[channel] - zero[channel]);
    pixels[4 * k + 3] = 255;
  });
  return { pixels, size };
}

export class Sheet {
  #canvas;
  #layer;
  /** The plate that was drawn last, as a canvas. @type {{ plate: Plate, canvas: HTMLCanvasElement } | null} */ #laid = null;

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#canvas = canvas;
    this.#layer = new Layer(canvas);
  }

  /** @param {Scene} scene */
  draw(scene) {
    const { grid, plate } = scene;
    const [columns, rows] = grid.pixels;
    const width = this.#canvas.clientWidth;
    if (plate && this.#laid?.plate !== plate) this.#laid = { plate, canvas: canvasOf(plate.pixels, plate.size, "srgb") };
    drawScene(this.#layer.begin({ ...grid, pixels: [width, (width * rows) / columns] }), scene, plate && (this.#laid?.canvas ?? null));
  }
}
