// The picture of a field: the potential as colour, lines of equal potential, lines of force, conductors.

import { toPixels } from "../common/frame.js";
import { Sheet } from "../flow/sheet.js";

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

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#sheet = new Sheet(canvas);
  }

  /** @param {GridField} field @param {import("./answers.js").Answer} answer @param {number} highest the largest potential, without its sign */
  prepare(field, { equal, force }, highest) {
    this.#equal = equal;
    this.#force = force;
    this.#sheet.colour(field.grid, Float32Array.from(field.values, (value) => Math.max(-1, Math.min(1, value / (highest || 1)))), COLOURS);
  }

  /** @param {GridField} field @param {Drawn[]} drawn @param {Shown} shown */
  draw({ grid }, drawn, shown) {
    const sheet = this.#sheet;
    const { context } = sheet.begin(grid);
    const shield = drawn.find(({ around }) => around);
    if (shield) sheet.within(shield.outline);
    if (shown.potential) sheet.lay();
    if (shown.levels) sheet.lines(this.#equal, 1, 0.4);
    if (shown.lines) sheet.lines(this.#force, 1.6, 0.85);
    if (shield) context.restore();
    for (const { outline, potential, around } of drawn) {
      sheet.outline(outline, !around);
      this.#words(potential, around ? [middleOf(outline)[0], Math.max(...outline.map((p) => p[1])) - 0.18] : middleOf(outline));
    }
  }

  /** @param {number} potential @param {Point} at */
  #words(potential, at) {
    const { context, frame, density } = this.#sheet.drawing;
    Object.assign(context, { fillStyle: this.#sheet.ink, font: `600 ${13 * density}px Inter, sans-serif`, textAlign: "center", textBaseline: "middle" });
    context.fillText(potential > 0 ? `+${potential} V` : potential < 0 ? `−${-potential} V` : "0 V", ...toPixels(frame, at));
  }
}

/** The middle of a conductor's box. @param {Point[]} outline @returns {Point} */
function middleOf(outline) {
  const [xs, ys] = [0, 1].map((k) => outline.map((p) => p[k]));
  return [(Math.min(...xs) + Math.max(...xs)) / 2, (Math.min(...ys) + Math.max(...ys)) / 2];
}
