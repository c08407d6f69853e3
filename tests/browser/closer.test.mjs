// Looking closer where it could not be done: the cortex, the photo that is looked at, a formula's left plane; adding a point by finger.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { middle, openPage, screenshot, settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** A sum over a canvas. @param {Page} page @param {string} id */
const digest = (page, id) =>
  page.evaluate((name) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(name));
    const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).getImageData(0, 0, canvas.width, canvas.height);
    return data.reduce((sum, value) => (Math.imul(sum, 31) + value) | 0, 0);
  }, id);

/** Waits until a canvas shows something else than it did, or the same again, and the page is ready. @param {Page} page @param {string} id @param {number} sum @param {"another" | "same"} [wanted] */
async function shows(page, id, sum, wanted = "another") {
  await page.waitForFunction(({ id, sum, wanted }) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(id));
    const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).getImageData(0, 0, canvas.width, canvas.height);
    const now = data.reduce((total, value) => (Math.imul(total, 31) + value) | 0, 0);
    return document.body.dataset.state === "ready" && (now === sum) === (wanted === "same");
  }, { id, sum, wanted });
}

/** @param {Page} page @param {string} id @param {() => Promise<unknown>} work */
async function zooms(page, id, work) {
  const before = await digest(page, id);
  await page.keyboard.down("Control");
  await work();
  await page.keyboard.up("Control");
  await shows(page, id, before);
}

test("the cortex is looked at closer by wheel, drag, buttons and keys, on each panel alone", async () => {
  const { page, errors, close } = await openPage(session, "cortex.html#lines=0");
  const whole = [await digest(page, "cortex"), await digest(page, "beside"), await digest(page, "seen")];
  const at = await middle(page.locator("#cortex"));
  const scrolled = await page.evaluate(() => window.scrollY);
  await page.mouse.move(at.x + 60, at.y);
  await zooms(page, "cortex", () => page.mouse.wheel(0, -600));
  const closer = await digest(page, "cortex");
  assert.notEqual(closer, whole[0]);
  assert.equal(await digest(page, "beside"), whole[1], "the other panel stays");
  assert.equal(await page.evaluate(() => window.scrollY), scrolled);
  await page.mouse.move(at.x + 60, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x - 160, at.y, { steps: 4 });
  await page.mouse.up();
  await shows(page, "cortex", closer);
  await screenshot(page, "cortex-closer");
  await page.locator(".target .zoom").first().locator("button", { hasText: "Fit" }).click();
  await shows(page, "cortex", whole[0], "same");

  const fixation = () => new URLSearchParams(new URL(page.url()).hash.slice(1)).get("fixation");
  const gaze = fixation();
  const photo = await middle(page.locator("#seen"));
  await page.mouse.move(photo.x, photo.y);
  await zooms(page, "seen", () => page.mouse.wheel(0, -500));
  assert.notEqual(await digest(page, "seen"), whole[2]);
  assert.equal(fixation(), gaze, "looking closer moves no gaze");
  await page.mouse.click(photo.x + 10, photo.y + 10);
  await settled(page, "ready");
  await page.waitForFunction((old) => new URLSearchParams(location.hash.slice(1)).get("fixation") !== old, gaze);
  await page.locator(".source .zoom button", { hasText: "Fit" }).focus();
  await page.keyboard.press("0");
  await shows(page, "seen", whole[2], "same");
  assert.deepEqual(errors, []);
  await close();
});

