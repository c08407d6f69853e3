// Level lines as JavaScript sees them: flat points, where lines begin, their values, paths.

import assert from "node:assert/strict";
import { test } from "node:test";
import init, { AnnulusMap, ChannelFlow, Electrostatics, PotentialFlow, Region } from "conformal-warp";

await init();

const square = (/** @type {number} */ half) => new Float64Array([-half, -half, half, -half, half, half, -half, half]);
const frame = () => new Region({ boundary: square(1), holes: [square(0.5)] });
const window = { center: /** @type {[number, number]} */ ([0, 0]), width: 6, pixels: /** @type {[number, number]} */ ([600, 600]) };

/** The points of line `k`. @param {import("conformal-warp").LevelLines} lines @param {number} k */
const line = (lines, k) => lines.points.slice(2 * lines.starts[k], 2 * lines.starts[k + 1]);

/** @param {import("conformal-warp").LevelLines} lines */
const holdsTogether = (lines) => {
  assert.equal(lines.starts.length, lines.length + 1);
  assert.equal(lines.levels.length, lines.length);
  assert.equal(lines.closed.length, lines.length);
  assert.equal(lines.starts[lines.length] * 2, lines.points.length);
  assert.ok(lines.length > 0 && lines.points.every(Number.isFinite));
};

test("circles and rays of a ring", () => {
  const map = AnnulusMap.solve(frame());
  const circles = map.levelLines("circles", new Float64Array([0.6, 0.8]));
  holdsTogether(circles);
  assert.deepEqual([...circles.closed], [1, 1]);
  for (const [k, level] of circles.levels.entries()) {
    const images = map.toAnnulus(line(circles, k));
    for (let j = 0; j < images.length; j += 2) assert.ok(Math.abs(Math.hypot(images[j], images[j + 1]) - level) < 1e-7);
  }
  const rays = map.levelLines("rays", new Float64Array([1]));
  holdsTogether(rays);
  assert.deepEqual([...rays.closed], [0]);
  const images = map.toAnnulus(line(rays, 0));
  for (let j = 0; j < images.length; j += 2) assert.ok(Math.abs(Math.atan2(images[j + 1], images[j]) - 1) < 1e-7);
  const path = circles.svgPath(window);
  assert.equal(path.match(/M/gi)?.length, 2);
  assert.equal(path.match(/Z/gi)?.length, 2);
  assert.throws(() => map.levelLines(/** @type {any} */ ("squares"), new Float64Array([1])), { code: "invalid-argument" });
});

test("equal potentials and lines of force", () => {
  const field = Electrostatics.solve(frame(), { potentials: [0, 1] });
  const lines = field.levelLines(new Float64Array([0.25, 0.5]), window);
  holdsTogether(lines);
  for (const [k, level] of lines.levels.entries()) {
    assert.ok(field.potential(line(lines, k)).every((value) => Math.abs(value - level) < 1e-6));
  }
  const force = field.forceLines(12, window);
  holdsTogether(force);
  const along = field.potential(line(force, 0)).filter((value) => !Number.isNaN(value));
  assert.ok(along.length > 2 && along.every((value, k) => k === 0 || value < along[k - 1] + 1e-9), "they fall with the field");
});

test("streamlines", () => {
  const region = Region.exterior({ holes: [square(1)] });
  const flow = PotentialFlow.past(region, { angle: 0.2 });
  const lines = flow.levelLines("streamlines", new Float64Array([-1, 1]), window);
  holdsTogether(lines);
  for (const [k, level] of lines.levels.entries()) {
    const misses = [...flow.stream(line(lines, k))].map((value) => Math.abs(value - level));
    // The ends are where the last chord leaves the frame.
    assert.ok(misses.slice(1, -1).every((miss) => miss < 1e-9) && misses.every((miss) => miss < 1e-4), `${Math.max(...misses)}`);
  }
});

