// Flows and fields are given away and shown before a class as the other pages are: files, frames, the projector.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { pixelsOf, saved } from "./support/files.mjs";
import { openPage, screenshot, settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** How much lies between neighbours one below the other in a PNG file. @param {Page} page @param {Buffer} bytes */
function edgesOf(page, bytes) {
  return page.evaluate(async (base64) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], { type: "image/png" }));
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d"));
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    let edges = 0;
    for (let k = 4 * bitmap.width; k < data.length; k += 4) edges += Math.abs(data[k] - data[k - 4 * bitmap.width]);
    return edges;
  }, bytes.toString("base64"));
}

/** Where nothing but colour is, on the canvas and in the file alike. @type {[number, number][]} */
const WIND = [[0.5, 0.5], [0.02, 0.5]];

test("a flow is saved at any size, with lines or without, as a drawing, and as a state that is gone on with", async () => {
  const { page, errors, close } = await openPage(session, "flow.html#body=circle&show=pressure,lines");
  await page.locator("#save").click();
  assert.deepEqual(await page.locator("#save-size option").allInnerTexts(), ["1024 × 614", "2048 × 1229", "4096 × 2458", "8192 × 4915"]);
  const lined = await saved(page, "#save-picture");
  assert.equal(lined.name, "flow.png");
  const found = await pixelsOf(page, lined.bytes, WIND);
  assert.deepEqual(found.size, [2048, 1229]);
  // The cylinder, and the fluid that the wind has not met yet.
  assert.deepEqual(found.pixels[0], [230, 226, 216, 255]);
  assert.ok(found.pixels[1][3] === 255, "all is covered");
  await page.locator("#save-size").selectOption("1024");
  const same = await saved(page, "#save-picture");
  await page.locator("#save-lines").uncheck();
  const bare = await saved(page, "#save-picture");
  assert.deepEqual((await pixelsOf(page, bare.bytes, WIND)).size, [1024, 614]);
  const [plain, drawn] = [await edgesOf(page, bare.bytes), await edgesOf(page, same.bytes)];
  assert.ok(plain < drawn / 3, `${plain} without lines, ${drawn} with them`);
  const drawing = await saved(page, "#save-drawing");
  assert.equal(drawing.name, "flow.svg");
  assert.match(drawing.bytes.toString(), /<path id="lines-1"[^>]* d="M[^"]{2000,}/);
  assert.match(drawing.bytes.toString(), /<path id="outline-1"[^>]* d="M[^"]+Z"/);
  const state = await saved(page, "#save-state");
  assert.equal(JSON.parse(state.bytes.toString()).page, "flow.html");
  await page.keyboard.press("Escape");
  await page.locator("#body").selectOption("wing");
  await page.waitForFunction(() => location.hash.includes("body=wing") && document.body.dataset.state === "ready");
  await page.locator("#save").click();
  await page.locator("#state-file").setInputFiles({ name: "flow.json", mimeType: "application/json", buffer: state.bytes });
  await page.waitForFunction(() => /** @type {HTMLSelectElement} */ (document.getElementById("body")).value === "circle" && document.body.dataset.state === "ready");
  assert.deepEqual(errors, []);
  await close();
});

