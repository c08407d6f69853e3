// The main job, in a real browser: a region on a photo, and its conformal image on the disk.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { disk, drag, handle, middle, onPhoto, openPage, openQuarters, screenshot, settled, startBrowser, toggle } from "./support/page.mjs";

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

test("opening shows a warped photo, with its evidence in words", async () => {
  const { page, errors, close } = await openPage(session);
  const picture = await disk(page);
  assert.equal(picture.thinnestInside, 255, "a hole in the disk");
  assert.equal(picture.thickestOutside, 0, "pixels outside the disk");
  assert.ok(picture.colours > 5000, `only ${picture.colours} colours: not a photo`);
  const evidence = await page.locator("#evidence").innerText();
  for (const words of ["Estimated error", "Unknowns", "Conformal radius", "Triangles", "none", "ms"]) {
    assert.ok(evidence.includes(words), `“${words}” is missing in: ${evidence}`);
  }
  assert.equal(await page.locator("#notice").innerText(), "");
  await screenshot(page, "opening");
  assert.deepEqual(errors, []);
  await close();
});

test("dragging a point changes the picture; undo brings the very same one back", async () => {
  const { page, errors, close } = await openPage(session);
  const first = await disk(page);
  const from = await middle(handle(page, "vertex", 0));
  await drag(page, from, { x: from.x - 40, y: from.y - 30 });
  await settled(page, "ready");
  const second = await disk(page);
  assert.notEqual(second.digest, first.digest);
  assert.equal(second.thinnestInside, 255);
  await page.keyboard.press("Control+z");
  await settled(page, "ready");
  assert.equal((await disk(page)).digest, first.digest);
  await page.locator("#redo").click();
  await settled(page, "ready");
  assert.equal((await disk(page)).digest, second.digest);
  assert.deepEqual(errors, []);
  await close();
});

test("an outline that crosses itself is said so in words, in red, and the last picture stays", async () => {
  const { page, errors, close } = await openPage(session, "#shape=square");
  const good = await disk(page);
  await page.mouse.move(0, 0);
  const [from, across] = [await middle(handle(page, "vertex", 0)), await middle(handle(page, "vertex", 2))];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  // Past the far side: the corner's two edges cross the others.
  await page.mouse.move(across.x + 40, (from.y + across.y) / 2 + 20);
  await settled(page, "invalid");
  assert.match(await page.locator("#notice").innerText(), /These two red edges cross/);
  assert.equal(await page.locator(".edge.wrong").count(), 2);
  await screenshot(page, "crossing");
  await page.mouse.up();
  await settled(page, "invalid");
  const kept = await disk(page);
  assert.ok(kept.colours > 5000 && kept.thinnestInside === 255, "the last good picture is gone");
  await page.locator("#undo").click();
  await settled(page, "ready");
  assert.equal(await page.locator("#notice").innerText(), "");
  assert.equal(await page.locator(".edge.wrong").count(), 0);
  assert.equal((await disk(page)).digest, good.digest);
  assert.deepEqual(errors, []);
  await close();
});

test("the vector's ends: the centre goes to 0, the other end to 1, on a picture with known colours", async () => {
  const { page, errors, close } = await openPage(session);
  await openQuarters(page);
  await page.locator("#choose-shape").selectOption("square");
  await settled(page, "ready");
  // Centre in the middle, 1 at the right: the quarters keep their places on the disk.
  /** @type {[number, number][]} */
  const places = [[-0.4, 0.4], [0.4, 0.4], [0.4, -0.4], [-0.4, -0.4]];
  const [red, green, blue, white] = [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255, 255, 255, 255]];
  assert.deepEqual((await disk(page, places)).samples, [red, green, blue, white]);

  // The outer end to the middle of the upper edge: the disk turns by a quarter, clockwise.
  await drag(page, await middle(handle(page, "toward")), await onPhoto(page, 0.5, 0.05));
  await settled(page, "ready");
  assert.deepEqual((await disk(page, places)).samples, [white, red, green, blue]);

  await drag(page, await middle(handle(page, "center")), await onPhoto(page, 0.7, 0.7));
  await settled(page, "ready");
  assert.deepEqual((await disk(page, [[0, 0]])).samples, [blue]);
  assert.deepEqual(errors, []);
  await close();
});

