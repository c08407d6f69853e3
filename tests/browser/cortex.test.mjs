// The page of the visual cortex: the halves of the field go where they belong, and the gaze moves.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { middle, openPage, openQuarters, screenshot, settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** @param {string} [hash] @param {import("playwright-core").BrowserContextOptions} [options] */
const openCortex = (hash = "", options = {}) => openPage(session, `cortex.html${hash}`, options);

/**
 * The picture of both cortices: pixels in shares of its width and height, the share that is filled, a sum over all.
 *
 * @param {Page} page
 * @param {[number, number][]} [places]
 */
function cortex(page, places = []) {
  return page.evaluate((wanted) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("cortex"));
    const { width, height } = canvas;
    const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).getImageData(0, 0, width, height);
    let filled = 0;
    for (let at = 3; at < data.length; at += 4) filled += data[at] / 255;
    const samples = wanted.map(([x, y]) => {
      const at = 4 * (Math.floor(y * height) * width + Math.floor(x * width));
      return [...data.slice(at, at + 4)];
    });
    return { samples, filled: filled / (width * height), digest: data.reduce((sum, value) => (Math.imul(sum, 31) + value) | 0, 0) };
  }, places);
}

test("opening shows what both hemispheres receive, with the model's source", async () => {
  const { page, errors, close } = await openCortex();
  const { filled } = await cortex(page);
  assert.ok(filled > 0.2 && filled < 0.9, `${filled} of the panel is filled`);
  assert.match(await page.locator("#source").innerText(), /Schira and others, 2010/);
  assert.ok((await page.locator("#plot .curve").getAttribute("d"))?.startsWith("M"));
  await screenshot(page, "cortex");
  await page.locator("#lines").click();
  await settled(page, "ready");
  await screenshot(page, "cortex-bare");
  assert.deepEqual(errors, []);
  await close();
});

test("the right of the field is seen at the right, the upper half above", async () => {
  const { page, errors, close } = await openCortex("#angle=100&lines=0");
  await openQuarters(page);
  const { samples } = await cortex(page, [[0.35, 0.4], [0.65, 0.4], [0.65, 0.6], [0.35, 0.6]]);
  assert.deepEqual(samples, [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255, 255, 255, 255]]);
  // Far to the left of the red quarter's corner: all of the picture lies to the right of the gaze.
  const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await page.locator("#seen").boundingBox());
  await page.mouse.click(box.x + 1, box.y + 0.25 * box.height);
  await settled(page, "ready");
  const looked = await cortex(page, [[0.35, 0.4], [0.65, 0.4], [0.65, 0.6]]);
  assert.equal(looked.samples[0][3], 0, "the right hemisphere sees nothing");
  assert.deepEqual(looked.samples.slice(1), [[255, 0, 0, 255], [255, 0, 0, 255]]);
  assert.deepEqual(errors, []);
  await close();
});

test("gaze, angle and model change the picture, and the address holds them", async () => {
  const { page, errors, close } = await openCortex("#image=coffee");
  const seen = [(await cortex(page)).digest];
  /** @param {string} what */
  const changed = async (what) => {
    await settled(page, "ready");
    const { digest } = await cortex(page);
    assert.ok(!seen.includes(digest), `${what} changes nothing`);
    seen.push(digest);
  };
  const at = await middle(page.locator("#seen"));
  await page.mouse.click(at.x - 30, at.y - 20);
  await changed("a click");
  await page.locator("#seen-marks").focus();
  await page.keyboard.press("ArrowRight");
  await changed("an arrow key");
  await page.locator("#field-of-view").fill("80");
  await changed("the angle");
  await page.locator("#model").selectOption("monopole");
  await changed("the model");
  await page.waitForURL(/model=monopole/);
  const other = await openCortex(new URL(page.url()).hash);
  assert.equal((await page.locator("#angle").innerText()), "80°");
  await other.close();
  await page.mouse.move(0, 0);
  const panel = await middle(page.locator("#cortex"));
  await page.mouse.move(panel.x + 60, panel.y);
  assert.match(await page.locator("#reading").innerText(), /looks [\d.]+° away .* gives [\d.]+ mm to each degree/);
  assert.deepEqual(errors, []);
  await close();
});

for (const [name, width, height] of /** @type {const} */ ([["desktop", 1440, 900], ["laptop", 1280, 720], ["phone", 390, 844]])) {
  test(`${name}: nothing is cut off`, async () => {
    const { page, errors, close } = await openCortex("", { viewport: { width, height } });
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    assert.ok(overflow <= 0, `${overflow} pixels too wide`);
    await screenshot(page, `cortex-${name}`);
    assert.deepEqual(errors, []);
    await close();
  });
}
