// The picture of a flow: pressure as colour, streamlines, specks, bodies, where the fluid rests.

import { levelPieces } from "./levels.js";
import { Sheet } from "./sheet.js";
import { scaleOf, toPixels } from "../common/frame.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./wind.js").Wind} Wind */
/** @typedef {{ pressure: boolean, lines: boolean, specks: boolean }} Shown */

/** Streamlines across the picture's height. */
const LINES = 26;
/** Pressure coefficients beyond this look alike. */
const STRONGEST = 1.6;
/** Of suction, of rest, and of pressure. @type {import("./sheet.js").Scale} */
const COLOURS = {
  light: [[38, 84, 190], [250, 249, 246], [200, 52, 44]],
  dark: [[72, 128, 255], [24, 27, 33], [232, 92, 78]],
};

export class FlowView {
  #sheet;
  /** @type {number[]} */ #pieces = [];
  /** Traced ones, which take the pieces' place. @type {Point[][] | null} */ #lines = null;

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#sheet = new Sheet(canvas);
  }

  /** Prepares what changes with the wind alone. @param {Wind} wind @param {Shown} shown */
  prepare(wind, shown) {
    if (shown.pressure) this.#sheet.colour(wind.grid, coefficients(wind).map(shareOf), COLOURS);
    this.#lines = null;
    this.#pieces = shown.lines ? levelPieces(wind.values, wind.grid, levelsOf(wind)) : [];
  }

  /** Streamlines that were traced for the wind that was prepared. @param {Point[][]} lines */
  take(lines) {
    this.#lines = lines;
  }

  /** @param {Wind} wind @param {Point[][]} outlines @param {Shown} shown @param {Point[][]} trails @param {Point[]} resting where the fluid rests */
  draw({ grid }, outlines, shown, trails, resting) {
    const sheet = this.#sheet;
    const { context, frame, density } = sheet.begin(grid);
    if (shown.pressure) sheet.lay();
    if (shown.lines && this.#lines) sheet.lines(this.#lines, 1.1, 0.5);
    else if (shown.lines) sheet.pieces(this.#pieces, grid, 1.1, 0.5);
    if (shown.specks) {
      // Trails fade: their older half is drawn faintly.
      sheet.lines(trails, 1.3, 0.2);
      sheet.lines(trails.map((trail) => trail.slice(trail.length >> 1)), 1.3, 0.6);
    }
    for (const outline of outlines) sheet.outline(outline, true);
    Object.assign(context, { fillStyle: "#ffc62e", strokeStyle: "#5f4300", lineWidth: 1.2 * density });
    for (const point of resting) {
      context.beginPath();
      context.arc(...toPixels(frame, point), 4 * density, 0, 2 * Math.PI);
      context.fill();
      context.stroke();
    }
  }

  /** A stroke that is being drawn. @param {Point[]} stroke */
  sketch(stroke) {
    this.#sheet.lines([stroke], 2.5, 1, this.#sheet.accent);
  }
}

/** How strong a pressure coefficient is, −1 to 1. @param {number} coefficient */
const shareOf = (coefficient) => Math.sign(coefficient) * Math.min(1, Math.abs(coefficient) / (coefficient > 0 ? 1 : STRONGEST)) ** 0.8;

/** Stream functions at equal distances, through that of each body: its lines are those that part there. @param {Wind} wind */
export function levelsOf({ values, grid, walls }) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  const step = grid.pixels[1] / scaleOf(grid) / LINES;
  const [first] = walls;
  const begin = Math.ceil((low - first) / step);
  const even = Array.from({ length: Math.max(0, Math.floor((high - first) / step) - begin + 1) }, (_, k) => first + (begin + k) * step);
  return [...new Set([...even, ...walls])];
}

/** Pressure coefficients 1 − |u|². Points of a body beside the fluid take that of their neighbours, so that colours reach the wall. @param {Wind} wind */
function coefficients({ alongX, alongY, solid, grid: { pixels: [columns, rows] } }) {
  const found = Float32Array.from(alongX, (x, k) => (solid[k] ? 0 : 1 - x * x - alongY[k] * alongY[k]));
  const filled = Float32Array.from(found);
  for (let k = 0; k < found.length; k++) {
    if (!solid[k]) continue;
    const column = k % columns;
    const around = [column > 0 ? k - 1 : -1, column + 1 < columns ? k + 1 : -1, k - columns, k + columns < columns * rows ? k + columns : -1];
    const fluid = around.filter((at) => at >= 0 && !solid[at]);
    if (fluid.length) filled[k] = fluid.reduce((sum, at) => sum + found[at], 0) / fluid.length;
  }
  return filled;
}
