// The package without a bundler: Node, Deno, Bun, plain modules and workers in a browser, runtimes that are handed a module.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { createContext, runInContext } from "node:vm";
import { closeBrowser, resultIn } from "./support/browser.mjs";
import { POOLED, WORK, program, project, run, unpacked } from "./support/project.mjs";

/** @type {string} */
let expected;

before(async () => {
  expected = (await run(project("node-import"), [process.execPath, "main.js"])).trim();
});

after(closeBrowser);

test("require under Node, for both entries", async () => {
  for (const entry of ["conformal-warp", "conformal-warp/inline"]) {
    const main = `
      ${WORK.replace("export", "")}
      const warp = require("${entry}");
      warp.init().then(() => console.log(work(warp)));`;
    const folder = project("node-require", entry, { "main.cjs": main });
    assert.equal((await run(folder, [process.execPath, "main.cjs"])).trim(), expected, entry);
  }
});

const binaries = {
  deno: [program("@deno/linux-x64-glibc/deno"), "run", "--allow-read", "--allow-env"],
  bun: [program("@oven/bun-linux-x64/bin/bun"), "run"],
};

test("Deno and Bun", async () => {
  for (const [name, command] of Object.entries(binaries)) {
    assert.ok(existsSync(command[0]), `${name} is not installed`);
    for (const entry of ["conformal-warp", "conformal-warp/inline"]) {
      assert.equal((await run(project(name, entry), [...command, "main.js"])).trim(), expected, `${name}, ${entry}`);
    }
  }
});

const map = '<script type="importmap">{ "imports": { "conformal-warp": "./node_modules/conformal-warp/pkg/index.js" } }</script>';

test("plain modules in a browser, on the page and in a worker", async () => {
  const inWorker = `
    import init, * as warp from "./node_modules/conformal-warp/pkg/index.js";
    import { work } from "./work.js";
    await init();
    postMessage(work(warp));`;
  const folder = project("plain", "conformal-warp", {
    "index.html": `<!doctype html><meta charset="utf-8">${map}<script type="module" src="./main.js"></script>`,
    "worker.html": '<!doctype html><meta charset="utf-8"><script>new Worker("./worker.js", { type: "module" }).onmessage = ({ data }) => (window.result = data);</script>',
    "worker.js": inWorker,
  });
  assert.equal(await resultIn(folder), expected);
  assert.equal(await resultIn(folder, "worker.html"), expected);
});

test("a pool, under Node, Deno and Bun and on a page without isolation", async () => {
  const folder = project("pool", undefined, {
    "main.js": POOLED,
    "index.html": `<!doctype html><meta charset="utf-8">${map.replace(" } }", ', "conformal-warp/pool": "./node_modules/conformal-warp/pkg/pool.js" } }')}<script type="module" src="./main.js"></script>`,
  });
  assert.equal((await run(folder, [process.execPath, "main.js"])).trim(), expected);
  for (const command of Object.values(binaries)) assert.equal((await run(folder, [...command, "main.js"])).trim(), expected, command[0]);
  assert.equal(await resultIn(folder), expected);
  const required = POOLED.replace(/import .* from "conformal-warp\/pool";/, 'const { createPool } = require("conformal-warp/pool");').replace(/import .*work.js";/, "");
  assert.equal((await run(project("pool-require", undefined, { "main.cjs": required }), [process.execPath, "main.cjs"])).trim(), expected);
});

test("a content security policy of 'self' and 'wasm-unsafe-eval' is enough; without the latter a sentence says so", async () => {
  const page = (/** @type {string} */ policy) =>
    `<!doctype html><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="${policy}"><script type="module" src="./main.js"></script>`;
  const folder = project("csp", "./node_modules/conformal-warp/pkg/index.js", {
    "index.html": page("default-src 'self'; script-src 'self' 'wasm-unsafe-eval'"),
    "strict.html": page("default-src 'self'; script-src 'self'"),
  });
  assert.equal(await resultIn(folder), expected);
  assert.match(await resultIn(folder, "strict.html"), /^not-wasm: .*may not be compiled here/);
});

test("a runtime without files, fetch and process is handed the module", async () => {
  const globals = { TextDecoder, TextEncoder, WebAssembly, FinalizationRegistry };
  const context = createContext({ ...globals, module: { exports: {} } });
  runInContext(readFileSync(join(unpacked, "pkg", "index.cjs"), "utf8"), context);
  const warp = /** @type {any} */ (context).module.exports;
  await assert.rejects(warp.init(), { code: "load-failed" });
  const module = await WebAssembly.compile(readFileSync(join(unpacked, "pkg", "conformal_warp_bg.wasm")));
  await warp.init(module);
  runInContext(`${WORK.replace("export", "")}; result = work(module.exports)`, context);
  assert.equal(/** @type {any} */ (context).result, expected);
});
