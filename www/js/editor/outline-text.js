// Outlines that come as text: GeoJSON, WKT, columns of numbers, airfoils, SVG. All that a text has are read; the largest is taken.

import { area, distance, simplifyClosed, sizeOf } from "./geometry.js";
import { placed, polygonOf } from "./outline.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** Reads one curve: SVG, the data of an SVG path, JSON; `tolerance` in its units. @typedef {(text: string, tolerance: number) => Point[]} CurveReader */
/** `kind`: what the text is, and how it was read, in words. @typedef {{ outlines: Point[][], kind: string, holes?: number }} Found */
/** @typedef {{ outline: Point[], said: string }} Chosen */

/** More corners than these are not taken: they would not be seen as handles. */
const MOST_CORNERS = 400;
/** A corner may be left out that lies off the line by this share of the size; more where there are too many. */
const FINEST = 2e-4;
/** Curves become edges this close, as a share of their size. */
const CURVE = 5e-4;
/** A file with more shapes than these is a picture. */
const MOST_SHAPES = 400;

/** The largest outline of a text, and what was done. @param {string} text @param {CurveReader} readCurve @returns {Chosen} */
export function chooseOutline(text, readCurve) {
  const { outlines, kind, holes } = readOutlines(text.trim(), readCurve);
  const sound = outlines.map(cleaned).filter(spreads);
  if (!sound.length) throw new Error("It has no closed outline: at least three points that are not on one line are needed.");
  const largest = sound.reduce((best, outline) => (Math.abs(area(outline)) > Math.abs(area(best)) ? outline : best));
  const outline = thinned(largest);
  const among = sound.length > 1 ? `, the largest of its ${sound.length} outlines` : "";
  const left = outline.length < largest.length ? ` ${outline.length} of its ${largest.length} corners are kept; the others lie on the lines between them, or nearly so.` : "";
  return { outline, said: `Read ${kind}${among}.${holeWords(holes)}${left}` };
}

/** @param {number} [holes] */
const holeWords = (holes) => (holes ? ` ${holes === 1 ? "A hole is" : `${holes} holes are`} left out: only SVG drawings bring theirs.` : "");

const [DRAWING, PATH] = ["an SVG drawing", "the data of an SVG path"];

/** What a text is that may draw curves, in words; null for any other. @param {string} text without space around it */
export function curvesIn(text) {
  if (text.startsWith("<")) return DRAWING;
  return /^[Mm]\s*[-+.\d]/.test(text) ? PATH : null;
}

