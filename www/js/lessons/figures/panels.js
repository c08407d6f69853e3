// The density of harmonic measure on the wall, and how the error falls with the number of unknowns.

import { along, Board } from "../board.js";
import { closed, deepEnough, ROOM } from "../shapes.js";
import { power } from "../../editor/evidence.js";
import { crossingEdges, mix, rightOf } from "../../editor/geometry.js";

/** @typedef {import("../../common/frame.js").Point} Point */

const TOLERANCES = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12];
/** Places on each wall where the density is drawn. */
const HAIRS = 40;
/** The corner that points inward. */
const NICHE = 3;

/** @param {import("../place.js").Place} place */
export function mount(place) {
  const room = new Board("A room, with the density of walkers on its wall", [0, 0], 2.9);
  const plot = new Board("The error of the map over the number of unknowns", [0, 0], 2);
  place.put(room, plot);
  const center = room.handle([-0.3, -0.25], { label: "The centre", kind: "gold", limit: (to) => deepEnough(outline(), to), onMove: () => draw() });
  const niche = room.handle(ROOM[NICHE], {
    label: "The corner that points inward",
    limit: (to) => (deepEnough(outline(to), center.at) && crossingEdges(outline(to)).size === 0 ? to : null),
    onMove: () => draw(),
  });

  /** @param {Point} [corner] */
  function outline(corner = niche?.at ?? ROOM[NICHE]) {
    return ROOM.map((at, k) => (k === NICHE ? corner : at));
  }

  function draw() {
    const boundary = outline();
    const shape = { boundary, center: center.at, toward: rightOf(boundary, center.at).point };
    const feet = boundary.flatMap((from, k) => Array.from({ length: HAIRS }, (_, j) => mix(from, boundary[(k + 1) % boundary.length], (j + 0.5) / HAIRS)));
    room.curves("body", [closed(boundary)]);
    place.ask({ what: "density", shape, at: feet }, ({ density }) => {
      const tips = feet.map((foot, k) => outward(boundary, foot, Math.floor(k / HAIRS), Math.min(0.55, 0.35 * density[k])));
      room.curves("hairs", feet.map((foot, k) => [foot, tips[k]]));
      place.ask({ what: "solves", shape, tolerances: TOLERANCES }, (solves) => drawPlot(plot, place, solves));
    });
  }
  draw();
}

/** A point outside, so far from a foot on a wall. @param {Point[]} boundary @param {Point} foot @param {number} edge @param {number} far @returns {Point} */
function outward(boundary, [x, y], edge, far) {
  const [from, to] = [boundary[edge], boundary[(edge + 1) % boundary.length]];
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  return [x + (far * (to[1] - from[1])) / length, y - (far * (to[0] - from[0])) / length];
}

/** @param {Board} plot @param {import("../place.js").Place} place @param {{ unknowns: number, errorEstimate: number }[]} solves */
function drawPlot(plot, place, solves) {
  const most = Math.max(...solves.map(({ unknowns }) => unknowns));
  /** @param {number} unknowns @param {number} error @returns {Point} */
  const at = (unknowns, error) => [-0.68 + (1.5 * unknowns) / most, 0.8 + (1.55 * Math.log10(error)) / 13];
  const points = solves.map(({ unknowns, errorEstimate }) => at(unknowns, Math.min(1, errorEstimate)));
  const decades = [0, -3, -6, -9, -12];
  plot.curves("net", decades.map((decade) => along(at(0, 10 ** decade), at(most * 1.05, 10 ** decade), 1)));
  plot.curves("one", [points]);
  plot.dots("mark", points, 5);
  plot.words([
    ...decades.map((decade) => /** @type {[string, Point]} */ ([decade ? `10${superscript(decade)}` : "1", [-0.93, at(0, 10 ** decade)[1] - 0.02]])),
    ["0", [-0.7, -0.87]],
    [String(most), [0.72, -0.87]],
    ["unknowns", [-0.1, -0.97]],
    ["error", [-0.93, 0.9]],
  ]);
  const last = solves[solves.length - 1];
  place.say(`${last.unknowns} unknowns for an error of ${power(last.errorEstimate)}; each dot is a solve.`);
}

/** @param {number} decade */
const superscript = (decade) => String(decade).replace(/./g, (digit) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(digit)] ?? "");
