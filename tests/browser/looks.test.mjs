// How pages lie on phones, tablets, laptops and wide screens: nothing too wide, no cell alone in its row, wide screens used.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openPage, settled, startBrowser } from "./support/page.mjs";

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

const PAGES = ["", "regions.html", "formula.html", "cortex.html", "flow.html", "fields.html"];

for (const path of PAGES) {
  test(`${path || "index.html"} from 390 to 2560 pixels`, async () => {
    const { page, errors, close } = await openPage(session, path);
    for (const [width, height] of [[390, 844], [820, 1180], [1280, 720], [2560, 1300]]) {
      await page.setViewportSize({ width, height });
      await page.waitForFunction((width) => innerWidth === width && document.body.dataset.state === "ready", width);
      const found = await page.evaluate(() => {
        /** Rows of a grid, from the tops of its cells. @param {Element} grid */
        const rows = (grid) => {
          /** @type {Map<number, Element[]>} */
          const found = new Map();
          for (const cell of grid.children) {
            const top = Math.round(cell.getBoundingClientRect().top);
            found.set(top, [...(found.get(top) ?? []), cell]);
          }
          return [...found.values()];
        };
        const lonely = [...document.querySelectorAll(".evidence, .steps, .gallery")].flatMap((grid) => {
          const cells = rows(grid);
          const [last] = cells.slice(-1);
          const narrow = last.length === 1 && last[0].getBoundingClientRect().width < 0.75 * grid.getBoundingClientRect().width;
          return cells.length > 1 && narrow ? [`${grid.className}: ${last[0].textContent?.slice(0, 40)}`] : [];
        });
        const stages = [...document.querySelectorAll(".stage")].map((stage) => stage.getBoundingClientRect());
        return {
          overflow: document.documentElement.scrollWidth - innerWidth,
          lonely,
          used: (Math.max(...stages.map(({ right }) => right)) - Math.min(...stages.map(({ left }) => left))) / innerWidth,
          empty: [...document.querySelectorAll(".columns li, .evidence dd, figcaption")].filter((cell) => !cell.textContent?.trim()).map((cell) => cell.outerHTML.slice(0, 60)),
        };
      });
      assert.ok(found.overflow <= 0, `at ${width}: ${found.overflow} pixels too wide`);
      assert.deepEqual(found.lonely, [], `at ${width}`);
      assert.deepEqual(found.empty, [], `at ${width}`);
      assert.ok(found.used > 0.55, `at ${width}: pictures take ${(100 * found.used).toFixed(0)} % of the width`);
    }
    assert.deepEqual(errors, []);
    await close();
  });
}

test("the lessons are as long before their figures come to life as after", async () => {
  const context = await session.browser.newContext({ viewport: { width: 820, height: 1180 } });
  const page = await context.newPage();
  await page.goto(`${session.url}lessons.html`);
  await settled(page, "ready");
  const length = () => page.evaluate(() => document.body.scrollHeight);
  const before = await length();
  for (const figure of await page.locator("figure[data-figure]").all()) {
    await figure.scrollIntoViewIfNeeded();
    await page.locator(`#${await figure.getAttribute("id")}[data-state="ready"]`).waitFor();
  }
  const now = await length();
  assert.ok(Math.abs(now / before - 1) < 0.06, `${before} pixels became ${now}`);
  await context.close();
});
