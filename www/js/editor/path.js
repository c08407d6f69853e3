// Outlines in the language of SVG's paths: in the plane, y upwards, as the package takes them; and in pixels, to be drawn.

import { flatten, toPixels } from "../common/frame.js";
import { arcOfPath, radiusOf } from "./curve.js";
import { edgeOf, outlineOf, polygonOf } from "./outline.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./curve.js").Curve} Curve */
/** @typedef {import("./outline.js").Outline} Outline */
/** Where points are written, how long a unit is there, whether y goes down, and numbers as text. @typedef {{ at: (point: Point) => Point, scale: number, down: boolean, text: (x: number) => string }} Hand */

/** @param {(x: number) => string} text @returns {Hand} */
const planeHand = (text) => ({ at: (point) => point, scale: 1, down: false, text });

/** @param {Frame} frame @returns {Hand} */
const pixelHand = (frame) => ({ at: (point) => toPixels(frame, point), scale: frame.pixels[0] / frame.width, down: true, text: (x) => x.toFixed(2) });

/** What goes on from an edge's start. @param {[a: Point, b: Point, curve: Curve]} edge @param {Hand} hand */
function edgeData([a, b, curve], { at, scale, down, text }) {
  /** @param {Point[]} points */
  const list = (...points) => points.map((point) => at(point).map(text).join(",")).join(" ");
  if (!curve) return `L${list(b)}`;
  if (curve.kind === "curve") return `C${list(curve.first, curve.second, b)}`;
  const arc = curve.kind === "arc" ? { radii: [radiusOf(a, b, curve), radiusOf(a, b, curve)], turn: 0, large: Math.abs(curve.bulge) > 1, left: curve.bulge > 0 } : curve;
  const [rx, ry] = arc.radii.map((radius) => text(radius * scale));
  return `A${rx},${ry} ${text(down ? -arc.turn : arc.turn)} ${Number(arc.large)} ${Number(arc.left !== down)} ${list(b)}`;
}

/** @param {Outline} outline @param {Hand} hand */
function write(outline, hand) {
  const last = outline.boundary.length - 1;
  // What closes it straight needs not be written.
  const edges = outline.boundary.map((_, k) => (k === last && !outline.curves?.[k] ? "" : edgeData(edgeOf(outline, k), hand)));
  return `M${hand.at(outline.boundary[0]).map(hand.text).join(",")}${edges.join("")}Z`;
}

/** An outline in the plane, to the last digit or as `text` writes numbers. @param {Outline} outline @param {(x: number) => string} [text] */
export const planePath = (outline, text = String) => write(outline, planeHand(text));

/** An outline to be drawn. @param {Outline} outline @param {Frame} frame */
export const pixelPath = (outline, frame) => write(outline, pixelHand(frame));

/** One of its edges to be drawn. @param {[a: Point, b: Point, curve: Curve]} edge @param {Frame} frame */
export function pixelEdge([a, b, curve], frame) {
  return `M${toPixels(frame, a).map((x) => x.toFixed(2)).join(",")}${edgeData([a, b, curve], pixelHand(frame))}`;
}

/** Numbers that a command takes. @type {Record<string, number>} */
const TAKES = { M: 2, L: 2, H: 1, V: 1, C: 6, Q: 4, A: 7, Z: 0 };

/** The outline of one closed path of absolute commands, as the package and this page write them; throws words that go on after its name. @param {string} text @returns {Outline} */
export function readPath(text) {
  /** @type {Point[]} */
  const boundary = [];
  /** @type {Curve[]} */
  const curves = [];
  const tokens = text.match(/[a-z]|[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?|[^\s,]/gi) ?? [];
  /** @type {Point} */
  let at = [0, 0];
  let command = "";
  for (let k = 0; k < tokens.length; ) {
    if (/^[a-z]$/i.test(tokens[k])) command = tokens[k++];
    if (!(command in TAKES)) throw new Error(`has “${(command || tokens[k]).slice(0, 10)}”, where only M, L, H, V, C, Q, A and Z can be read`);
    if (command === "M" && boundary.length) throw new Error("has more than one curve");
    const values = tokens.slice(k, k + TAKES[command]).map(Number);
    if (values.length < TAKES[command] || !values.every((x) => Math.abs(x) <= 1e12)) throw new Error(`has something else than ${TAKES[command]} numbers after “${command}”`);
    k += TAKES[command];
    if (command === "Z") {
      if (k < tokens.length) throw new Error("goes on after its end");
      break;
    }
    const end = endOf(command, values, at);
    if (command !== "M") curves.push(curveOf(command, values, at, end));
    boundary.push(end);
    at = end;
    // Numbers after those of M are of lines.
    if (command === "M") command = "L";
  }
  if (boundary.length < 2) throw new Error("needs at least two points");
  const [first] = boundary;
  // What ends where it began needs no line to close it.
  if (Math.hypot(at[0] - first[0], at[1] - first[1]) <= 1e-9 * (Math.abs(at[0]) + Math.abs(at[1]))) boundary.pop();
  else curves.push(null);
  if (boundary.length < 2 || !curves.some(Boolean) && boundary.length < 3) throw new Error("has no inside");
  return outlineOf(boundary, curves);
}

/** The outlines of several paths, one after another. @param {string} text @returns {Outline[]} */
export const readPaths = (text) => text.split(/(?=M)/).map(readPath);

/** @param {string} command @param {number[]} values @param {Point} at @returns {Point} */
function endOf(command, values, [x, y]) {
  if (command === "H") return [values[0], y];
  if (command === "V") return [x, values[0]];
  return [values[values.length - 2], values[values.length - 1]];
}

/** @param {string} command @param {number[]} v @param {Point} from @param {Point} to @returns {Curve} */
function curveOf(command, v, from, to) {
  switch (command) {
    case "C":
      return { kind: "curve", first: [v[0], v[1]], second: [v[2], v[3]] };
    case "Q": {
      /** Two thirds of the way to the control point. @param {Point} end @returns {Point} */
      const near = (end) => [end[0] + (2 / 3) * (v[0] - end[0]), end[1] + (2 / 3) * (v[1] - end[1])];
      return { kind: "curve", first: near(from), second: near(to) };
    }
    case "A":
      return arcOfPath(from, to, { kind: "ellipse", radii: [v[0], v[1]], turn: v[2], large: v[3] !== 0, left: v[4] !== 0 });
    default:
      return null;
  }
}

/** Closed paths as lines: what they look like. @param {string[]} paths */
export const linesOf = (paths) => paths.map((path) => flatten(polygonOf(readPath(path))));
