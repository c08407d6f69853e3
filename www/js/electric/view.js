// The picture of a field: the potential as colour, lines of equal potential, lines of force, conductors.

import { palette, plateOf, Sheet } from "../flow/sheet.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../flow/grid-field.js").GridField} GridField */
/** @typedef {{ outline: Point[], potential: number, around: boolean }} Drawn a conductor */
/** @typedef {{ potential: boolean, levels: boolean, lines: boolean }} Shown */

/** Of the lowest potential, of zero, and of the highest. @type {import("../flow/sheet.js").Scale} */
const COLOURS = {
  light: [[52, 98, 200], [250, 249, 246], [206, 62, 52]],
  dark: [[60, 112, 230], [24, 27, 33], [222, 84, 70]],
};

export class ElectricView {
  #sheet;
  /** @type {Point[][]} */ #equal = [];
  /** @type {Point[][]} */ #force = [];
  /** @type {import("../flow/scene.js").Plate | null} */ #plate = null;
  /** What was drawn last. @type {import("../flow/scene.js").Scene | null} */ scene = null;

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#sheet = new Sheet(canvas);
  }

  /** @param {GridField} field @param {import("./answers.js").Answer} answer @param {number} highest the largest potential, without its sign */
  prepare(field, { equal, force }, highest) {
    this.#equal = equal;
    this.#force = force;
    this.#plate = plateOf(field.grid, Float32Array.from(field.values, (value) => Math.max(-1, Math.min(1, value / (highest || 1)))), COLOURS);
  }

  /** @param {GridField} field @param {Drawn[]} drawn @param {Shown} shown */
  draw({ grid }, drawn, shown) {
    this.scene = {
      grid,
      palette: palette(),
      plate: shown.potential ? this.#plate : null,
      within: drawn.find(({ around }) => around)?.outline ?? null,
      strokes: [
        ...(shown.levels ? [{ lines: this.#equal, width: 1, opacity: 0.4 }] : []),
        ...(shown.lines ? [{ lines: this.#force, width: 1.6, opacity: 0.85 }] : []),
      ],
      bodies: drawn.map(({ outline, around }) => ({ outline, filled: !around })),
      words: drawn.map(({ outline, potential, around }) => ({
        text: potential > 0 ? `+${potential} V` : potential < 0 ? `−${-potential} V` : "0 V",
        at: around ? [middleOf(outline)[0], Math.max(...outline.map((p) => p[1])) - 0.18] : middleOf(outline),
      })),
      rests: [],
      over: [],
    };
    this.#sheet.draw(this.scene);
  }
}

/** The middle of a conductor's box. @param {Point[]} outline @returns {Point} */
function middleOf(outline) {
  const [xs, ys] = [0, 1].map((k) => outline.map((p) => p[k]));
  return [(Math.min(...xs) + Math.max(...xs)) / 2, (Math.min(...ys) + Math.max(...ys)) / 2];
}
