// The files that pages give away, and what is in them.

import { readFile } from "node:fs/promises";

/** @typedef {import("playwright-core").Page} Page */

/** The file that a button of the menu gives. @param {Page} page @param {string} button */
export async function saved(page, button) {
  const menu = page.locator("#save-menu");
  if (!(await menu.isVisible())) await page.locator("#save").click();
  const coming = page.waitForEvent("download");
  await page.locator(button).click();
  const file = await coming;
  return { name: file.suggestedFilename(), bytes: await readFile(await file.path()) };
}

/** Size and some pixels of a PNG file, as the browser reads it. @param {Page} page @param {Buffer} bytes @param {[number, number][]} at in shares of its sides */
export function pixelsOf(page, bytes, at) {
  return page.evaluate(async ({ base64, at }) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], { type: "image/png" }));
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d"));
    context.drawImage(bitmap, 0, 0);
    const pixels = at.map(([x, y]) => [...context.getImageData(Math.floor(x * bitmap.width), Math.floor(y * bitmap.height), 1, 1).data]);
    return { size: [bitmap.width, bitmap.height], pixels };
  }, { base64: bytes.toString("base64"), at });
}
