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

/** @type {Map<string, Outline>} */
const given = new Map();

/** The outline of a formula, with the landmark where the corners of the field go to the outline’s. @param {string} name @returns {Outline} */
export function outlineOf(name) {
  const known = given.get(name);
  if (known) return known;
  const options = models.get(name)?.options ?? { ...POLIMENI, area: HUMAN };
  const model = RetinoCorticalMap.model(options);
  const { center, direction } = RetinoCorticalMap.modelLandmark(options);
  const [u, v] = model.toCortex(new Float64Array(BLIND_SPOT));
  model.free();
  const flat = RetinoCorticalMap.modelOutline(options, name === "own" ? 80 : VERTICES);
  /** @type {Point[]} */
  const boundary = Array.from({ length: flat.length / 2 }, (_, k) => [flat[2 * k], flat[2 * k + 1]]);
  /** @type {Outline} */
  const outline = { kind: "outline", boundary, center, direction, fromFormula: Math.hypot(u - center[0], v - center[1]) };
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
