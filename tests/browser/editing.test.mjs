// Drawing, keyboard, files, addresses: the ways in which a region and a photo come in.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { chosenPhoto, disk, drag, handle, middle, onPhoto, openPage, openQuarters, screenshot, settled, startBrowser } from "./support/page.mjs";

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** @param {import("playwright-core").Page} page */
const pointCount = (page) => page.locator("#photo-marks .vertex").count();

test("a region drawn corner by corner closes at its first corner", async () => {
  const { page, errors, close } = await openPage(session);
  await page.locator("#draw").click();
  for (const [x, y] of [[0.2, 0.2], [0.8, 0.25], [0.7, 0.8], [0.45, 0.5], [0.25, 0.75]]) {
    const at = await onPhoto(page, x, y);
    await page.mouse.click(at.x, at.y);
  }
  await screenshot(page, "drawing");
  const first = await onPhoto(page, 0.2, 0.2);
  await page.mouse.click(first.x + 3, first.y - 2);
  await settled(page, "ready");
  assert.equal(await pointCount(page), 5);
  assert.equal((await disk(page)).thinnestInside, 255);
  assert.deepEqual(errors, []);
  await close();
});

test("a region drawn in one stroke becomes an outline; Esc gives a drawing up", async () => {
  const { page, errors, close } = await openPage(session);
  const before = await disk(page);
  await page.locator("#draw").click();
  const start = await onPhoto(page, 0.8, 0.5);
  await page.mouse.click(start.x, start.y);
  await page.keyboard.press("Escape");
  assert.equal((await disk(page)).digest, before.digest);

  await page.locator("#draw").click();
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  for (let k = 1; k <= 80; k++) {
    const angle = (2 * Math.PI * k) / 80;
    const at = await onPhoto(page, 0.5 + 0.3 * Math.cos(angle), 0.5 - 0.3 * Math.sin(angle));
    await page.mouse.move(at.x, at.y);
  }
  await page.mouse.up();
  await settled(page, "ready");
  const count = await pointCount(page);
  assert.ok(count >= 2 && count <= 16, `${count} curves for a circle`);
  // The map of a disk onto a disk is a similarity: the conformal radius is the radius, 0.3 of a photo of width 2.
  const radius = Number((await page.locator("#evidence").innerText()).match(/Conformal radius\s+([\d.]+)/)?.[1]);
  assert.ok(Math.abs(radius - 0.6) < 0.01, `conformal radius ${radius}`);
  assert.deepEqual(errors, []);
  await close();
});

test("pressing an edge adds a point, a double click or Delete removes it", async () => {
  const { page, errors, close } = await openPage(session, "#shape=star");
  const [a, b] = [await middle(handle(page, "vertex", 0)), await middle(handle(page, "vertex", 1))];
  const half = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  await drag(page, half, { x: half.x + 5, y: half.y - 30 });
  await settled(page, "ready");
  assert.equal(await pointCount(page), 11);
  await page.keyboard.press("Delete");
  await settled(page, "ready");
  assert.equal(await pointCount(page), 10);
  const corner = await middle(handle(page, "vertex", 2));
  await page.mouse.dblclick(corner.x, corner.y);
  await settled(page, "ready");
  assert.equal(await pointCount(page), 9);
  assert.equal((await disk(page)).thinnestInside, 255);
  assert.deepEqual(errors, []);
  await close();
});

test("the keyboard alone moves points and both ends of the vector", async () => {
  const { page, errors, close } = await openPage(session);
  const first = await disk(page);
  const from = await middle(handle(page, "vertex", 0));
  await handle(page, "vertex", 0).focus();
  await page.keyboard.press("Shift+ArrowLeft");
  await page.keyboard.press("ArrowUp");
  await settled(page, "ready");
  const to = await middle(handle(page, "vertex", 0));
  assert.deepEqual([Math.round(to.x - from.x), Math.round(to.y - from.y)], [-10, -1]);
  const second = await disk(page);
  assert.notEqual(second.digest, first.digest);
  await handle(page, "center").focus();
  await page.keyboard.press("Shift+ArrowDown");
  await settled(page, "ready");
  assert.notEqual((await disk(page)).digest, second.digest);
  assert.deepEqual(errors, []);
  await close();
});

