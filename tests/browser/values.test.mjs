// The formula's page beyond pictures: values as colours, lines of every kind, the way from z to f, parameters, the picture's own plane.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { evenHue } from "../../www/js/formula/oklab.js";
import { morphed } from "../../www/js/formula/morph.js";
import { portray, saw, square, valuesOver } from "../../www/js/formula/portrait.js";
import { drag, middle, openPage, screenshot, settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** @param {string} hash @param {import("playwright-core").BrowserContextOptions} [options] */
const openFormula = (hash, options = {}) => openPage(session, `formula.html${hash}`, options);

/** A byte in linear light. @param {number} byte */
const linear = (byte) => (byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4);

/** A colour of the screen in OKLab. @param {ArrayLike<number>} rgb */
function oklab(rgb) {
  const [r, g, b] = [rgb[0], rgb[1], rgb[2]].map(linear);
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s, 1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s, 0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s];
}

test("hues are even: one lightness and one chroma in OKLab, all on the screen, equal steps apart", () => {
  for (const light of [0.3, 0.55, 0.74, 0.9]) {
    const colours = Array.from({ length: 360 }, (_, k) => {
      const out = new Uint8ClampedArray(4);
      evenHue(light, (k * Math.PI) / 180, 1, out, 0);
      return oklab(out);
    });
    const chroma = colours.map(([, a, b]) => Math.hypot(a, b));
    // A byte is about 0.003 of lightness.
    assert.ok(colours.every(([l]) => Math.abs(l - light) < 0.004), `lightness at ${light}`);
    assert.ok(Math.max(...chroma) - Math.min(...chroma) < 0.006, `chroma at ${light}: ${Math.min(...chroma)} to ${Math.max(...chroma)}`);
    // Steps over thirty degrees, since colours are whole bytes; of dark ones there are few.
    if (light < 0.5) continue;
    const steps = colours.map(([, a, b], k) => Math.hypot(a - colours[(k + 30) % 360][1], b - colours[(k + 30) % 360][2]));
    assert.ok(Math.max(...steps) / Math.min(...steps) < 1.25, `steps at ${light}: ${Math.min(...steps)} to ${Math.max(...steps)}`);
  }
});

test("contours are means over the pixel: what a box of many samples has", () => {
  for (const [x, stretch] of [[0.3, 0.1], [0.95, 0.2], [-1.02, 0.3], [2.5, 1.7], [0.1, 5]]) {
    const places = Array.from({ length: 20001 }, (_, k) => x + stretch * (k / 20000 - 0.5));
    const mean = (/** @type {(t: number) => number} */ f) => places.reduce((sum, t) => sum + f(t), 0) / places.length;
    assert.ok(Math.abs(saw(x, stretch) - mean((t) => t - Math.floor(t))) < 2e-4, `saw at ${x}`);
    assert.ok(Math.abs(square(x, stretch) - mean((t) => (Math.floor(t) % 2 === 0 ? 1 : -1))) < 2e-4, `square at ${x}`);
  }
});

test("every scheme is defined everywhere, also at zeros and beyond what is defined", () => {
  const view = /** @type {import("../../www/js/common/frame.js").Frame} */ ({ center: [0, 0], width: 2, pixels: [32, 32] });
  const grid = valuesOver(null, view, [0, 32]);
  grid.values.fill(NaN, 0, 8);
  grid.values.fill(0, 40, 48);
  for (const scheme of /** @type {const} */ (["hue", "shaded", "contours", "gold", "chess"])) {
    const out = new Uint8ClampedArray(4 * 32 * 32).fill(77);
    portray(grid, scheme, 12, out);
    assert.deepEqual([...out.subarray(0, 16)].filter((_, k) => k % 4 === 3), [0, 0, 0, 0], `${scheme}: something where nothing is defined`);
    assert.ok([...out].filter((_, k) => k % 4 === 3).slice(4).every((alpha) => alpha === 255), scheme);
  }
});

test("the way from z to f is a formula too, whatever stands before it", () => {
  assert.equal(morphed("z^2", 1), "z^2");
  assert.equal(morphed("f(z) = z^2", 0.25), "0.7500 * z + 0.2500 * ( z^2)");
  assert.equal(morphed("w = z + 1", 0), "1.0000 * z + 0.0000 * ( z + 1)");
});

/** Colours in places of a canvas, in shares of its sides. @param {Page} page @param {string} id @param {[number, number][]} places @returns {Promise<number[][]>} */
const coloursOf = (page, id, places) =>
  page.evaluate(({ id, places }) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(id));
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    return places.map(([x, y]) => [...context.getImageData(Math.floor(x * canvas.width), Math.floor(y * canvas.height), 1, 1).data]);
  }, { id, places });

