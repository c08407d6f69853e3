// The code of the README runs as it stands, with the package from its tarball.

import assert from "node:assert/strict";
import { copyFileSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";
import { root } from "../../tools/steps.mjs";
import { closeBrowser, resultIn } from "./support/browser.mjs";
import { project, run } from "./support/project.mjs";

after(closeBrowser);

const readme = readFileSync(join(root, "README.md"), "utf8");
const blocks = [...readme.matchAll(/```js\n([\s\S]*?)```/g)].map(([, code]) => code);

test("the README has code for a canvas, a region, curves, holes, quadrilaterals and a pool", () => assert.equal(blocks.length, 6));

for (const [k, code] of blocks.entries()) {
  test(`block ${k + 1} of the README`, async () => {
    if (!code.includes("document")) {
      const printed = await run(project(`readme-${k}`, undefined, { "main.js": code }), [process.execPath, "main.js"]);
      assert.match(printed, /\d/);
      return;
    }
    // The picture that it draws is not the one that it loads.
    const digest = "const bytes = context.getImageData(0, 0, width, height).data; globalThis.result = [width, new Set(bytes).size > 50];";
    const folder = project(`readme-${k}`, undefined, {
      "main.js": `${code}\n${digest}`,
      "index.html": `<!doctype html><meta charset="utf-8"><canvas></canvas><script type="importmap">{ "imports": { "conformal-warp": "./node_modules/conformal-warp/pkg/index.js" } }</script><script type="module" src="./main.js"></script>`,
    });
    copyFileSync(join(root, "www", "images", "coffee.jpg"), join(folder, "photo.jpg"));
    const [width, varied] = /** @type {[number, boolean]} */ (await resultIn(folder));
    assert.ok(width > 100 && varied);
  });
}
