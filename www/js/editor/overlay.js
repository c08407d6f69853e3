// Lines over a picture: triangulation and grids, on a canvas in device pixels.

import { scaleOf, toPixels } from "../common/frame.js";

/** @typedef {import("../common/frame.js").Point} Point */

const WHITE = "rgb(255 255 255 / 0.62)";
const SHADE = "rgb(0 0 0 / 0.35)";

/** Every edge of the triangles once. @param {Uint32Array} triangles @returns {Uint32Array} pairs of nodes */
export function meshEdges(triangles) {
  /** @type {Set<number>} */
  const seen = new Set();
  const edges = [];
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const [a, b] = [triangles[t + k], triangles[t + ((k + 1) % 3)]];
      const key = Math.min(a, b) * 0x4000000 + Math.max(a, b);
      if (seen.has(key)) continue;
      seen.add(key);
      edges.push(a, b);
    }
  }
  return Uint32Array.from(edges);
}

/** @typedef {import("../common/canvas.js").Drawing} Drawing */

/** @param {Drawing} drawing @param {Float64Array} points @param {Uint32Array} edges */
export function drawMesh({ context, frame, density }, points, edges) {
  const path = new Path2D();
  for (let k = 0; k < edges.length; k += 2) {
    path.moveTo(...toPixels(frame, [points[2 * edges[k]], points[2 * edges[k] + 1]]));
    path.lineTo(...toPixels(frame, [points[2 * edges[k + 1]], points[2 * edges[k + 1] + 1]]));
  }
  context.strokeStyle = WHITE;
  context.lineWidth = 0.6 * density;
  context.stroke(path);
}

/** Light lines with a dark edge, seen on any photo. @param {Drawing} drawing @param {Path2D} path */
function strokeTwice({ context, density }, path) {
  context.lineCap = "round";
  context.lineJoin = "round";
  for (const [style, width] of /** @type {[string, number][]} */ ([[SHADE, 2.6], ["rgb(255 255 255 / 0.9)", 1.2]])) {
    context.strokeStyle = style;
    context.lineWidth = width * density;
    context.stroke(path);
  }
}

/** @param {Drawing} drawing @param {Point[][]} lines in the plane */
export function drawLines(drawing, lines) {
  const path = new Path2D();
  for (const line of lines) {
    line.forEach((point, k) => {
      const [x, y] = toPixels(drawing.frame, point);
      if (k) path.lineTo(x, y);
      else path.moveTo(x, y);
    });
  }
  strokeTwice(drawing, path);
}

/** Circles about 0 and rays from it to the rim. @param {Drawing} drawing @param {number[]} rings @param {number[]} rays in turns */
export function drawPolarGrid(drawing, rings, rays) {
  const { frame } = drawing;
  const [x, y] = toPixels(frame, [0, 0]);
  const path = new Path2D();
  for (const ring of rings) {
    path.moveTo(x + ring * scaleOf(frame), y);
    path.arc(x, y, ring * scaleOf(frame), 0, 2 * Math.PI);
  }
  for (const ray of rays) {
    path.moveTo(x, y);
    path.lineTo(...toPixels(frame, [Math.cos(2 * Math.PI * ray), Math.sin(2 * Math.PI * ray)]));
  }
  strokeTwice(drawing, path);
}
