// What the page of flows asks the package: flows to be added up, on a grid of points.

import { PotentialFlow, Region } from "../../pkg/index.js";
import { flatten } from "../common/frame.js";
import { chosenFrom } from "../editor/read-outline.js";
import { pointsOf } from "./grid-field.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./bodies.js").Bodies} Bodies */
/** @typedef {import("../common/frame.js").Frame} Frame */
/** The stream function ψ of a flow on the grid, NaN inside bodies, and on each body. @typedef {{ psi: Float64Array, walls: number[] }} Basic */
/**
 * Every flow past the bodies is a sum of these: the winds along x and along y, and a turning around each body.
 * @typedef {object} Basis
 * @property {Basic[]} flows
 * @property {[alongX: number[], alongY: number[]] | null} kutta the turnings with which each wind leaves at the trailing corners
 * @property {number} estimate of the largest error, in units of the wind times the bodies' size
 * @property {number} unknowns
 * @property {number} ms
 */
/** @typedef {{ what: "basis", bodies: Bodies, grid: Frame } | { what: "outline", text: string }} Question */

/** For a picture; the estimate is shown. */
const TOLERANCE = 1e-3;

/** @param {Question} question @returns {any} */
export function answer(question) {
  return question.what === "outline" ? chosenFrom(question.text) : basis(question.bodies, question.grid);
}

/** @param {Bodies} bodies @param {Frame} grid @returns {Basis} */
function basis({ outlines, curve, trailing }, grid) {
  const begin = performance.now();
  const region = Region.exterior({ holes: outlines.map(flatten), curve });
  /** @param {number} angle @param {number[] | "kutta"} circulation */
  const flow = (angle, circulation) => PotentialFlow.past(region, { angle, circulation, ...(trailing && { trailing }) }, { tolerance: TOLERANCE });
  const still = outlines.map(() => 0);
  const winds = [flow(0, still), flow(Math.PI / 2, still)];
  const turnings = outlines.map((_, k) => flow(0, still.map((_, j) => (j === k ? 1 : 0))));
  const leaving = trailing && [flow(0, "kutta"), flow(Math.PI / 2, "kutta")];
  const points = pointsOf(grid);
  const walls = flatten(outlines.map(([first]) => first));
  const [along, across] = winds.map((wind) => sampled(wind, points, walls));
  const turned = turnings.map((turning) => difference(sampled(turning, points, walls), along));
  const [{ errorEstimate, unknowns }] = winds;
  const kutta = leaving && /** @type {[number[], number[]]} */ (leaving.map(({ circulation }) => [...circulation]));
  for (const each of [...winds, ...turnings, ...(leaving ?? [])]) each.free();
  region.free();
  return { flows: [along, across, ...turned], kutta, estimate: errorEstimate, unknowns, ms: performance.now() - begin };
}

/** @param {PotentialFlow} flow @param {Float64Array} points @param {Float64Array} walls a point of each body @returns {Basic} */
const sampled = (flow, points, walls) => ({ psi: flow.stream(points), walls: [...flow.stream(walls)] });

/** @param {Basic} a @param {Basic} b @returns {Basic} */
const difference = (a, b) => ({ psi: a.psi.map((value, k) => value - b.psi[k]), walls: a.walls.map((value, k) => value - b.walls[k]) });
