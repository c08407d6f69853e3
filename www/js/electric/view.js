// The picture of a field: the potential as colour, lines of equal potential, lines of force, conductors.

import { levelPieces } from "../flow/levels.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../flow/grid-field.js").GridField} GridField */
/** @typedef {{ outline: Point[], potential: number, around: boolean }} Drawn a conductor */
/** @typedef {{ potential: boolean, levels: boolean, lines: boolean }} Shown */

/** Steps of a line of force, in cells of the grid, and how many there are at most. */
const STEP = 0.5;
const STEPS = 1500;
/** Lines of equal potential between the lowest and the highest. */
const LEVELS = 21;
/** Colours of the lowest potential, of zero, and of the highest. @type {Record<"light" | "dark", [number, number, number][]>} */
const COLOURS = {
  light: [[52, 98, 200], [250, 249, 246], [206, 62, 52]],
  dark: [[60, 112, 230], [24, 27, 33], [222, 84, 70]],
};

/** A line of force from a point on; it ends at a wall or the picture's edge. @param {GridField} field @param {Point} from @returns {Point[]} */
export function lineOfForce(field, from) {
  const step = (STEP * field.grid.width) / field.grid.columns;
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
  #canvas;
  #context;
  #plate = document.createElement("canvas");
  #dark = matchMedia("(prefers-color-scheme: dark)");
  /** @type {Point[][]} */ #lines = [];
  /** @type {number[]} */ #pieces = [];

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#canvas = canvas;
    const context = canvas.getContext("2d");
    if (!context) throw new Error("This browser gives no 2d canvas.");
    this.#context = context;
  }

  /** @param {GridField} field @param {Point[]} seeds @param {number} highest the largest potential, without its sign */
  prepare(field, seeds, highest) {
    this.#lines = seeds.map((seed) => lineOfForce(field, seed));
    this.#pieces = levelPieces(field.values, field.grid, Array.from({ length: LEVELS }, (_, k) => highest * ((2 * (k + 0.5)) / LEVELS - 1)));
    this.#colour(field, highest);
  }

  /** @param {GridField} field @param {Drawn[]} drawn @param {Shown} shown */
  draw({ grid }, drawn, shown) {
    const density = window.devicePixelRatio || 1;
    const wide = Math.max(64, Math.round(this.#canvas.clientWidth * density));
    const high = Math.round((wide * grid.rows) / grid.columns);
    if (this.#canvas.width !== wide || this.#canvas.height !== high) Object.assign(this.#canvas, { width: wide, height: high });
    const context = this.#context;
    const [ink, cell] = [this.#dark.matches ? "#eceae5" : "#1c1e23", wide / grid.columns];
    const size = grid.width / wide;
    /** @param {Point} point @returns {Point} */
    const pixel = ([x, y]) => [(x - grid.center[0]) / size + wide / 2, high / 2 - (y - grid.center[1]) / size];
    context.clearRect(0, 0, wide, high);
    const shield = drawn.find(({ around }) => around);
    context.save();
    if (shield) {
      trace(context, shield.outline.map(pixel), true);
      context.clip();
    }
    if (shown.potential) {
      context.imageSmoothingQuality = "high";
      context.drawImage(this.#plate, 0, 0, wide, high);
    }
    Object.assign(context, { strokeStyle: ink, lineCap: "round", lineJoin: "round" });
    if (shown.levels) {
      Object.assign(context, { lineWidth: density, globalAlpha: 0.4 });
      context.beginPath();
      for (let k = 0; k < this.#pieces.length; k += 4) {
        context.moveTo(this.#pieces[k] * cell, this.#pieces[k + 1] * cell);
        context.lineTo(this.#pieces[k + 2] * cell, this.#pieces[k + 3] * cell);
      }
      context.stroke();
    }
    if (shown.lines) {
      Object.assign(context, { lineWidth: 1.6 * density, globalAlpha: 0.85 });
      for (const line of this.#lines) {
        trace(context, line.map(pixel), false);
        context.stroke();
      }
    }
    context.restore();
    for (const { outline, potential, around } of drawn) {
      trace(context, outline.map(pixel), true);
      context.fillStyle = this.#dark.matches ? "#3a3f49" : "#e6e2d8";
      if (!around) context.fill();
      Object.assign(context, { strokeStyle: ink, lineWidth: 2 * density });
      context.stroke();
      this.#words(potential, around ? [middleOf(outline)[0], Math.max(...outline.map((p) => p[1])) - 0.18] : middleOf(outline), pixel, ink, density);
    }
  }

  /** @param {number} potential @param {Point} at @param {(point: Point) => Point} pixel @param {string} ink @param {number} density */
  #words(potential, at, pixel, ink, density) {
    const context = this.#context;
    Object.assign(context, { fillStyle: ink, font: `600 ${13 * density}px Inter, sans-serif`, textAlign: "center", textBaseline: "middle" });
    context.fillText(potential > 0 ? `+${potential} V` : potential < 0 ? `−${-potential} V` : "0 V", ...pixel(at));
  }

  /** @param {GridField} field @param {number} highest */
  #colour({ values, grid: { columns, rows } }, highest) {
    Object.assign(this.#plate, { width: columns, height: rows });
    const context = this.#plate.getContext("2d");
    if (!context) return;
    const image = context.createImageData(columns, rows);
    const [low, zero, high] = COLOURS[this.#dark.matches ? "dark" : "light"];
    values.forEach((value, k) => {
      const end = value > 0 ? high : low;
      const share = Math.min(1, Math.abs(value) / (highest || 1));
      for (let channel = 0; channel < 3; channel++) image.data[4 * k + channel] = zero[channel] + share * (end[channel] - zero[channel]);
      image.data[4 * k + 3] = 255;
    });
    context.putImageData(image, 0, 0);
  }
}

/** @param {CanvasRenderingContext2D} context @param {Point[]} points in pixels @param {boolean} closed */
function trace(context, points, closed) {
  context.beginPath();
  points.forEach((point, k) => (k ? context.lineTo(...point) : context.moveTo(...point)));
  if (closed) context.closePath();
}

/** The middle of a conductor's box. @param {Point[]} outline @returns {Point} */
function middleOf(outline) {
  const [xs, ys] = [0, 1].map((k) => outline.map((p) => p[k]));
  return [(Math.min(...xs) + Math.max(...xs)) / 2, (Math.min(...ys) + Math.max(...ys)) / 2];
}