/** @param {Page} page */
const digest = (page) =>
  page.evaluate(() => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("target"));
    const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).getImageData(0, 0, canvas.width, canvas.height);
    return data.reduce((sum, value) => (Math.imul(sum, 31) + value) | 0, 0);
  });

test("values as colours: both planes agree, z² has each hue twice, contours and lines follow the density, the address holds it", async () => {
  const { page, errors, close } = await openFormula("#f=z%5E2&view=0,0,2&around=0,0,2&texture=0,0,2");
  await page.locator("#colours").selectOption("hue");
  await settled(page, "ready");
  // f(0.5 + 0.5i) = 0.5i, and the same at the opposite point; in the plane of values it is straight up.
  const [one, two] = await coloursOf(page, "target", [[0.75, 0.25], [0.25, 0.75]]);
  const [key] = await coloursOf(page, "source", [[0.5, 0.25]]);
  for (let k = 0; k < 3; k++) assert.ok(Math.abs(one[k] - two[k]) < 6 && Math.abs(one[k] - key[k]) < 6, `${one} ${two} ${key}`);
  assert.match(await page.locator("#source-words").innerText(), /key to the colours/);
  assert.equal(await page.locator(".picture-handle.move").isVisible(), false);
  const seen = new Set([await digest(page)]);
  for (const scheme of ["shaded", "contours", "gold", "chess"]) {
    await page.locator("#colours").selectOption(scheme);
    await settled(page, "ready");
    seen.add(await digest(page));
  }
  await page.locator("#density").fill("20");
  await settled(page, "ready");
  seen.add(await digest(page));
  await page.locator("#colours").selectOption("hue");
  for (const lines of ["imaginary", "real", "modulus", "phase", "cartesian", "polar"]) {
    await page.locator("#lines").selectOption(lines);
    await settled(page, "ready");
    seen.add(await digest(page));
  }
  assert.equal(seen.size, 12, "each looks otherwise");
  await page.waitForURL(/colours=hue/);
  assert.match(page.url(), /lines=polar/);
  assert.match(page.url(), /density=20/);
  const last = await digest(page);
  await page.reload();
  await settled(page, "ready");
  assert.equal(await digest(page), last);
  await page.locator("#direction").selectOption("push-forward");
  await settled(page, "ready");
  assert.match(await page.locator("#target-words").innerText(), /key to the colours/);
  await screenshot(page, "formula-values");
  assert.deepEqual(errors, []);
  await close();
});

test("streamlines are where they belong: Im z² = 0 on both axes, not between them", async () => {
  const { page, errors, close } = await openFormula("#f=z%5E2&view=0,0,2&texture=0,0,4&density=2&colours=hue&lines=imaginary");
  const dark = (/** @type {number[]} */ rgb) => oklab(rgb)[0] < 0.55;
  // 0.5 + 0.25i has Im z² = 0.25, away from the multiples of 2.
  const [right, up, between] = await coloursOf(page, "target", [[0.8, 0.4999], [0.4999, 0.2], [0.75, 0.375]]);
  assert.ok(dark(right) && dark(up) && !dark(between), `${right} ${up} ${between}`);
  assert.deepEqual(errors, []);
  await close();
});

test("from z to f: the slider scrubs, play goes to the end, and the words say which maps lie between", async () => {
  const { page, errors, close } = await openFormula("#f=2z&view=0,0,4&texture=0,0,2&image=lattice");
  const whole = await digest(page);
  await page.locator("#morph").fill("0.5");
  await settled(page, "ready");
  assert.match(await page.locator("#evidence").innerText(), /h\(z\) = \(1 − s\) z \+ s f\(z\), with s = 0\.50/);
  const half = await digest(page);
  assert.notEqual(half, whole);
  await page.waitForURL(/morph=0\.5/);
  // Half of the way to 2z is 1.5z.
  await page.locator("#morph").fill("1");
  await page.locator("#formula").fill("1.5z");
  await page.waitForURL(/f=1\.5z/);
  await settled(page, "ready");
  assert.equal(await digest(page), half);
  await page.locator("#formula").fill("2z");
  await page.waitForURL(/f=2z/);
  await page.locator("#speed").selectOption("4");
  await page.getByRole("button", { name: "Play the way from z to f(z)" }).click();
  await page.waitForFunction(() => Number(/** @type {HTMLInputElement} */ (document.getElementById("morph")).value) < 1);
  await page.waitForFunction(() => /** @type {HTMLInputElement} */ (document.getElementById("morph")).value === "1");
  await settled(page, "ready");
  assert.equal(await digest(page), whole);
  assert.deepEqual(errors, []);
  await close();
});

