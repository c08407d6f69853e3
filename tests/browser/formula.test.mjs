// The formula's page: what is typed is drawn, what cannot be read is said, sliders and views are live.

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
const openFormula = (hash = "", options = {}) => openPage(session, `formula.html${hash}`, options);

/**
 * Pixels of a picture, in shares of its width and height, and a sum over all of it.
 *
 * @param {Page} page
 * @param {string} id
 * @param {[number, number][]} [places]
 */
function picture(page, id, places = []) {
  return page.evaluate(
    ([name, wanted]) => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(name));
      const { width, height } = canvas;
      const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).getImageData(0, 0, width, height);
      const samples = wanted.map(([x, y]) => {
        const at = 4 * (Math.floor(y * height) * width + Math.floor(x * width));
        return [...data.slice(at, at + 4)];
      });
      return { digest: data.reduce((sum, value) => (Math.imul(sum, 31) + value) | 0, 0), samples };
    },
    /** @type {const} */ ([id, places]),
  );
}

test("opening shows a warped photo, its formula, and all presets as pictures", async () => {
  const { page, errors, close } = await openFormula();
  assert.equal(await page.locator("#formula").inputValue(), "(n - m i) log(z) / pi");
  assert.equal(await page.locator("#params li").count(), 2);
  assert.match(await page.locator("#evidence").innerText(), /Analytic: angles are kept\. Drawn in \d+ ms/);
  const drawn = () => {
    const canvases = /** @type {HTMLCanvasElement[]} */ ([...document.querySelectorAll("#gallery canvas")]);
    const painted = canvases.filter((canvas) => canvas.getContext("2d")?.getImageData(80, 80, 1, 1).data[3] === 255);
    return painted.length >= 16 && painted.length === canvases.length;
  };
  await page.waitForFunction(drawn);
  await screenshot(page, "formula");
  assert.deepEqual(errors, []);
  await close();
});

test("multiplying by i turns the picture by a quarter, one way pulled back, the other pushed forward", async () => {
  const { page, errors, close } = await openFormula("#f=i+z&wrap=transparent&texture=0,0,2&view=0,0,4");
  await openQuarters(page);
  const [red, green, blue, white, nothing] = [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255, 255, 255, 255], [0, 0, 0, 0]];
  // Clockwise from the top left, then one place beyond the picture.
  /** @type {[number, number][]} */
  const places = [[0.4, 0.4], [0.6, 0.4], [0.6, 0.6], [0.4, 0.6], [0.1, 0.1]];
  assert.deepEqual((await picture(page, "source", places)).samples, [red, green, blue, white, nothing]);
  assert.deepEqual((await picture(page, "target", places)).samples, [white, red, green, blue, nothing]);
  await page.locator("#direction").selectOption("push-forward");
  await settled(page, "ready");
  assert.deepEqual((await picture(page, "target", places)).samples, [green, blue, white, red, nothing]);
  assert.deepEqual(errors, []);
  await close();
});

test("a formula that cannot be read is said so, at its place, and the picture stays", async () => {
  const { page, errors, close } = await openFormula("#f=z%5E2");
  const before = await picture(page, "target");
  await page.locator("#formula").fill("z^2 + ) 3");
  await page.waitForFunction(() => document.getElementById("mistake")?.textContent !== "");
  assert.match(await page.locator("#mistake").innerText(), /position 6: expected .* found/);
  assert.equal(await page.locator("#caret").textContent(), `${" ".repeat(6)}▲`);
  await screenshot(page, "formula-mistake");
  assert.equal((await picture(page, "target")).digest, before.digest);
  await page.locator("#formula").fill("z^3");
  await settled(page, "ready");
  assert.equal(await page.locator("#mistake").textContent(), "");
  assert.notEqual((await picture(page, "target")).digest, before.digest);
  await page.locator("#formula").fill("z + conj(z)/2");
  await settled(page, "ready");
  await page.waitForFunction(() => document.getElementById("evidence")?.textContent?.startsWith("Not analytic"));
  assert.deepEqual(errors, []);
  await close();
});

test("a letter becomes a parameter with sliders; the address holds its value", async () => {
  const { page, errors, close } = await openFormula("#f=z&image=lattice");
  const plain = await picture(page, "target");
  await page.locator("#formula").fill("a z");
  await settled(page, "ready");
  assert.equal((await picture(page, "target")).digest, plain.digest);
  await page.locator("#params input").first().fill("2");
  await settled(page, "ready");
  const doubled = await picture(page, "target");
  assert.notEqual(doubled.digest, plain.digest);
  await page.waitForFunction(() => location.hash.includes("p.a=2%2C0"));
  const other = await openFormula(new URL(page.url()).hash);
  assert.equal((await picture(other.page, "target")).digest, doubled.digest);
  await other.close();
  assert.deepEqual(errors, []);
  await close();
});

test("the view is dragged and zoomed, and goes home", async () => {
  const { page, errors, close } = await openFormula("#f=z&view=0,0,4");
  const home = await picture(page, "target");
  const at = await middle(page.locator("#target"));
  await page.mouse.move(at.x + 60, at.y + 20);
  const address = page.url();
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -400);
  await page.keyboard.up("Control");
  await page.waitForURL((url) => url.href !== address);
  await settled(page, "ready");
  const zoomed = await picture(page, "target");
  assert.notEqual(zoomed.digest, home.digest);
  await page.mouse.down();
  await page.mouse.move(at.x - 40, at.y + 90);
  await page.mouse.up();
  await settled(page, "ready");
  assert.notEqual((await picture(page, "target")).digest, zoomed.digest);
  await page.locator("#home").click();
  await settled(page, "ready");
  assert.equal((await picture(page, "target")).digest, home.digest);
  assert.deepEqual(errors, []);
  await close();
});

test("keys move and zoom the view, and bring it home", async () => {
  const { page, errors, close } = await openFormula("#f=z&view=0,0,4");
  const home = await picture(page, "target");
  const seen = new Set([home.digest]);
  await page.locator("#target-marks").focus();
  for (const key of ["ArrowRight", "Shift+ArrowUp", "+", "+", "-"]) {
    await page.keyboard.press(key);
    await settled(page, "ready");
    seen.add((await picture(page, "target")).digest);
  }
  assert.equal(seen.size, 5, "each key shows another view, and − the one before the last +");
  await page.keyboard.press("0");
  await settled(page, "ready");
  assert.equal((await picture(page, "target")).digest, home.digest);
  assert.deepEqual(errors, []);
  await close();
});

for (const [name, width, height] of /** @type {const} */ ([["desktop", 1440, 900], ["laptop", 1280, 720], ["phone", 390, 844]])) {
  test(`${name}: nothing is cut off`, async () => {
    const { page, errors, close } = await openFormula("", { viewport: { width, height } });
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    assert.ok(overflow <= 0, `${overflow} pixels too wide`);
    await screenshot(page, `formula-${name}`);
    assert.deepEqual(errors, []);
    await close();
  });
}
