// Regions with holes on the page of two regions: rings that fit, rings that are stretched, and what has no map, in words.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { deepPoint } from "../../www/js/editor/geometry.js";
import { goesByRings } from "../../www/js/pair/holes.js";
import { ringLines } from "../../www/js/pair/ring-lines.js";
import { pixelsOf, saved } from "./support/files.mjs";
import { drag, middle, openPage, quarters, screenshot, settled, startBrowser, toggle } from "./support/page.mjs";
import { picture } from "./support/pair.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("../../www/js/common/frame.js").Point} Point */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** @param {Page} page */
const evidence = (page) => page.locator("#evidence").innerText();
/** @param {Page} page */
const notice = (page) => page.locator("#notice").innerText();

/** A place of a square photo's plane, [−1, 1] across, on the screen. @param {Page} page @param {"from" | "to"} side @param {Point} point */
async function placeOf(page, side, [x, y]) {
  const box = await page.locator(`#${side}-photo`).boundingBox();
  assert.ok(box);
  return { x: box.x + ((x + 1) / 2) * box.width, y: box.y + ((1 - y) / 2) * box.height };
}

/** Where the middle of the probe's mark is on a side, in its plane. @param {Page} page @param {"from" | "to"} side @returns {Promise<Point>} */
async function markOn(page, side) {
  await page.waitForFunction((name) => document.querySelector(`#${name}-marks > .probe`)?.getAttribute("d"), side);
  return page.evaluate((name) => {
    const mark = /** @type {SVGPathElement} */ (document.querySelector(`#${name}-marks > .probe`));
    const { width, height } = /** @type {Element} */ (mark.ownerSVGElement).getBoundingClientRect();
    // The end of its last line but one, and of the last, the cross: half way along each.
    const lines = (mark.getAttribute("d") ?? "").split("M").slice(-2).map((line) => line.match(/-?[\d.]+(?:e-?\d+)?/g)?.map(Number) ?? []);
    const [x, y] = [0, 1].map((axis) => lines.reduce((sum, line) => sum + line[2 * Math.floor(line.length / 4) + axis], 0) / lines.length);
    return [(2 * x) / width - 1, 1 - (2 * y) / height];
  }, side);
}

/** Points at a place, and sees that its image is where it must be. @param {Page} page @param {"from" | "to"} side @param {Point} at @param {Point} image */
async function pointsTo(page, side, at, image) {
  const { x, y } = await placeOf(page, side, at);
  await page.mouse.move(x, y);
  const other = side === "from" ? "to" : "from";
  await page.waitForFunction(() => document.getElementById("reading")?.textContent?.startsWith("Here"));
  const found = await markOn(page, other);
  const off = Math.hypot(found[0] - image[0], found[1] - image[1]);
  assert.ok(off < 0.006, `${side} ${at} is shown at ${found}, and belongs to ${image}`);
}

/** Two square frames: the second is half as large, and its vector a quarter turn on. */
const FRAMES = "a.region=-.8,-.8;.8,-.8;.8,.8;-.8,.8&a.holes=M-.4-.4L.4-.4L.4,.4L-.4,.4Z&a.center=.6,.1&a.toward=.8,.2&b.region=-.4,-.4;.4,-.4;.4,.4;-.4,.4&b.holes=M-.2-.2L.2-.2L.2,.2L-.2,.2Z&b.center=-.1,.3&b.toward=-.1,.4";
/** Two round rings, of moduli 2 and 4. */
const disk = (/** @type {number} */ r) => `M${r},0A${r},${r},0,0,1,${-r},0A${r},${r},0,0,1,${r},0Z`;
const ROUND = `a.image=astronaut&a.path=${disk(0.8)}&a.holes=${disk(0.4)}&a.center=.6,0&a.toward=.8,0&b.image=retina&b.path=${disk(0.8)}&b.holes=${disk(0.2)}&b.center=.6,0&b.toward=.8,0`;

