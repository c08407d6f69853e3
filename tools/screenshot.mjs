// node tools/screenshot.mjs: the README's pictures of the pages, docs/screenshot.jpg and docs/flow.jpg. The package must be built.

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { launchChromium } from "./chromium.mjs";
import { serve } from "./server.mjs";
import { main, root } from "./steps.mjs";

/** The pictures, each of a page at an address; `wait`: until specks have trails, in milliseconds. */
const PICTURES = [
  { name: "screenshot", address: "#show=grid", height: 745, wait: 0 },
  { name: "flow", address: "flow.html#body=flap&angle=4", height: 720, wait: 3000 },
];

await main(async () => {
  const folder = join(root, "docs");
  mkdirSync(folder, { recursive: true });
  const server = await serve(join(root, "www"));
  const browser = await launchChromium();
  for (const { name, address, height, wait } of PICTURES) {
    const page = await browser.newPage({ viewport: { width: 1280, height }, deviceScaleFactor: 1.5 });
    await page.goto(`${server.url}${address}`);
    await page.waitForFunction(() => document.body.dataset.state === "ready");
    await page.evaluate(() => document.fonts.ready);
    await page.waitForTimeout(wait);
    const path = join(folder, `${name}.jpg`);
    await page.screenshot({ path, type: "jpeg", quality: 82 });
    await page.close();
    console.log(path);
  }
  await browser.close();
  await server.close();
});