test("the page of a region opens the state of a flow, and a link back and forth keeps both", async () => {
  const { page, errors, close } = await openPage(session, "flow.html#body=circle&circulation=-2&show=lines");
  const state = await saved(page, "#save-state");
  await page.goto(session.url);
  await settled(page, "ready");
  await page.locator("#save").click();
  await page.locator("#state-file").setInputFiles({ name: "flow.json", mimeType: "application/json", buffer: state.bytes });
  await page.waitForURL(/flow\.html#body=circle/);
  await settled(page, "ready");
  assert.match(await page.locator("#reading").innerText(), /Circulation −2\.00/);
  await page.locator("nav a", { hasText: "Formula" }).click();
  await page.waitForURL(/formula\.html/);
  await settled(page, "ready");
  assert.equal(await page.locator("#remark").isVisible(), false);
  await page.locator("nav a", { hasText: "Flow" }).click();
  await page.waitForURL(/flow\.html#.*circulation=-2/);
  await settled(page, "ready");
  assert.equal(await page.locator("#remark").isVisible(), false);
  assert.deepEqual(errors, []);
  await close();
});

test("a field is saved as it is seen in the dark, within its shield, with its volts", async () => {
  const { page, errors, close } = await openPage(session, "fields.html#set=coax", { colorScheme: "dark" });
  await page.locator("#save").click();
  await page.locator("#save-size").selectOption("1024");
  const file = await saved(page, "#save-picture");
  assert.equal(file.name, "field.png");
  const { size, pixels } = await pixelsOf(page, file.bytes, [[0.02, 0.05], [0.98, 0.95]]);
  assert.deepEqual(size, [1024, 614]);
  for (const outside of pixels) assert.deepEqual(outside, [29, 32, 38, 255], "beyond the shield is paper");
  const drawing = await saved(page, "#save-drawing");
  assert.match(drawing.bytes.toString(), /<path id="lines-1"[^>]* d="M[^"]{2000,}/);
  const state = await saved(page, "#save-state");
  assert.deepEqual(JSON.parse(state.bytes.toString()).state.set, "coax");
  await page.keyboard.press("Escape");
  await page.evaluate(() => (location.hash = "#set=three&volts=-1,1,0"));
  await page.waitForFunction(() => /** @type {HTMLSelectElement} */ (document.getElementById("set")).value === "three" && document.body.dataset.state === "ready");
  await page.waitForFunction(() => /3: /.test(document.getElementById("reading")?.textContent ?? ""));
  assert.deepEqual(errors, []);
  await close();
});

for (const [path, id] of [["flow.html", "flow"], ["fields.html", "field"]]) {
  test(`${path} in a frame is the picture alone, as wide as it can be, and leads to the page`, async () => {
    const viewport = { width: 960, height: 520 };
    const { page, errors, close } = await openPage(session, `${path}?embed`, { viewport });
    for (const gone of ["h1", "nav", ".toolbar", "#reading", "#evidence", "footer"]) assert.ok(await page.locator(gone).first().isHidden(), gone);
    const box = await page.locator(`#${id}`).boundingBox();
    assert.ok(box && box.x >= 0 && box.y >= 0 && box.x + box.width <= 960 && box.y + box.height <= 490, JSON.stringify(box));
    assert.ok(box.width > 700, `${box.width} pixels wide`);
    assert.match((await page.locator(".whole").getAttribute("href")) ?? "", new RegExp(`${path.replace(".", "\\.")}`));
    await screenshot(page, `embed-${id}`);
    assert.deepEqual(errors, []);
    await close();
  });

  test(`${path}: lines are thick on a projector, and keys lead there and back`, async () => {
    const { page, errors, close } = await openPage(session, `${path}#${id === "flow" ? "body=circle&show=lines" : "set=pair"}`);
    /** Pixels as dark as lines, of a thousand. */
    const dark = () => page.locator(`#${id}`).evaluate((canvas) => {
      const { width, height } = /** @type {HTMLCanvasElement} */ (canvas);
      const { data } = /** @type {CanvasRenderingContext2D} */ (/** @type {HTMLCanvasElement} */ (canvas).getContext("2d")).getImageData(0, 0, width, height);
      let count = 0;
      for (let k = 0; k < data.length; k += 4) if (data[k + 3] > 100 && data[k] + data[k + 1] + data[k + 2] < 240) count++;
      return (1000 * count) / (width * height);
    });
    const before = await dark();
    await page.keyboard.press("p");
    await page.waitForFunction(() => document.body.classList.contains("projector") && document.fullscreenElement === document.documentElement);
    await page.waitForFunction(({ id, before }) => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(id));
      const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).getImageData(0, 0, canvas.width, canvas.height);
      let count = 0;
      for (let k = 0; k < data.length; k += 4) if (data[k + 3] > 100 && data[k] + data[k + 1] + data[k + 2] < 240) count++;
      return (1000 * count) / (canvas.width * canvas.height) > 1.3 * before;
    }, { id, before });
    await screenshot(page, `projector-${id}`);
    await page.keyboard.press("p");
    await page.waitForFunction(() => !document.body.classList.contains("projector") && !document.fullscreenElement);
    assert.ok(await page.locator("h1").isVisible());
    assert.deepEqual(errors, []);
    await close();
  });
}