test("only as many holes as on the other side, and one at most, go by rings", () => {
  const holes = (/** @type {number} */ n) => ({ holes: Array(n).fill("") });
  const ask = (/** @type {number} */ a, /** @type {number} */ b) => goesByRings({ from: holes(a), to: holes(b) });
  assert.deepEqual([ask(0, 0), ask(1, 1)], [false, true]);
  assert.throws(() => ask(1, 0), { code: "different-holes", message: /first region has one hole, the second none/ });
  assert.throws(() => ask(0, 2), { code: "different-holes", message: /has no hole, the second 2 holes/ });
  // 3n − 3 moduli.
  assert.throws(() => ask(2, 2), { code: "many-holes", message: /3 numbers/ });
  assert.throws(() => ask(4, 4), { code: "many-holes", message: /9 numbers/ });
});

test("lines of a ring lie in it; frames of all sizes have their vectors at the same place", () => {
  for (const field of [false, true]) {
    for (const inner of [0.05, 0.5, 0.97]) {
      const lines = ringLines({ field, density: 12 }, inner);
      assert.ok(lines.length >= 12 && lines.every((line) => line.every((_, k) => k % 2 || Math.abs(Math.hypot(line[k], line[k + 1]) - (1 + inner) / 2) < (1 - inner) / 2)), `${field} ${inner}`);
    }
  }
  const square = (/** @type {number} */ h) => /** @type {Point[]} */ ([[-h, -h], [h, -h], [h, h], [-h, h]]);
  for (const size of [1, 0.565, 0.123, 7]) {
    const [x, y] = deepPoint(square(0.85 * size), [square(0.4 * size)]);
    assert.ok(x < 0 && y < 0, `${size}: ${x}, ${y}`);
  }
});

test("a frame goes into a frame as it must, to the point, both ways, and into a file", async () => {
  const { page, errors, close } = await openPage(session, "regions.html#a.image=astronaut&b.image=retina");
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.locator("#from-open").click()]);
  await chooser.setFiles({ name: "quarters.png", mimeType: "image/png", buffer: await quarters(page) });
  await page.waitForFunction(() => document.querySelector("#from-choose-photo option:checked")?.textContent === "quarters.png");
  await page.evaluate((hash) => (location.hash = hash), FRAMES);
  await page.waitForFunction(() => document.getElementById("evidence")?.innerText.includes("Moduli"));
  await settled(page, "ready");
  const words = await evidence(page);
  assert.match(words, /Moduli\s+1\.\d{6} and 1\.\d{6}[^]*conformal and keeps angles/);
  assert.doesNotMatch(words, /Dilatation/);
  // z → iz/2 turns to the left: what was at the top right is at the top left.
  const [red, green, blue, white] = [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255, 255, 255, 255]];
  /** @type {Point[]} */
  const places = [[-0.3, 0.3], [0.3, 0.3], [0.3, -0.3], [-0.3, -0.3]];
  assert.deepEqual((await picture(page, places)).samples, [green, blue, white, red]);
  await pointsTo(page, "from", [0.6, 0.3], [-0.15, 0.3]);
  assert.match(await page.locator("#reading").innerText(), /shrunk 2\.0 times and turned 90° to the left/);
  await pointsTo(page, "to", [0.1, -0.3], [-0.6, -0.2]);
  await page.mouse.move(0, 0);
  await toggle(page, "grid");
  await toggle(page, "heat");
  await screenshot(page, "pair-rings");
  await toggle(page, "heat");
  await toggle(page, "grid");
  await page.locator("#save").click();
  await page.locator("#save-size").selectOption("1024");
  const { size, pixels } = await pixelsOf(page, (await saved(page, "#save-picture")).bytes, places.map(([x, y]) => /** @type {[number, number]} */ ([(x + 1) / 2, (1 - y) / 2])));
  assert.deepEqual(size, [1024, 1024]);
  assert.deepEqual(pixels, [green, blue, white, red]);
  assert.deepEqual(errors, []);
  await close();
});

