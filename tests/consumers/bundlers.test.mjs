// The package, bundled by what people bundle with, and run.

import assert from "node:assert/strict";
import { cpSync, existsSync, mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { closeBrowser, resultAt, resultIn } from "./support/browser.mjs";
import { POOLED, WORK, program, project, run, tool, unpacked } from "./support/project.mjs";

/** What Node computes from the same files. @type {string} */
let expected;
/** The same without regions. @type {string} */
let expectedFormula;

before(async () => {
  const folder = project("reference");
  expected = (await run(folder, [process.execPath, "main.js"])).trim();
  assert.match(expected, /^1\.0787052024 \d+$/);
  expectedFormula = expected.replace(/^\S+/, "0.0000000000");
});

after(closeBrowser);

const entries = ["conformal-warp", "conformal-warp/inline", "conformal-warp/formula"];
const short = (/** @type {string} */ entry) => entry.replaceAll("/", "-");
const wanted = (/** @type {string} */ entry) => (entry.endsWith("formula") ? expectedFormula : expected);

for (const version of ["vite5", "vite6", "vite7", "vite8"]) {
  test(`${version}: development server and build`, async () => {
    const { build, createServer } = await tool(version);
    for (const entry of [...entries, "conformal-warp/pool"]) {
      const folder = project(`${version}-${short(entry)}`, entry, pooled(entry));
      const server = await createServer({ root: folder, configFile: false, logLevel: "error", server: { port: 0, host: "127.0.0.1" } });
      await server.listen();
      try {
        assert.equal(await resultAt(server.resolvedUrls.local[0]), wanted(entry), `${entry}, development`);
      } finally {
        await server.close();
      }
      await build({ root: folder, configFile: false, logLevel: "error" });
      assert.equal(await resultIn(join(folder, "dist")), wanted(entry), `${entry}, built`);
    }
  });
}

test("webpack 5", async () => {
  const { default: webpack } = await tool("webpack");
  for (const entry of [...entries, "conformal-warp/pool"]) {
    const folder = project(`webpack-${short(entry)}`, entry, pooled(entry));
    const output = { path: join(folder, "dist"), filename: "main.js" };
    const stats = await new Promise((resolve, reject) =>
      webpack({ mode: "production", context: folder, entry: "./main.js", output, performance: false }, (/** @type {any} */ error, /** @type {any} */ done) =>
        error ? reject(error) : resolve(done),
      ),
    );
    assert.ok(!stats.hasErrors() && !stats.hasWarnings(), stats.toString());
    page(join(folder, "dist"));
    assert.equal(await resultIn(join(folder, "dist")), wanted(entry), entry);
  }
});

test("esbuild for browsers: inline as it is, the main entry with its file beside the bundle, or a sentence", async () => {
  const { build } = await tool("esbuild");
  for (const entry of entries) {
    const folder = project(`esbuild-${short(entry)}`, entry);
    const outdir = join(folder, "dist");
    await build({ absWorkingDir: folder, entryPoints: ["main.js"], bundle: true, format: "esm", outdir, logLevel: "error" });
    page(outdir);
    if (!entry.endsWith("inline")) {
      const advice = await resultIn(outdir);
      assert.match(advice, /^load-failed: The module is not at http.*import "conformal-warp(\/formula)?\/inline"/);
      besides(entry, outdir);
    }
    assert.equal(await resultIn(outdir), wanted(entry), entry);
  }
});

test("esbuild for Node, as modules and as CommonJS", async () => {
  const { build } = await tool("esbuild");
  for (const entry of entries) {
    for (const format of ["esm", "cjs"]) {
      const folder = project(`esbuild-node-${format}-${short(entry)}`, entry);
      const outfile = join(folder, "dist", format === "esm" ? "main.mjs" : "main.cjs");
      const result = await build({ absWorkingDir: folder, entryPoints: ["main.js"], bundle: true, platform: "node", format, outfile, logLevel: "silent" });
      assert.deepEqual(result.errors, []);
      assert.equal((await run(folder, [process.execPath, outfile])).trim(), wanted(entry), `${entry}, ${format}`);
    }
  }
});

test("rollup", async () => {
  const { rollup } = await tool("rollup");
  const { default: nodeResolve } = await tool("@rollup/plugin-node-resolve");
  for (const entry of entries) {
    const folder = project(`rollup-${short(entry)}`, entry);
    const bundle = await rollup({ input: join(folder, "main.js"), plugins: [nodeResolve({ browser: true })] });
    await bundle.write({ dir: join(folder, "dist"), format: "es" });
    page(join(folder, "dist"));
    if (!entry.endsWith("inline")) besides(entry, join(folder, "dist"));
    assert.equal(await resultIn(join(folder, "dist")), wanted(entry), entry);
  }
});

test("Parcel", async () => {
  const folder = project("parcel");
  const parcel = program("parcel/lib/bin.js");
  await run(folder, [process.execPath, parcel, "build", "index.html", "--no-cache", "--no-source-maps", "--no-autoinstall", "--public-url", "./"]);
  assert.equal(await resultIn(join(folder, "dist")), expected);
});

test("Jest, as people have it set up, under Node and jsdom", async () => {
  const check = `
    test("it computes", async () => {
      const warp = require("ENTRY");
      await warp.init();
      expect(require("./work.cjs").work(warp)).toBe("${expected}");
      expect(() => new warp.Region({ boundary: [1] })).toThrow(/The option "center" is missing/);
    });`;
  const folder = project("jest", undefined, {
    "main.test.cjs": check.replace("ENTRY", "conformal-warp"),
    "inline.test.cjs": check.replace("ENTRY", "conformal-warp/inline"),
    "jsdom.test.cjs": `/** @jest-environment jsdom */\n${check.replace("ENTRY", "conformal-warp/inline")}`,
    "jsdom-main.test.cjs": `/** @jest-environment jsdom */\n${check.replace("ENTRY", "conformal-warp")}`,
    "work.cjs": workAsCommonJs(),
    "jest.config.json": '{ "testMatch": ["**/*.test.cjs"] }',
  });
  await run(folder, [process.execPath, program("jest/bin/jest.js"), "--ci", "--config", "jest.config.json"], { CI: "true" });
});

test("Vitest", async () => {
  const folder = project("vitest", undefined, {
    "main.test.js": `
      import { expect, test } from "vitest";
      import init, * as warp from "conformal-warp";
      import { work } from "./work.js";
      test("it computes", async () => {
        await init();
        expect(work(warp)).toBe("${expected}");
      });`,
  });
  await run(folder, [process.execPath, program("vitest/vitest.mjs"), "run", "--root", folder], { CI: "true" });
});

/** @param {string} entry @returns {Record<string, string>} */
function pooled(entry) {
  return entry.endsWith("pool") ? { "main.js": POOLED } : {};
}

/** The page of a bundle. @param {string} folder */
function page(folder) {
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, "index.html"), '<!doctype html><meta charset="utf-8"><script type="module" src="./main.js"></script>');
}

/**
 * Puts the .wasm beside a bundle, as the README says.
 *
 * @param {string} entry
 * @param {string} folder
 */
function besides(entry, folder) {
  const name = entry.endsWith("formula") ? "formula_bg.wasm" : "conformal_warp_bg.wasm";
  const file = join(unpacked, "pkg", entry.endsWith("formula") ? "formula" : "", name);
  assert.ok(existsSync(file));
  cpSync(file, join(folder, name));
}

function workAsCommonJs() {
  return WORK.replace("export function work", "exports.work = function work");
}
