// The state of the page, and its address.

import { photos } from "../common/photos.js";
import { models, ownOutline } from "./models.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./models.js").Outline} Outline */
/** @typedef {import("./models.js").Landmark} Landmark */
/**
 * @typedef {object} State
 * @property {string} image
 * @property {[string, string]} models of the two panels
 * @property {number} shear of the wedge-dipole
 * @property {number} fieldOfView in degrees, across the picture
 * @property {Point} fixation in the picture's plane
 * @property {boolean} lines
 * @property {boolean} circles
 * @property {number} dots a millimetre, for the scene as it can be recovered; 0 for the scene itself
 * @property {Outline | null} own
 * @property {Record<string, Landmark>} landmarks that were moved, by outline
 */

/** @type {State} */
export const USUAL = {
  image: "astronaut",
  models: ["schira", "human"],
  shear: 0.95,
  fieldOfView: 40,
  fixation: [-0.13, 0.55],
  lines: true,
  circles: false,
  dots: 0,
  own: null,
  landmarks: {},
};

/** Resolutions of the cortex that the page offers, in dots a millimetre. */
export const DOTS = [1, 2, 4, 8];
/** Longer outlines are not kept in the address. */
const LONGEST = 200;

/** @param {State} state */
export function encode(state) {
  const { image, fieldOfView, fixation, lines, circles, shear, dots, own, landmarks } = state;
  const fields = new URLSearchParams({ image, model: state.models[0], beside: state.models[1], angle: String(fieldOfView) });
  fields.set("fixation", numbers(fixation, 4));
  fields.set("lines", lines ? "1" : "0");
  if (circles) fields.set("circles", "1");
  if (state.models.includes("wedge")) fields.set("shear", String(shear));
  if (dots) fields.set("dots", String(dots));
  if (own && own.boundary.length <= LONGEST) fields.set("own", numbers(own.boundary.flat(), 2));
  for (const [name, { center, direction }] of Object.entries(landmarks)) {
    if (state.models.includes(name)) fields.set(`at-${name}`, numbers([...center, direction], 3));
  }
  return fields.toString().replaceAll("%2C", ",");
}

/** @param {string} hash @returns {State} */
export function decode(hash) {
  const fields = new URLSearchParams(hash);
  /** @template T @param {string} name @param {T} usual @param {(text: string) => T | null} read @returns {T} */
  const field = (name, usual, read) => read(fields.get(name) ?? "") ?? usual;
  /** @param {number} low @param {number} high @returns {(text: string) => number | null} */
  const between = (low, high) => (text) => (text !== "" && Number(text) >= low && Number(text) <= high ? Number(text) : null);
  /** @param {object} table @returns {(text: string) => string | null} */
  const among = (table) => (text) => (text in table ? text : null);
  const image = field("image", USUAL.image, among(photos));
  const boundary = pairs(fields.get("own") ?? "");
  return {
    image,
    models: [field("model", USUAL.models[0], among(models)), field("beside", USUAL.models[1], among(models))],
    shear: field("shear", USUAL.shear, between(0.5, 1.3)),
    fieldOfView: field("angle", USUAL.fieldOfView, between(5, 150)),
    fixation: pairs(fields.get("fixation") ?? "")[0] ?? (image === USUAL.image ? USUAL.fixation : [0, 0]),
    lines: fields.get("lines") !== "0",
    circles: fields.get("circles") === "1",
    dots: field("dots", 0, (text) => DOTS.find((dots) => String(dots) === text) ?? null),
    own: boundary.length > 2 ? ownOutline(boundary) : null,
    landmarks: Object.fromEntries(
      Object.keys(models).flatMap((name) => {
        const [x, y, direction] = (fields.get(`at-${name}`) ?? "").split(",").map(Number);
        return Number.isFinite(direction) ? [[name, { center: /** @type {Point} */ ([x, y]), direction }]] : [];
      }),
    ),
  };
}

/** @param {number[]} values @param {number} digits */
const numbers = (values, digits) => values.map((value) => String(Number(value.toFixed(digits)))).join(",");

/** "x,y,x,y" → points; none if a number is missing. @param {string} text @returns {Point[]} */
function pairs(text) {
  const values = text === "" ? [] : text.split(",").map(Number);
  if (values.length % 2 || !values.every(Number.isFinite)) return [];
  return Array.from({ length: values.length / 2 }, (_, k) => [values[2 * k], values[2 * k + 1]]);
}