test("rings that differ are stretched, and the page says so with all numbers", async () => {
  const { page, errors, close } = await openPage(session, `regions.html#${ROUND}`);
  const words = await evidence(page);
  assert.match(words, /Moduli\s+2\.0000 and 4\.0000/);
  // log 4 / log 2.
  assert.match(words, /Dilatation K\s+2\.0000[^]*angles are not kept/);
  assert.doesNotMatch(words, /keeps angles/);
  assert.match(await page.locator("#reading").innerText(), /ellipse 2\.00 times/);
  assert.match(await page.locator("#to-words").innerText(), /stretched/);
  // z → z|z|/0.8, twice as much outwards as around.
  await pointsTo(page, "from", [0.42, 0.42], [0.42 * 0.42 * Math.SQRT2 / 0.8, 0.42 * 0.42 * Math.SQRT2 / 0.8]);
  const [most, least] = (await page.locator("#reading").innerText()).match(/[\d.]+(?= times)/g)?.map(Number) ?? [];
  assert.ok(Math.abs(most - 1.485) < 0.02 && Math.abs(least - 0.742) < 0.02, `${most}, ${least}`);
  await pointsTo(page, "to", [0, 0.45], [0, Math.sqrt(0.8 * 0.45)]);
  await page.mouse.move(0, 0);
  await page.locator("#show").click();
  assert.deepEqual(await Promise.all(["mesh", "measure", "grid", "heat"].map((name) => page.locator(`#${name}`).isDisabled())), [true, true, false, false]);
  await page.keyboard.press("Escape");
  await toggle(page, "field");
  await screenshot(page, "pair-stretched");
  // The holes made alike, it is conformal.
  await page.evaluate((hash) => (location.hash = hash), `b.path=${disk(0.4)}&b.holes=${disk(0.2)}&b.center=.3,0&b.toward=.4,0`);
  await page.waitForFunction(() => document.getElementById("evidence")?.innerText.includes("keeps angles"));
  await settled(page, "ready");
  assert.match(await page.locator("#to-words").innerText(), /filled with the first/);
  assert.match(await page.locator("#reading").innerText(), /stays a circle/);
  assert.deepEqual(errors, []);
  await close();
});

test("a hole on one side alone is said in words; one more drawn, dragged, undone and taken out is all it takes", async () => {
  const { page, errors, close } = await openPage(session, "regions.html#a.image=retina&a.shape=square&b.image=astronaut&b.shape=square");
  const first = await picture(page);
  assert.equal(await page.locator("#to-words").innerText(), "filled with the first");
  /** @param {"from" | "to"} side @param {number} half */
  const drawHole = async (side, half) => {
    await page.locator(`#${side}-hole`).click();
    assert.equal(await page.locator(`#${side}-hole`).getAttribute("aria-pressed"), "true");
    const corners = /** @type {Point[]} */ ([[-half, -half], [half, -half], [half, half], [-half, half], [-half, -half]]);
    for (const corner of corners) {
      const { x, y } = await placeOf(page, side, corner);
      await page.mouse.click(x, y);
    }
    await page.mouse.move(0, 0);
  };
  await drawHole("from", 0.3);
  await settled(page, "invalid");
  assert.match(await notice(page), /first region has one hole, the second none.*The picture stays as it was/);
  await screenshot(page, "pair-different-holes");
  assert.equal((await picture(page)).digest, first.digest, "the last picture is kept");
  await pointsTo(page, "from", [0.4, 0.4], [0.4, 0.4]);

  // The second hole is drawn where the words are.
  await drawHole("to", 0.3);
  await settled(page, "ready");
  assert.equal(await notice(page), "");
  assert.match(await evidence(page), /conformal and keeps angles/);
  const corner = await middle(page.locator('#to-marks [data-part="vertex"][data-index="6"]'));
  await drag(page, corner, { x: corner.x + 18, y: corner.y - 18 });
  await page.mouse.move(0, 0);
  await settled(page, "ready");
  assert.match(await evidence(page), /Dilatation K\s+1\.\d{4}/);
  await page.locator("#to-undo").click();
  await settled(page, "ready");
  assert.match(await evidence(page), /conformal and keeps angles/);
  await page.keyboard.press("Control+z");
  await settled(page, "invalid");
  await page.locator("#from-undo").click();
  await page.mouse.move(0, 0);
  await settled(page, "ready");
  assert.equal((await picture(page)).digest, first.digest);
  await page.locator("#from-redo").click();
  await settled(page, "invalid");
  await page.locator('#from-marks [data-part="vertex"][data-index="5"]').focus();
  await page.keyboard.press("Shift+Delete");
  await settled(page, "ready");

  // More than one each has no map, also where a page opens with it.
  await page.evaluate(() => (location.hash = "a.shape=mask&b.shape=mask"));
  await settled(page, "invalid");
  assert.match(await notice(page), /Each region has 3 holes.*6 numbers/);
  await page.reload();
  await settled(page, "invalid");
  assert.match(await notice(page), /Each region has 3 holes/);
  await page.locator("#from-choose-shape").selectOption("frame");
  await page.locator("#to-choose-shape").selectOption("frame");
  await settled(page, "ready");
  assert.match(await evidence(page), /keeps angles/);
  assert.deepEqual(errors, []);
  await close();
});

