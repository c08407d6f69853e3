// Pictures of flows and fields as plain data, drawn on the page and, in any size, in a worker.

import { toPixels } from "../common/frame.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/layers.js").Drawing} Drawing */
/** The colours of a function on a grid, a pixel a point. @typedef {{ pixels: Uint8ClampedArray<ArrayBuffer>, size: Point }} Plate */
/** Lines in the plane, or pieces of lines as x, y of both ends in the grid's pixels. @typedef {{ lines: Point[][], pieces?: number[], width: number, opacity: number, colour?: string }} Strokes */
/** @typedef {{ outline: Point[], filled: boolean }} Body */
/** The colours of lines, of bodies, of what is under all and of what is being drawn. @typedef {{ ink: string, body: string, paper: string, accent: string }} Palette */
/**
 * @typedef {object} Scene
 * @property {Frame} grid whose plane is shown
 * @property {Palette} palette
 * @property {Plate | null} plate
 * @property {Point[] | null} within beyond this outline there is nothing
 * @property {Strokes[]} strokes
 * @property {Body[]} bodies
 * @property {{ text: string, at: Point }[]} words
 * @property {Point[]} rests where the fluid rests
 * @property {{ at: Point, turns: 1 | -1, chosen: boolean }[]} [vortices] counter-clockwise, or the other way
 * @property {Strokes[]} over what is drawn by hand
 */

/** In the light and in the dark. @type {Record<"light" | "dark", Palette>} */
export const PALETTES = {
  light: { ink: "#1c1e23", body: "#e6e2d8", paper: "#ffffff", accent: "#2b4bc8" },
  dark: { ink: "#eceae5", body: "#3a3f49", paper: "#1d2026", accent: "#9db2ff" },
};

/** Draws a scene. @param {Drawing} drawing @param {Scene} scene @param {CanvasImageSource | null} plate its colours */
export function drawScene(drawing, scene, plate) {
  drawGround(drawing, scene, plate);
  drawLines(drawing, scene);
  drawBodies(drawing, scene);
  drawMarks(drawing, scene);
}

/** The colours. @param {Drawing} drawing @param {Scene} scene @param {CanvasImageSource | null} plate */
export function drawGround({ context, frame }, { within }, plate) {
  if (!plate) return;
  context.save();
  if (within) context.clip(pathOf([within], frame, true));
  context.imageSmoothingQuality = "high";
  context.drawImage(plate, 0, 0, ...frame.pixels);
  context.restore();
}

/** @param {Drawing} drawing @param {Scene} scene */
export function drawLines(drawing, { grid, palette, within, strokes, over }) {
  const { context, frame } = drawing;
  context.save();
  if (within) context.clip(pathOf([within], frame, true));
  for (const each of strokes) stroke(drawing, grid, palette, each);
  context.restore();
  for (const each of over) stroke(drawing, grid, palette, each);
}

/** Conductors and bodies, and what is written on them. @param {Drawing} drawing @param {Scene} scene */
export function drawBodies({ context, frame, density }, { palette, bodies, words }) {
  Object.assign(context, { fillStyle: palette.body, strokeStyle: palette.ink, lineWidth: 2 * density, lineJoin: "round" });
  for (const { outline, filled } of bodies) {
    const path = pathOf([outline], frame, true);
    if (filled) context.fill(path);
    context.stroke(path);
  }
  Object.assign(context, { fillStyle: palette.ink, font: `600 ${13 * density}px Inter, sans-serif`, textAlign: "center", textBaseline: "middle" });
  for (const { text, at } of words) context.fillText(text, ...toPixels(frame, at));
}

/** @param {Drawing} drawing @param {Scene} scene */
export function drawMarks({ context, frame, density }, { rests, palette, vortices = [] }) {
  for (const each of vortices) drawVortex(context, toPixels(frame, each.at), density, palette, each);
  Object.assign(context, { fillStyle: "#ffc62e", strokeStyle: "#5f4300", lineWidth: 1.2 * density });
  for (const point of rests) {
    context.beginPath();
    context.arc(...toPixels(frame, point), 4 * density, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  }
}

/**
 * A disk with an arrow most of the way around.
 * @param {Drawing["context"]} context @param {Point} at in pixels @param {number} density @param {Palette} palette
 * @param {{ turns: 1 | -1, chosen: boolean }} vortex
 */
function drawVortex(context, [x, y], density, palette, { turns, chosen }) {
  const [radius, arrow, head] = [10 * density, 5.5 * density, 4 * density];
  Object.assign(context, { fillStyle: palette.paper, strokeStyle: chosen ? palette.accent : palette.ink, lineWidth: (chosen ? 2.4 : 1.4) * density, lineCap: "round", lineJoin: "round" });
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  // Angles grow clockwise on the screen.
  const end = 0.9 * turns;
  const [tipX, tipY] = [x + arrow * Math.cos(end), y + arrow * Math.sin(end)];
  const back = end + (turns * Math.PI) / 2;
  context.beginPath();
  context.arc(x, y, arrow, 0, end, turns > 0);
  for (const side of [-0.7, 0.7]) {
    context.moveTo(tipX, tipY);
    context.lineTo(tipX + head * Math.cos(back + side), tipY + head * Math.sin(back + side));
  }
  context.stroke();
}

/** @param {Drawing} drawing @param {Frame} grid @param {Palette} palette @param {Strokes} strokes */
function stroke({ context, frame, density }, grid, { ink }, { lines, pieces = [], width, opacity, colour = ink }) {
  const path = pathOf(lines, frame, false);
  const scale = frame.pixels[0] / grid.pixels[0];
  for (let k = 0; k < pieces.length; k += 4) {
    path.moveTo(pieces[k] * scale, pieces[k + 1] * scale);
    path.lineTo(pieces[k + 2] * scale, pieces[k + 3] * scale);
  }
  Object.assign(context, { strokeStyle: colour, lineWidth: width * density, globalAlpha: opacity, lineCap: "round", lineJoin: "round" });
  context.stroke(path);
  context.globalAlpha = 1;
}

/** @param {Point[][]} lines @param {Frame} frame @param {boolean} closed */
function pathOf(lines, frame, closed) {
  const path = new Path2D();
  for (const line of lines) {
    line.forEach((point, k) => (k ? path.lineTo(...toPixels(frame, point)) : path.moveTo(...toPixels(frame, point))));
    if (closed) path.closePath();
  }
  return path;
}
