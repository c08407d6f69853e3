// The state of the page, and its address.

import { between, flag, numbers, oneOf, outline, photo, point, readAddress } from "../common/address.js";
import { knowsPicture } from "../common/images.js";
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
  fields.set("fixation", write(fixation, 4));
  fields.set("lines", lines ? "1" : "0");
  if (circles) fields.set("circles", "1");
  if (state.models.includes("wedge")) fields.set("shear", String(shear));
  if (dots) fields.set("dots", String(dots));
  if (own && own.boundary.length <= LONGEST) fields.set("own", write(own.boundary.flat(), 2));
  for (const [name, { center, direction }] of Object.entries(landmarks)) {
    if (state.models.includes(name)) fields.set(`at-${name}`, write([...center, direction], 3));
  }
  return fields.toString().replaceAll("%2C", ",");
}

const schema = {
  image: photo(knowsPicture),
  model: oneOf(models.keys()),
  beside: oneOf(models.keys()),
  shear: between(0.5, 1.3),
  angle: between(5, 150),
  fixation: point,
  lines: flag,
  circles: flag,
  dots: (/** @type {string} */ text) => Number(oneOf(["0", ...DOTS.map(String)])(text)),
  own: outline,
};

/** The state of an address; what it leaves out is as in `usual`. @param {string} hash @param {State} usual @returns {{ state: State, wrong: string[] }} */
export function decode(hash, usual) {
  const { values, others, wrong } = readAddress(hash, schema, (name) => (name.startsWith("at-") && models.has(name.slice(3)) ? numbers(3) : undefined));
  const { image = usual.image, model = usual.models[0], beside = usual.models[1], shear = usual.shear, angle = usual.fieldOfView } = values;
  const { lines = usual.lines, circles = usual.circles, dots = usual.dots, own } = values;
  const fixation = values.fixation ?? (image === usual.image ? usual.fixation : image === USUAL.image ? USUAL.fixation : [0, 0]);
  /** @type {[string, Landmark][]} */
  const landmarks = [...others].map(([name, [x, y, direction]]) => [name.slice(3), { center: [x, y], direction }]);
  const state = {
    image,
    models: /** @type {[string, string]} */ ([model, beside]),
    shear,
    fieldOfView: angle,
    fixation,
    lines,
    circles,
    dots,
    own: own ? ownOutline(own) : usual.own,
    landmarks: { ...usual.landmarks, ...Object.fromEntries(landmarks) },
  };
  return { state, wrong };
}

/** @param {number[]} values @param {number} digits */
const write = (values, digits) => values.map((value) => String(Number(value.toFixed(digits)))).join(",");
