// node tools/screenshot.mjs [name …]: pictures of the pages for README.md and docs/PAGES.md. The package must be built.

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { launchChromium } from "./chromium.mjs";
import { serve } from "./server.mjs";
import { Failure, main, root } from "./steps.mjs";

/** @typedef {{ name: string, address: string, size: [number, number], density?: number, dark?: boolean, wait?: number }} Picture `wait`: until specks have trails, in milliseconds */

/** Each of a page at an address. @type {Picture[]} */
const PICTURES = [
  { name: "screenshot", address: "#show=grid", size: [1280, 745], density: 1.5 },
  { name: "flow", address: "flow.html#body=flap&angle=4", size: [1280, 720], density: 1.5, wait: 3000 },
  { name: "page-pair", address: "regions.html", size: [1280, 720], dark: true },
  { name: "page-holes", address: "#shape=mask", size: [1280, 720] },
  { name: "page-rings", address: "regions.html#a.holes=M.33,.05A.25,.25,0,0,1,-.17,.05A.25,.25,0,0,1,.33,.05Z&a.center=-.35,.1&a.toward=.6,.05&b.path=M.36,.5A.48,.48,0,0,1,-.6,.5A.48,.48,0,0,1,.36,.5Z&b.holes=M.16,.53A.27,.27,0,0,1,-.38,.53A.27,.27,0,0,1,.16,.53Z&b.center=-.5,.5&b.toward=.36,.5&show=grid", size: [1280, 720] },
  { name: "page-cut", address: "formula.html#f=sqrt(z%5E2-1)&colours=contours&view=0,0,4&cut=60", size: [1280, 720] },
  { name: "page-ellipses", address: "formula.html#f=z%2Bconj(z)%5E2/4&lines=ellipses&density=10&view=0,0,3&image=chelsea&wrap=mirror", size: [1280, 720], dark: true },
  { name: "page-cortex", address: "cortex.html", size: [1280, 880] },
  { name: "page-fields", address: "fields.html#set=three", size: [1280, 720], dark: true },
  { name: "page-phone", address: "#shape=star", size: [390, 844], density: 1.25 },
];

await main(async () => {
  const folder = join(root, "docs");
  mkdirSync(folder, { recursive: true });
  const server = await serve(join(root, "www"));
  const browser = await launchChromium();
  const wanted = process.argv.slice(2);
  for (const { name, address, size: [width, height], density = 1, dark = false, wait = 0 } of PICTURES) {
    if (wanted.length && !wanted.includes(name)) continue;
    const page = await browser.newPage({ viewport: { width, height }, deviceScaleFactor: density, colorScheme: dark ? "dark" : "light" });
    await page.goto(`${server.url}${address}`);
    await page.waitForFunction(() => document.body.dataset.state === "ready");
    await page.evaluate(() => document.fonts.ready);
    await page.waitForTimeout(wait);
    if (await page.locator("#remark").isVisible()) throw new Failure(await page.locator("#remark").innerText());
    const path = join(folder, `${name}.jpg`);
    await page.screenshot({ path, type: "jpeg", quality: density > 1 ? 82 : 76 });
    await page.close();
    console.log(path);
  }
  await browser.close();
  await server.close();
});
