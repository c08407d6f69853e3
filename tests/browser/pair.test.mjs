// The page that maps one region to another: places, outlines, both editors, swapping.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { drag, middle, openPage, quarters, screenshot, settled, startBrowser, toggle } from "./support/page.mjs";
import { picture } from "./support/pair.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** @param {string} [hash] @param {import("playwright-core").BrowserContextOptions} [options] */
const openRegions = (hash = "", options = {}) => openPage(session, `regions.html${hash}`, options);

/** A handle of one of the two regions. @param {Page} page @param {"from" | "to"} side @param {string} part @param {number} [index] */
const handle = (page, side, part, index) =>
  page.locator(`#${side}-marks [data-part="${part}"]${index === undefined ? "" : `[data-index="${index}"]`}`);

/** @param {Page} page @param {"from" | "to"} side @param {{ name: string, mimeType: string, buffer: Buffer }} file */
async function openFile(page, side, file) {
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.locator(`#${side}-open`).click()]);
  await chooser.setFiles(file);
  await page.waitForFunction(([id, name]) => document.querySelector(`#${id} option:checked`)?.textContent === name, [`${side}-choose-photo`, file.name]);
  await settled(page, "ready");
}

test("opening shows the first region in the second, with its evidence", async () => {
  const { page, errors, close } = await openRegions();
  const evidence = await page.locator("#evidence").innerText();
  for (const words of ["Estimated error", "Unknowns", "Triangles", "none"]) assert.ok(evidence.includes(words), `“${words}” is missing`);
  const before = await picture(page);
  await toggle(page, "mesh");
  await screenshot(page, "regions-triangles");
  assert.notEqual((await picture(page)).digest, before.digest);
  await toggle(page, "mesh");
  assert.equal((await picture(page)).digest, before.digest);
  await page.locator("#bare").click();
  await screenshot(page, "regions");
  assert.deepEqual(errors, []);
  await close();
});

test("center goes to center and direction to direction, on pictures with known colours", async () => {
  const square = "region=-0.7,-0.7;0.7,-0.7;0.7,0.7;-0.7,0.7";
  const { page, errors, close } = await openRegions(
    `#a.image=astronaut&a.${square}&a.center=0,0&a.toward=0.7,0&b.image=retina&b.${square}&b.center=0,0&b.toward=0.7,0`,
  );
  const file = { name: "quarters.png", mimeType: "image/png", buffer: await quarters(page) };
  await openFile(page, "from", file);
  await page.locator("#from-choose-shape").selectOption("square");
  await settled(page, "ready");
  const [red, green, blue, white] = [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255, 255, 255, 255]];
  /** @type {[number, number][]} */
  const places = [[-0.3, 0.3], [0.3, 0.3], [0.3, -0.3], [-0.3, -0.3]];
  assert.deepEqual((await picture(page, places)).samples, [red, green, blue, white]);
  // The corners too: the two outlines are the same square.
  assert.deepEqual((await picture(page, [[-0.68, 0.68], [0.68, -0.68]])).samples, [red, blue]);
  const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await page.locator("#to-photo").boundingBox());
  await drag(page, await middle(handle(page, "to", "toward")), { x: box.x + box.width / 2, y: box.y + 0.15 * box.height });
  await settled(page, "ready");
  assert.deepEqual((await picture(page, places)).samples, [green, blue, white, red]);
  assert.deepEqual(errors, []);
  await close();
});

test("both regions can be edited; each side undoes its own; a crossing is said in words", async () => {
  const { page, errors, close } = await openRegions();
  const first = await picture(page);
  for (const side of /** @type {const} */ (["from", "to"])) {
    const at = await middle(handle(page, side, "vertex", 2));
    await drag(page, at, { x: at.x + 9, y: at.y + 12 });
    await settled(page, "ready");
    assert.notEqual((await picture(page)).digest, first.digest, `the ${side} side`);
    await page.locator(`#${side}-undo`).click();
    await settled(page, "ready");
    assert.equal((await picture(page)).digest, first.digest, `the ${side} side`);
  }
  const [a, b] = [await middle(handle(page, "from", "vertex", 0)), await middle(handle(page, "from", "vertex", 6))];
  await drag(page, a, { x: b.x + 30, y: b.y });
  await settled(page, "invalid");
  assert.match(await page.locator("#notice").innerText(), /These two red edges cross/);
  await page.keyboard.press("Control+z");
  await settled(page, "ready");
  assert.equal(await page.locator("#notice").innerText(), "");
  assert.deepEqual(errors, []);
  await close();
});

test("swapping the sides swaps what the address says; undo has both back", async () => {
  const { page, errors, close } = await openRegions();
  const first = await picture(page);
  await page.locator("#swap").click();
  await page.waitForFunction(() => location.hash.includes("a.image=astronaut") && location.hash.includes("b.image=chelsea"));
  await settled(page, "ready");
  await page.keyboard.press("Control+z");
  await page.waitForFunction(() => location.hash.includes("a.image=chelsea") && location.hash.includes("b.image=astronaut"));
  await settled(page, "ready");
  assert.equal((await picture(page)).digest, first.digest);
  assert.deepEqual(errors, []);
  await close();
});

for (const [name, width, height] of /** @type {const} */ ([["desktop", 1440, 900], ["laptop", 1280, 720], ["phone", 390, 844]])) {
  test(`${name}: nothing is cut off`, async () => {
    const { page, errors, close } = await openRegions("", { viewport: { width, height } });
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    assert.ok(overflow <= 0, `${overflow} pixels too wide`);
    await screenshot(page, `regions-${name}`);
    assert.deepEqual(errors, []);
    await close();
  });
}

test("all built-in shapes go into a horseshoe: without a mesh the picture is drawn point by point, and says so", async () => {
  const { page, errors, close } = await openRegions();
  await page.locator("#to-choose-shape").selectOption("horseshoe");
  for (const shape of ["", "ell", "star", "dumbbell", "coast", "slit"]) {
    if (shape) await page.locator("#from-choose-shape").selectOption(shape);
    await settled(page, "ready");
    assert.equal(await page.locator("#notice").innerText(), "", shape);
  }
  const evidence = await page.locator("#evidence").innerText();
  assert.match(evidence, /Triangles\s+(none\s+these maps crowd|[\d,]+)/);
  await screenshot(page, "pair-horseshoe");
  // The pointer still has its image at the other side.
  const at = await middle(page.locator("#from-photo"));
  await page.mouse.move(at.x - 90, at.y);
  await page.mouse.move(at.x - 92, at.y);
  await page.waitForFunction(() => /Here the photo is/.test(document.getElementById("reading")?.textContent ?? ""));
  assert.deepEqual(errors, []);
  await close();
});

test("looking closer at the second photo draws its picture anew, and all of it is as before", async () => {
  const { page, errors, close } = await openRegions();
  const whole = await picture(page);
  await page.locator("#to-stage .zoom button").first().focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  await page.keyboard.press("ArrowUp");
  await settled(page, "ready");
  await page.mouse.move(0, 0);
  const near = await picture(page);
  assert.notEqual(near.digest, whole.digest);
  await screenshot(page, "pair-closer");
  await page.keyboard.press("0");
  await settled(page, "ready");
  assert.equal((await picture(page)).digest, whole.digest);
  assert.deepEqual(errors, []);
  await close();
});
