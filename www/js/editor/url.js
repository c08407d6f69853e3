// A drawing in the address, after the #: a link is a drawing.

import { between, outline, oneOf, photo, point, someOf } from "../common/address.js";
import { knowsPicture } from "../common/images.js";
import { planePath, readPath, readPaths } from "./path.js";
import { holedShapes, shapes } from "./presets.js";
import { towardPoint } from "./region.js";
import { NOTHING_SHOWN, ONTO } from "./store.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./region.js").Region} Region */
/** @typedef {import("./store.js").Shown} Shown */
/** @typedef {{ image?: string, shape?: string, region?: Point[], path?: import("./outline.js").Outline, holes?: import("./outline.js").Outline[], center?: Point, toward?: Point }} Fields what an address says of one drawing */

/** The fields of one drawing. */
export const drawingSchema = {
  image: photo(knowsPicture),
  shape: oneOf([...shapes.keys(), ...holedShapes.keys()]),
  region: outline,
  path: readPath,
  holes: readPaths,
  center: point,
  toward: point,
};

/** And what becomes of holes. */
export const ontoSchema = { onto: oneOf(ONTO) };

/** Names of what can be shown over a drawing. */
const LAYERS = /** @type {const} */ (["mesh", "grid", "field", "heat", "measure"]);

/** What is shown over a drawing. */
export const shownSchema = { show: someOf(LAYERS), density: between(6, 48), morph: between(0, 1) };

/** What an address says of that; what it leaves out is as given. @param {{ show?: (typeof LAYERS)[number][], density?: number, morph?: number, onto?: import("./store.js").Onto }} fields @param {Shown} usual @returns {Shown} */
export function shownOf({ show, density, morph, onto }, usual) {
  const told = show && Object.fromEntries(LAYERS.map((name) => [name, show.includes(name)]));
  return { ...usual, ...told, ...(density && { density: Math.round(density) }), ...(morph !== undefined && { morph }), ...(onto && { onto }) };
}

/** @param {Shown} shown @returns {string} the fields, with & before them */
export function encodeShown(shown) {
  const names = LAYERS.filter((name) => shown[name]);
  return `${names.length ? `&show=${names.join(",")}` : ""}${shown.density === NOTHING_SHOWN.density ? "" : `&density=${shown.density}`}${shown.morph === 1 ? "" : `&morph=${short(shown.morph)}`}${shown.onto ? `&onto=${shown.onto}` : ""}`;
}

/** A ten-thousandth of half the photo is finer than a screen's pixel. @param {number} x */
const short = (x) => String(Number(x.toFixed(4)));

/** Where curves join smoothly, they are to do so after they were written. @param {number} x */
const fine = (x) => String(Number(x.toFixed(6)));

/** @param {Point[]} points */
const write = (points) => points.map((p) => p.map(short).join(",")).join(";");

/** @param {import("./store.js").Document} doc @param {string} [prefix] of the fields' names @returns {string} the hash, without # */
export function encodeDrawing(doc, prefix = "") {
  return Object.entries(fieldsOf(doc)).map(([key, value]) => `${prefix}${key}=${value}`).join("&");
}

/** The fields of a drawing that is not the first one any more. @param {import("./store.js").Document} doc @param {import("./store.js").Document} first @returns {Record<string, string>} */
export function drawingFields(doc, first) {
  return encodeDrawing(doc) === encodeDrawing(first) ? {} : fieldsOf(doc);
}

/** @param {import("./store.js").Document} doc @returns {Record<string, string>} */
function fieldsOf({ image, region }) {
  /** @param {import("./outline.js").Outline} drawn */
  const written = (drawn) => planePath(drawn, fine).replaceAll(" ", ",");
  /** @type {Record<string, string>} */
  const outline = region.curves ? { path: written(region) } : { region: write(region.boundary) };
  return { image, ...outline, ...(region.holes && { holes: region.holes.map(written).join("") }), center: write([region.center]), toward: write([towardPoint(region)]) };
}