test("letters bring their holes to both sides; links, swaps and the other page keep them", async () => {
  const { page, errors, close } = await openPage(session, "regions.html");
  for (const [side, letter, state] of [["from", "O", "invalid"], ["to", "D", "ready"]]) {
    await page.locator(`#${side}-choose-shape`).selectOption("letter");
    await page.locator("input.letter").fill(letter);
    await page.locator("dialog[open] .strong").click();
    await page.waitForFunction((name) => location.hash.includes(`${name}.holes=M`), side === "from" ? "a" : "b");
    await settled(page, state);
  }
  assert.match(await evidence(page), /Moduli\s+[\d.]+ and [\d.]+/);
  await page.mouse.move(0, 0);
  await screenshot(page, "pair-letters");
  const seen = await picture(page);
  await page.reload();
  await settled(page, "ready");
  // An address has six digits: nothing moves by a pixel.
  assert.match(await evidence(page), /Dilatation K/);
  const again = await picture(page);
  await page.reload();
  await settled(page, "ready");
  assert.equal((await picture(page)).digest, again.digest);
  const hash = new URL(page.url()).hash;
  await page.locator("#swap").click();
  await page.waitForFunction((before) => location.hash !== before, hash);
  await settled(page, "ready");
  assert.notEqual((await picture(page)).digest, seen.digest);
  await page.locator("#swap").click();
  await page.waitForFunction((before) => location.hash === before, hash);
  await settled(page, "ready");
  assert.equal((await picture(page)).digest, again.digest);
  // A curved drawing on the same photo leaves no holes of the one before.
  const next = await page.evaluate(async (module) => {
    const { addressFor } = await import(module);
    return addressFor("a.image=cat&a.path=M0,0Z&a.holes=M1,1Z&b.holes=M2,2Z", { image: "cat", path: "M3,3Z", center: "0,0" }, "regions.html");
  }, `${session.url}js/common/along.js`);
  assert.doesNotMatch(next, /a\.holes/);
  assert.match(next, /b\.holes/);
  await page.locator('nav a[href^="./"]').click();
  await page.waitForFunction(() => document.getElementById("evidence")?.innerText.includes("Inner radius"));
  assert.match(page.url(), /[#&]holes=M/);
  assert.deepEqual(errors, []);
  await close();
});

for (const [path, side] of [["regions.html#a.shape=frame&b.shape=frame", "from-marks"], ["#shape=frame", "photo-marks"]]) {
  test(`${path}: a hole that is dragged without a rest is followed`, async () => {
    const { page, errors, close } = await openPage(session, path);
    await page.evaluate(() => {
      Object.assign(window, { pictures: 0 });
      const { putImageData } = CanvasRenderingContext2D.prototype;
      CanvasRenderingContext2D.prototype.putImageData = function (/** @type {any[]} */ ...all) {
        /** @type {any} */ (window).pictures++;
        return putImageData.apply(this, /** @type {any} */ (all));
      };
    });
    const { x, y } = await middle(page.locator(`#${side} [data-part="vertex"][data-index="4"]`));
    await page.mouse.move(x, y);
    await page.mouse.down();
    let seen = 0;
    const end = Date.now() + 30_000;
    for (let n = 1; seen < 3 && Date.now() < end; n++) {
      await page.mouse.move(x + 9 * Math.sin(n / 7), y + 9 * Math.sin(n / 9));
      if (n % 8 === 0) seen = await page.evaluate(() => /** @type {any} */ (window).pictures);
    }
    await page.mouse.up();
    assert.ok(seen >= 3, `${seen} pictures while it was dragged`);
    await settled(page, "ready");
    assert.deepEqual(errors, []);
    await close();
  });
}
