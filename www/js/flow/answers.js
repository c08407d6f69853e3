// What the page of flows asks the package: flows to be added up, on a grid of points.

import { PotentialFlow, Region } from "../../pkg/index.js";
import { flatten, unflatten } from "../common/frame.js";
import { chosenFrom } from "../editor/read-outline.js";
import { pointsOf } from "./grid-field.js";
import { pointsOfLines } from "./level-lines.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./bodies.js").Bodies} Bodies */
/** @typedef {import("./vortices.js").Vortex} Vortex */
/** @typedef {import("../common/frame.js").Frame} Frame */
/** The stream function ψ of a flow on the grid, NaN inside bodies, and on each body. @typedef {{ psi: Float64Array, walls: number[] }} Basic */
/**
 * Every flow past the bodies is a sum of these: the winds along x and along y, a turning around each body, and last what the vortices
 * drive, if there are any.
 * @typedef {object} Basis
 * @property {Basic[]} flows
 * @property {[alongX: number[], alongY: number[], vortices: number[]] | null} kutta the turnings with which each of these leaves at the trailing corners
 * @property {number} estimate of the largest error, in units of the wind times the bodies' size
 * @property {number} unknowns
 * @property {number} ms
 */
/**
 * Streamlines of the flow past the bodies whose basis was asked for last, and the points where it rests.
 * @typedef {{ lines: Point[][], resting: Point[] }} Traced
 */
/** @typedef {{ what: "lines", angle: number, circulation: number[], levels: number[], frame: Frame }} LinesQuestion */
/** @typedef {{ what: "basis", bodies: Bodies, vortices: Vortex[], grid: Frame } | LinesQuestion | { what: "outline", text: string }} Question */

/** For a picture; the estimate is shown. */
const TOLERANCE = 1e-3;

/** The flow of the last basis. @type {PotentialFlow | null} */
let kept = null;

/** @param {Question} question @returns {any} */
export function answer(question) {
  if (question.what === "outline") return chosenFrom(question.text);
  return question.what === "lines" ? traced(question) : basis(question.bodies, question.vortices, question.grid);
}

/** @param {LinesQuestion} question @returns {Traced | null} */
function traced({ angle, circulation, levels, frame }) {
  if (!kept) return null;
  const flow = kept.again({ angle, circulation });
  const lines = pointsOfLines(flow.levelLines("streamlines", Float64Array.from(levels), frame));
  const resting = [...unflatten(flow.stagnationPoints), ...unflatten(flow.freeStagnationPoints(frame))];
  flow.free();
  return { lines, resting };
}

/** @param {Bodies} bodies @param {Vortex[]} vortices @param {Frame} grid @returns {Basis} */
function basis({ outlines, curve, trailing }, vortices, grid) {
  const begin = performance.now();
  const region = Region.exterior({ holes: outlines.map(flatten), curve });
  const still = outlines.map(() => 0);
  const solved = PotentialFlow.past(region, { circulation: still, vortices }, { tolerance: TOLERANCE });
  const calm = vortices.map(({ at }) => ({ at, circulation: 0 }));
  /** @param {number} angle @param {number[] | "kutta"} circulation */
  const flow = (angle, circulation) => solved.again({ angle, circulation, vortices: calm, ...(trailing && { trailing }) });
  /** @param {number[] | "kutta"} circulation */
  const driven = (circulation) => solved.again({ speed: 0, circulation, ...(trailing && { trailing }) });
  const winds = [flow(0, still), flow(Math.PI / 2, still)];
  const whirls = vortices.length ? [driven(still)] : [];
  const turnings = outlines.map((_, k) => flow(0, still.map((_, j) => (j === k ? 1 : 0))));
  const leaving = trailing && [flow(0, "kutta"), flow(Math.PI / 2, "kutta"), ...(vortices.length ? [driven("kutta")] : [])];
  const points = pointsOf(grid);
  const walls = flatten(outlines.map(([first]) => first));
  const [along, across] = winds.map((wind) => sampled(wind, points, walls));
  const turned = turnings.map((turning) => difference(sampled(turning, points, walls), along));
  const whirled = whirls.map((whirl) => sampled(whirl, points, walls));
  const { errorEstimate, unknowns } = solved;
  const kutta = leaving && /** @type {[number[], number[], number[]]} */ ([...leaving.map(({ circulation }) => [...circulation]), still].slice(0, 3));
  kept?.free();
  kept = solved;
  for (const each of [...winds, ...turnings, ...whirls, ...(leaving ?? [])]) each.free();
  region.free();
  return { flows: [along, across, ...turned, ...whirled], kutta, estimate: errorEstimate, unknowns, ms: performance.now() - begin };
}

/** ψ of a vortex itself has no bound; what is not shown of it is beyond this. */
const DEEPEST = 4;

/** @param {PotentialFlow} flow @param {Float64Array} points @param {Float64Array} walls a point of each body @returns {Basic} */
const sampled = (flow, points, walls) => ({ psi: flow.stream(points).map((psi) => (Math.abs(psi) === Infinity ? Math.sign(psi) * DEEPEST : psi)), walls: [...flow.stream(walls)] });

/** @param {Basic} a @param {Basic} b @returns {Basic} */
const difference = (a, b) => ({ psi: a.psi.map((value, k) => value - b.psi[k]), walls: a.walls.map((value, k) => value - b.walls[k]) });