test("vortices and sources", () => {
  const region = Region.exterior({ holes: [square(1)] });
  const at = /** @type {[number, number]} */ ([2, 0.5]);
  const flow = PotentialFlow.past(region, { speed: 0, vortices: [{ at, circulation: 3 }] }, { tolerance: 1e-9 });
  const lines = flow.levelLines("streamlines", flow.stream(new Float64Array([2.3, 0.5])), window);
  assert.deepEqual([...lines.closed], [1], "around the vortex");
  const drift = flow.drift;
  assert.equal(drift.length, 2);
  assert.ok(drift[1] < -0.01, "down along the wall, which answers it");
  const stronger = flow.again({ speed: 0, vortices: [{ at, circulation: 6 }] }).drift;
  assert.ok(Math.abs(stronger[1] - 2 * drift[1]) < 1e-9);
  assert.ok(Math.abs(flow.again({ speed: 0 }).drift[1] - drift[1]) < 1e-12, "it stays");
  const basin = new Region({ boundary: square(1), center: [0, 0], toward: [1, 0] });
  const sources = [{ at: /** @type {[number, number]} */ ([-0.5, 0]), strength: 2 }, { at: /** @type {[number, number]} */ ([0.5, 0.2]), strength: -2 }];
  const through = PotentialFlow.past(basin, { sources }, { tolerance: 1e-9 });
  assert.deepEqual([...through.circulation], []);
  assert.ok(through.velocity(new Float64Array([0, 0.1]))[0] > 0.5);
  assert.ok(Math.abs(through.velocity(new Float64Array([0.3, 1]))[1]) < 1e-6, "along the wall");
  const streamlines = through.levelLines("streamlines", new Float64Array([0]), { center: [0, 0], width: 2, pixels: [100, 100] });
  holdsTogether(streamlines);
});

test("a channel", () => {
  const region = new Region({ boundary: new Float64Array([0, 2, 0, 0, 2, 0, 2, 1, 1, 1, 1, 2]), center: [0.5, 0.5], toward: [0, 0] });
  const flow = ChannelFlow.solve(region, { corners: [[1, 2], [0, 2], [2, 0], [2, 1]], flux: 2 }, { tolerance: 1e-10 });
  // A bend is as long as 1 − (2/π) log 2 of its width, but for e^(−2π) of what its short legs change.
  assert.ok(Math.abs(flow.potentialDifference / 2 - (3 - (2 / Math.PI) * Math.LN2)) < 1e-3, `${flow.potentialDifference}`);
  assert.equal(flow.speed, 2);
  const streamlines = flow.levelLines("streamlines", new Float64Array([0, 0.5, 1, 3]));
  holdsTogether(streamlines);
  assert.equal(streamlines.length, 3, "there is no ψ beyond the flux");
  for (const [k, level] of streamlines.levels.entries()) {
    assert.ok(flow.stream(line(streamlines, k)).every((psi) => Math.abs(psi - level) < 1e-8));
  }
  const potentials = flow.levelLines("potentials", new Float64Array([1]));
  holdsTogether(potentials);
  const values = flow.potential(line(potentials, 0));
  assert.ok(values.every((value, k) => k % 2 === 1 || Math.abs(value - 1) < 1e-8));
  const [u, v] = flow.velocity(new Float64Array([0.5, 1.9]));
  assert.ok(v < -1.9 && Math.abs(u) < 0.1, "down the first leg");
  assert.ok(Math.abs(flow.pressure(new Float64Array([0.5, 1.9]))[0] - (1 - (u * u + v * v) / 4)) < 1e-12);
  assert.equal(ChannelFlow.solve(region, { ends: [[0.5, 2], [2, 0.5]] }).potentialDifference, Infinity);
  const holed = new Region({ boundary: square(1), holes: [square(0.5)] });
  assert.throws(() => ChannelFlow.solve(holed, { ends: [[-1, 0], [1, 0]] }), { code: "wrong-region" });
});
