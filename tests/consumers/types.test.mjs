// The package's types, unskipped, under every way of resolving modules, with and without the DOM.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { root } from "../../tools/steps.mjs";
import { program, project, run } from "./support/project.mjs";

const compilers = { "TypeScript 5.9": program("typescript/bin/tsc"), "TypeScript 7": join(root, "node_modules", "typescript", "bin", "tsc") };
const resolutions = /** @type {const} */ ([["node16", "node16"], ["esnext", "bundler"], ["esnext", "node10"]]);
const libraries = [["esnext"], ["es2022"], ["esnext", "dom"], ["esnext", "webworker"]];

for (const [name, compiler] of Object.entries(compilers)) {
  for (const [module, moduleResolution] of resolutions) {
    // TypeScript 7 has given up the last.
    if (name === "TypeScript 7" && moduleResolution === "node10") continue;
    test(`${name}, ${moduleResolution}`, async () => {
      const names = ["use.ts", "dom.ts", "cjs.cts"];
      const source = (/** @type {string} */ file) => readFileSync(new URL(`types/${file}`, import.meta.url), "utf8");
      const folder = project(`types-${name}-${moduleResolution}`.replaceAll(" ", "-"), undefined, Object.fromEntries(names.map((file) => [file, source(file)])));
      for (const lib of libraries) {
        const files = ["use.ts", ...(lib.includes("dom") ? ["dom.ts"] : []), ...(module === "node16" ? ["cjs.cts"] : [])];
        const compilerOptions = { module, moduleResolution, lib, target: "es2022", types: [], strict: true, skipLibCheck: false, noEmit: true };
        writeFileSync(join(folder, "tsconfig.json"), JSON.stringify({ compilerOptions, files }));
        await assert.doesNotReject(run(folder, [process.execPath, compiler, "-p", "."]), lib.join(", "));
      }
    });
  }
}
