// The page in a real Chromium, and what the tests look at in it.

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { launchChromium } from "../../../tools/chromium.mjs";
import { contentPolicy, serve } from "../../../tools/server.mjs";
import { root } from "../../../tools/steps.mjs";

/** @typedef {import("playwright-core").Page} Page */

const screenshots = join(root, "tests", "screenshots");

/** A server for www/ and a browser; `close` ends both. */
export async function startBrowser() {
  mkdirSync(screenshots, { recursive: true });
  const server = await serve(join(root, "www"), 0, contentPolicy);
  const browser = await launchChromium();
  return {
    url: server.url,
    browser,
    close: async () => {
      await browser.close();
      await server.close();
    },
  };
}

/**
 * Opens the page at an address and waits until its first picture is complete. `errors` collects what the page logs as
 * errors or throws.
 *
 * @param {Awaited<ReturnType<typeof startBrowser>>} session
 * @param {string} [hash]
 * @param {import("playwright-core").BrowserContextOptions} [options]
 */
export async function openPage({ browser, url }, hash = "", options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, ...options });
  const page = await context.newPage();
  /** @type {string[]} */
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  await page.goto(url + hash);
  await settled(page, "ready");
  return { page, errors, close: () => context.close() };
}

/**
 * Waits until the photo of that name is chosen: decoding a file takes a moment, in which the old picture is a ready one.
 *
 * @param {import("playwright-core").Page} page
 * @param {string} name
 */
export async function chosenPhoto(page, name) {
  await page.waitForFunction(
    (name) => document.querySelector("#choose-photo option:checked")?.textContent === name && document.body.ariaBusy !== "true",
    name,
  );
}

/** Opens the picture of four known colours from a file, and waits until it is shown. @param {Page} page */
export async function openQuarters(page) {
  await page.locator("#file").setInputFiles({ name: "quarters.png", mimeType: "image/png", buffer: await quarters(page) });
  await chosenPhoto(page, "quarters.png");
  await settled(page, "ready");
}

/** Waits for a state of the page, and for photos that are being loaded. @param {Page} page @param {string} state */
export async function settled(page, state) {
  await page.waitForFunction((wanted) => document.body.dataset.state === wanted && document.body.ariaBusy !== "true", state);
}

/** Switches what is shown over the pictures, by the menu under Show. @param {Page} page @param {string} name */
export async function toggle(page, name) {
  await page.locator("#show").click();
  await page.locator(`#${name}`).click();
  await page.keyboard.press("Escape");
  await settled(page, "ready");
}

/** @param {Page} page @param {string} name */
export async function screenshot(page, name) {
  await page.evaluate(() => document.fonts.ready);
  await page.screenshot({ path: join(screenshots, `${name}.png`) });
}

/**
 * What the picture of the disk holds: its pixels in points of the disk, and a sum over all of it.
 *
 * @param {Page} page
 * @param {[number, number][]} [points] of the plane
 */
export function disk(page, points = []) {
  return page.evaluate((wanted) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("disk"));
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    const { data, width, height } = context.getImageData(0, 0, canvas.width, canvas.height);
    const size = 2.12 / width;
    let [digest, thinnestInside, thickestOutside] = [0, 255, 0];
    const colours = new Set();
    for (let row = 0; row < height; row++) {
      for (let column = 0; column < width; column++) {
        const radius = size * Math.hypot(column + 0.5 - width / 2, row + 0.5 - height / 2);
        const at = 4 * (row * width + column);
        const alpha = data[at + 3];
        if (radius < 0.98) thinnestInside = Math.min(thinnestInside, alpha);
        if (radius > 1.01) thickestOutside = Math.max(thickestOutside, alpha);
        if (radius < 0.98) colours.add((data[at] << 16) | (data[at + 1] << 8) | data[at + 2]);
        for (let channel = 0; channel < 4; channel++) digest = (Math.imul(digest, 31) + data[at + channel]) | 0;
      }
    }
    const samples = wanted.map(([x, y]) => {
      const at = 4 * (Math.floor(height / 2 - y / size) * width + Math.floor(width / 2 + x / size));
      return [...data.slice(at, at + 4)];
    });
    return { width, digest, thinnestInside, thickestOutside, colours: colours.size, samples };
  }, points);
}

/** The middle of an element, on the screen. @param {import("playwright-core").Locator} locator */
export async function middle(locator) {
  const box = await locator.boundingBox();
  if (!box) throw new Error("The element is not on the page.");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** The handle of a part of the region. @param {Page} page @param {string} part @param {number} [index] */
export function handle(page, part, index) {
  const which = index === undefined ? "" : `[data-index="${index}"]`;
  return page.locator(`#photo-marks [data-part="${part}"]${which}`);
}

/**
 * Drags with the mouse and lets go.
 *
 * @param {Page} page
 * @param {{ x: number, y: number }} from
 * @param {{ x: number, y: number }} to
 */
export async function drag(page, from, to) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2);
  await page.mouse.move(to.x, to.y);
  await page.mouse.up();
}

/** A point of the photo, in shares of its width and height, on the screen. @param {Page} page @param {number} x @param {number} y */
export async function onPhoto(page, x, y) {
  const box = await page.locator("#photo").boundingBox();
  if (!box) throw new Error("The photo is not on the page.");
  return { x: box.x + x * box.width, y: box.y + y * box.height };
}

/**
 * A PNG of four quarters, clockwise from the top left: red, green, blue, white.
 *
 * @param {Page} page
 */
export async function quarters(page) {
  const url = await page.evaluate(() => {
    const canvas = Object.assign(document.createElement("canvas"), { width: 200, height: 200 });
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    const places = [[0, 0], [100, 0], [100, 100], [0, 100]];
    ["#f00", "#0f0", "#00f", "#fff"].forEach((colour, k) => {
      context.fillStyle = colour;
      context.fillRect(places[k][0], places[k][1], 100, 100);
    });
    return canvas.toDataURL("image/png");
  });
  return Buffer.from(url.slice(url.indexOf(",") + 1), "base64");
}