test("parameters: re and im are labelled, a number of any size widens the slider, and t is time", async () => {
  const { page, errors, close } = await openFormula("#f=z+exp(i*t)%2Ba&view=0,0,4");
  const row = page.locator('#params li[data-name="a"]');
  assert.deepEqual(await row.locator(".part span").allInnerTexts(), ["re", "im"]);
  await row.getByLabel("imaginary part of a, as a number").fill("37.5");
  await settled(page, "ready");
  await page.waitForURL(/p\.a=1%2C37\.5/);
  // The slider rests on steps.
  assert.ok(Math.abs(Number(await row.getByLabel("imaginary part of a", { exact: true }).inputValue()) - 37.5) < 0.2);
  const time = page.locator('#params li[data-name="t"]').getByLabel("real part of t", { exact: true });
  const before = Number(await time.inputValue());
  const play = page.getByRole("button", { name: "Play t", exact: true });
  await play.press("Enter");
  await page.waitForFunction((before) => Number(/** @type {HTMLInputElement} */ (document.querySelector('#params li[data-name="t"] input')).value) > before + 0.3, before);
  await play.click();
  assert.equal(await play.getAttribute("aria-pressed"), "false");
  await settled(page, "ready");
  assert.deepEqual(errors, []);
  await close();
});

test("the picture is moved and sized in its own plane, by hand and by keys, while the plane stays", async () => {
  const { page, errors, close } = await openFormula("#f=z&view=0,0,4&texture=0,0,2&wrap=transparent");
  const before = await digest(page);
  const at = await middle(page.locator(".picture-handle.move .dot"));
  await drag(page, at, { x: at.x + 40, y: at.y - 20 });
  await settled(page, "ready");
  const moved = await middle(page.locator(".picture-handle.move .dot"));
  assert.ok(Math.hypot(moved.x - at.x - 40, moved.y - at.y + 20) < 1.5, JSON.stringify([at, moved]));
  assert.notEqual(await digest(page), before);
  await page.locator(".picture-handle.move").focus();
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Shift+ArrowDown");
  const nudged = await middle(page.locator(".picture-handle.move .dot"));
  assert.ok(Math.hypot(nudged.x - moved.x + 4, nudged.y - moved.y - 20) < 1.5);
  const corner = await middle(page.locator(".picture-handle.size .dot"));
  await drag(page, corner, { x: corner.x + 30, y: corner.y + 10 });
  const larger = await middle(page.locator(".picture-handle.size .dot"));
  assert.ok(Math.abs(larger.x - corner.x - 30) < 1.5, "the corner follows the hand");
  await page.waitForURL((url) => /texture=0\.\d+%2C/.test(url.hash) && !/texture=[^&]*%2C2&/.test(url.hash));
  assert.deepEqual(errors, []);
  await close();
});

test("the probe works both ways, and an example is seen where it is chosen", async () => {
  const { page, errors, close } = await openFormula("#f=z%5E2&view=0,0,4&around=0,0,4");
  const marks = () => page.evaluate(() => ["source-marks", "target-marks"].map((id) => document.querySelector(`#${id} > .probe`)?.getAttribute("d") ?? ""));
  const box = await page.locator("#source").boundingBox();
  if (!box) throw new Error("no plane");
  // At i: √i = (1 + i)/√2 and its opposite, of which one is shown.
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 4);
  await page.waitForFunction(() => (document.querySelector("#target-marks > .probe")?.getAttribute("d") ?? "").length > 200);
  const [, there] = await marks();
  const numbers = there.match(/-?\d+\.\d+/g)?.map(Number) ?? [];
  const mean = [0, 1].map((k) => numbers.filter((_, n) => n % 2 === k).reduce((sum, x) => sum + x, 0) / (numbers.length / 2));
  const [u, v] = [mean[0] / box.width - 0.5, 0.5 - mean[1] / box.height].map((x) => 4 * x);
  const off = Math.min(Math.hypot(u - Math.SQRT1_2, v - Math.SQRT1_2), Math.hypot(u + Math.SQRT1_2, v + Math.SQRT1_2));
  assert.ok(off < 0.06, `the mark is at ${u} + ${v}i`);
  assert.match(await page.locator("#reading").innerText(), /^Here the picture is (enlarged|shrunk)/);
  await page.locator("#gallery a").last().scrollIntoViewIfNeeded();
  await page.locator("#gallery a").last().click();
  await page.waitForFunction(() => {
    const { top, bottom } = /** @type {HTMLElement} */ (document.getElementById("panels")).getBoundingClientRect();
    return top > -2 && bottom < window.innerHeight + 2;
  });
  await settled(page, "ready");
  assert.deepEqual(errors, []);
  await close();
});
