// Built projects in a real Chromium.

import { launchChromium } from "../../../tools/chromium.mjs";
import { serve } from "../../../tools/server.mjs";

/** @typedef {import("playwright-core").Browser} Browser */

/** @type {Promise<Browser> | undefined} */
let browser;

/** What a page says that it computed. @param {string} url */
export async function resultAt(url) {
  browser ??= launchChromium();
  const page = await (await browser).newPage();
  /** @type {string[]} */
  const said = [];
  page.on("console", (message) => said.push(message.text()));
  page.on("pageerror", (error) => said.push(String(error)));
  try {
    await page.goto(url);
    await page.waitForFunction(() => "result" in globalThis, undefined, { timeout: 40_000 });
    return await page.evaluate(() => /** @type {any} */ (globalThis).result);
  } catch (error) {
    throw new Error(`${error}\n${said.join("\n")}`);
  } finally {
    await page.close();
  }
}

/** The same of a folder. @param {string} folder @param {string} [path] */
export async function resultIn(folder, path = "") {
  const server = await serve(folder);
  try {
    return await resultAt(server.url + path);
  } finally {
    await server.close();
  }
}

export async function closeBrowser() {
  await (await browser)?.close();
}
