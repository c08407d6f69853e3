// The picture of a field: the potential as colour, lines of equal potential, lines of force, conductors.

import { scaleOf, toPixels } from "../common/frame.js";
import { levelPieces } from "../flow/levels.js";
import { Sheet } from "../flow/sheet.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../flow/grid-field.js").GridField} GridField */
/** @typedef {{ outline: Point[], potential: number, around: boolean }} Drawn a conductor */
/** @typedef {{ potential: boolean, levels: boolean, lines: boolean }} Shown */

/** Steps of a line of force, in cells of the grid, and how many there are at most. */
const STEP = 0.5;
const STEPS = 1500;
/** Lines of equal potential between the lowest and the highest. */
const LEVELS = 21;
/** Of the lowest potential, of zero, and of the highest. @type {import("../flow/sheet.js").Scale} */
const COLOURS = {
  light: [[52, 98, 200], [250, 249, 246], [206, 62, 52]],
  dark: [[60, 112, 230], [24, 27, 33], [222, 84, 70]],
};

/** A line of force from a point on; it ends at a wall or the picture's edge. @param {GridField} field @param {Point} from @returns {Point[]} */
export function lineOfForce(field, from) {
  const step = STEP / scaleOf(field.grid);
  const line = [from];
  for (let k = 0; k < STEPS; k++) {
    const [x, y] = line[line.length - 1];
    const first = downhill(field, [x, y]);
    if (!first) break;
    const middle = downhill(field, [x + (step / 2) * first[0], y + (step / 2) * first[1]]);
    if (!middle) break;
    line.push([x + step * middle[0], y + step * middle[1]]);
  }
  return line;
}

/** The direction in which the potential falls. @param {GridField} field @param {Point} at @returns {Point | null} */
function downhill(field, at) {
  const slopes = field.slopes(at);
  const length = slopes ? Math.hypot(...slopes) : 0;
  return slopes && length > 0 ? [-slopes[0] / length, -slopes[1] / length] : null;
}

export class ElectricView {
  #sheet;
  /** @type {Point[][]} */ #lines = [];
  /** @type {number[]} */ #pieces = [];

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#sheet = new Sheet(canvas);
  }

  /** @param {GridField} field @param {Point[]} seeds @param {number} highest the largest potential, without its sign */
  prepare(field, seeds, highest) {
    this.#lines = seeds.map((seed) => lineOfForce(field, seed));
    this.#pieces = levelPieces(field.values, field.grid, Array.from({ length: LEVELS }, (_, k) => highest * ((2 * (k + 0.5)) / LEVELS - 1)));
    this.#sheet.colour(field.grid, Float32Array.from(field.values, (value) => Math.max(-1, Math.min(1, value / (highest || 1)))), COLOURS);
  }

  /** @param {GridField} field @param {Drawn[]} drawn @param {Shown} shown */
  draw({ grid }, drawn, shown) {
    const sheet = this.#sheet;
    const { context } = sheet.begin(grid);
    const shield = drawn.find(({ around }) => around);
    if (shield) sheet.within(shield.outline);
    if (shown.potential) sheet.lay();
    if (shown.levels) sheet.pieces(this.#pieces, grid, 1, 0.4);
    if (shown.lines) sheet.lines(this.#lines, 1.6, 0.85);
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