test("a formula's left plane is moved and zoomed, stays in the address, and goes home; the wheel alone scrolls the page", async () => {
  const { page, errors, close } = await openPage(session, "formula.html#f=z", { viewport: { width: 1280, height: 500 } });
  const whole = [await digest(page, "source"), await digest(page, "target")];
  const at = await middle(page.locator("#source"));
  await page.mouse.move(at.x, at.y);
  await page.mouse.wheel(0, 120);
  await page.waitForFunction(() => window.scrollY > 50);
  assert.equal(await digest(page, "source"), whole[0], "the wheel alone zooms");
  await page.evaluate(() => window.scrollTo(0, 0));
  // Beside the handle in the middle, which moves the picture.
  await page.mouse.move(at.x - 60, at.y - 40);
  await page.mouse.down();
  await page.mouse.move(at.x - 10, at.y - 20, { steps: 3 });
  await page.mouse.up();
  await page.waitForURL(/around=/);
  await settled(page, "ready");
  const moved = await digest(page, "source");
  assert.notEqual(moved, whole[0]);
  assert.equal(await digest(page, "target"), whole[1], "the right plane stays");
  // It was taken hold of: now the wheel is its own.
  const address = page.url();
  await page.mouse.wheel(0, -300);
  await shows(page, "source", moved);
  await page.waitForURL((url) => url.href !== address);
  const around = page.url().match(/around=[^&]*/)?.[0];
  await page.reload();
  await settled(page, "ready");
  assert.notEqual(await digest(page, "source"), whole[0]);
  assert.equal(page.url().match(/around=[^&]*/)?.[0], around);
  await page.locator("#source-marks").focus();
  await page.keyboard.press("0");
  await shows(page, "source", whole[0], "same");
  assert.deepEqual(errors, []);
  await close();
});

test("a finger adds a point by the handle in the middle of an edge", async () => {
  const { page, errors, close } = await openPage(session, "#shape=square", { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const corners = page.locator('#photo-marks [data-part="vertex"]');
  assert.equal(await corners.count(), 4);
  const at = await middle(page.locator("#photo-marks .middle").first());
  const touch = await page.context().newCDPSession(page);
  /** @param {string} type @param {{ x: number, y: number }[]} touchPoints */
  const send = (type, touchPoints) => touch.send("Input.dispatchTouchEvent", /** @type {any} */ ({ type, touchPoints }));
  await send("touchStart", [at]);
  for (let k = 1; k <= 4; k++) await send("touchMove", [{ x: at.x, y: at.y - 6 * k }]);
  await send("touchEnd", []);
  await settled(page, "ready");
  assert.equal(await corners.count(), 5);
  const added = await middle(corners.nth(1));
  assert.ok(Math.hypot(added.x - at.x, added.y - at.y + 24) < 3, `${added.x - at.x}, ${added.y - at.y}`);
  await screenshot(page, "middles");
  assert.deepEqual(errors, []);
  await close();
});

test("the projector's view shows the pictures and few controls on all of the screen, and is left again", async () => {
  for (const path of ["", "regions.html", "formula.html", "cortex.html", "flow.html", "fields.html"]) {
    const { page, errors, close } = await openPage(session, path);
    await page.locator("#present").click();
    await page.waitForFunction(() => document.fullscreenElement === document.documentElement);
    await page.waitForFunction(() => [...document.querySelectorAll(".stage")].every((stage) => stage.getBoundingClientRect().bottom <= innerHeight));
    await settled(page, "ready");
    for (const gone of ["h1", ".page-foot", "#save"]) assert.ok(await page.locator(gone).first().isHidden(), `${path}: ${gone}`);
    const boxes = await page.locator(".stage").evaluateAll((all) => all.map((stage) => stage.getBoundingClientRect()).map(({ left, top, right, bottom }) => [left, top, right, bottom]));
    const size = await page.evaluate(() => [innerWidth, innerHeight]);
    for (const [left, top, right, bottom] of boxes) assert.ok(left >= 0 && top >= 0 && right <= size[0] && bottom <= size[1], `${path}: ${[left, top, right, bottom]} on ${size}`);
    await page.locator("#present").click();
    await page.waitForFunction(() => !document.fullscreenElement);
    await settled(page, "ready");
    assert.ok(await page.locator("h1").isVisible());
    assert.deepEqual(errors, []);
    await close();
  }
});
