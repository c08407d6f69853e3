// The formulas for V1 that the page offers, each with its source.

import { RetinoCorticalMap } from "../../pkg/index.js";

/** @typedef {import("../../pkg/index.js").CorticalModelOptions} ModelOptions */
/** @typedef {import("../../pkg/index.js").Hemisphere} Hemisphere */
/** @typedef {{ title: string, source: string, options: Omit<ModelOptions, "hemisphere"> }} Model */

/** Lengths in millimetres, eccentricities in degrees. @type {Record<string, Model>} */
export const models = {
  schira: {
    title: "Human, dipole",
    source: "k = 18 mm, a = 1.05°, b = 90° (Schira and others, 2010)",
    options: { k: 18, a: 1.05, b: 90 },
  },
  polimeni: {
    title: "Human, dipole (2006)",
    source: "k = 15 mm, a = 0.69°, b = 80° (Polimeni and others, 2006)",
    options: { k: 15, a: 0.69, b: 80 },
  },
  macaque: {
    title: "Macaque’s size, dipole",
    source: "the dipole of 2006, scaled to 1343 mm², the mean area of macaque V1; a model, not a measurement",
    options: { k: 15, a: 0.69, b: 80, area: 1343 },
  },
  monopole: {
    title: "Monopole",
    source: "k log((z + a)/a) with k = 15 mm, a = 0.69°: the complex logarithm, good near the fovea only",
    options: { k: 15, a: 0.69 },
  },
};

/** The hemispheres in the order in which their halves of the field are seen. @type {Hemisphere[]} */
export const HEMISPHERES = ["right", "left"];

/** @param {string} name @param {Hemisphere} hemisphere */
export function cortexOf(name, hemisphere) {
  return RetinoCorticalMap.model({ ...models[name].options, hemisphere });
}

/** A point of the visual field E·e^{iθ} → two numbers. @param {number} eccentricity in degrees @param {number} azimuth in radians @returns {[number, number]} */
export const fieldPoint = (eccentricity, azimuth) => [eccentricity * Math.cos(azimuth), eccentricity * Math.sin(azimuth)];

/**
 * Half of the size of both cortices, laid out with the foveas together at 0.
 * @param {string} name @returns {{ width: number, height: number }} in millimetres
 */
export function halfSize(name) {
  const map = cortexOf(name, "left");
  const rim = [];
  for (let k = 0; k <= 90; k++) {
    rim.push(...fieldPoint(89.99, ((k - 45) / 45) * (Math.PI / 2 - 1e-6)), ...fieldPoint(k, Math.PI / 2 - 1e-6));
  }
  const points = map.toCortex(new Float64Array(rim));
  map.free();
  let [width, height] = [0, 0];
  points.forEach((value, k) => {
    if (k % 2 === 0) width = Math.max(width, Math.abs(value) || 0);
    else height = Math.max(height, Math.abs(value) || 0);
  });
  return { width, height };
}
