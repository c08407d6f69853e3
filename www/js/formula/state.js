// What the formula's page shows, and its address.

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./pipeline.js").Lines} Lines */
/** @typedef {import("../../pkg/index.js").Direction} Direction */
/** @typedef {import("../../pkg/index.js").Wrap} Wrap */
/** @typedef {import("../../pkg/index.js").Preset} Preset */
/** A part of a plane, whatever its pixels. @typedef {{ center: Point, width: number }} Placement */
/**
 * @typedef {object} State
 * @property {string} formula
 * @property {Record<string, Point>} params
 * @property {Direction} direction
 * @property {string} image
 * @property {Wrap} wrap
 * @property {Lines} lines
 * @property {Placement} texture
 * @property {Placement} view
 */

/** The picture that presets ask for by kind. @type {Record<Preset["picture"], string>} */
const IMAGES = { photo: "astronaut", lattice: "lattice" };

/** @param {Preset} preset @param {string} image the photo that is shown now @returns {State} */
export function fromPreset({ formula, params, direction, wrap, texture, view, picture }, image) {
  const fitting = picture === "lattice" || image === "lattice" ? IMAGES[picture] : image;
  return { formula, params, direction, image: fitting, wrap, lines: "none", texture, view };
}

/** @param {number} x */
const short = (x) => String(Number(x.toPrecision(6)));

/** @param {Placement} place */
const write = ({ center, width }) => [...center, width].map(short).join(",");

/** @param {State} state @returns {string} the hash, without # */
export function encode(state) {
  const { formula, params, direction, image, wrap, lines, texture, view } = state;
  const fields = new URLSearchParams({ f: formula, way: direction, image, wrap, lines, texture: write(texture), view: write(view) });
  for (const [name, value] of Object.entries(params)) fields.set(`p.${name}`, value.map(short).join(","));
  return fields.toString();
}

/**
 * The state of an address: a preset's name, a formula, or both left out.
 * @param {string} hash @param {Preset[]} presets @param {State} usual @returns {State}
 */
export function decode(hash, presets, usual) {
  const fields = new URLSearchParams(hash.replace(/^#/, ""));
  const preset = presets.find(({ name }) => name === fields.get("preset"));
  const base = preset ? fromPreset(preset, usual.image) : usual;
  const params = { ...base.params };
  for (const [key, value] of fields) {
    const point = numbers(value, 2);
    if (key.startsWith("p.") && point) params[key.slice(2)] = [point[0], point[1]];
  }
  return {
    formula: fields.get("f") ?? base.formula,
    params,
    direction: choice(fields.get("way"), /** @type {const} */ (["pull-back", "push-forward"]), base.direction),
    image: fields.get("image") ?? base.image,
    wrap: choice(fields.get("wrap"), /** @type {const} */ (["repeat", "mirror", "clamp", "transparent"]), base.wrap),
    lines: choice(fields.get("lines"), /** @type {const} */ (["none", "cartesian", "polar", "stretch", "argument"]), base.lines),
    texture: placement(fields.get("texture")) ?? base.texture,
    view: placement(fields.get("view")) ?? base.view,
  };
}

/** @template {string} T @param {string | null} text @param {readonly T[]} allowed @param {T} usual @returns {T} */
function choice(text, allowed, usual) {
  return allowed.find((name) => name === text) ?? usual;
}

/** @param {string | null} text @param {number} count @returns {number[] | null} */
function numbers(text, count) {
  const values = (text ?? "").split(",").map(Number);
  return values.length === count && values.every(Number.isFinite) ? values : null;
}

/** @param {string | null} text @returns {Placement | null} */
function placement(text) {
  const values = numbers(text, 3);
  return values && values[2] > 0 ? { center: [values[0], values[1]], width: values[2] } : null;
}
