// The lessons: every figure lives, can be moved by pointer and keys, and is there as a still picture without JavaScript.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { root } from "../../tools/steps.mjs";
import { middle, openPage, screenshot, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** Brings a figure into view and waits until it is drawn. @param {Page} page @param {string} name */
async function figure(page, name) {
  const found = page.locator(`#figure-${name}`);
  await found.scrollIntoViewIfNeeded();
  await drawn(page, name);
  return found;
}

/** @param {Page} page @param {string} name */
const drawn = (page, name) => page.waitForFunction((id) => document.getElementById(id)?.dataset.state === "ready", `figure-${name}`);

/** All that a figure draws: paths, and sums over its canvases. @param {Page} page @param {string} name */
function drawing(page, name) {
  return page.locator(`#figure-${name} .board:not([hidden])`).evaluateAll((boards) =>
    boards.map((board) => {
      const canvas = /** @type {HTMLCanvasElement} */ (board.querySelector("canvas"));
      const data = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
      let digest = 0;
      for (const value of data) digest = (Math.imul(digest, 31) + value) | 0;
      return `${digest} ${[...board.querySelectorAll("path")].map((path) => path.getAttribute("d")).join(" ")}`;
    }),
  );
}

const reading = (/** @type {Page} */ page, /** @type {string} */ name) => page.locator(`#figure-${name} .reading`).innerText();

const figures = ["angles", "letter", "elementary", "wing", "riemann", "vector", "walkers", "panels", "triangles", "curtain", "gaze", "field"];

test("every figure is drawn, and changes when its first point is moved by keys and by pointer", async () => {
  const { page, errors, close } = await openPage(session, "lessons.html");
  assert.deepEqual(await page.locator("figure[data-figure]").evaluateAll((all) => all.map((f) => /** @type {HTMLElement} */ (f).dataset.figure)), figures);
  for (const name of figures) {
    const found = await figure(page, name);
    const before = await drawing(page, name);
    assert.ok(before.every((board) => board.trim() !== "0" && board.trim() !== ""), `${name} has an empty board`);
    const grip = found.locator(".grip").first();
    await grip.focus();
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("Shift+ArrowLeft");
    await drawn(page, name);
    const moved = await drawing(page, name);
    assert.notDeepEqual(moved, before, `${name} does not answer to keys`);
    const { x, y } = await middle(grip);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 14, y - 3);
    await page.mouse.up();
    await drawn(page, name);
    assert.notDeepEqual(await drawing(page, name), moved, `${name} does not answer to the pointer`);
  }
  assert.deepEqual(errors, []);
  await close();
});

test("angles stay under conformal maps, turn round under z̄, and change under a mixture", async () => {
  const { page, close } = await openPage(session, "lessons.html");
  const found = await figure(page, "angles");
  /** @param {string} map */
  const angles = async (map) => {
    await found.locator("select").selectOption(map);
    await drawn(page, "angles");
    return (await reading(page, "angles")).replaceAll("−", "-").match(/-?\d+\.\d/g)?.map(Number) ?? [];
  };
  for (const map of ["z^2", "exp(z)"]) {
    const [before, after] = await angles(map);
    assert.equal(after, before, map);
  }
  const [before, mirrored] = await angles("conj(z)");
  assert.equal(mirrored, -before);
  const [, mixed] = await angles("z + conj(z)/2");
  assert.ok(Math.abs(mixed - before) > 3, `${mixed} from ${before}`);
  await close();
});

test("two thousand walkers count to within five percent of the map's shares", async () => {
  const { page, close } = await openPage(session, "lessons.html");
  const found = await figure(page, "walkers");
  await found.locator("button").click();
  await page.waitForFunction(() => document.querySelector("#figure-walkers .reading")?.textContent?.startsWith("2,000 walkers"));
  const heights = (/** @type {string} */ kind) =>
    found.locator(`path.${kind}`).evaluate((path) => (path.getAttribute("d") ?? "").split("Z").filter(Boolean).map((bar) => {
      const rows = [...bar.matchAll(/[\d.]+ ([\d.]+)/g)].map((match) => Number(match[1]));
      return Math.max(...rows) - Math.min(...rows);
    }));
  const [exact, counted] = [await heights("bar"), await heights("counted")];
  const whole = (/** @type {number[]} */ bars) => bars.reduce((sum, bar) => sum + bar, 0);
  assert.equal(exact.length, 6);
  exact.forEach((bar, k) => assert.ok(Math.abs(bar / whole(exact) - counted[k] / whole(counted)) < 0.05, `wall ${k + 1}: ${counted} for ${exact}`));
  await close();
});

test("without JavaScript the text is there, and every figure as a still picture", async () => {
  const context = await session.browser.newContext({ javaScriptEnabled: false, viewport: { width: 1280, height: 720 } });
  const page = await context.newPage();
  /** @type {string[]} */
  const missing = [];
  page.on("response", (response) => response.status() >= 400 && missing.push(response.url()));
  await page.goto(`${session.url}lessons.html`, { waitUntil: "load" });
  assert.equal(await page.locator("img.still").count(), figures.length);
  for (const image of await page.locator("img.still").all()) {
    await image.scrollIntoViewIfNeeded();
    const box = await image.boundingBox();
    assert.ok(box && box.width > 300 && box.height > 100);
  }
  assert.deepEqual(missing, []);
  await context.close();
});

for (const [name, width, height, colorScheme] of /** @type {const} */ ([["phone", 390, 844, "dark"], ["tablet", 820, 1180, "light"], ["desktop", 1280, 720, "light"], ["wide", 2560, 1300, "dark"]])) {
  test(`${name}, ${colorScheme}: the lessons fit, and axe-core finds nothing`, async () => {
    const { page, errors, close } = await openPage(session, "lessons.html", { viewport: { width, height }, colorScheme });
    for (const each of figures) await figure(page, each);
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    assert.ok(overflow <= 0, `${overflow} pixels too wide`);
    await page.locator("details").first().click();
    await page.evaluate(readFileSync(join(root, "node_modules", "axe-core", "axe.min.js"), "utf8"));
    const violations = await page.evaluate(async () => {
      const { violations: found } = await /** @type {any} */ (window).axe.run();
      return found.map((/** @type {any} */ { id, nodes }) => `${id}: ${nodes.map((/** @type {any} */ node) => node.html).join(", ").slice(0, 300)}`);
    });
    assert.deepEqual(violations, []);
    await page.evaluate(() => window.scrollTo(0, 0));
    await screenshot(page, `lessons-${name}-${colorScheme}`);
    assert.deepEqual(errors, []);
    await close();
  });
}
