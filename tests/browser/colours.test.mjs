// Photos with more colours than sRGB has keep them on screens that show them, and in the files that are saved there.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { saved } from "./support/files.mjs";
import { settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** A page on a screen that shows this many colours, with a photo opened that is as red as Display P3 can be. @param {"p3" | "srgb"} gamut @param {string} path */
async function openRed(gamut, path) {
  const context = await session.browser.newContext({ viewport: { width: 1280, height: 720 } });
  const page = await context.newPage();
  /** @type {string[]} */
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  const screen = await context.newCDPSession(page);
  await screen.send("Emulation.setEmulatedMedia", { features: [{ name: "color-gamut", value: gamut }] });
  await page.goto(session.url + path);
  await settled(page, "ready");
  const base64 = await page.evaluate(async () => {
    const canvas = new OffscreenCanvas(300, 300);
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext("2d", { colorSpace: "display-p3" }));
    context.fillStyle = "color(display-p3 1 0 0)";
    context.fillRect(0, 0, 300, 300);
    const bytes = new Uint8Array(await (await canvas.convertToBlob({ type: "image/png" })).arrayBuffer());
    return btoa(String.fromCharCode(...bytes));
  });
  await page.locator("#file").setInputFiles({ name: "red.png", mimeType: "image/png", buffer: Buffer.from(base64, "base64") });
  await page.waitForFunction(() => document.querySelector("#choose-photo option:checked")?.textContent === "red.png" && document.body.dataset.state === "ready");
  return { page, errors, close: () => context.close() };
}

/** The middle of a canvas, in Display P3. @param {Page} page @param {string} id */
const middleOf = (page, id) =>
  page.evaluate((id) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(id));
    return [...(canvas.getContext("2d")?.getImageData(canvas.width / 2 + 20, canvas.height / 2 + 20, 1, 1, { colorSpace: "display-p3" }).data ?? [])];
  }, id);

/** A file's pixel a little beside the middle, in Display P3. @param {Page} page @param {Buffer} bytes */
const inFile = (page, bytes) =>
  page.evaluate(async (base64) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], { type: "image/png" }));
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d", { colorSpace: "display-p3" }));
    context.drawImage(bitmap, 0, 0);
    return [...context.getImageData(bitmap.width / 2 + 30, bitmap.height / 2 + 30, 1, 1).data];
  }, bytes.toString("base64"));

/** As red as sRGB can be, in Display P3. */
const SRGB_RED = [234, 51, 35, 255];

/** @param {number[]} found @param {number[]} wanted */
const near = (found, wanted) => assert.ok(found.length === 4 && found.every((byte, k) => Math.abs(byte - wanted[k]) <= 2), `${found} is not ${wanted}`);

for (const [path, ids] of /** @type {const} */ ([["", ["photo", "disk"]], ["formula.html#f=z&wrap=clamp", ["source", "target"]], ["cortex.html", ["seen"]]])) {
  test(`${path || "index.html"}: the red of Display P3 stays as it is on a wide screen, and is the reddest of sRGB elsewhere`, async () => {
    const wide = await openRed("p3", path);
    for (const id of ids) near(await middleOf(wide.page, id), [255, 0, 0, 255]);
    const file = (await saved(wide.page, "#save-picture")).bytes;
    assert.ok(file.includes(Buffer.from([0x63, 0x49, 0x43, 0x50, 12, 13, 0, 1])), "the file says that it is Display P3");
    near(await inFile(wide.page, file), [255, 0, 0, 255]);
    assert.deepEqual(wide.errors, []);
    await wide.close();
    const usual = await openRed("srgb", path);
    for (const id of ids) near(await middleOf(usual.page, id), SRGB_RED);
    const other = (await saved(usual.page, "#save-picture")).bytes;
    assert.ok(other.includes(Buffer.from([0x73, 0x52, 0x47, 0x42, 0])), "the file says that it is sRGB");
    near(await inFile(usual.page, other), SRGB_RED);
    assert.deepEqual(usual.errors, []);
    await usual.close();
  });
}

test("values as colours are sRGB's on every screen, and in files", async () => {
  const seen = [];
  for (const gamut of /** @type {const} */ (["p3", "srgb"])) {
    const { page, errors, close } = await openRed(gamut, "formula.html#f=z&view=0,0,4&colours=hue");
    seen.push(await middleOf(page, "target"), await inFile(page, (await saved(page, "#save-picture")).bytes));
    assert.deepEqual(errors, []);
    await close();
  }
  near(seen[0], seen[2]);
  near(seen[1], seen[3]);
});
