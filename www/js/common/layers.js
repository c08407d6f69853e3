// Lines over a picture as plain data: drawn on a canvas, on the page or off it, or written as an SVG file.

import { scaleOf, toPixels } from "./frame.js";

/** @typedef {import("./frame.js").Frame} Frame */
/** @typedef {import("./frame.js").Point} Point */
/** What a line is, which says how it looks. @typedef {"mesh" | "lines" | "outline" | "rim" | "circles" | "vector" | "fence"} Ink */
/** Lines in the plane, each x, y, x, y, …; or the edges between points, two a line. @typedef {{ ink: Ink, closed?: boolean } & ({ lines: ArrayLike<number>[] } | { points: Float64Array, edges: Uint32Array })} LineLayer */
/** @typedef {LineLayer} Layer */
/** A canvas to draw on, its frame, and device pixels a CSS pixel. @typedef {{ context: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D, frame: Frame, density: number }} Drawing */

/** Strokes of each ink, one over the other: colour and width in CSS pixels. @type {Record<Ink, [colour: string, width: number][]>} */
const STROKES = {
  mesh: [["rgb(255 255 255 / 0.62)", 0.6]],
  lines: [["rgb(0 0 0 / 0.35)", 2.6], ["rgb(255 255 255 / 0.9)", 1.2]],
  outline: [["rgb(0 0 0 / 0.45)", 4], ["#ffffff", 2]],
  rim: [["rgb(0 0 0 / 0.45)", 2.6], ["#ffffff", 1.25]],
  circles: [["#ffc62e", 1.4]],
  vector: [["rgb(0 0 0 / 0.5)", 4.5], ["#ffc62e", 2.25]],
  fence: [["rgb(0 0 0 / 0.6)", 0.8]],
};
/** What is filled between lines. @type {Partial<Record<Ink, string>>} */
const FILLS = { fence: "rgb(255 198 46 / 0.8)" };
/** The same on paper, where no photo lies under them. @type {Record<Ink, [colour: string, width: number]>} */
const ON_PAPER = { mesh: ["#8a8f9c", 0.4], lines: ["#2b4bc8", 0.9], outline: ["#1c1e23", 1.6], rim: ["#1c1e23", 1.6], circles: ["#b07700", 0.9], vector: ["#c02626", 1.4], fence: ["#b07700", 0.6] };

/** Every line of a layer as pixels. @param {Layer} layer @param {Frame} frame @returns {Generator<Point[]>} */
function* pixelLines(layer, frame) {
  if ("edges" in layer) {
    const { points, edges } = layer;
    for (let k = 0; k + 1 < edges.length; k += 2) yield [edges[k], edges[k + 1]].map((n) => toPixels(frame, [points[2 * n], points[2 * n + 1]]));
  } else {
    for (const line of layer.lines) yield Array.from({ length: line.length >> 1 }, (_, k) => toPixels(frame, [line[2 * k], line[2 * k + 1]]));
  }
}

/** @param {Drawing} drawing @param {Layer[]} layers @param {boolean} [quick] without what lies under lines to set them off: while a hand moves */
export function drawLayers({ context, frame, density }, layers, quick = false) {
  context.lineCap = "round";
  context.lineJoin = "round";
  for (const layer of layers) {
    const path = tracedPath(layer, frame);
    const fill = FILLS[layer.ink];
    if (fill) {
      context.fillStyle = fill;
      context.fill(path, "evenodd");
    }
    for (const [colour, width] of quick ? STROKES[layer.ink].slice(-1) : STROKES[layer.ink]) {
      context.strokeStyle = colour;
      context.lineWidth = width * density;
      context.stroke(path);
    }
  }
}

