// The page of electric fields: known capacitances, potentials by pointer and keys, addresses.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openPage, screenshot, settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** The number in a row of the evidence. @param {Page} page @param {string} name */
async function value(page, name) {
  const row = page.locator("#evidence > div", { has: page.locator("dt", { hasText: name }) });
  return parseFloat(await row.locator("dd").first().innerText());
}

/** ε₀ in picofarads a metre. */
const EPSILON = 8.854187817;

test("two wires, and a wire beside a shield's middle, have the capacitance of the books", async () => {
  const { page, errors, close } = await openPage(session, "fields.html#set=pair");
  assert.ok(Math.abs((await value(page, "Capacitance")) - (Math.PI * EPSILON) / Math.acosh(1.8 / 0.8)) < 0.01);
  await page.locator("#set").selectOption("coax");
  await page.waitForFunction(() => location.hash.startsWith("#set=coax") && document.body.dataset.state === "ready");
  const [R, r, d2] = [1.65, 0.4, 0.3 ** 2 + 0.1 ** 2];
  const expected = (2 * Math.PI * EPSILON) / Math.acosh((R * R + r * r - d2) / (2 * R * r));
  assert.ok(Math.abs((await value(page, "Capacitance")) - expected) < 0.02, `${await value(page, "Capacitance")} for ${expected}`);
  assert.ok(Math.abs((await value(page, "As a line")) - (376.730313 * EPSILON) / expected) < 0.1);
  assert.deepEqual(errors, []);
  await close();
});

test("a press on a conductor, or its number, changes its potential, and the address keeps it", async () => {
  const { page, errors, close } = await openPage(session, "fields.html#set=three");
  const box = await page.locator("#field").boundingBox();
  assert.ok(box);
  const ready = (/** @type {string} */ volts) => page.waitForFunction((wanted) => location.hash.endsWith(`volts=${wanted}`) && document.body.dataset.state === "ready", volts);
  // The first wire lies at (−1.1, −0.5) of a plane six wide.
  await page.mouse.click(box.x + (box.width * (3 - 1.1)) / 6, box.y + box.height / 2 + (box.width * 0.5) / 6);
  await ready("-1,1,-1");
  await page.keyboard.press("3");
  await ready("-1,1,0");
  await page.reload();
  await settled(page, "ready");
  assert.match(page.url(), /volts=-1,1,0/);
  assert.match(await page.locator("#reading").innerText(), /1: −.*2: [\d.]+, 3: /);
  assert.deepEqual(errors, []);
  await close();
});

test("every set of conductors is drawn", async () => {
  const { page, errors, close } = await openPage(session, "fields.html");
  for (const name of await page.locator("#set option").evaluateAll((all) => all.map((option) => /** @type {HTMLOptionElement} */ (option).value))) {
    await page.locator("#set").selectOption(name);
    await page.waitForFunction((set) => location.hash.startsWith(`#set=${set}&`) && document.body.dataset.state === "ready", name);
    await screenshot(page, `fields-${name}`);
  }
  for (const layer of ["potential", "levels", "lines"]) {
    await page.locator(`#${layer}`).click();
    assert.equal(await page.locator(`#${layer}`).getAttribute("aria-pressed"), "false");
  }
  assert.deepEqual(errors, []);
  await close();
});

test("an address with something else in it is said in words, and the rest is drawn", async () => {
  const { page, errors, close } = await openPage(session, "fields.html#set=toString&volts=5");
  assert.match(await page.locator("#remark p").innerText(), /“set=toString” must be one of pair/);
  assert.ok((await value(page, "Capacitance")) > 19);
  assert.deepEqual(errors, []);
  await close();
});
