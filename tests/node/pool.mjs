// conformal-warp/pool under Node: the same answers as without it, from any number of workers.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Worker } from "node:worker_threads";
import init, { FormulaMap, Region, RegionMap, RiemannMap, Texture } from "conformal-warp";
import { createPool } from "conformal-warp/pool";

const square = { boundary: new Float64Array([-1, -1, 1, -1, 1, 1, -1, 1]), center: /** @type {[number, number]} */ ([0, 0]), toward: /** @type {[number, number]} */ ([1, 0]) };
const rgba = Uint8ClampedArray.from({ length: 4 * 64 * 64 }, (_, k) => (k * 37) % 256);
const frame = { center: /** @type {[number, number]} */ ([0, 0]), width: 2, pixels: /** @type {[number, number]} */ ([64, 61]) };
const options = { texture: frame, view: frame };

/** @type {import("conformal-warp/pool").Pool} */
let pool;

before(async () => {
  await init();
  pool = await createPool({ workers: 3 });
});

after(() => pool.close());

test("pictures and points are those of one thread, to the bit", async () => {
  const map = pool.RiemannMap.solve(new pool.Region(square), { tolerance: 1e-6 });
  const alone = RiemannMap.solve(new Region(square), { tolerance: 1e-6 });
  assert.equal(await map.conformalRadius, alone.conformalRadius);
  const points = Float64Array.from({ length: 80_002 }, (_, k) => Math.sin(k));
  assert.deepEqual(await map.toDisk(points), alone.toDisk(points));

  const texture = new pool.Texture(rgba, 64, 64);
  const own = new Texture(rgba, 64, 64);
  for (const quality of /** @type {const} */ (["bilinear", "best"])) {
    assert.deepEqual(await map.warp(texture, { ...options, quality }), alone.warp(own, { ...options, quality }));
  }
  const formula = new pool.FormulaMap("z^2 + t", { params: { t: [0.1, 0] } });
  const expected = new FormulaMap("z^2 + t", { params: { t: [0.1, 0] } });
  const rows = /** @type {[number, number]} */ ([10, 43]);
  assert.deepEqual(await formula.warp(texture, { ...options, rows }), expected.warp(own, { ...options, rows }));
  const out = new Uint8ClampedArray(4 * 64 * 61);
  assert.equal(await formula.warp(texture, { ...options, out }), out);
  assert.deepEqual(out, expected.warp(own, options));
  const prepared = formula.prepareWarp(texture, options);
  assert.deepEqual(await prepared.warp(texture), out);
  const preparedAlone = expected.prepareWarp(own, options);
  assert.deepEqual(await prepared.size, preparedAlone.size);
  assert.ok((await prepared.bytes) > 0.9 * preparedAlone.bytes);
  assert.deepEqual(await formula.overlay({ kind: "polar", view: frame, out: out.slice() }), expected.overlay({ kind: "polar", view: frame, out: out.slice() }));
  for (const wrong of [new Array(4 * 64 * 61).fill(0), "abc", new Uint8Array(4 * 64 * 61), 0]) {
    await assert.rejects(formula.warp(texture, /** @type {any} */ ({ ...options, out: wrong })), { code: "invalid-option", option: "out" });
  }
  await assert.rejects(formula.warp(texture, /** @type {any} */ ({ ...options, rows: [0, 1, 2] })), { code: "invalid-option" });
  assert.deepEqual(await formula.overlay({ kind: "polar", view: frame }), expected.overlay({ kind: "polar", view: frame }));
});

test("what goes wrong is rejected with its code, and the pool works on", async () => {
  const bad = new pool.Region({ ...square, center: [3, 0] });
  await assert.rejects(bad.ready, { code: "center-outside", at: [3, 0] });
  await assert.rejects(bad.boundary, { code: "center-outside" });
  const formula = new pool.FormulaMap("z");
  await assert.rejects(formula.eval(new Float64Array(3)), { code: "wrong-length" });
  await assert.rejects(formula.warp(new pool.Texture(rgba, 64, 64), { ...options, out: new Uint8ClampedArray(1) }), { code: "wrong-length" });
  await assert.rejects(formula.eval(/** @type {any} */ (() => 1)), { code: "invalid-argument" });
  formula.free();
  await assert.rejects(formula.eval(new Float64Array(2)), { code: "freed" });
  await assert.rejects(createPool({ workers: 0 }), { code: "invalid-option" });
  assert.equal((await new pool.FormulaMap("z").eval(new Float64Array([1, 2])))[1], 2);
});

