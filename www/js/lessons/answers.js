// What the lessons' figures ask the package.

import { FormulaMap, JointTriangulation, Region, RetinoCorticalMap, RiemannMap, Texture } from "../../pkg/index.js";
import { flatten, unflatten } from "../common/frame.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {{ boundary: Point[], center: Point, toward: Point, tolerance?: number }} Shape */
/**
 * @typedef {{ what: "images", formula: string, lines: Point[][], at?: Point[] }} ImagesQuestion
 * @typedef {{ what: "pulled", formula: string, params: Record<string, Point>, picture: string, view: Frame }} PulledQuestion
 * @typedef {{ what: "disk", shape: Shape, lines: Point[][], picture?: string, view?: Frame }} DiskQuestion
 * @typedef {{ what: "density", shape: Shape, at: Point[] }} DensityQuestion
 * @typedef {{ what: "solves", shape: Shape, tolerances: number[] }} SolvesQuestion
 * @typedef {{ what: "mesh", shape: Shape, spacing: number, picture?: string, view?: Frame }} MeshQuestion
 * @typedef {{ what: "gaze", model: Record<string, number>, picture: string, fieldOfView: number, fixation: Point, view: Frame }} GazeQuestion
 * @typedef {{ what: "cortex", model: Record<string, number>, lines: Point[][], at: Point }} CortexQuestion
 * @typedef {ImagesQuestion | PulledQuestion | DiskQuestion | DensityQuestion | SolvesQuestion | MeshQuestion | GazeQuestion | CortexQuestion} Question
 */

/** @type {Map<string, { texture: Texture, frame: Frame }>} */
const pictures = new Map();

/** @param {import("../common/answering.js").Known} picture */
export function know({ id, pixels, frame }) {
  pictures.get(id)?.texture.free();
  pictures.set(id, { texture: new Texture(pixels, ...frame.pixels), frame });
}

/** @param {Question} question @returns {any} */
export function answer(question) {
  switch (question.what) {
    case "images":
      return images(question);
    case "pulled":
      return pulled(question);
    case "disk":
      return disk(question);
    case "density":
      return density(question);
    case "solves":
      return solves(question);
    case "mesh":
      return mesh(question);
    case "gaze":
      return gaze(question);
    case "cortex":
      return cortex(question);
  }
}

/** The picture that a question names. @param {string} id */
function pictureOf(id) {
  const picture = pictures.get(id);
  if (!picture) throw new Error(`The lessons have no picture ${id}.`);
  return picture;
}

/** Lines through a function of many points at once. @param {Point[][]} lines @param {(points: Float64Array) => Float64Array} map @returns {Point[][]} */
function carry(lines, map) {
  const all = unflatten(map(flatten(lines.flat())));
  let taken = 0;
  return lines.map(({ length }) => all.slice(taken, (taken += length)));
}

/** @type {{ text: string, map: FormulaMap } | null} */
let formula = null;

/** The last formula's map is kept. @param {string} text */
function formulaOf(text) {
  if (formula?.text === text) return formula.map;
  const map = new FormulaMap(text);
  formula?.map.free();
  formula = { text, map };
  return map;
}

/** @param {ImagesQuestion} question */
function images({ formula, lines, at = [] }) {
  const map = formulaOf(formula);
  return { lines: carry(lines, (points) => map.eval(points)), at: unflatten(map.eval(flatten(at))), derivative: unflatten(map.derivative(flatten(at))) };
}

/** @param {PulledQuestion} question */
function pulled({ formula, params, picture, view }) {
  const { texture, frame } = pictureOf(picture);
  const map = formulaOf(formula);
  for (const [name, value] of Object.entries(params)) map.setParam(name, value);
  return map.warp(texture, { texture: frame, view, direction: "pull-back" });
}

/** @type {Map<string, RiemannMap>} */
const solved = new Map();
/** Solves that are kept: those of all figures at rest. */
const KEPT = 6;

/** The map of a shape, solved once; the oldest is forgotten. @param {Shape} shape */
function mapOf({ boundary, center, toward, tolerance = 1e-6 }) {
  const key = JSON.stringify([boundary, center, toward, tolerance]);
  const known = solved.get(key);
  if (known) return known;
  const region = new Region({ boundary: flatten(boundary), center, toward });
  let map;
  try {
    map = RiemannMap.solve(region, { tolerance });
  } finally {
    region.free();
  }
  solved.set(key, map);
  const [oldest] = solved.keys();
  if (solved.size > KEPT) {
    solved.get(oldest)?.free();
    solved.delete(oldest);
  }
  return map;
}

