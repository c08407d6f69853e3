// What a map says besides its picture: field lines, |f'|, harmonic measure; and a probe that stays, is sized and dragged.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { CIRCLE_FENCE, diskLines } from "../../www/js/editor/field.js";
import { drag, handle, middle, onPhoto, openPage, openQuarters, screenshot, settled, startBrowser, toggle } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** Colours of the photo's canvas in places of the photo, in shares of its sides. @param {Page} page @param {string} id @param {[number, number][]} places */
const coloursOf = (page, id, places) =>
  page.evaluate(({ id, places }) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(id));
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    return places.map(([x, y]) => [...context.getImageData(Math.round(x * canvas.width), Math.round(y * canvas.height), 1, 1).data]);
  }, { id, places });

test("a field's rings and lines make squares: equal steps of log |w| and of arg w", () => {
  const lines = diskLines({ field: true, density: 24 });
  const radii = lines.slice(0, -24).map(([x, y]) => Math.hypot(x, y));
  assert.ok(radii.length > 8);
  for (let k = 1; k < radii.length; k++) assert.ok(Math.abs(Math.log(radii[k - 1] / radii[k]) - (2 * Math.PI) / 24) < 1e-12);
  assert.ok(CIRCLE_FENCE.every(Number.isFinite));
});

test("field lines, |f′| and harmonic measure lie over both pictures, stay in the address, and follow a drag", async () => {
  const { page, errors, close } = await openPage(session, "#shape=dumbbell");
  /** @type {[number, number][]} */
  const rooms = [[0.3, 0.5], [0.7, 0.5]];
  const bare = await coloursOf(page, "photo", rooms);
  await toggle(page, "heat");
  const heated = await coloursOf(page, "photo", rooms);
  assert.notDeepEqual(heated, bare);
  const centre = await middle(handle(page, "center"));
  const [left, right] = [await onPhoto(page, 0.3, 0.5), await onPhoto(page, 0.7, 0.5)];
  const nearLeft = Math.abs(centre.x - left.x) < Math.abs(centre.x - right.x);
  // The room without the centre is far smaller on the disk: blue.
  const far = heated[nearLeft ? 1 : 0];
  assert.ok(far[2] > far[0] + 25, `${far} is not blue`);
  assert.match(page.url(), /show=heat$/);
  await toggle(page, "heat");
  const plain = await coloursOf(page, "disk-lines", [[0.5, 0.02], [0.99, 0.5]]);
  await toggle(page, "measure");
  await toggle(page, "field");
  assert.notDeepEqual(await coloursOf(page, "disk-lines", [[0.5, 0.02], [0.99, 0.5]]), plain);
  await page.locator("#show").click();
  await page.locator("#density").fill("36");
  await page.keyboard.press("Escape");
  await settled(page, "ready");
  await page.waitForURL(/show=field,measure&density=36$/);
  await screenshot(page, "overlays");
  await page.reload();
  await settled(page, "ready");
  assert.ok(await page.locator("#field").isChecked());
  assert.equal(await page.locator("#density").inputValue(), "36");
  const from = await middle(handle(page, "vertex", 0));
  await drag(page, from, { x: from.x + 10, y: from.y - 15 });
  await settled(page, "ready");
  assert.deepEqual(errors, []);
  await close();
});

test("harmonic measure of a square seen from its middle: large in the middle of a side, nothing in its corners", async () => {
  const { page, errors, close } = await openPage(session);
  await openQuarters(page);
  await page.locator("#choose-shape").selectOption("square");
  await toggle(page, "measure");
  // The square spans [−0.75, 0.75]; the fence stands outside of it.
  const gold = (/** @type {number[]} */ [r, g, b]) => r > 150 && g > 100 && b < 110 && r > b + 80;
  const [side, corner] = await coloursOf(page, "photo", [[0.5, 0.125 - 0.015], [0.125 + 0.01, 0.125 - 0.015]]);
  assert.ok(gold(side), `no fence over the side: ${side}`);
  assert.ok(!gold(corner), `a fence in the corner: ${corner}`);
  assert.deepEqual(errors, []);
  await close();
});

