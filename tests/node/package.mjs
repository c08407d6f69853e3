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
  assert.equal(region.constructor.name, "Region");
  assert.throws(() => /** @type {any} */ (Region)(square()), TypeError);
});

test("errors are Errors with a code and a position", async () => {
  await init();
  assert.throws(
    () => new Region({ ...square(), center: [3, 0] }),
    (error) => error instanceof Error && isDeepStrictEqual({ ...error }, { code: "center-outside", at: [3, 0] }),
  );
});