/** A layer as a path in pixels; without a point made for each, since meshes have many. @param {Layer} layer @param {Frame} frame */
function tracedPath(layer, frame) {
  const path = new Path2D();
  const [left, top] = toPixels(frame, [0, 0]);
  const scale = scaleOf(frame);
  if ("edges" in layer) {
    const { points, edges } = layer;
    for (let k = 0; k + 1 < edges.length; k += 2) {
      const [a, b] = [2 * edges[k], 2 * edges[k + 1]];
      path.moveTo(left + scale * points[a], top - scale * points[a + 1]);
      path.lineTo(left + scale * points[b], top - scale * points[b + 1]);
    }
    return path;
  }
  for (const line of layer.lines) {
    for (let k = 0; k + 1 < line.length; k += 2) {
      const [x, y] = [left + scale * line[k], top - scale * line[k + 1]];
      if (k) path.lineTo(x, y);
      else path.moveTo(x, y);
    }
    if (layer.closed) path.closePath();
  }
  return path;
}

/** Between two drawings of a file, in its units. */
const GAP = 40;

/** An SVG file of drawings side by side. @param {{ name: string, frame: Frame, layers: Layer[] }[]} drawings @param {string} title @returns {string} */
export function svgFile(drawings, title) {
  const width = drawings.reduce((sum, { frame }) => sum + frame.pixels[0] + GAP, GAP);
  const height = Math.max(...drawings.map(({ frame }) => frame.pixels[1])) + 2 * GAP;
  let left = GAP;
  const groups = drawings.map(({ name, frame, layers }, n) => {
    const [columns, rows] = frame.pixels;
    const top = (height - rows) / 2;
    const inside = layers.map((layer) => `<path id="${layer.ink}-${n + 1}" ${strokeOf(layer.ink)} d="${pathOf(layer, frame)}"/>`).join("\n");
    const group = `<svg id="${name}" x="${left}" y="${top}" width="${columns}" height="${rows}" viewBox="0 0 ${columns} ${rows}" overflow="hidden">\n${inside}\n</svg>`;
    left += columns + GAP;
    return group;
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" fill="none" stroke-linejoin="round" stroke-linecap="round">\n<title>${title}</title>\n${groups.join("\n")}\n</svg>\n`;
}

/** @param {Ink} ink */
const strokeOf = (ink) => `stroke="${ON_PAPER[ink][0]}" stroke-width="${ON_PAPER[ink][1]}"`;

/** @param {number} x */
const short = (x) => String(Math.round(100 * x) / 100);

/** @param {Layer} layer @param {Frame} frame */
function pathOf(layer, frame) {
  let data = "";
  for (const line of pixelLines(layer, frame)) {
    if (line.length) data += `M${line.map(([x, y]) => `${short(x)} ${short(y)}`).join("L")}${layer.closed ? "Z" : ""}`;
  }
  return data;
}

/** An arrow's head, as a share of the width of what it is drawn in. */
const HEAD = 0.02;

/** An arrow, in the plane. @param {Point} from @param {Point} to @param {Frame} frame in which it is drawn @returns {Float64Array[]} */
export function arrowLines([x0, y0], [x1, y1], { width }) {
  const head = HEAD * width;
  const length = Math.hypot(x1 - x0, y1 - y0) || 1;
  const [u, v] = [(head * (x1 - x0)) / length, (head * (y1 - y0)) / length];
  return [Float64Array.of(x0, y0, x1, y1), Float64Array.of(x1 - u - v / 2, y1 - v + u / 2, x1, y1, x1 - u + v / 2, y1 - v - u / 2)];
}

/** No mesh has more nodes. */
const NODES = 2 ** 26;

/** Every edge of triangles once. @param {Uint32Array} triangles @returns {Uint32Array} pairs of nodes */
export function meshEdges(triangles) {
  const keys = new Float64Array(triangles.length);
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const a = triangles[t + k];
      const b = triangles[t + ((k + 1) % 3)];
      keys[t + k] = a < b ? a * NODES + b : b * NODES + a;
    }
  }
  keys.sort();
  const edges = new Uint32Array(2 * keys.length);
  let count = 0;
  keys.forEach((key, k) => {
    if (key === keys[k - 1]) return;
    edges[count++] = Math.floor(key / NODES);
    edges[count++] = key % NODES;
  });
  return edges.slice(0, count);
}
