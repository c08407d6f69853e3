// The picture of a flow: pressure as colour, streamlines, specks, bodies, the wind's arrow.

import { levelPieces } from "./levels.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./wind.js").Wind} Wind */
/** @typedef {{ pressure: boolean, lines: boolean, specks: boolean }} Shown */

/** Streamlines across the picture's height. */
const LINES = 26;
/** Pressure coefficients beyond this look alike. */
const STRONGEST = 1.6;
/** Colours of suction, of rest, and of pressure, in the light and in the dark. @type {Record<"light" | "dark", [number, number, number][]>} */
const COLOURS = {
  light: [[38, 84, 190], [250, 249, 246], [200, 52, 44]],
  dark: [[72, 128, 255], [24, 27, 33], [232, 92, 78]],
};

export class FlowView {
  #canvas;
  #context;
  /** The pressure's colours, one pixel a point of the grid. */
  #plate = document.createElement("canvas");
  #dark = matchMedia("(prefers-color-scheme: dark)");
  /** @type {number[]} */ #pieces = [];

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#canvas = canvas;
    const context = canvas.getContext("2d");
    if (!context) throw new Error("This browser gives no 2d canvas.");
    this.#context = context;
  }

  /** Prepares what changes with the wind alone. @param {Wind} wind @param {Shown} shown */
  prepare(wind, shown) {
    if (shown.pressure) this.#colour(wind);
    this.#pieces = shown.lines ? levelPieces(wind.values, wind.grid, levelsOf(wind)) : [];
  }

  /** @param {Wind} wind @param {Point[][]} outlines @param {Shown} shown @param {Point[][]} trails @param {Point[]} resting where the fluid rests */
  draw(wind, outlines, shown, trails, resting) {
    const { grid } = wind;
    const context = this.#fit(grid.columns / grid.rows);
    const scale = this.#canvas.width / grid.columns;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.#canvas.width, this.#canvas.height);
    if (shown.pressure) {
      context.imageSmoothingEnabled = true;
      context.imageSmoothingQuality = "high";
      context.drawImage(this.#plate, 0, 0, this.#canvas.width, this.#canvas.height);
    }
    const ink = this.#dark.matches ? "#eceae5" : "#1c1e23";
    if (shown.lines) this.#lines(scale, ink);
    /** @param {Point} point @returns {Point} */
    const pixel = ([x, y]) => {
      const size = grid.width / grid.columns / scale;
      return [(x - grid.center[0]) / size + this.#canvas.width / 2, this.#canvas.height / 2 - (y - grid.center[1]) / size];
    };
    if (shown.specks) this.#trails(trails, pixel, ink);
    this.#bodies(outlines, pixel);
    context.fillStyle = "#ffc62e";
    context.strokeStyle = "#5f4300";
    context.lineWidth = 1.2 * this.#density;
    for (const point of resting) {
      context.beginPath();
      context.arc(...pixel(point), 4 * this.#density, 0, 2 * Math.PI);
      context.fill();
      context.stroke();
    }
  }

  /** A stroke that is being drawn. @param {Point[]} stroke @param {{ center: Point, width: number }} plane */
  sketch(stroke, { center, width }) {
    const context = this.#context;
    const scale = this.#canvas.width / width;
    context.beginPath();
    stroke.forEach(([x, y], k) => {
      const at = /** @type {Point} */ ([(x - center[0]) * scale + this.#canvas.width / 2, this.#canvas.height / 2 - (y - center[1]) * scale]);
      if (k) context.lineTo(...at);
      else context.moveTo(...at);
    });
    context.strokeStyle = this.#dark.matches ? "#9db2ff" : "#2b4bc8";
    context.lineWidth = 2.5 * this.#density;
    context.stroke();
  }

  get #density() {
    return window.devicePixelRatio || 1;
  }

  /** @param {number} aspect */
  #fit(aspect) {
    const wide = Math.max(64, Math.round(this.#canvas.clientWidth * this.#density));
    const high = Math.round(wide / aspect);
    if (this.#canvas.width !== wide || this.#canvas.height !== high) Object.assign(this.#canvas, { width: wide, height: high });
    return this.#context;
  }

  /** @param {Wind} wind */
  #colour(wind) {
    const { columns, rows } = wind.grid;
    Object.assign(this.#plate, { width: columns, height: rows });
    const context = this.#plate.getContext("2d");
    if (!context) return;
    const image = context.createImageData(columns, rows);
    const [suction, rest, pressure] = COLOURS[this.#dark.matches ? "dark" : "light"];
    coefficients(wind).forEach((coefficient, k) => {
      const end = coefficient > 0 ? pressure : suction;
      const share = Math.min(1, Math.abs(coefficient) / (coefficient > 0 ? 1 : STRONGEST)) ** 0.8;
      for (let channel = 0; channel < 3; channel++) image.data[4 * k + channel] = rest[channel] + share * (end[channel] - rest[channel]);
      image.data[4 * k + 3] = 255;
    });
    context.putImageData(image, 0, 0);
  }

  /** @param {number} scale @param {string} ink */
  #lines(scale, ink) {
    const context = this.#context;
    context.beginPath();
    const pieces = this.#pieces;
    for (let k = 0; k < pieces.length; k += 4) {
      context.moveTo(pieces[k] * scale, pieces[k + 1] * scale);
      context.lineTo(pieces[k + 2] * scale, pieces[k + 3] * scale);
    }
    context.strokeStyle = ink;
    context.globalAlpha = 0.5;
    context.lineWidth = 1.1 * this.#density;
    context.lineCap = "round";
    context.stroke();
    context.globalAlpha = 1;
  }

  /** Trails fade: their older half is drawn faintly. @param {Point[][]} trails @param {(point: Point) => Point} pixel @param {string} ink */
  #trails(trails, pixel, ink) {
    const context = this.#context;
    context.strokeStyle = ink;
    context.lineWidth = 1.3 * this.#density;
    for (const [from, alpha] of [[0, 0.2], [0.5, 0.6]]) {
      context.globalAlpha = alpha;
      context.beginPath();
      for (const trail of trails) {
        trail.slice(Math.floor(from * trail.length)).forEach((point, k) => (k ? context.lineTo(...pixel(point)) : context.moveTo(...pixel(point))));
      }
      context.stroke();
    }
    context.globalAlpha = 1;
  }

  /** @param {Point[][]} outlines @param {(point: Point) => Point} pixel */
  #bodies(outlines, pixel) {
    const context = this.#context;
    for (const outline of outlines) {
      context.beginPath();
      outline.forEach((point, k) => (k ? context.lineTo(...pixel(point)) : context.moveTo(...pixel(point))));
      context.closePath();
      context.fillStyle = this.#dark.matches ? "#3a3f49" : "#e6e2d8";
      context.fill();
      context.strokeStyle = this.#dark.matches ? "#eceae5" : "#1c1e23";
      context.lineWidth = 2 * this.#density;
      context.lineJoin = "round";
      context.stroke();
    }
  }
}

/** Stream functions at equal distances, through that of each body: its lines are those that part there. @param {Wind} wind */
function levelsOf({ values, grid: { width, columns, rows }, walls }) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  const step = (width * rows) / columns / LINES;
  const [first] = walls;
  const begin = Math.ceil((low - first) / step);
  const even = Array.from({ length: Math.max(0, Math.floor((high - first) / step) - begin + 1) }, (_, k) => first + (begin + k) * step);
  return [...new Set([...even, ...walls])];
}

/** Pressure coefficients 1 − |u|². Points of a body beside the fluid take that of their neighbours, so that colours reach the wall. @param {Wind} wind */
function coefficients({ alongX, alongY, solid, grid: { columns, rows } }) {
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
