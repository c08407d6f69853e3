// How the page sits on screens of different sizes, and what it tells to those who do not see it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { onGrid, photoFrame, toPixels, toPlane } from "../../www/js/common/frame.js";
import { root } from "../../tools/steps.mjs";
import { middle, openPage, screenshot, startBrowser } from "./support/page.mjs";

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

const pages = ["", "regions.html", "formula.html", "cortex.html", "flow.html", "fields.html"];

for (const [width, height] of /** @type {const} */ ([[390, 844], [360, 640]])) {
  for (const path of pages) {
    test(`${path || "index.html"} on a phone of ${width} × ${height}: two pictures are seen at once, and fingers hit what they aim at`, async () => {
      const { page, errors, close } = await openPage(session, path, { viewport: { width, height }, hasTouch: true, isMobile: true });
      const boxes = await page.locator(".stage").evaluateAll((all) => all.map((stage) => stage.getBoundingClientRect()));
      for (const { left, right, bottom } of boxes.slice(0, 2)) assert.ok(left >= 0 && right <= width && bottom <= height, `a picture ends at ${right}, ${bottom}`);
      const small = await page.evaluate(() =>
        [...document.querySelectorAll("button, select, nav a, input[type=range], input[type=text]")].flatMap((control) => {
          const box = control.getBoundingClientRect();
          return box.height && (box.height < 44 || box.width < 44) ? [`${control.id || control.textContent}: ${box.width} × ${box.height}`] : [];
        }),
      );
      assert.deepEqual(small, []);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth)) <= 0);
      await screenshot(page, `phone-${width}-${path.replace(".html", "") || "index"}`);
      assert.deepEqual(errors, []);
      await close();
    });
  }
}

test("a finger moves the handle nearest to it, and scrolls where there is none", async () => {
  const { page, errors, close } = await openPage(session, "#shape=square", { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const before = await page.evaluate(() => location.hash);
  const corner = await middle(page.locator('#photo-marks [data-part="vertex"][data-index="2"]'));
  const touch = await page.context().newCDPSession(page);
  /** @param {string} type @param {{ x: number, y: number }[]} touchPoints */
  const send = (type, touchPoints) => touch.send("Input.dispatchTouchEvent", /** @type {any} */ ({ type, touchPoints }));
  // Fourteen pixels beside the corner.
  await send("touchStart", [{ x: corner.x + 10, y: corner.y - 10 }]);
  for (let k = 1; k <= 5; k++) await send("touchMove", [{ x: corner.x + 10 - 6 * k, y: corner.y - 10 + 4 * k }]);
  await send("touchEnd", []);
  await page.waitForFunction((old) => location.hash !== old, before);
  const moved = await middle(page.locator('#photo-marks [data-part="vertex"][data-index="2"]'));
  assert.ok(Math.hypot(moved.x - corner.x + 30, moved.y - corner.y - 20) < 2, `${moved.x - corner.x}, ${moved.y - corner.y}`);
  assert.equal(await page.evaluate(() => window.scrollY), 0);
  assert.deepEqual(errors, []);
  await close();
});

for (const path of pages) {
  for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
    test(`${path || "index.html"}, ${colorScheme}: axe-core finds nothing, whatever the page is at`, async () => {
      const { page, close } = await openPage(session, `${path}#nothing=1`, { colorScheme });
      await page.evaluate(readFileSync(join(root, "node_modules", "axe-core", "axe.min.js"), "utf8"));
      const violations = () =>
        page.evaluate(async () => {
          const { violations: found } = await /** @type {any} */ (window).axe.run();
          return found.map((/** @type {any} */ { id, nodes }) => `${id}: ${nodes.map((/** @type {any} */ { target }) => target.join(" ")).join(", ")}`);
        });
      assert.deepEqual(await violations(), []);
      if (path === "") {
        await page.locator("#draw").click();
        await page.locator("#show").click();
        await page.locator("#mesh").click();
        assert.deepEqual(await violations(), []);
      }
      await close();
    });
  }
}
