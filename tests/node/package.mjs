// The npm package as a consumer under Node meets it: loading, and what misuse says.

import assert from "node:assert/strict";
import { cp, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { isDeepStrictEqual } from "node:util";
import init, { Region, initSync } from "conformal-warp";

const square = () => ({
  boundary: new Float64Array([-1, -1, 1, -1, 1, 1, -1, 1]),
  center: /** @type {[number, number]} */ ([0, 0]),
  toward: /** @type {[number, number]} */ ([1, 0]),
});

const pkg = fileURLToPath(new URL("../../pkg", import.meta.url));

/** A copy of the package in which nothing is loaded yet. @returns {Promise<typeof import("conformal-warp")>} */
async function freshCopy(/** @type {import("node:test").TestContext} */ context) {
  const folder = await mkdtemp(join(tmpdir(), "conformal-warp-"));
  context.after(() => rm(folder, { recursive: true }));
  await cp(pkg, folder, { recursive: true });
  await writeFile(join(folder, "package.json"), '{ "type": "module" }');
  return import(pathToFileURL(join(folder, "index.js")).href);
}

test("calls before init() say so", () => {
  const notInitialized = { code: "not-initialized", message: /await init\(\) first/ };
  assert.throws(() => new Region(square()), notInitialized);
  assert.throws(() => initSync(/** @type {any} */ (undefined)), TypeError);
});

test("a failed init() can be repeated, and two at once load one module", async () => {
  await assert.rejects(init(new Uint8Array([1, 2, 3])), WebAssembly.CompileError);
  const [first, second] = await Promise.all([init(), init()]);
  assert.equal(first, second);
  assert.equal(await init(), first);
  assert.equal(new Region(square()).boundary.length, 8);
});

test("init() takes an address, bytes, a response or a module; initSync() the latter two", async (context) => {
  const url = pathToFileURL(join(pkg, "conformal_warp_bg.wasm"));
  const bytes = await readFile(url);
  const module = await WebAssembly.compile(bytes);
  const response = new Response(bytes, { headers: { "Content-Type": "application/wasm" } });
  for (const source of [url, url.href, bytes, response, Promise.resolve(url), module]) {
    const copy = await freshCopy(context);
    await copy.default(source);
    assert.equal(new copy.Region(square()).boundary.length, 8);
  }
  for (const source of [bytes, module]) {
    const copy = await freshCopy(context);
    const output = copy.initSync(source);
    assert.equal(new copy.Region(square()).boundary.length, 8);
    assert.equal(await copy.default(), output);
  }
});

test("init() pending and initSync() keep one instance; a wrong source is said in a sentence with a code", async (context) => {
  const bytes = await readFile(join(pkg, "conformal_warp_bg.wasm"));
  const copy = await freshCopy(context);
  const pending = copy.default();
  const output = copy.initSync(bytes);
  const region = new copy.Region(square());
  assert.equal(await pending, output);
  assert.equal(region.boundary.length, 8);

  const other = await freshCopy(context);
  const page = new Response("<!doctype html>", { headers: { "Content-Type": "text/html" } });
  await assert.rejects(other.default(page), { code: "load-failed", message: /what came is text\/html.*conformal-warp\/inline/ });
  await assert.rejects(other.default(new Response("", { status: 404 })), { code: "load-failed", message: /404/ });
  await assert.rejects(other.default(pathToFileURL("/none.wasm")), { code: "load-failed" });
  await assert.rejects(other.default(/** @type {any} */ (7)), { code: "invalid-argument" });
  const empty = new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]);
  await assert.rejects(other.default(empty), { code: "not-wasm" });
  assert.throws(() => other.initSync(empty), { code: "not-wasm" });
  await other.default();
});

test("after a crash nothing answers until init.reset(), and what was made before stays gone", async (context) => {
  const copy = await freshCopy(context);
  const { memory } = await copy.default();
  const region = new copy.Region(square());
  const map = copy.RiemannMap.solve(region);
  // A stack that overflows traps in the module, as a fault of its own would.
  const dive = (/** @type {number} */ depth) => {
    copy.RiemannMap.solve(region, { onProgress: () => dive(depth + 1) });
  };
  assert.throws(() => dive(0), { code: "crashed", message: /await init\.reset\(\)/ });
  for (const call of [() => map.toDisk(new Float64Array(2)), () => new copy.Region(square()), () => copy.presets()]) {
    assert.throws(call, { code: "crashed" });
  }
  const again = await copy.default.reset();
  assert.notEqual(again.memory, memory);
  assert.throws(() => map.unknowns, { code: "stale" });
  assert.throws(() => copy.RiemannMap.solve(region), { code: "stale" });
  map.free();
  assert.equal(copy.RiemannMap.solve(new copy.Region(square())).angles.length, 4);
});

test("use after free says so; freeing twice is harmless", async () => {
  await init();
  const region = new Region(square());
  region.free();
  region.free();
  const freed = { code: "freed", message: /This Region was freed/ };
  assert.throws(() => region.boundary, freed);
  assert.throws(() => region.contains(new Float64Array(2)), freed);

  const disposed = new Region(square());
  disposed[Symbol.dispose]();
  assert.throws(() => disposed.center, freed);
});

test("classes behave as classes", async () => {
  await init();
  const region = new Region(square());
  assert.ok(region instanceof Region);
  assert.equal(region.constructor, Region);
  assert.equal(region.constructor.name, "Region");
  assert.throws(() => /** @type {any} */ (Region)(square()), TypeError);
  assert.throws(() => /** @type {any} */ (Region)(square()), { code: "no-constructor", message: "A Region is not made by Region() but by new Region()." });
});

test("errors are Errors with a code and a position", async () => {
  await init();
  assert.throws(
    () => new Region({ ...square(), center: [3, 0] }),
    (error) => error instanceof Error && isDeepStrictEqual({ ...error }, { code: "center-outside", at: [3, 0] }),
  );
});
