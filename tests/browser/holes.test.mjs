// Regions with holes on the page of the disk: drawn, dragged, taken out, read from files and letters; their images, and links to them.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { addHole, canRemove, edgeAfter, faults, holeAt, isInside, makeRegion, moveVertex, pointsOf, removeHole, removeVertex, splitEdge, translate, translateHole } from "../../www/js/editor/region.js";
import { disk, drag, handle, middle, onPhoto, openPage, screenshot, settled, startBrowser, toggle } from "./support/page.mjs";

/** @typedef {import("../../www/js/common/frame.js").Point} Point */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** @param {number} half @param {Point} [at] @returns {Point[]} */
const square = (half, [x, y] = [0, 0]) => [[x - half, y - half], [x + half, y - half], [x + half, y + half], [x - half, y + half]];

test("points are counted through all outlines, and verbs change the one that they are on", () => {
  const holes = [{ boundary: square(0.2, [-0.4, 0]) }, { boundary: square(0.2, [0.4, 0]) }];
  const region = makeRegion(square(1), undefined, undefined, holes);
  assert.ok(isInside(region, region.center));
  assert.deepEqual([0, 3, 4, 7, 8, 11].map((index) => holeAt(region, index)), [null, null, 0, 0, 1, 1]);
  assert.deepEqual(edgeAfter(region, 7).slice(0, 2), [[-0.4 - 0.2, 0.2], [-0.4 - 0.2, -0.2]], "a hole closes by itself");
  const moved = moveVertex(region, 8, [0.1, -0.3]);
  assert.deepEqual(pointsOf(moved)[8], [0.1, -0.3]);
  assert.deepEqual([moved.boundary, moved.holes?.[0]], [region.boundary, region.holes?.[0]]);
  const split = splitEdge(region, 7, [-0.6, 0]);
  assert.deepEqual([split.boundary.length, split.holes?.map(({ boundary }) => boundary.length)], [4, [5, 4]]);
  assert.ok(Math.abs(pointsOf(split)[8][1]) < 1e-12);
  // A triangle that loses a point is no hole any more.
  let less = removeVertex(region, 4);
  assert.equal(less.holes?.[0].boundary.length, 3);
  assert.ok(canRemove(less, 4));
  less = removeVertex(less, 4);
  assert.deepEqual(less.holes, [region.holes?.[1]]);
  assert.equal(removeHole(less, 0).holes, undefined);
  assert.deepEqual(pointsOf(translate(region, [0.1, 0])).map(([x]) => Number((x - 0.1).toFixed(9))), pointsOf(region).map(([x]) => Number(x.toFixed(9))));
  assert.deepEqual(translateHole(region, 1, [0, 0.1]).holes?.[0], region.holes?.[0]);
});

test("a hole over the center moves it; outlines that meet are red", () => {
  const plain = makeRegion(square(1), [0, 0], [1, 0]);
  const ring = addHole(plain, { boundary: square(0.3).reverse() });
  assert.ok(isInside(ring, ring.center) && Math.hypot(...ring.center) > 0.4);
  assert.equal(faults(ring).edges.size, 0);
  const over = translateHole(ring, 0, [0.9, 0]);
  // The right side of the square, and the two sides of the hole that cross it.
  assert.deepEqual([...faults(over).edges].sort((a, b) => a - b), [1, 4, 6]);
  assert.ok(faults(translateHole(ring, 0, [ring.center[0], ring.center[1]])).center);
});

/** A disk with a round hole, radii 0.8 and 0.4: its ring is itself. */
const RING = "path=M.8,0A.8,.8,0,0,1,-.8,0A.8,.8,0,0,1,.8,0Z&holes=M.4,0A.4,.4,0,0,1,-.4,0A.4,.4,0,0,1,.4,0Z&center=.6,0&toward=.8,0";

/** @param {import("playwright-core").Page} page */
const evidence = (page) => page.locator("#evidence").innerText();

/** Waits for what was computed: letters and files take a moment before anything is. @param {import("playwright-core").Page} page @param {string} words */
async function told(page, words) {
  await page.waitForFunction((text) => document.getElementById("evidence")?.innerText.includes(text), words);
  await settled(page, "ready");
}

