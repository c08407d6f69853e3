// What is given away: pictures of any size, drawings, states as files, code for frames; made beside the page, and cancelled.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { pixelsOf, saved } from "./support/files.mjs";
import { handle, middle, drag, chosenPhoto, openPage, openQuarters, screenshot, settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

test("the disk is saved at the photo's own size, at another, and with lines", async () => {
  const { page, errors, close } = await openPage(session);
  await openQuarters(page);
  await page.locator("#choose-shape").selectOption("square");
  await settled(page, "ready");
  /** @type {[number, number][]} */
  const places = [[0.3, 0.3], [0.7, 0.3], [0.7, 0.7], [0.3, 0.7], [0.01, 0.01], [0.75, 0.5]];
  const own = await saved(page, "#save-picture");
  assert.equal(own.name, "disk.png");
  const bare = await pixelsOf(page, own.bytes, places);
  assert.deepEqual(bare.size, [200, 200], "the photo’s own size");
  const [red, green, blue, white] = [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255, 255, 255, 255]];
  assert.deepEqual(bare.pixels.slice(0, 4), [red, green, blue, white]);
  assert.equal(bare.pixels[4][3], 0, "the corner of the picture is clear");
  await page.locator("#save-size").selectOption("1024");
  await page.locator("#save-lines").check();
  const lined = await pixelsOf(page, (await saved(page, "#save-picture")).bytes, places);
  assert.deepEqual(lined.size, [1024, 1024]);
  assert.deepEqual(lined.pixels.slice(0, 4), [red, green, blue, white]);
  // The vector lies over the border between two colours.
  assert.ok(lined.pixels[5][0] > 240 && lined.pixels[5][1] > 160 && lined.pixels[5][2] < 90, `no vector: ${lined.pixels[5]}`);
  await screenshot(page, "save-menu");
  assert.deepEqual(errors, []);
  await close();
});

test("a large photo is saved from all of its pixels, not from what the screen needs", async () => {
  const { page, errors, close } = await openPage(session);
  // Stripes one pixel wide: gone where the photo was made smaller first.
  const url = await page.evaluate(async () => {
    const canvas = new OffscreenCanvas(4096, 1024);
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext("2d"));
    context.fillStyle = "#fff";
    context.fillRect(0, 0, 4096, 1024);
    context.fillStyle = "#000";
    for (let x = 0; x < 4096; x += 2) context.fillRect(x, 0, 1, 1024);
    const reader = new FileReader();
    reader.readAsDataURL(await canvas.convertToBlob());
    await new Promise((resolve) => (reader.onload = resolve));
    return String(reader.result);
  });
  await page.locator("#file").setInputFiles({ name: "stripes.png", mimeType: "image/png", buffer: Buffer.from(url.slice(url.indexOf(",") + 1), "base64") });
  await chosenPhoto(page, "stripes.png");
  await settled(page, "ready");
  await page.locator("#save").click();
  assert.match(await page.locator("#save-size option:checked").innerText(), /photo’s own: 4096 × 4096/);
  const { bytes } = await saved(page, "#save-picture");
  const middle = await pixelsOf(page, bytes, Array.from({ length: 16 }, (_, k) => [0.5 + k / 4096, 0.5]));
  assert.deepEqual(middle.size, [4096, 4096]);
  const greys = middle.pixels.map(([r]) => r);
  assert.ok(Math.max(...greys) - Math.min(...greys) > 60, `no stripes: ${greys}`);
  assert.deepEqual(errors, []);
  await close();
});

test("8192 × 8192 shows how far it is, leaves the page alive, and is cancelled", async () => {
  const { page, errors, close } = await openPage(session);
  await page.locator("#save").click();
  await page.locator("#save-size").selectOption("8192");
  await page.locator("#save-picture").click();
  await page.waitForFunction(() => Number(document.querySelector(".menu-busy progress")?.getAttribute("value") ?? 0) > 0.27, undefined, { timeout: 60_000 });
  await page.keyboard.press("Escape");
  const from = await middle(handle(page, "vertex", 0));
  await drag(page, from, { x: from.x - 30, y: from.y - 20 });
  await settled(page, "ready");
  await page.locator("#save").click();
  await page.locator("#save-cancel").click();
  await page.waitForFunction(() => document.querySelector(".menu-words")?.textContent?.startsWith("Cancelled"));
  assert.ok(await page.locator(".menu-busy").isHidden());
  assert.deepEqual(errors, []);
  await close();
});

