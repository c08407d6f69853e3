// The picture of a flow: pressure as colour, streamlines, specks, bodies, where the fluid rests.

import { levelPieces } from "./levels.js";
import { palette, plateOf, Sheet } from "./sheet.js";
import { scaleOf } from "../common/frame.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./scene.js").Scene} Scene */
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
  /** @type {import("./scene.js").Plate | null} */ #plate = null;
  /** What was drawn last. @type {Scene | null} */ scene = null;

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#sheet = new Sheet(canvas);
  }

  /** Prepares what changes with the wind alone. @param {Wind} wind @param {Shown} shown */
  prepare(wind, shown) {
    this.#plate = shown.pressure ? plateOf(wind.grid, coefficients(wind).map(shareOf), COLOURS) : null;
    this.#lines = null;
    this.#pieces = shown.lines ? levelPieces(wind.values, wind.grid, levelsOf(wind)) : [];
  }

  /** Streamlines that were traced for the wind that was prepared. @param {Point[][]} lines */
  take(lines) {
    this.#lines = lines;
  }

  /**
   * @param {Wind} wind @param {Point[][]} outlines @param {Shown} shown @param {Point[][]} trails @param {Point[]} rests where the fluid rests
   * @param {import("./scene.js").Scene["vortices"]} vortices
   * @param {Point[]} [sketch] what is being drawn
   */
  draw({ grid }, outlines, shown, trails, rests, vortices, sketch) {
    const colours = palette();
    /** @type {import("./scene.js").Strokes[]} */
    const strokes = shown.lines ? [{ ...(this.#lines ? { lines: this.#lines } : { lines: [], pieces: this.#pieces }), width: 1.1, opacity: 0.5 }] : [];
    // Trails fade: their older half is drawn faintly.
    if (shown.specks) strokes.push({ lines: trails, width: 1.3, opacity: 0.2 }, { lines: trails.map((trail) => trail.slice(trail.length >> 1)), width: 1.3, opacity: 0.6 });
    this.scene = {
      grid,
      palette: colours,
      plate: shown.pressure ? this.#plate : null,
      within: null,
      strokes,
      bodies: outlines.map((outline) => ({ outline, filled: true })),
      words: [],
      rests,
      vortices,
      over: sketch ? [{ lines: [sketch], width: 2.5, opacity: 1, colour: colours.accent }] : [],
    };
    this.#sheet.draw(this.scene);
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