test("a round ring is its own image; links hold holes and what becomes of them", async () => {
  const { page, errors, close } = await openPage(session, `#${RING}`);
  assert.match(await evidence(page), /Inner radius\s+0\.500000/);
  const { samples } = await disk(page, [[0, 0], [0.3, 0.3], [0.6, 0.3], [-0.7, 0]]);
  assert.deepEqual(samples.map(([, , , alpha]) => alpha), [0, 0, 255, 255]);
  assert.deepEqual([await page.locator("#onto").isVisible(), await page.locator("#morph").isVisible()], [true, false]);
  await screenshot(page, "ring");
  // The probe is carried by the map itself: a ring's similarity turns nothing and enlarges by 1/0.8.
  const at = await onPhoto(page, 0.8, 0.5);
  await page.mouse.move(at.x, at.y);
  await page.waitForFunction(() => /enlarged|shrunk|times|×/.test(document.getElementById("reading")?.textContent ?? ""));
  await page.locator("#onto").selectOption("slits");
  await settled(page, "ready");
  assert.match(await evidence(page), /Slits\s+0\.\d{4}/);
  assert.match(page.url(), /holes=M.*onto=slits/);
  const seen = await disk(page, [[0, 0]]);
  assert.equal(seen.samples[0][3], 255, "the center is at 0 now");
  await page.reload();
  await settled(page, "ready");
  assert.equal((await disk(page)).digest, seen.digest);
  await toggle(page, "grid");
  await toggle(page, "heat");
  await screenshot(page, "slits");
  assert.deepEqual(errors, []);
  await close();
});

test("a hole is drawn, dragged, and taken out again", async () => {
  const { page, errors, close } = await openPage(session, "#shape=square");
  await page.locator("#hole").click();
  assert.equal(await page.locator("#hole").getAttribute("aria-pressed"), "true");
  const corners = /** @type {Point[]} */ ([[0.4, 0.4], [0.6, 0.4], [0.6, 0.6], [0.4, 0.6]]);
  for (const [x, y] of [...corners, corners[0]]) {
    const at = await onPhoto(page, x, y);
    await page.mouse.click(at.x, at.y);
  }
  await settled(page, "ready");
  const vertices = page.locator("#photo-marks .vertex");
  assert.equal(await vertices.count(), 8);
  const first = Number((await evidence(page)).match(/Inner radius\s+([\d.]+)/)?.[1]);
  assert.ok(first > 0.2 && first < 0.4, String(first));

  // A larger hole leaves a thinner ring.
  const corner = await middle(handle(page, "vertex", 5));
  await drag(page, corner, { x: corner.x + 30, y: corner.y + 30 });
  await settled(page, "ready");
  assert.ok(Number((await evidence(page)).match(/Inner radius\s+([\d.]+)/)?.[1]) > first + 0.02);
  const inside = await onPhoto(page, 0.47, 0.47);
  await drag(page, inside, { x: inside.x - 20, y: inside.y });
  await settled(page, "ready");
  assert.equal(await vertices.count(), 8);
  await page.keyboard.press("Control+z");
  await settled(page, "ready");

  // Out of the region, it is said, and undone.
  const far = await onPhoto(page, 0.95, 0.47);
  await drag(page, inside, far);
  await settled(page, "invalid");
  assert.match(await page.locator("#notice").innerText(), /hole/i);
  await page.keyboard.press("Control+z");
  await settled(page, "ready");

  await vertices.nth(5).focus();
  await page.keyboard.press("Shift+Delete");
  await settled(page, "ready");
  assert.equal(await vertices.count(), 4);
  assert.equal((await disk(page)).thinnestInside, 255);
  assert.equal(await page.locator("#onto").isVisible(), false);
  assert.deepEqual(errors, []);
  await close();
});

test("letters and drawings bring their holes, and they go along to the page of two regions", async () => {
  const { page, errors, close } = await openPage(session);
  await page.locator("#choose-shape").selectOption("letter");
  await page.locator("input.letter").fill("B");
  await page.locator("dialog[open] .strong").click();
  await told(page, "Round holes");
  assert.match(await evidence(page), /Round holes\s+0\.\d{4}, 0\.\d{4}/);
  await screenshot(page, "letter-with-holes");

  await page.locator("#choose-shape").selectOption("read");
  await page.locator("dialog[open] textarea").fill('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><path d="M2 2h20v20H2zM8 8v8h8V8z"/></svg>');
  await page.locator("dialog[open] .strong").click();
  await told(page, "Inner radius");
  assert.match(await evidence(page), /Inner radius\s+0\.4\d+/);
  await page.locator('nav a[href^="regions"]').click();
  await settled(page, "invalid");
  assert.match(page.url(), /a\.holes=M/);
  assert.match(await page.locator("#notice").innerText(), /first region has one hole, the second none/);
  assert.deepEqual(errors, []);
  await close();
});
