// A model's name and what was changed of it → all that makes its map. In the worker: outlines are those of formulas.

import { RetinoCorticalMap } from "../../pkg/index.js";
import { HUMAN, isOutline, models, POLIMENI } from "./models.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./models.js").Landmark} Landmark */
/** @typedef {import("./models.js").Outline} Outline */
/** @typedef {import("./models.js").Spec} Spec */

/** Vertices of the outlines that come with the page. */
const VERTICES = 160;
/** The blind spot: 15° temporal, 1.5° below. */
const BLIND_SPOT = [15, -1.5];
/** Degrees → the stereographic half disk, its radius taken for 90: a dipole's outline is a conformal image of that too, corner for corner. */
const onDisk = (/** @type {number} */ x, /** @type {number} */ y) => {
  const e = Math.hypot(x, y);
  const scale = (90 * Math.tan((e * Math.PI) / 360)) / e;
  return [x * scale, y * scale];
};

/** @type {Map<string, Outline>} */
const given = new Map();

/** The outline of a formula, with the landmark where the corners of the field go to the outline’s. @param {string} name @returns {Outline} */
export function outlineOf(name) {
  const known = given.get(name);
  if (known) return known;
  const options = models.get(name)?.options ?? { ...POLIMENI, area: HUMAN };
  const model = RetinoCorticalMap.model(options);
  const [right, below] = BLIND_SPOT;
  const [x, y, ahead, up] = model.toCortex(new Float64Array([...onDisk(right, below), ...onDisk(right + 1e-3, below)]));
  const [u, v] = model.toCortex(new Float64Array(BLIND_SPOT));
  model.free();
  const flat = RetinoCorticalMap.modelOutline(options, name === "own" ? 80 : VERTICES);
  /** @type {Point[]} */
  const boundary = Array.from({ length: flat.length / 2 }, (_, k) => [flat[2 * k], flat[2 * k + 1]]);
  /** @type {Outline} */
  const outline = { kind: "outline", boundary, center: [x, y], direction: Math.atan2(up - y, ahead - x), fromFormula: Math.hypot(u - x, v - y) };
  given.set(name, outline);
  return outline;
}

/**
 * @param {string} name @param {{ shear: number, own: Outline | null, landmarks: Record<string, Landmark> }} state
 * @returns {Spec}
 */
export function specOf(name, { shear, own, landmarks }) {
  if (isOutline(name)) return { ...((name === "own" && own) || outlineOf(name)), ...landmarks[name] };
  const { options = POLIMENI } = models.get(name) ?? {};
  return { kind: "formula", options: name === "wedge" ? { ...options, shear } : options };
}
