// A solved map as a function: a million points each way, and what it costs to get ready for that.

import { RiemannMap } from "conformal-warp";
import { fixture, regionOf } from "./lib/fixtures.mjs";
import { Table, Target, ms, scientific } from "./lib/table.mjs";
import { milliseconds } from "./lib/timing.mjs";

const COUNT = 1e6;

export default async function bench() {
  const region = regionOf(fixture("blob100"));
  const inside = pointsInside(region, COUNT);
  const map = RiemannMap.solve(region, { tolerance: 1e-8 });
  // Few points do without it, so that they need not wait.
  const build = timeOnce(() => map.prepare());
  const images = map.toDisk(inside);
  const back = map.fromDisk(images);
  const times = {
    toDisk: milliseconds(() => map.toDisk(inside)),
    fromDisk: milliseconds(() => map.fromDisk(images)),
    derivative: milliseconds(() => map.derivative(inside)),
  };
  const table = new Table("Evaluate: blob100 at 1e-8, a million points", { what: 28, time: 22, "µs a point": 10 });
  const row = (/** @type {string} */ what, /** @type {number} */ time, /** @type {number} */ limit) =>
    table.row(what, limit ? new Target(time, limit, ms) : ms(time), ((time * 1000) / COUNT).toFixed(3));
  table.row("building, both ways", new Target(build, 300, ms), "");
  row("toDisk", times.toDisk, 150);
  row("fromDisk", times.fromDisk, 200);
  row("derivative", times.derivative, 0);
  table.row("largest round trip error", scientific(largestDistance(inside, back)), "");
}

/** @param {() => void} work */
function timeOnce(work) {
  const start = performance.now();
  work();
  return performance.now() - start;
}

/**
 * Points of the region, the same on every run.
 *
 * @param {import("conformal-warp").Region} region
 * @param {number} count
 */
function pointsInside(region, count) {
  const tried = new Float64Array(4 * count);
  let seed = 1;
  for (let k = 0; k < tried.length; k++) {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    tried[k] = (seed / 2 ** 32 - 0.5) * 3;
  }
  const inside = region.contains(tried);
  const points = new Float64Array(2 * count);
  let found = 0;
  for (let k = 0; k < inside.length && found < count; k++) {
    if (inside[k]) points.set(tried.subarray(2 * k, 2 * k + 2), 2 * found++);
  }
  return points.subarray(0, 2 * found);
}

/**
 * @param {Float64Array} a
 * @param {Float64Array} b
 */
function largestDistance(a, b) {
  let largest = 0;
  for (let k = 0; k < a.length; k += 2) {
    const distance = Math.hypot(a[k] - b[k], a[k + 1] - b[k + 1]);
    // A NaN must not pass for a small distance.
    if (!(distance <= largest)) largest = distance;
  }
  return largest;
}