/** Lines of the disk carried back into the region, the corners' angles, and the disk's picture. @param {DiskQuestion} question */
function disk({ shape, lines, picture, view }) {
  const map = mapOf(shape);
  return {
    lines: carry(lines, (points) => map.fromDisk(points)),
    angles: [...map.angles],
    radius: map.conformalRadius,
    ...(picture && view && { pixels: exactly(map, picture, view) }),
  };
}

/** The disk's picture pixel by pixel. @param {RiemannMap} map @param {string} picture @param {Frame} view */
function exactly(map, picture, view) {
  const { texture, frame } = pictureOf(picture);
  return map.warp(texture, { texture: frame, view });
}

/** The density of harmonic measure at points of the boundary, a unit of length: |f′| / 2π. @param {DensityQuestion} question */
function density({ shape, at }) {
  const map = mapOf(shape);
  return {
    angles: [...map.angles],
    density: unflatten(map.derivative(flatten(at))).map(([re, im]) => Math.hypot(re, im) / (2 * Math.PI)),
  };
}

/** @param {SolvesQuestion} question */
function solves({ shape, tolerances }) {
  return tolerances.map((tolerance) => {
    const { unknowns, residual, errorEstimate } = mapOf({ ...shape, tolerance });
    return { tolerance, unknowns, residual, errorEstimate };
  });
}

/** @param {MeshQuestion} question */
function mesh({ shape, spacing, picture, view }) {
  const map = mapOf(shape);
  const joint = JointTriangulation.regionToDisk(map, { spacing });
  try {
    return {
      source: unflatten(joint.source),
      target: unflatten(joint.target),
      triangles: joint.triangles,
      evidence: joint.evidence,
      ...(picture && view && { ...both(map, joint, picture, view) }),
    };
  } finally {
    joint.free();
  }
}

/** The disk's picture by triangles and pixel by pixel. @param {RiemannMap} map @param {JointTriangulation} joint @param {string} picture @param {Frame} view */
function both(map, joint, picture, view) {
  const { texture, frame } = pictureOf(picture);
  return { byTriangles: joint.warp(texture, { texture: frame, view }), exact: exactly(map, picture, view) };
}

/** The hemispheres as they receive the halves of the field, left half first. */
const HEMISPHERES = /** @type {const} */ (["right", "left"]);

/** @param {Record<string, number>} model @param {"left" | "right"} hemisphere */
const hemisphereOf = (model, hemisphere) => RetinoCorticalMap.model({ k: model.k, a: model.a, ...(model.b && { b: model.b }), hemisphere });

/** @param {GazeQuestion} question */
function gaze({ model, picture, fieldOfView, fixation, view }) {
  const { texture, frame } = pictureOf(picture);
  /** @type {Uint8ClampedArray<ArrayBuffer> | undefined} */
  let pixels;
  // Each hemisphere paints its half of the view over what the other has left clear.
  for (const hemisphere of HEMISPHERES) {
    const map = hemisphereOf(model, hemisphere);
    const image = map.seeing({ picture: frame, fieldOfView, fixation });
    const half = image.warp(texture, { texture: frame, view });
    pixels = pixels ? merge(pixels, half) : half;
    image.free();
    map.free();
  }
  return pixels;
}

/** What is opaque in either. @param {Uint8ClampedArray<ArrayBuffer>} one @param {Uint8ClampedArray} other */
function merge(one, other) {
  for (let k = 3; k < one.length; k += 4) if (other[k] > one[k]) one.set(other.subarray(k - 3, k + 1), k - 3);
  return one;
}

/** @param {CortexQuestion} question */
function cortex({ model, lines, at }) {
  const map = hemisphereOf(model, "left");
  try {
    return {
      lines: carry(lines, (points) => map.toCortex(points)),
      at: unflatten(map.toCortex(flatten([at])))[0],
      magnification: map.magnification(flatten([at]))[0],
    };
  } finally {
    map.free();
  }
}
