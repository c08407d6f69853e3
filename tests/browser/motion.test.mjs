// Nothing moves by itself where somebody asked their system for that.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openPage, settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

const still = /** @type {const} */ ({ reducedMotion: "reduce" });

/** A sum over a canvas after each of so many frames of the screen. @param {Page} page @param {string} id @param {number} frames @returns {Promise<number[]>} */
const sums = (page, id, frames) =>
  page.evaluate(async ({ id, frames }) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(id));
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    const found = [];
    for (let k = 0; k < frames; k++) {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
      found.push(data.reduce((sum, value) => (Math.imul(sum, 31) + value) | 0, 0));
    }
    return found;
  }, { id, frames });

/** Waits until streamlines are traced, the last thing that a flow does by itself. @param {Page} page */
const traced = (page) => page.locator('#flow[data-lines="traced"]').waitFor();

test("specks stand still, with their trails, and go on when motion is allowed again", async () => {
  const { page, errors, close } = await openPage(session, "flow.html#body=circle&show=specks", still);
  await traced(page);
  const found = await sums(page, "flow", 12);
  assert.equal(new Set(found).size, 1, "something moved");
  // They are there: without them the picture is another.
  await page.locator("#specks").click();
  const [without] = await sums(page, "flow", 1);
  assert.notEqual(without, found[0]);
  await page.locator("#specks").click();
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await page.waitForFunction(async () => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("flow"));
    const look = () => canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data.reduce((sum, value) => (Math.imul(sum, 31) + value) | 0, 0);
    const first = look();
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    return look() !== first;
  });
  assert.deepEqual(errors, []);
  await close();
});

for (const [name, path, button] of /** @type {const} */ ([
  ["the way from z to f", "formula.html#f=z%5E2", "Play the way from z to f(z)"],
  ["the way to the disk", "", "Play the way from the region to the disk"],
])) {
  test(`${name} is taken a step a press, and playing ends when stillness is asked for`, async () => {
    const { page, errors, close } = await openPage(session, path, still);
    const way = () => page.locator("#morph").inputValue().then(Number);
    assert.equal(await way(), 1);
    const play = page.getByRole("button", { name: button });
    await play.click();
    const first = await way();
    assert.ok(first > 0 && first < 0.5, `it went to ${first} by one press`);
    await settled(page, "ready");
    assert.equal(await way(), first, "it went on by itself");
    assert.equal(await play.getAttribute("aria-pressed"), "false");
    await play.click();
    assert.ok((await way()) > first);
    await page.emulateMedia({ reducedMotion: "no-preference" });
    await play.click();
    await page.waitForFunction((button) => document.querySelector(`[aria-label="${button}"]`)?.getAttribute("aria-pressed") === "true", button);
    await page.emulateMedia({ reducedMotion: "reduce" });
    await page.waitForFunction((button) => document.querySelector(`[aria-label="${button}"]`)?.getAttribute("aria-pressed") === "false", button);
    const stopped = await way();
    await settled(page, "ready");
    assert.equal(await way(), stopped);
    assert.deepEqual(errors, []);
    await close();
  });
}

test("a parameter that is played goes on by one step, and nothing fades or slides", async () => {
  const { page, errors, close } = await openPage(session, "formula.html#f=z%2Bt&p.t=0,0", still);
  const value = () => page.getByLabel("real part of t, as a number").inputValue().then(Number);
  await page.getByRole("button", { name: "Play t", exact: true }).click();
  assert.equal(await value(), 0.5);
  await settled(page, "ready");
  assert.equal(await value(), 0.5);
  const moving = await page.evaluate(() => [...document.querySelectorAll("*")].filter((element) => parseFloat(getComputedStyle(element).transitionDuration) > 0 || getComputedStyle(element).animationName !== "none").map((element) => element.outerHTML.slice(0, 80)));
  assert.deepEqual(moving, []);
  assert.deepEqual(errors, []);
  await close();
});
