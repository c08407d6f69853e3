// What the formula's page shows, and its address.

import { between, numbers, oneOf, photo, point, readAddress } from "../common/address.js";
import { knowsPicture } from "../common/images.js";
import { PRINCIPAL } from "./cut.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./pipeline.js").Lines} Lines */
/** @typedef {import("./pipeline.js").Colours} Colours */
/** @typedef {import("../../pkg/formula/index.js").Direction} Direction */
/** @typedef {import("../../pkg/formula/index.js").Wrap} Wrap */
/** @typedef {import("../../pkg/formula/index.js").Preset} Preset */
/** A part of a plane, whatever its pixels. @typedef {{ center: Point, width: number }} Placement */
/**
 * @typedef {object} State
 * @property {string} formula
 * @property {Record<string, Point>} params
 * @property {Direction} direction
 * @property {string} image
 * @property {Wrap} wrap
 * @property {Colours} colours the picture, or a scheme of colours for values of f
 * @property {Lines} lines
 * @property {number} density lines in the width of the picture
 * @property {number} morph how far on the way from z to f(z), 0 to 1
 * @property {import("./cut.js").Cut} cut of logarithms, roots and powers
 * @property {Placement} texture
 * @property {Placement} view
 * @property {Placement | null} around what is seen of the picture’s own plane, once somebody has moved it
 */

/** The picture that presets ask for by kind. @type {Record<Preset["picture"], string>} */
const IMAGES = { photo: "astronaut", lattice: "lattice" };
/** What can be shown, and what over it. */
const COLOURS = /** @type {const} */ (["picture", "hue", "shaded", "contours", "gold", "chess"]);
const LINES = /** @type {const} */ (["none", "cartesian", "polar", "real", "imaginary", "modulus", "phase", "stretch", "argument", "ellipses"]);
/** Longer formulas are nobody's handwriting. */
const LONGEST = 4000;

/** @param {Preset} preset @param {string} image the photo that is shown now @returns {State} */
export function fromPreset({ formula, params, direction, wrap, texture, view, picture }, image) {
  const fitting = picture === "lattice" || image === "lattice" ? IMAGES[picture] : image;
  return { formula, params, direction, image: fitting, wrap, colours: "picture", lines: "none", density: 8, morph: 1, cut: PRINCIPAL, texture, view, around: null };
}

/** @param {number} x */
const short = (x) => String(Number(x.toPrecision(6)));

/** @param {Placement} place */
const write = ({ center, width }) => [...center, width].map(short).join(",");

/** @param {State} state @returns {string} the hash, without # */
export function encode(state) {
  const { formula, params, direction, image, wrap, colours, lines, density, morph, cut, texture, view, around } = state;
  const fields = new URLSearchParams({ f: formula, way: direction, image, wrap, lines, texture: write(texture), view: write(view) });
  if (colours !== "picture") fields.set("colours", colours);
  if (density !== 8) fields.set("density", String(density));
  if (morph !== 1) fields.set("morph", short(morph));
  if (cut.angle !== PRINCIPAL.angle) fields.set("cut", short(cut.angle));
  if (cut.sheet !== PRINCIPAL.sheet) fields.set("sheet", String(cut.sheet));
  if (around) fields.set("around", write(around));
  for (const [name, value] of Object.entries(params)) fields.set(`p.${name}`, value.map(short).join(","));
  return fields.toString();
}

/** A place in the plane: the middle and the width. @param {string} text @returns {Placement} */
function placement(text) {
  const [x, y, width] = numbers(3)(text);
  if (!(width > 0)) throw new Error("needs a positive width as its third number");
  return { center: [x, y], width };
}

/** Sheets each way that can be shown. */
export const SHEETS = 99;

/** @param {string} text */
function sheet(text) {
  const value = between(-SHEETS, SHEETS)(text);
  if (!Number.isInteger(value)) throw new Error("must be a whole number");
  return value;
}

/** @param {string} text */
function formula(text) {
  if (text.length > LONGEST) throw new Error(`has ${text.length} characters; ${LONGEST} are the most`);
  return text;
}

/**
 * The state of an address: a preset's name, a formula, what else it says; the rest is as in `usual`.
 * @param {string} hash @param {Preset[]} presets @param {State} usual @returns {{ state: State, wrong: string[] }}
 */
export function decode(hash, presets, usual) {
  const schema = {
    preset: oneOf(presets.map(({ name }) => name)),
    f: formula,
    way: oneOf(/** @type {const} */ (["pull-back", "push-forward"])),
    image: photo((id) => id === "lattice" || knowsPicture(id)),
    wrap: oneOf(/** @type {const} */ (["repeat", "mirror", "clamp", "transparent"])),
    colours: oneOf(COLOURS),
    lines: oneOf(LINES),
    density: between(2, 32),
    morph: between(0, 1),
    cut: between(-180, 180),
    sheet,
    texture: placement,
    view: placement,
    around: placement,
  };
  const { values, others, wrong } = readAddress(hash, schema, (name) => (/^p\.[a-z]$/i.test(name) ? point : undefined));
  const preset = presets.find(({ name }) => name === values.preset);
  const base = preset ? fromPreset(preset, usual.image) : usual;
  const told = [...others].map(([name, value]) => [name.slice(2), value]);
  const { f = base.formula, way = base.direction, image = base.image, wrap = base.wrap } = values;
  const { colours = base.colours, lines = base.lines, density = base.density, morph = base.morph } = values;
  const { cut: angle = base.cut.angle, sheet: onSheet = base.cut.sheet } = values;
  const { texture = base.texture, view = base.view, around = base.around } = values;
  const state = { formula: f, params: { ...base.params, ...Object.fromEntries(told) }, direction: way, image, wrap, colours, lines, density: Math.round(density), morph, cut: { angle, sheet: onSheet }, texture, view, around };
  return { state, wrong };
}