test("a probe is pinned, becomes a letter, is sized, dragged and moved by keys, and follows the map", async () => {
  const { page, errors, close } = await openPage(session);
  await page.locator("#show").click();
  await page.locator("#probe-figure").selectOption("letter");
  await page.locator("#probe-size").fill("40");
  await page.locator("#probe-pin").check();
  await page.keyboard.press("Escape");
  const marks = () => page.evaluate(() => ["photo-marks", "disk-marks"].map((id) => document.querySelector(`#${id} > .probe`)?.getAttribute("d") ?? ""));
  const first = await marks();
  assert.ok(first[0].length > 200 && first[1].length > 200, "no letter in both panels");
  assert.match(await page.locator("#reading").innerText(), /^Here the photo is (enlarged|shrunk)/);
  const pin = page.locator(".pin");
  const at = await middle(pin);
  const region = page.url();
  await drag(page, { x: at.x + 14, y: at.y + 16 }, { x: at.x + 44, y: at.y + 66 });
  const dragged = await marks();
  assert.ok(dragged[0] !== first[0] && dragged[1] !== first[1]);
  const moved = await middle(pin);
  assert.ok(Math.hypot(moved.x - at.x - 30, moved.y - at.y - 50) < 2, `${moved.x - at.x}, ${moved.y - at.y}`);
  assert.equal(page.url(), region, "the region stays as it was");
  await pin.focus();
  await page.keyboard.press("Shift+ArrowLeft");
  assert.ok(Math.abs((await middle(pin)).x - moved.x + 16) < 1);
  const before = await marks();
  await page.mouse.move(5, 5);
  const corner = await middle(handle(page, "vertex", 3));
  await drag(page, corner, { x: corner.x + 30, y: corner.y - 10 });
  await settled(page, "ready");
  const followed = await marks();
  assert.equal(followed[0], before[0]);
  assert.notEqual(followed[1], before[1]);
  await screenshot(page, "probe");
  await page.locator("#show").click();
  await page.locator("#probe-pin").uncheck();
  assert.deepEqual(await marks(), ["", ""]);
  assert.deepEqual(errors, []);
  await close();
});

test("two regions: what goes to circles and rays, the stretch and both measures lie over both pictures, stay in the address, and are saved", async () => {
  const { page, errors, close } = await openPage(session, "regions.html");
  const digests = () =>
    page.evaluate(() =>
      ["from-photo", "to-photo"].map((id) => {
        const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(id));
        const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).getImageData(0, 0, canvas.width, canvas.height);
        return data.reduce((sum, value) => (Math.imul(sum, 31) + value) | 0, 0);
      }));
  const seen = [await digests()];
  for (const name of ["grid", "field", "heat", "measure", "mesh"]) {
    await toggle(page, name);
    seen.push(await digests());
  }
  for (const side of [0, 1]) assert.equal(new Set(seen.map((pair) => pair[side])).size, 6, `side ${side}: each layer is seen`);
  await page.waitForURL(/show=mesh,field,heat,measure$/);
  await screenshot(page, "regions-overlays");
  await page.reload();
  await settled(page, "ready");
  for (const name of ["field", "heat", "measure", "mesh"]) assert.ok(await page.locator(`#${name}`).isChecked(), name);
  await page.locator("#save").click();
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#save-drawing").click()]);
  const file = await download.path();
  const { readFileSync } = await import("node:fs");
  const drawing = readFileSync(file, "utf8");
  for (const ink of ["fence-1", "fence-2", "mesh-1", "lines-2"]) assert.ok(drawing.includes(`id="${ink}"`), `no ${ink} in the drawing`);
  assert.deepEqual(errors, []);
  await close();
});

test("two regions: an ellipse on itself is stretched nowhere, and its fence is the same on both sides", async () => {
  const { page, errors, close } = await openPage(session, "regions.html#a.shape=ellipse&b.shape=ellipse&a.image=coffee&b.image=coffee&show=heat");
  const [left, right] = [await coloursOf(page, "from-photo", [[0.5, 0.35], [0.4, 0.6], [0.65, 0.5]]), await coloursOf(page, "to-photo", [[0.5, 0.35], [0.4, 0.6], [0.65, 0.5]])];
  await toggle(page, "heat");
  const bare = await coloursOf(page, "to-photo", [[0.5, 0.35], [0.4, 0.6], [0.65, 0.5]]);
  right.forEach((colour, k) => {
    // White at 185 of 255 over the photo.
    colour.slice(0, 3).forEach((value, channel) => assert.ok(Math.abs(value - (247 * 185 + bare[k][channel] * 70) / 255) < 6, `${colour} over ${bare[k]}`));
    assert.ok(left[k].every((value, channel) => Math.abs(value - colour[channel]) < 12), `${left[k]} and ${colour}`);
  });
  assert.deepEqual(errors, []);
  await close();
});

for (const path of ["regions.html", "formula.html"]) {
  test(`${path}: a probe is pinned there too`, async () => {
    const { page, errors, close } = await openPage(session, path);
    await page.locator("#probe").click();
    await page.locator("#probe-figure").selectOption("square");
    await page.locator("#probe-pin").check();
    await page.waitForFunction(() => [...document.querySelectorAll(".probe")].filter((mark) => (mark.getAttribute("d") ?? "").length > 100).length === 2);
    await page.keyboard.press("Escape");
    const at = await middle(page.locator(".pin"));
    const url = page.url();
    await drag(page, at, { x: at.x + 25, y: at.y + 15 });
    assert.ok(Math.abs((await middle(page.locator(".pin"))).x - at.x - 25) < 2);
    assert.equal(page.url(), url);
    assert.deepEqual(errors, []);
    await close();
  });
}
