// How the page sits on screens of different sizes, and what it tells to those who do not see it.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { onGrid, photoFrame, toPixels, toPlane } from "../../www/js/common/frame.js";
import { openPage, screenshot, startBrowser } from "./support/page.mjs";

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

test("plane → pixels inverts pixels → plane, and the middle is the centre", () => {
  const frame = onGrid(photoFrame(600, 400), [937.5, 625]);
  for (const pixel of /** @type {[number, number][]} */ ([[0, 0], [0.5, 0.5], [937.5, 625], [-31.25, 700.125]])) {
    const [x, y] = toPixels(frame, toPlane(frame, pixel));
    assert.ok(Math.hypot(x - pixel[0], y - pixel[1]) < 1e-10, `${pixel} came back as ${[x, y]}`);
  }
  assert.deepEqual(toPlane(frame, [468.75, 312.5]), [0, 0]);
  const [left, top] = toPlane(frame, [0, 0]);
  assert.ok(left === -1 && Math.abs(top - 2 / 3) < 1e-15, "the top left corner has the largest y");
});

for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
  for (const [name, width, height] of /** @type {const} */ ([["desktop", 1440, 900], ["laptop", 1280, 720], ["phone", 390, 844]])) {
    test(`${name}, ${colorScheme}: nothing is cut off`, async () => {
      const { page, errors, close } = await openPage(session, "", { viewport: { width, height }, colorScheme });
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
      assert.ok(overflow <= 0, `${overflow} pixels too wide`);
      if (name !== "phone") {
        const bottoms = await page.locator(".stage").evaluateAll((all) => all.map((stage) => stage.getBoundingClientRect().bottom));
        assert.ok(Math.max(...bottoms) <= height, "a panel is below the fold");
      }
      await screenshot(page, `${name}-${colorScheme}`);
      assert.deepEqual(errors, []);
      await close();
    });
  }
}

test("every control has a name, and the page a title, a language and a description", async () => {
  const { page, close } = await openPage(session);
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, select, input, progress, [role=button], [role=img]")]
      .filter((element) => {
        const label = element.getAttribute("aria-label") ?? element.textContent ?? "";
        return !label.trim();
      })
      .map((element) => element.outerHTML),
  );
  assert.deepEqual(nameless, []);
  assert.equal(await page.locator("html").getAttribute("lang"), "en");
  assert.ok((await page.title()).length > 20);
  assert.ok(((await page.locator('meta[name="description"]').getAttribute("content")) ?? "").length > 60);
  await close();
});