test("another photo comes by file, by drop, by name; a file that is none is said so", async () => {
  const { page, errors, close } = await openPage(session);
  const first = await disk(page);
  await openQuarters(page);
  const second = await disk(page);
  assert.notEqual(second.digest, first.digest);

  await page.evaluate(async (name) => {
    const blob = await (await fetch(name)).blob();
    const files = new DataTransfer();
    files.items.add(new File([blob], "dropped.jpg", { type: "image/jpeg" }));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: files, bubbles: true, cancelable: true }));
  }, "images/coffee.jpg");
  await chosenPhoto(page, "dropped.jpg");
  await settled(page, "ready");
  const third = await disk(page);
  assert.notEqual(third.digest, second.digest);
  assert.equal(third.thinnestInside, 255);

  await page.locator("#file").setInputFiles({ name: "notes.txt", mimeType: "text/plain", buffer: Buffer.from("no picture") });
  await page.locator("#remark").waitFor();
  assert.match(await page.locator("#remark").innerText(), /“notes\.txt” could not be read as a picture/);
  // The disk is as good as it was.
  assert.equal(await page.evaluate(() => document.body.dataset.state), "ready");
  assert.equal(await page.locator("#notice").innerText(), "");
  assert.equal((await disk(page)).digest, third.digest);

  await page.locator("#choose-photo").selectOption("astronaut");
  await settled(page, "ready");
  assert.equal((await disk(page)).digest, first.digest);
  assert.deepEqual(errors, []);
  await close();
});

test("the address holds the drawing: opened elsewhere it gives the same picture", async () => {
  const { page, close } = await openPage(session, "#image=coffee&shape=star");
  const first = await disk(page);
  const address = new URL(page.url()).hash;
  assert.match(address, /image=coffee/);
  const other = await openPage(session, address);
  assert.equal(await pointCount(other.page), 10);
  const second = await disk(other.page);
  assert.ok(second.colours > 5000 && second.thinnestInside === 255);
  // Written with four decimals, read again: the drawing is the same from then on.
  await other.page.reload();
  await settled(other.page, "ready");
  assert.equal((await disk(other.page)).digest, second.digest);
  assert.equal(first.width, second.width);
  assert.deepEqual(other.errors, []);
  await other.close();

  const garbled = await openPage(session, "#image=nobody&region=1,2;x&center=&show=zebra");
  assert.equal(await garbled.page.locator("#choose-photo").inputValue(), "astronaut");
  assert.deepEqual(garbled.errors, []);
  await garbled.close();
  await close();
});

test("one looks closer at photo and disk by wheel, buttons and keys, edits there, and sees all again", async () => {
  const { page, errors, close } = await openPage(session);
  const whole = await disk(page);
  const at = await middle(handle(page, "vertex", 3));
  await page.mouse.move(at.x, at.y);
  const scrolled = await page.evaluate(() => window.scrollY);
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -800);
  await page.keyboard.up("Control");
  const near = await middle(handle(page, "vertex", 3));
  // A wheel's event knows whole pixels only.
  assert.ok(Math.hypot(near.x - at.x, near.y - at.y) < 4, "what is under the pointer stays there");
  const [a, b] = [await middle(handle(page, "vertex", 2)), await middle(handle(page, "vertex", 4))];
  assert.ok(Math.hypot(a.x - b.x, a.y - b.y) > 100, "its neighbours are farther apart");
  assert.equal(await page.evaluate(() => window.scrollY), scrolled);
  await screenshot(page, "closer");
  await drag(page, near, { x: near.x + 30, y: near.y - 12 });
  const moved = await middle(handle(page, "vertex", 3));
  assert.ok(Math.hypot(moved.x - near.x - 30, moved.y - near.y + 12) < 1);
  await settled(page, "ready");
  await page.keyboard.press("Control+z");
  await page.locator("#photo-stage .zoom button").nth(2).click();
  const back = await middle(handle(page, "vertex", 3));
  assert.ok(Math.hypot(back.x - at.x, back.y - at.y) < 1);
  await settled(page, "ready");
  assert.equal((await disk(page)).digest, whole.digest);

  await page.locator(".target .zoom button").first().focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("ArrowLeft");
  await settled(page, "ready");
  assert.notEqual((await disk(page)).digest, whole.digest);
  await page.keyboard.press("0");
  await settled(page, "ready");
  assert.equal((await disk(page)).digest, whole.digest);
  assert.deepEqual(errors, []);
  await close();
});
