// The code of the README runs as it stands, with the package from its tarball.

import assert from "node:assert/strict";
import { copyFileSync, mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";
import { root } from "../../tools/steps.mjs";
import { closeBrowser, resultIn } from "./support/browser.mjs";
import { project, run, tool } from "./support/project.mjs";

after(closeBrowser);

const { PNG } = await tool("pngjs");

const readme = readFileSync(join(root, "README.md"), "utf8");
const blocks = [...readme.matchAll(/```js\n([\s\S]*?)```/g)].map(([, code]) => code);

test("the README has code for a canvas, Node, a region, curves, holes, quadrilaterals and a pool", () => assert.equal(blocks.length, 7));

/**
 * A project with a photo that has `code` as its main.js; what it has drawn is looked at.
 *
 * @param {string} name
 * @param {string} code
 * @param {string} scripts
 */
function painting(name, code, scripts) {
  const digest = "const bytes = context.getImageData(0, 0, width, height).data; globalThis.result = [width, new Set(bytes).size > 50];";
  const html = `<!doctype html><meta charset="utf-8"><title>README</title><body>${scripts}</body>`;
  const folder = project(name, undefined, { "main.js": `${code}\n${digest}`, "index.html": html });
  mkdirSync(join(folder, "public"));
  for (const place of [folder, join(folder, "public")]) copyFileSync(join(root, "www", "images", "coffee.jpg"), join(place, "photo.jpg"));
  return folder;
}

/** @param {string} folder */
async function assertDrawn(folder) {
  const [width, varied] = /** @type {[number, boolean]} */ (await resultIn(folder));
  assert.ok(width > 100 && varied);
}

for (const [k, code] of blocks.entries()) {
  test(`block ${k + 1} of the README`, async () => {
    if (!code.includes("document")) {
      const folder = project(`readme-${k}`, undefined, { "main.js": code });
      const photo = join(root, "tests", "fixtures", "figure-7.png");
      if (code.includes("photo.png")) copyFileSync(photo, join(folder, "photo.png"));
      assert.match(await run(folder, [process.execPath, "main.js"]), /\d/);
      if (!code.includes("warped.png")) return;
      const [before, after] = [photo, join(folder, "warped.png")].map((file) => PNG.sync.read(readFileSync(file)));
      assert.deepEqual([after.width, after.height], [before.width, before.height]);
      assert.ok(!after.data.equals(before.data) && new Set(after.data).size > 50);
      return;
    }
    const [page] = readme.match(/<script type="importmap">.*<\/script>/) ?? [];
    await assertDrawn(painting(`readme-${k}`, code, `${page}<script type="module" src="./main.js"></script>`));

    // As Vite makes it of the folder.
    const folder = painting(`readme-${k}-vite`, code, '<script type="module" src="/main.js"></script>');
    const { build } = await tool("vite8");
    await build({ root: folder, configFile: false, logLevel: "error" });
    await assertDrawn(join(folder, "dist"));
  });
}

test("the README's call that does not wait", async () => {
  const [, line] = readme.match(/`(import \{ initSync \} from "conformal-warp\/inline"; initSync\(\);)`/) ?? [];
  const more = 'import { FormulaMap } from "conformal-warp/inline";\nconsole.log(new FormulaMap("z^2").eval(new Float64Array([0, 1]))[0]);';
  assert.match(await run(project("readme-sync", undefined, { "main.js": `${line}\n${more}` }), [process.execPath, "main.js"]), /^-1\n$/);
});