test("one worker solves, and the others get the map", async () => {
  /** @type {string[]} */
  const asked = [];
  const script = new URL(import.meta.resolve("conformal-warp/pool-worker"));
  const other = await createPool({
    workers: 3,
    worker: () => {
      const worker = new Worker(script);
      const post = worker.postMessage.bind(worker);
      worker.postMessage = (message) => {
        if (message.task) asked.push(message.task.key ?? message.task.kind);
        post(message);
      };
      return worker;
    },
  });
  const region = new other.Region(square);
  const map = other.RiemannMap.solve(region, { tolerance: 1e-6 });
  // Used before it is made, and its parts gone before they are used up: what is asked comes in order.
  const between = other.RegionMap.between(map, map);
  const moved = map.withCenter({ center: [0.3, 0.1], toward: [1, 0] });
  region.free();
  map.free();
  const points = Float64Array.from({ length: 80_000 }, (_, k) => Math.sin(k) / 2);
  const alone = RiemannMap.solve(new Region(square), { tolerance: 1e-6 });
  assert.deepEqual(await between.forward(points), RegionMap.between(alone, alone).forward(points));
  assert.deepEqual(await moved.toDisk(points), alone.withCenter({ center: [0.3, 0.1], toward: [1, 0] }).toDisk(points));
  const stored = await moved.toBytes();
  assert.deepEqual(await other.RiemannMap.fromBytes(stored).fromDisk(points), await moved.fromDisk(points));
  for (const key of ["solve", "withCenter"]) assert.equal(asked.filter((task) => task === key).length, 1, key);
  await assert.rejects(other.RiemannMap.solve(new other.Region(square), { tolerance: 7 }).ready, { code: "invalid-option" });
  assert.equal((await new other.FormulaMap("z").eval(new Float64Array([1, 2])))[1], 2);
  other.close();
});

test("a signal aborts, and progress is told", async () => {
  const region = new pool.Region(square);
  const aborted = AbortSignal.abort(new Error("enough"));
  assert.throws(() => pool.RiemannMap.solve(region, { signal: aborted }), /enough/);
  const stages = new Set();
  await pool.RiemannMap.solve(region, { onProgress: (stage) => void stages.add(stage) }).ready;
  assert.ok(stages.size > 0);
  const prepared = pool.RiemannMap.solve(region);
  stages.clear();
  await prepared.prepare((stage) => void stages.add(stage));
  assert.ok(stages.size > 0, "what is prepared tells how far it is");
  await assert.rejects(pool.RiemannMap.solve(region).prepare(() => { throw new Error("mine"); }), /mine/);
  const controller = new AbortController();
  const map = pool.RiemannMap.solve(region, { tolerance: 1e-12, signal: controller.signal });
  controller.abort(new Error("no more"));
  await assert.rejects(map.ready, /no more/);
});

test("closing rejects what is not done, and all that is asked later", async () => {
  const other = await createPool({ workers: 1 });
  const formula = new other.FormulaMap("z");
  const answer = formula.eval(new Float64Array(2));
  other.close();
  await assert.rejects(answer, { code: "pool-closed" });
  await assert.rejects(formula.eval(new Float64Array(2)), { code: "pool-closed" });
  await assert.rejects(new other.FormulaMap("z").ready, { code: "pool-closed" });
  await assert.rejects(other.FormulaMap.fromBytes(new Uint8Array(1)).ready, { code: "pool-closed" });
  formula.free();
  other.close();
});

test("a worker that ends is told, and so is what is no module of the package", async () => {
  const script = new URL(import.meta.resolve("conformal-warp/pool-worker"));
  /** @type {Worker[]} */
  const workers = [];
  const other = await createPool({ workers: 1, worker: () => (workers.push(new Worker(script)), workers[0]) });
  await workers[0].terminate();
  await assert.rejects(new other.FormulaMap("z").eval(new Float64Array(2)), { code: "pool-failed" });
  await assert.rejects(createPool({ workers: 1, worker: () => new Worker("process.exit(1)", { eval: true }) }), { code: "pool-failed" });
});

test("wrong calls are told as without a pool", async () => {
  const call = /** @type {any} */ (createPool);
  for (const options of [4, { threads: 4 }, { worker: 4 }, { worker: () => ({}), workers: 1 }, { workers: "4" }, { workers: 257 }]) {
    await assert.rejects(call(options), (/** @type {any} */ error) => /^invalid-(option|argument)$/.test(error.code) && error.message.endsWith("."));
  }
  const classes = /** @type {any} */ (pool);
  assert.throws(() => classes.FormulaMap("z"), { code: "no-constructor" });
  assert.throws(() => new classes.RiemannMap(), { code: "no-constructor" });
  const formula = new classes.FormulaMap("z");
  const texture = new classes.Texture(rgba, 64, 64);
  for (const signal of [1, Object.create(null), Symbol("no")]) {
    await assert.rejects(formula.warp(texture, { ...options, signal }), { code: "invalid-option", option: "signal" });
  }
  await assert.rejects(formula.warp(new Texture(rgba, 64, 64), options), { code: "invalid-argument" });
  assert.throws(() => classes.RiemannMap.solve(new classes.Region(square), { onProgress: 3 }), { code: "invalid-option", option: "onProgress" });
  const other = await createPool({ workers: 1 });
  await assert.rejects(formula.warp(new other.Texture(rgba, 64, 64), options), { code: "invalid-argument" });
  other.close();
});

test("looking at an object asks its workers for nothing", async () => {
  const other = await createPool({ workers: 1 });
  const formula = /** @type {any} */ (new other.FormulaMap("z"));
  for (const key of ["toJSON", "nope", "constructor", "paint", "hasOwnProperty"]) assert.equal(formula[key], undefined, key);
  assert.equal(await formula.text, "z");
  other.close();
});

test("onProgress of a pool may be async, and what it throws is thrown on", async () => {
  const region = new pool.Region(square);
  const call = (/** @type {() => unknown} */ onProgress) => pool.RiemannMap.solve(region, /** @type {any} */ ({ onProgress })).ready;
  await assert.rejects(call(() => { throw new Error("mine"); }), /mine/);
  await assert.rejects(call(async () => { throw new Error("mine, later"); }), /mine, later/);
  await call(async () => undefined);
});