for (const [path, parts] of /** @type {const} */ ([
  ["", ["outline-1", "mesh-1", "lines-1", "vector-1", "rim-2", "mesh-2"]],
  ["regions.html", ["outline-1", "mesh-1", "vector-1", "outline-2", "mesh-2"]],
  ["regions.html#a.shape=frame&b.shape=frame", ["outline-1", "lines-1", "vector-1", "outline-2", "lines-2"]],
  ["formula.html", ["lines-1", "lines-2"]],
  ["cortex.html", ["lines-1", "rim-1"]],
])) {
  test(`${path || "index.html"}: a drawing with all its lines, and a picture of a thousand pixels`, async () => {
    const { page, errors, close } = await openPage(session, path);
    const drawing = await saved(page, "#save-drawing");
    assert.match(drawing.name, /^\w+\.svg$/);
    const found = await page.evaluate((text) => {
      const read = new DOMParser().parseFromString(text, "image/svg+xml");
      if (read.querySelector("parsererror")) return [["parsererror", "", true]];
      return [...read.querySelectorAll("path")].map((shape) => [shape.id, (shape.getAttribute("d") ?? "").length, /NaN|Infinity|undefined/.test(shape.outerHTML)]);
    }, drawing.bytes.toString());
    for (const id of parts) assert.ok(found.some(([name, length]) => name === id && Number(length) > 20), `${id} is missing or empty: ${JSON.stringify(found)}`);
    assert.ok(found.every(([, , bad]) => !bad), JSON.stringify(found));
    await page.locator("#save-size").selectOption("1024");
    const picture = await pixelsOf(page, (await saved(page, "#save-picture")).bytes, [[0.3, 0.5], [0.6, 0.45], [0.5, 0.6]]);
    assert.equal(Math.max(...picture.size), 1024);
    assert.ok(picture.pixels.some(([r, g, b, a]) => a === 255 && r + g + b > 0), JSON.stringify(picture));
    assert.deepEqual(errors, []);
    await close();
  });
}

test("a state goes into a file with its photo, and comes back where both were forgotten", async () => {
  const { page, errors, close } = await openPage(session);
  await openQuarters(page);
  await page.locator("#choose-shape").selectOption("star");
  await settled(page, "ready");
  const region = new URL(page.url()).hash.match(/region=[^&]*/)?.[0];
  const { name, bytes } = await saved(page, "#save-state");
  assert.equal(name, "disk.json");
  await page.locator("#forget").evaluate((button) => /** @type {HTMLElement} */ (button).click());
  await page.goto("about:blank");
  await page.goto(`${session.url}formula.html`);
  await settled(page, "ready");
  // From another page of ours: it leads to the one that it was saved on.
  await page.locator("#state-file").setInputFiles({ name, mimeType: "application/json", buffer: bytes });
  await page.waitForURL(/#.*region=/);
  await settled(page, "ready");
  await chosenPhoto(page, "quarters.png");
  assert.equal(decodeURIComponent(new URL(page.url()).hash).match(/region=[^&]*/)?.[0], region);
  await page.locator("#state-file").setInputFiles({ name: "other.json", mimeType: "application/json", buffer: Buffer.from('{"a": 1}') });
  await page.waitForFunction(() => document.querySelector("#remark p")?.textContent?.includes("is no state that was saved here"));
  assert.deepEqual(errors, []);
  await close();
});

test("the code for a frame shows the pictures alone, and leads back to the page", async () => {
  const { page, errors, close } = await openPage(session, "#shape=star", { permissions: ["clipboard-read", "clipboard-write"] });
  await page.locator("#save").click();
  await page.locator("#copy-embed").click();
  await page.waitForFunction(() => document.getElementById("copy-embed")?.textContent === "Copied");
  const code = await page.evaluate(() => navigator.clipboard.readText());
  const source = await page.evaluate((html) => new DOMParser().parseFromString(html, "text/html").querySelector("iframe")?.src, code);
  assert.ok(source?.startsWith(`${session.url}?embed#image=astronaut&region=`), source);
  await page.setViewportSize({ width: 960, height: 520 });
  await page.goto(source ?? "");
  await settled(page, "ready");
  for (const id of ["#photo", "#disk"]) {
    const box = await page.locator(id).boundingBox();
    assert.ok(box && box.y >= 0 && box.y + box.height <= 520 && box.width > 300, `${id}: ${JSON.stringify(box)}`);
  }
  for (const gone of [".toolbar", "h1", ".page-foot"]) assert.ok(await page.locator(gone).first().isHidden(), gone);
  await screenshot(page, "embed");
  const from = await middle(handle(page, "vertex", 2));
  await drag(page, from, { x: from.x + 20, y: from.y - 20 });
  await settled(page, "ready");
  assert.equal(new URL(page.url()).search, "?embed", "a reload stays in the frame's view");
  assert.deepEqual(errors, []);
  await close();
});
