// Regions with holes: solves, a million points both ways, and the ring that Chebfun's example times.

import { AnnulusMap, PotentialFlow, Region, SlitMap } from "conformal-warp";
import { Table, Target, ms, scientific } from "./lib/table.mjs";
import { milliseconds } from "./lib/timing.mjs";

/** @typedef {{ boundary?: Float64Array, holes: Float64Array[], curve?: "polygon" | "smooth", center?: [number, number] }} Given */

/**
 * A curve by its points.
 *
 * @param {number} count
 * @param {(t: number, k: number) => [number, number]} at
 */
const curve = (count, at) => Float64Array.from(Array.from({ length: count }, (_, k) => at((2 * Math.PI * k) / count, k)).flat());

/** What somebody draws: no two corners alike. @param {number} count @param {[number, number]} center @param {number} radius */
const blob = (count, [x, y], radius) =>
  curve(count, (t, k) => {
    const r = radius * (1 + 0.12 * Math.sin(3 * t + x) + 0.03 * (((k * 7) % 5) - 2));
    return [x + r * Math.cos(t), y + r * Math.sin(t)];
  });

/** Chebfun's example ConformalMapping2: two ellipses. @param {number} size @param {number} turn @param {number} x */
const ellipse = (size, turn, x) =>
  curve(64, (t) => {
    const [a, b] = [size * Math.cos(t), 0.6 * size * Math.sin(t)];
    return [x + a * Math.cos(turn) - b * Math.sin(turn), a * Math.sin(turn) + b * Math.cos(turn)];
  });

/** Holes on a lattice. @param {number} columns @param {number} rows @param {number} count of vertices */
const many = (columns, rows, count) =>
  Array.from({ length: columns * rows }, (_, k) => {
    const [i, j] = [k % columns, Math.floor(k / columns)];
    return blob(count, [i - (columns - 1) / 2, j - (rows - 1) / 2], 0.28);
  });

/** The outer wall of the lattice. @type {[number, number][]} */
const BOX = [[-6, -4], [6, -4], [6, 4], [-6, 4]];

/** @type {{ name: string, given: Given, kind: "annulus" | "disk", tolerance: number, time: number, peer?: string }[]} */
const rows = [
  { name: "ring of two ellipses", given: { boundary: ellipse(3, 0, -1), holes: [ellipse(1, 0.5, 0)], curve: "smooth" }, kind: "annulus", tolerance: 1e-12, time: 100, peer: "Chebfun 7900 ms, printed" },
  { name: "ring of two 100-gons", given: { boundary: blob(100, [0, 0], 1), holes: [blob(100, [0.1, 0], 0.4)] }, kind: "annulus", tolerance: 1e-8, time: 400 },
  { name: "five holes of 20", given: { boundary: blob(40, [0, 0], 3.4), holes: [[0, 0], [1.6, 0], [-1.6, 0], [0, 1.7], [0, -1.7]].map(([x, y]) => blob(20, [x, y], 0.5)), center: [0.8, 0.9] }, kind: "disk", tolerance: 1e-6, time: 400 },
  { name: "50 holes of 12", given: { boundary: curve(4, (_, k) => BOX[k]), holes: many(10, 5, 12), center: [0.5, 0.5] }, kind: "disk", tolerance: 1e-6, time: 5000 },
  { name: "dragging a hole's vertex", given: { boundary: blob(20, [0, 0], 1), holes: [blob(12, [0.1, 0], 0.4)] }, kind: "annulus", tolerance: 1e-3, time: 30 },
];

const MILLION = 1_000_000;

export default async function bench() {
  const table = new Table("Regions with holes: solve", { case: 26, tolerance: 9, estimate: 8, unknowns: 8, time: 22, beside: 26 });
  for (const { name, given, kind, tolerance, time, peer = "–" } of rows) {
    const region = new Region(/** @type {any} */ (given));
    const solve = () => (kind === "annulus" ? AnnulusMap.solve(region, { tolerance }) : SlitMap.solve(region, { kind: "disk" }, { tolerance }));
    const map = solve();
    table.row(name, scientific(tolerance), scientific(map.errorEstimate), map.unknowns, new Target(milliseconds(() => solve().free()), time, ms), peer);
    map.free();
  }
  evaluation();
  wind();
}

/** A million points of rings, both ways. */
function evaluation() {
  const table = new Table("Regions with holes: a million points", { case: 26, "to build": 10, forward: 22, back: 22, "there and back": 14 });
  const square = (/** @type {number} */ half) => new Float64Array([-half, -half, half, -half, half, half, -half, half]);
  /** @type {[string, Given][]} */
  const rings = [["frame", { boundary: square(1), holes: [square(0.5)] }], ["ring of two 100-gons", rows[1].given], ["ring of two ellipses", rows[0].given]];
  for (const [name, given] of rings) {
    const region = new Region(/** @type {any} */ (given));
    const map = AnnulusMap.solve(region);
    const begin = performance.now();
    map.prepare();
    const built = performance.now() - begin;
    const ring = curve(MILLION, (_, k) => {
      const r = map.innerRadius ** ((k * 0.6180339887) % 1);
      return [r * Math.cos(k * 0.7548776662), r * Math.sin(k * 0.7548776662)];
    });
    const points = map.fromAnnulus(ring);
    const back = milliseconds(() => map.fromAnnulus(ring));
    const forward = milliseconds(() => map.toAnnulus(points));
    const again = map.toAnnulus(points);
    const worst = again.reduce((most, x, k) => Math.max(most, Math.abs(x - ring[k])), 0);
    table.row(name, ms(built), new Target(forward, 200, ms), new Target(back, 200, ms), scientific(worst));
    map.free();
    region.free();
  }
}

/** A body of 60 vertices in the wind, as it is dragged: solve, and the stream function on the page's grid. */
function wind() {
  const table = new Table("Flow past a body of 60 vertices, dragged", { step: 40, time: 22 });
  const region = Region.exterior({ holes: [blob(60, [0, 0], 1)] });
  const points = curve(60 * 36, (_, k) => [(k % 60) / 10 - 2.95, Math.floor(k / 60) / 10 - 1.75]);
  const solve = () => PotentialFlow.past(region, { angle: 0.1 }, { tolerance: 1e-3 });
  const flow = solve();
  table.row("solve", new Target(milliseconds(() => solve().free()), 30, ms));
  table.row("another wind, on 60 × 36 points", ms(milliseconds(() => flow.again({ angle: 0.2 }).stream(points))));
  const frame = { center: /** @type {[number, number]} */ ([0, 0]), width: 6, pixels: /** @type {[number, number]} */ ([600, 360]) };
  const levels = Float64Array.from({ length: 26 }, (_, k) => (k - 12.5) / 8);
  table.row("26 streamlines", ms(milliseconds(() => flow.levelLines("streamlines", levels, frame).free())));
  flow.free();
  region.free();
}