/** @param {string} text @param {CurveReader} readCurve @returns {Found} */
function readOutlines(text, readCurve) {
  if (text === "") throw new Error("There is no text.");
  const kind = curvesIn(text);
  if (kind === DRAWING) return { outlines: svgOutlines(text, readCurve), kind };
  if (/^[{[]/.test(text)) return jsonOutlines(text, readCurve);
  if (/^(SRID=\d+;\s*)?(MULTI)?(POLYGON|LINESTRING|GEOMETRYCOLLECTION|CURVEPOLYGON)/i.test(text)) return wktOutlines(text);
  if (kind === PATH) return { outlines: pathParts(text).flatMap((part) => curve(part, readCurve)), kind };
  return columns(text);
}

/** Whether a text that somebody pastes looks like an outline. @param {string} text */
export const looksLikeOutline = (text) =>
  /^\s*(\{[^]*"(coordinates|features)"|\[\s*\[\s*[-+.\d]|(SRID=\d+;\s*)?(MULTI)?POLYGON|[Mm]\s*[-+.\d]+[\s,]+[-+.\d]|<svg|<\?xml[^]*<svg)/i.test(text) ||
  text.trim().split("\n").filter((line) => pairOf(line)).length > 4;

// SVG

/** One curve, read twice: to know its size, and as finely as that asks for. @param {string} text @param {CurveReader} readCurve @returns {Point[][]} */
function curve(text, readCurve) {
  const rough = readCurve(text, 1);
  return [readCurve(text, Math.max(1e-12, CURVE * sizeOf(rough)))];
}

const SHAPE = /<(path|polygon|polyline|rect|circle|ellipse)\b(?:[^>"']|"[^"]*"|'[^']*')*?(?:\/>|>[^]*?<\/\1\s*>)/g;

/** Every curve that a file draws, in its own place: the file is read with all the other shapes taken out. @param {string} text @param {CurveReader} readCurve */
function svgOutlines(text, readCurve) {
  try {
    return curve(text, readCurve);
  } catch (error) {
    const shapes = [...text.matchAll(SHAPE)];
    if (shapes.length > MOST_SHAPES) throw new Error(`It draws ${shapes.length} shapes: it is a picture. Keep the one that is the outline.`);
    const [before, after] = [text.slice(0, shapes[0]?.index ?? 0), shapes];
    /** @type {Point[][]} */
    const found = [];
    shapes.forEach((shape, k) => {
      const rest = [before];
      after.forEach((other, n) => {
        if (n === k) rest.push("\u0000");
        rest.push(text.slice(other.index + other[0].length, after[n + 1]?.index));
      });
      const around = rest.join("");
      const data = shape[0].match(/\sd\s*=\s*("([^"]*)"|'([^']*)')/);
      const parts = shape[1] === "path" && data ? pathParts(data[2] ?? data[3] ?? "") : [null];
      for (const part of parts) {
        const alone = part === null || !data ? shape[0] : shape[0].replace(data[0], ` d="${part}"`);
        try {
          found.push(...curve(around.replace("\u0000", () => alone), readCurve));
        } catch {
          // It is no outline; others may be.
        }
      }
    });
    if (!found.length) throw error;
    return found;
  }
}

/** Numbers that a command of a path takes. @type {Record<string, number>} */
const TAKES = { M: 2, L: 2, H: 1, V: 1, C: 6, S: 4, Q: 4, T: 2, A: 7, Z: 0 };

/** The subpaths of a path's data, each beginning where it begins. @param {string} data @returns {string[]} */
export function pathParts(data) {
  /** @type {string[]} */
  const parts = [];
  let [x, y, startX, startY] = [0, 0, 0, 0];
  for (const [, letter, text] of data.matchAll(/([MLHVCSQTAZ])([^MLHVCSQTAZ]*)/gi)) {
    const name = letter.toUpperCase();
    const relative = letter !== name;
    const values = (text.match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/gi) ?? []).map(Number);
    const takes = TAKES[name];
    const flags = name === "A";
    if (name === "Z") {
      [x, y] = [startX, startY];
      if (parts.length) parts[parts.length - 1] += "Z";
      continue;
    }
    // Flags of arcs may be written without spaces: such a path is not taken apart.
    if (values.length % takes || !values.length) return [data];
    for (let k = 0; k < values.length; k += takes) {
      const [u, v] = [values[k + takes - 2], values[k + takes - 1]];
      if (name === "H") x = v + (relative ? x : 0);
      else if (name === "V") y = v + (relative ? y : 0);
      else [x, y] = [u + (relative ? x : 0), v + (relative ? y : 0)];
      if (name === "M" && k === 0) {
        [startX, startY] = [x, y];
        parts.push(`M${x} ${y}`);
      }
    }
    if (name !== "M") parts[parts.length - 1] += letter + text;
    else if (values.length > 2) parts[parts.length - 1] += (relative ? "l" : "L") + values.slice(2).join(" ");
    if (flags && !text.includes(" ") && !text.includes(",")) return [data];
  }
  return parts.length ? parts : [data];
}

// JSON

/** @param {string} text @param {CurveReader} readCurve @returns {Found} */
function jsonOutlines(text, readCurve) {
  /** @type {any} */
  let found;
  try {
    found = JSON.parse(text);
  } catch (error) {
    throw new Error(`It begins like JSON, and cannot be read: ${error instanceof Error ? error.message : error}.`);
  }
  if (Array.isArray(found)) return { outlines: [isPoint(found[0]) ? found.map(pointOf) : readCurve(text, 1)], kind: "points in JSON" };
  if (found.type === "Topology") throw new Error("It is TopoJSON: turn it into GeoJSON first.");
  const rings = geoRings(found);
  if (!rings.length) throw new Error("It is JSON without a polygon: GeoJSON, or a list of points [[x, y], …], can be read.");
  const degrees = rings.every((ring) => ring.every(([x, y]) => Math.abs(x) <= 360 && Math.abs(y) <= 90));
  const holes = holesOf(found);
  return degrees ? { outlines: rings.map((ring) => ring.map(mercator)), kind: "GeoJSON as on Mercator’s map, which keeps angles", holes } : { outlines: rings, kind: "GeoJSON", holes };
}

/** The outer rings of all that a GeoJSON object holds. @param {any} object @returns {Point[][]} */
function geoRings(object) {
  switch (object?.type) {
    case "FeatureCollection":
      return (object.features ?? []).flatMap(geoRings);
    case "Feature":
      return geoRings(object.geometry);
    case "GeometryCollection":
      return (object.geometries ?? []).flatMap(geoRings);
    case "Polygon":
      return [ringOf(object.coordinates?.[0])];
    case "MultiPolygon":
      return (object.coordinates ?? []).map((/** @type {any} */ polygon) => ringOf(polygon?.[0]));
    case "LineString":
      return [ringOf(object.coordinates)];
    case "MultiLineString":
      return (object.coordinates ?? []).map(ringOf);
    default:
      return [];
  }
}

/** Inner rings of all that a GeoJSON object holds. @param {any} object @returns {number} */
function holesOf(object) {
  const parts = object?.features ?? object?.geometries ?? (object?.geometry ? [object.geometry] : []);
  const polygons = object?.type === "Polygon" ? [object.coordinates] : object?.type === "MultiPolygon" ? object.coordinates : [];
  return parts.reduce((/** @type {number} */ sum, /** @type {any} */ part) => sum + holesOf(part), 0) + polygons.reduce((/** @type {number} */ sum, /** @type {any[]} */ rings) => sum + rings.length - 1, 0);
}

/** @param {any} ring @returns {Point[]} */
function ringOf(ring) {
  if (!Array.isArray(ring) || !ring.every(isPoint)) throw new Error("It has a ring that is no list of points.");
  return ring.map(pointOf);
}

/** @param {any} value */
const isPoint = (value) => Array.isArray(value) && value.length >= 2 && value.slice(0, 2).every(Number.isFinite);

/** @param {number[]} value @returns {Point} */
const pointOf = ([x, y]) => [x, y];

/** Degrees nearer to a pole than this are off the map. */
const POLE = 89.5;

/** Longitude and latitude → Mercator's map, in degrees of the equator. @param {Point} degrees @returns {Point} */
function mercator([longitude, latitude]) {
  const phi = (Math.max(-POLE, Math.min(POLE, latitude)) * Math.PI) / 180;
  return [longitude, (Math.asinh(Math.tan(phi)) * 180) / Math.PI];
}

// WKT

/** The outer rings: those that open a polygon. @param {string} text @returns {Found} */
function wktOutlines(text) {
  const rings = [...text.matchAll(/([A-Z(,]\s*)\(([^()]*)\)/gi)];
  const outer = rings.filter(([, before]) => !before.startsWith(","));
  const outlines = outer.map(([, , inside]) =>
    inside.split(",").map((pair) => {
      const [x, y] = pair.trim().split(/\s+/).map(Number);
      if (!Number.isFinite(x) || !Number.isFinite(y)) throw new Error(`It has something else than a point: “${pair.trim().slice(0, 40)}”.`);
      return /** @type {Point} */ ([x, y]);
    }),
  );
  return { outlines, kind: "WKT", holes: rings.length - outer.length };
}

// Columns

/** Two numbers of a line; null if it has something else. @param {string} line @returns {Point | null} */
function pairOf(line) {
  const parts = line.trim().split(/\s*[,;\t]\s*|\s+/);
  if (parts.length < 2 || parts[0] === "" || parts[1] === "") return null;
  const [x, y] = parts.map(Number);
  return Number.isFinite(x) && Number.isFinite(y) ? [x, y] : null;
}

/** Two columns; a heading, empty lines and comments are passed over. @param {string} text @returns {Found} */
function columns(text) {
  const lines = text.split(/\r?\n/).map((line) => line.replace(/[#%].*$/, ""));
  const pairs = lines.flatMap((line, k) => {
    const pair = pairOf(line);
    if (!pair && line.trim() && k > 1) throw new Error(`Line ${k + 1} has no two numbers: “${line.trim().slice(0, 40)}”.`);
    return pair ? [pair] : [];
  });
  if (!pairs.length) throw new Error("It is nothing that can be read here: SVG, GeoJSON, WKT, or two columns of numbers.");
  const [[upper, lower], ...rest] = pairs;
  // Lednicer's way with airfoils: how many points each side has, then both from nose to tail.
  if (Number.isInteger(upper) && Number.isInteger(lower) && upper > 2 && lower > 2 && upper + lower === rest.length) {
    return { outlines: [[...rest.slice(0, upper).reverse(), ...rest.slice(upper)]], kind: "an airfoil, upper side and lower side" };
  }
  return { outlines: [pairs], kind: "two columns of numbers" };
}

// What is taken

/** Without points that repeat the one before, the last one the first too. @param {Point[]} points */
function cleaned(points) {
  const kept = points.filter(([x, y], k) => {
    const [u, v] = points[(k + points.length - 1) % points.length];
    return x !== u || y !== v || points.length === 1;
  });
  return kept;
}

/** Whether it has three points that are not on one line. @param {Point[]} outline */
function spreads([a, ...others]) {
  const b = others.reduce((best, p) => (a && distance(a, p) > distance(a, best) ? p : best), others[0]);
  return others.length > 1 && others.some(([x, y]) => (b[0] - a[0]) * (y - a[1]) !== (b[1] - a[1]) * (x - a[0]));
}

/** @param {Point[]} outline */
function thinned(outline) {
  const size = sizeOf(outline);
  let kept = outline;
  for (let slack = FINEST * size; kept === outline ? outline.length > 48 : kept.length > MOST_CORNERS; slack *= 1.5) {
    kept = simplifyClosed(outline, slack);
  }
  return kept;
}

/** Of the photo, how much an outline fills. */
const FILL = 0.84;

/** An outline, and what is in it, in the middle of a photo, as large as fits. @param {import("./outline.js").Outline[]} outlines the outer one first @param {import("../common/frame.js").Frame} photo */
export function placedOn(outlines, { center, width, pixels }) {
  const polygon = polygonOf(outlines[0]);
  const [xs, ys] = [polygon.map(([x]) => x), polygon.map(([, y]) => y)];
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const scale = FILL * Math.min(width / (right - left || 1), (width * pixels[1]) / pixels[0] / (high - low || 1));
  return outlines.map((outline) => placed(outline, scale, [center[0] - (scale * (left + right)) / 2, center[1] - (scale * (low + high)) / 2]));
}
