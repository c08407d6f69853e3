// node tools/lessons.mjs: the still pictures of the lessons for readers without JavaScript, www/images/lessons/. The package must be built.

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { launchChromium } from "./chromium.mjs";
import { serve } from "./server.mjs";
import { main, root } from "./steps.mjs";

/** Walkers that are counted in their figure, in milliseconds. */
const COUNTING = 2500;

await main(async () => {
  const folder = join(root, "www", "images", "lessons");
  mkdirSync(folder, { recursive: true });
  const server = await serve(join(root, "www"));
  const browser = await launchChromium();
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 }, deviceScaleFactor: 2 });
  await page.goto(`${server.url}lessons.html`);
  await page.evaluate(() => document.fonts.ready);
  for (const figure of await page.locator("figure[data-figure]").all()) {
    await figure.scrollIntoViewIfNeeded();
    const id = await figure.getAttribute("id");
    await page.waitForFunction((name) => document.getElementById(String(name))?.dataset.state === "ready", id);
    const name = String(await figure.getAttribute("data-figure"));
    if (name === "walkers") {
      await figure.getByRole("button", { name: /walkers/ }).last().click();
      await page.waitForTimeout(COUNTING);
    }
    await figure.locator(".boards").screenshot({ path: join(folder, `${name}.jpg`), type: "jpeg", quality: 80 });
  }
  await browser.close();
  await server.close();
  console.log(folder);
});
