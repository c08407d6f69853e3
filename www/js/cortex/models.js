// The maps of V1 that the page offers, each with its source: formulas, and outlines that Symm's method maps.

import { deepPoint } from "../editor/geometry.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../../pkg/index.js").CorticalModelOptions} ModelOptions */
/** @typedef {import("../../pkg/index.js").Hemisphere} Hemisphere */
/** Where the blind spot lies on an outline, and which way the horizontal meridian runs there. @typedef {{ center: Point, direction: number }} Landmark */
/** @typedef {{ kind: "formula", options: Omit<ModelOptions, "hemisphere"> }} Formula */
/** In millimetres, of a left hemisphere; `fromFormula`: how far its formula has the blind spot from there. @typedef {{ kind: "outline", boundary: Point[], fromFormula?: number } & Landmark} Outline */
/** All that makes a map, as plain data: the worker gets it too. @typedef {Formula | Outline} Spec */
/** @typedef {"formulas" | "outlines, by Symm’s method"} Group */
/** @typedef {{ title: string, group: Group, source: string, options?: Omit<ModelOptions, "hemisphere"> }} Model */

export const POLIMENI = { k: 15, a: 0.69, b: 80 };
/** Mean areas of V1 in mm², as measured. */
export const HUMAN = 2643;
const MACAQUE = 1343;
export const MEASURED = `Measured: ${HUMAN} mm² in people on average, 1986 to 3477 (Adams, Sincich and Horton, 2007), ${MACAQUE} mm² in macaques (Sincich, Adams and Horton, 2003).`;

/** Lengths in millimetres, eccentricities in degrees. @type {Map<string, Model>} */
export const models = new Map(Object.entries({
  schira: {
    title: "Dipole of 2010",
    group: "formulas",
    source: "the dipole with k = 18 mm, a = 1.05°, b = 90° (Schira and others, 2010)",
    options: { k: 18, a: 1.05, b: 90 },
  },
  polimeni: {
    title: "Dipole of 2006",
    group: "formulas",
    source: "the dipole with k = 15 mm, a = 0.69°, b = 80° (Polimeni and others, 2006)",
    options: POLIMENI,
  },
  wedge: {
    title: "Wedge-dipole",
    group: "formulas",
    source: "the dipole with k = 17.3 mm, a = 0.75°, b = 120° after a shear of the azimuths by α, fitted to human data with α = 0.95 (Polimeni and others, 2006); conformal for α = 1 only",
    options: { k: 17.3, a: 0.75, b: 120 },
  },
  macaque: {
    title: "Macaque’s size, dipole",
    group: "formulas",
    source: "the dipole of 2006, scaled to macaques’ mean area, a model, not a measurement",
    options: { ...POLIMENI, area: MACAQUE },
  },
  monopole: {
    title: "Monopole",
    group: "formulas",
    source: "the monopole k log((z + a)/a) with k = 15 mm, a = 0.69°, near the fovea the dipole of 2006",
    options: { k: 15, a: 0.69 },
  },
  human: {
    title: "Human size, dipole’s outline",
    group: "outlines, by Symm’s method",
    source: "the outline of the dipole of 2006, scaled to people’s mean area, a model, not a measurement",
    options: { ...POLIMENI, area: HUMAN },
  },
  monkey: {
    title: "Macaque’s size, dipole’s outline",
    group: "outlines, by Symm’s method",
    source: "the outline of the dipole of 2006, scaled to macaques’ mean area, a model, not a measurement",
    options: { ...POLIMENI, area: MACAQUE },
  },
  own: { title: "An outline of your own", group: "outlines, by Symm’s method", source: "your outline" },
}));

/** @param {string} name */
export const isOutline = (name) => models.get(name)?.group !== "formulas";

/** An outline that somebody gave, put where the page shows left hemispheres, with a landmark to begin with. @param {Point[]} boundary @returns {Outline} */
export function ownOutline(boundary) {
  const left = Math.min(...boundary.map(([x]) => x));
  const ys = boundary.map(([, y]) => y);
  const middle = (Math.min(...ys) + Math.max(...ys)) / 2;
  const placed = boundary.map(([x, y]) => /** @type {Point} */ ([x - left, y - middle]));
  return { kind: "outline", boundary: placed, center: deepPoint(placed), direction: 0 };
}
