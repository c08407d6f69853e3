// The code of docs/RECIPES.md runs as it stands, with the package from its tarball.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { cpSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";
import { root } from "../../tools/steps.mjs";
import { closeBrowser, resultIn } from "./support/browser.mjs";
import { answer, freePort } from "./support/ports.mjs";
import { project, tool, unpacked, work } from "./support/project.mjs";

after(closeBrowser);

/** The blocks of code by the heading that they stand under. @type {Record<string, string[]>} */
const blocks = {};
for (const part of readFileSync(join(root, "docs", "RECIPES.md"), "utf8").split(/^## /m).slice(1)) {
  const [heading] = part.split("\n");
  blocks[heading] = [...part.matchAll(/```\w+\n([\s\S]*?)```/g)].map(([, code]) => code);
}
const used = new Set();

/** @param {string} heading @param {number} count of blocks that it must have */
function recipe(heading, count) {
  used.add(heading);
  assert.equal(blocks[heading]?.length, count, heading);
  return blocks[heading];
}

const page = '<!doctype html><meta charset="utf-8"><body></body><script type="module" src="./main.js"></script>';
/** An `image`, and the `told` size and number of byte values of what a canvas shows once it is drawn. */
const IMAGE = `
const image = new ImageData(new Uint8ClampedArray(4 * 64 * 64).map((_, k) => (k % 4 === 3 ? 255 : (k * 37) % 256)), 64, 64);
async function tell() {
  for (let wait = 0; wait < 100; wait++) {
    const canvas = document.querySelector("canvas");
    const data = canvas?.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    if (data?.some((byte) => byte > 0)) return (globalThis.result = [canvas.width, new Set(data).size > 50]);
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
}`;

/**
 * Bundles for a browser, with the .wasm beside the bundle, and runs.
 *
 * @param {string} folder
 * @param {object} [options] of esbuild
 */
async function bundled(folder, options) {
  const { build } = await tool("esbuild");
  const outdir = join(folder, "dist");
  const nodePaths = [join(work, "node_modules")];
  await build({ absWorkingDir: folder, entryPoints: ["main.js"], bundle: true, format: "esm", outdir, nodePaths, logLevel: "error", ...options });
  cpSync(join(unpacked, "pkg", "conformal_warp_bg.wasm"), join(outdir, "conformal_warp_bg.wasm"));
  writeFileSync(join(outdir, "index.html"), page);
  return resultIn(outdir);
}

test("React", async () => {
  const [component] = recipe("React", 1);
  const folder = project("recipe-react", undefined, {
    "warped.jsx": component,
    "main.js": `
      import { createElement } from "react";
      import { createRoot } from "react-dom/client";
      import { Warped } from "./warped.jsx";
      ${IMAGE}
      createRoot(document.body).render(createElement(Warped, { image, formula: "z^2" }));
      tell();`,
  });
  assert.deepEqual(await bundled(folder, { jsx: "automatic", define: { "process.env.NODE_ENV": '"production"' } }), [512, true]);
});

test("Svelte", async () => {
  const [component] = recipe("Svelte", 1);
  const { compile } = await tool("svelte/compiler");
  const { js, warnings } = compile(component, { generate: "client", filename: "Warped.svelte" });
  assert.deepEqual(warnings, []);
  const folder = project("recipe-svelte", undefined, {
    "warped.js": js.code,
    "main.js": `
      import { mount } from "svelte";
      import Warped from "./warped.js";
      ${IMAGE}
      mount(Warped, { target: document.body, props: { image, formula: "1/z" } });
      tell();`,
  });
  assert.deepEqual(await bundled(folder, { conditions: ["browser"] }), [512, true]);
});

const map = '<script type="importmap">{ "imports": { "conformal-warp": "./node_modules/conformal-warp/pkg/index.js", "npm:conformal-warp/inline": "./node_modules/conformal-warp/pkg/inline.js" } }</script>';

test("a worker of one's own", async () => {
  const [worker, main] = recipe("A worker of your own", 2);
  const folder = project("recipe-worker", undefined, {
    // Import maps do not reach into workers; bundlers do.
    "worker.js": worker.replace('"conformal-warp"', '"./node_modules/conformal-warp/pkg/index.js"'),
    "main.js": `${main}\nconst wait = setInterval(() => globalThis.image && (clearInterval(wait), (globalThis.result = [image.width, new Set(image.data).size > 50])), 50);`,
    "index.html": page,
  });
  assert.deepEqual(await resultIn(folder), [64, true]);
});

test("storing a solve", async () => {
  const [browser] = recipe("Storing a solve", 1);
  const folder = project("recipe-store", undefined, {
    "main.js": `${browser}\nglobalThis.result = [first.conformalRadius, again.conformalRadius, first === again, (await new Promise((resolve) => (store("readonly").get("square").onsuccess = ({ target }) => resolve(target.result)))).length];`,
    "index.html": page.replace("<body>", `${map}<body>`),
  });
  const [first, again, same, bytes] = /** @type {[number, number, boolean, number]} */ (await resultIn(folder));
  assert.ok(first === again && !same && bytes > 500, `${first}, ${again}, ${bytes} bytes`);
});

test("a service under Node", async () => {
  const [service] = recipe("A service under Node", 1);
  const port = await freePort();
  const folder = project("recipe-service", undefined, { "main.js": service });
  const child = spawn(process.execPath, ["main.js"], { cwd: folder, env: { ...process.env, PORT: String(port) }, stdio: "inherit" });
  try {
    const at = (/** @type {string} */ formula) => `http://127.0.0.1:${port}/?f=${encodeURIComponent(formula)}`;
    const picture = await answer(at("sin(z)/z"));
    assert.equal(picture.headers.get("content-type"), "image/png");
    const png = Buffer.from(await picture.arrayBuffer());
    assert.equal(png.subarray(1, 4).toString(), "PNG");
    assert.deepEqual([png.readUInt32BE(16), png.readUInt32BE(20)], [256, 256]);
    const refused = await fetch(at("sin("));
    assert.equal(refused.status, 400);
    assert.equal(/** @type {any} */ (await refused.json()).code, "syntax");
  } finally {
    child.kill();
  }
});

test("Observable", async () => {
  const [cell] = recipe("Observable", 1);
  const folder = project("recipe-observable", undefined, {
    "main.js": `const display = (element) => document.body.append(element);\n${cell}\nconst data = canvas.getContext("2d").getImageData(0, 0, size, size).data;\nglobalThis.result = [canvas.isConnected, new Set(data).size > 50];`,
    "index.html": page.replace("<body>", `${map}<body>`),
  });
  assert.deepEqual(await resultIn(folder), [true, true]);
});

test("a content security policy", async () => {
  const [html] = recipe("A content security policy", 1);
  const folder = project("recipe-csp", "./node_modules/conformal-warp/pkg/index.js", { "index.html": html });
  assert.match(/** @type {string} */ (await resultIn(folder)), /^1\.0787052024 \d+$/);
});

test("no recipe is left out", () => {
  // Next builds in next.test.mjs.
  assert.deepEqual(Object.keys(blocks).filter((heading) => !used.has(heading) && heading !== "Next"), []);
});