test("the disk itself can be dragged: what was under the pointer stays under it, and upright turns it back", async () => {
  const { page, errors, close } = await openPage(session);
  await openQuarters(page);
  await page.locator("#choose-shape").selectOption("square");
  await settled(page, "ready");
  const { x, y, width } = /** @type {{ x: number, y: number, width: number }} */ (await page.locator("#disk").boundingBox());
  /** @param {number} u @param {number} v of the disk, on the screen */
  const at = (u, v) => ({ x: x + width * (0.5 + u / 2.12), y: y + width * (0.5 - v / 2.12) });
  await drag(page, at(0.15, 0.15), at(-0.5, -0.5));
  await settled(page, "ready");
  const [green, blue, white] = [[0, 255, 0, 255], [0, 0, 255, 255], [255, 255, 255, 255]];
  // The corner where the four quarters meet has gone to the lower left, beyond (−0.5, −0.5).
  assert.deepEqual((await disk(page, [[0, 0], [-0.5, -0.5], [-0.45, -0.85], [-0.85, -0.45]])).samples, [green, green, blue, [255, 0, 0, 255]]);
  assert.deepEqual((await disk(page, [[-0.66, -0.7]])).samples, [white]);
  assert.equal((await disk(page)).thinnestInside, 255);

  await drag(page, await middle(handle(page, "toward")), await onPhoto(page, 0.5, 0.05));
  await settled(page, "ready");
  const turned = (await disk(page)).digest;
  await page.locator("#upright").click();
  await settled(page, "ready");
  assert.notEqual((await disk(page)).digest, turned);
  assert.deepEqual(errors, []);
  await close();
});

test("a centre outside the outline is said so in words, and comes back", async () => {
  const { page, errors, close } = await openPage(session);
  const first = await disk(page);
  const home = await middle(handle(page, "center"));
  await drag(page, home, await onPhoto(page, 0.95, 0.95));
  await settled(page, "invalid");
  assert.match(await page.locator("#notice").innerText(), /round end of the vector lies outside the outline/);
  await drag(page, await middle(handle(page, "center")), { x: home.x + 12, y: home.y });
  await settled(page, "ready");
  assert.notEqual((await disk(page)).digest, first.digest);
  assert.equal(await page.locator("#notice").innerText(), "");
  assert.deepEqual(errors, []);
  await close();
});

test("triangles and polar grid are drawn on both sides, and the address remembers them", async () => {
  const { page, errors, close } = await openPage(session);
  /** @param {string} id */
  const inked = (id) =>
    page.evaluate((name) => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(name));
      const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).getImageData(0, 0, canvas.width, canvas.height);
      return data.reduce((sum, value) => (Math.imul(sum, 31) + value) | 0, 0);
    }, id);
  const bare = [await inked("photo"), await inked("disk-lines")];
  assert.equal(bare[1], 0, "lines on the disk before any were asked for");
  await toggle(page, "mesh");
  const meshed = [await inked("photo"), await inked("disk-lines")];
  assert.ok(meshed[0] !== bare[0] && meshed[1] !== 0, "no triangles");
  await toggle(page, "mesh");
  await toggle(page, "grid");
  const gridded = [await inked("photo"), await inked("disk-lines")];
  assert.ok(gridded[0] !== bare[0] && gridded[0] !== meshed[0] && gridded[1] !== 0, "no polar grid");
  assert.match(page.url(), /show=grid$/);
  await page.reload();
  await settled(page, "ready");
  assert.ok(await page.locator("#grid").isChecked());
  assert.equal(await inked("disk-lines"), gridded[1]);
  await toggle(page, "mesh");
  await screenshot(page, "triangles-and-grid");
  assert.deepEqual(errors, []);
  await close();
});

test("the page answers while its worker solves", async () => {
  const { page, errors, close } = await openPage(session);
  const seen = await page.evaluate(async () => {
    const shape = /** @type {HTMLSelectElement} */ (document.getElementById("choose-shape"));
    const mesh = /** @type {HTMLInputElement} */ (document.getElementById("mesh"));
    shape.value = "coast";
    shape.dispatchEvent(new Event("change"));
    const state = document.body.dataset.state;
    mesh.click();
    return { state, shown: mesh.checked, points: document.querySelectorAll(".vertex").length };
  });
  assert.deepEqual(seen, { state: "working", shown: true, points: 100 });
  await settled(page, "ready");
  assert.equal((await disk(page)).thinnestInside, 255);
  await screenshot(page, "coast");
  assert.deepEqual(errors, []);
  await close();
});
