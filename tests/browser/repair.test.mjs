// Outlines that meet themselves: a button takes out spikes, cuts off loops and pinches, and says so; undo takes it back.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { area, meetings } from "../../www/js/editor/geometry.js";
import { changeWords, repairOutline } from "../../www/js/editor/repair.js";
import { disk, openPage, screenshot, settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("../../www/js/common/frame.js").Point} Point */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** @param {Point[]} outline @returns {{ outline: Point[], said: string }} */
function repaired(outline) {
  const found = repairOutline(outline);
  if (!found) throw new Error("nothing is left");
  return { outline: found.outline, said: changeWords(found.changes) };
}

test("what is wrong with an outline is found and mended: the area that is left, and the words", () => {
  /** @type {[string, Point[], number, RegExp][]} */
  const cases = [
    ["a spike", [[0, 0], [2, 0], [2, 1], [1, 1], [1, 3], [1, 1], [0, 1]], 2, /took out a spike/],
    ["a spike of two lengths", [[0, 0], [2, 0], [2, 1], [1, 1], [1, 3], [1, 1.5], [0, 1]], 2.25, /took out a spike/],
    ["a hook at the end of a stroke", [[0, 0], [4, 0], [4, 4], [0, 4], [0, -0.2], [-0.2, 0.3], [0.3, 0.3]], 15.955, /cut off a loop \(0\.3 % of the area\)/],
    ["corners in the wrong order", [[0, 0], [1, 1], [1, 0], [0, 1]], 1, /the other way round at a crossing/],
    ["a room that hangs on by a point", [[0, 0], [1, 0], [1, 1], [2, 1], [2, 2.5], [1, 2.5], [1, 1], [0, 1]], 1.5, /hung on by a point or a line \(40 % of the area\)/],
    ["repeated points", [[0, 0], [0, 0], [1, 0], [1, 1], [0, 1], [0, 0]], 1, /took out 2 repeated points/],
  ];
  for (const [name, outline, left, words] of cases) {
    assert.ok(meetings(outline).length > 0, `${name}: no fault is seen`);
    const { outline: mended, said } = repaired(outline);
    assert.deepEqual(meetings(mended), [], name);
    assert.ok(Math.abs(Math.abs(area(mended)) - left) < 1e-3, `${name}: ${area(mended)}`);
    assert.match(said, words, name);
  }
  assert.equal(repairOutline([[0, 0], [1, 0], [2, 0]]), null);
});

test("whatever is scribbled, what is left is simple, and a sound outline stays as it is", () => {
  let seed = 1;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
  for (let n = 0; n < 60; n++) {
    // Every other scribble lies on a coarse grid, where points fall on points and on edges.
    const steps = n % 2 ? 9 : 1e6;
    const scribble = Array.from({ length: 4 + Math.floor(26 * random()) }, () => /** @type {Point} */ ([Math.round(steps * random()) / steps, Math.round(steps * random()) / steps]));
    const found = repairOutline(scribble);
    if (found) assert.deepEqual(meetings(found.outline), [], JSON.stringify(scribble));
  }
  /** @type {Point[]} */
  const ell = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]];
  assert.deepEqual(repairOutline(ell)?.outline, ell);
});

test("the button is there only while the outline meets itself; it says what it changed, and undo takes it back", async () => {
  const bow = "#region=-0.5,-0.5;0.5,0.5;0.5,-0.5;-0.5,0.5";
  const { page, errors, close } = await openPage(session, "#shape=square");
  const button = page.getByRole("button", { name: "Repair outline" });
  assert.equal(await button.count(), 0);
  await page.evaluate((hash) => void (location.hash = hash), bow);
  await settled(page, "invalid");
  assert.match(await page.locator("#notice").innerText(), /These two red edges cross/);
  await screenshot(page, "repair");
  await button.click();
  await settled(page, "ready");
  assert.match(await page.locator("#remark").innerText(), /joined the points the other way round at a crossing/);
  assert.equal(await page.locator(".edge.wrong").count(), 0);
  assert.equal(await button.count(), 0);
  assert.equal((await disk(page)).thinnestInside, 255);
  await page.keyboard.press("Control+z");
  await settled(page, "invalid");
  // By the keyboard too.
  await button.focus();
  await page.keyboard.press("Enter");
  await settled(page, "ready");
  assert.deepEqual(errors, []);
  await close();
});

test("an outline that folds back on itself is red there, and is repaired on the page of two regions, on each side alone", async () => {
  const spiked = "a.region=-0.5,-0.5;0.5,-0.5;0.5,0.5;0,0.5;0,0.8;0,0.5;-0.5,0.5";
  const { page, errors, close } = await openPage(session, "regions.html");
  await page.evaluate((hash) => void (location.hash = hash), spiked);
  await settled(page, "invalid");
  assert.ok((await page.locator("#from-marks .edge.wrong").count()) > 0, "no edge is red");
  assert.equal(await page.locator("#to-stage .repair").isVisible(), false);
  await page.locator("#from-stage .repair").click();
  await settled(page, "ready");
  assert.match(await page.locator("#remark").innerText(), /took out a spike/);
  assert.equal(await page.locator("#from-stage .repair").isVisible(), false);
  assert.deepEqual(errors, []);
  await close();
});
