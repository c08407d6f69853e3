// node tools/screenshot.mjs: the README's picture of the page, docs/screenshot.jpg. The package must be built.

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { launchChromium } from "./chromium.mjs";
import { serve } from "./server.mjs";
import { main, root } from "./steps.mjs";

await main(async () => {
  const folder = join(root, "docs");
  mkdirSync(folder, { recursive: true });
  const server = await serve(join(root, "www"));
  const browser = await launchChromium();
  const page = await browser.newPage({ viewport: { width: 1280, height: 745 }, deviceScaleFactor: 1.5 });
  await page.goto(`${server.url}#show=grid`);
  await page.waitForFunction(() => document.body.dataset.state === "ready");
  await page.evaluate(() => document.fonts.ready);
  const path = join(folder, "screenshot.jpg");
  await page.screenshot({ path, type: "jpeg", quality: 82 });
  await browser.close();
  await server.close();
  console.log(path);
});
