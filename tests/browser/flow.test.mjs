// The page of flows: lift where there is some, none where there is none; turning, drawing, loading, keeping.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { naca } from "../../www/js/flow/bodies.js";
import { drag, openPage, screenshot, settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

const reading = (/** @type {Page} */ page) => page.locator("#reading").innerText();

/** The circulation that the page reads. @param {Page} page */
async function circulation(page) {
  const [found] = (await reading(page)).replaceAll("−", "-").match(/-?\d+\.\d+/) ?? [];
  return Number(found);
}

/** A sum over the picture without what moves. @param {Page} page */
function picture(page) {
  return page.evaluate(() => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("flow"));
    const data = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
    let digest = 0;
    for (const value of data) digest = (Math.imul(digest, 31) + value) | 0;
    return digest;
  });
}

/** A point of the picture, in shares of its sides. @param {Page} page @param {number} x @param {number} y */
async function at(page, x, y) {
  const box = await page.locator("#flow").boundingBox();
  if (!box) throw new Error("The picture is not on the page.");
  return { x: box.x + x * box.width, y: box.y + y * box.height };
}

test("a wing is lifted by Kutta's circulation, as much as thin wings of its thickness are", async () => {
  const { page, errors, close } = await openPage(session, "flow.html#body=symmetric&angle=4&show=lines");
  // 2π(1 + 0.77 t) sin α is the exact lift of Joukowski's symmetric wings; a NACA wing of the same thickness is near it.
  const expected = -0.5 * 2.2 * 2 * Math.PI * (1 + 0.77 * 0.12) * Math.sin((4 * Math.PI) / 180);
  const found = await circulation(page);
  assert.ok(Math.abs(found / expected - 1) < 0.03, `${found} for ${expected}`);
  await page.locator("#angle").fill("0");
  assert.match(await reading(page), /no lift/);
  assert.deepEqual(errors, []);
  await close();
});

test("a cylinder has no lift until the fluid turns around it, and the address keeps that", async () => {
  const { page, errors, close } = await openPage(session, "flow.html#body=circle&show=pressure,lines");
  assert.match(await reading(page), /no lift/);
  assert.ok(await page.locator("#kutta").isDisabled(), "a cylinder has no edge");
  const before = await picture(page);
  await page.locator("#circulation").fill("-3");
  assert.match(await reading(page), /Circulation −3\.00 .* lift 3\.6/);
  assert.notEqual(await picture(page), before);
  assert.match(page.url(), /circulation=-3/);
  await page.reload();
  await settled(page, "ready");
  assert.equal(await circulation(page), -3);
  assert.deepEqual(errors, []);
  await close();
});

test("a drag turns the wind, specks move, and every body of the list is drawn", async () => {
  const { page, errors, close } = await openPage(session, "flow.html");
  const first = await circulation(page);
  await drag(page, await at(page, 0.3, 0.6), await at(page, 0.3, 0.5));
  assert.ok((await circulation(page)) < first, "the wind comes from further below");
  const now = await picture(page);
  await page.waitForFunction((now) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("flow"));
    const data = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
    let digest = 0;
    for (const value of data) digest = (Math.imul(digest, 31) + value) | 0;
    return digest !== now;
  }, now);
  for (const name of await page.locator("#body option:not([hidden])").evaluateAll((all) => all.map((option) => /** @type {HTMLOptionElement} */ (option).value))) {
    await page.locator("#body").selectOption(name);
    await page.waitForFunction((body) => location.hash.includes(`body=${body}`) && document.body.dataset.state === "ready", name);
    assert.match(await reading(page), /Circulation/);
    await screenshot(page, `flow-${name}`);
  }
  assert.deepEqual(errors, []);
  await close();
});

test("a vortex is put into the fluid, dragged, turned over and removed, and the address keeps it", async () => {
  const { page, errors, close } = await openPage(session, "flow.html#body=wing&angle=6&show=pressure,lines");
  const alone = await circulation(page);
  await page.locator("#vortex").click();
  await page.waitForFunction(() => location.hash.includes("vortices=-1.9,0.7,2"));
  await settled(page, "ready");
  const beside = await circulation(page);
  assert.ok(Math.abs(beside - alone) > 0.05, `${beside} with a vortex, ${alone} without: the edge asks for another circulation`);
  // 6 m of the plane across.
  const from = await at(page, 0.5 - 1.9 / 6, 0.5 - 0.7 / 3.6);
  await drag(page, from, await at(page, 0.5 + 1.8 / 6, 0.5 - 1.2 / 3.6));
  await page.waitForFunction(() => /vortices=1\.(7|8)\d*,1\.(1|2)\d*,2/.test(location.hash));
  await settled(page, "ready");
  await page.locator('#flow[data-lines="traced"]').waitFor();
  await screenshot(page, "flow-vortex");
  const behind = await circulation(page);
  assert.notEqual(behind, beside);
  await page.reload();
  await settled(page, "ready");
  assert.equal(await circulation(page), behind, "the address keeps it");
  const there = await at(page, 0.5 + 1.8 / 6, 0.5 - 1.2 / 3.6);
  await page.mouse.dblclick(there.x, there.y);
  await page.waitForFunction(() => /vortices=[^&]*,-2/.test(location.hash));
  await settled(page, "ready");
  assert.ok(Math.abs(await circulation(page) - alone + (behind - alone)) < 0.03, "the other way around it asks for as much less");
  await page.mouse.click(there.x, there.y);
  await page.keyboard.press("Delete");
  await page.waitForFunction(() => !location.hash.includes("vortices"));
  await settled(page, "ready");
  assert.equal(await circulation(page), alone);
  await page.locator("#vortex").click();
  await page.waitForFunction(() => location.hash.includes("vortices=-1.9,0.7,2"));
  await settled(page, "ready");
  await page.waitForFunction(() => document.getElementById("reading")?.textContent?.includes("around what is in the wind"));
  assert.doesNotMatch(await reading(page), /lift/, "beside a vortex that is not the circulation's");
  await drag(page, from, await at(page, 0.5, 1.03));
  await page.waitForFunction(() => !location.hash.includes("vortices"));
  assert.deepEqual(errors, []);
  await close();
});

test("vortices are moved, turned over, chosen and removed by keys", async () => {
  const { page, errors, close } = await openPage(session, "flow.html#body=wing&angle=6&show=pressure,lines");
  await page.locator("#vortex").focus();
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => location.hash.includes("vortices=-1.9,0.7,2"));
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("-");
  await page.waitForFunction(() => location.hash.includes("vortices=-1.95,0.75,-2"));
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => location.hash.includes("vortices=-1.95,0.75,-2;"));
  await page.keyboard.press("v");
  await page.keyboard.press("Delete");
  await page.waitForFunction(() => /vortices=[^;&]+,2(&|$)/.test(location.hash), null, { timeout: 5000 });
  // A slider has the arrows to itself.
  const before = await page.evaluate(() => location.hash.match(/vortices=[^&]+/)?.[0]);
  await page.locator("#angle").focus();
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => !/angle=6(&|$)/.test(location.hash));
  assert.equal(await page.evaluate(() => location.hash.match(/vortices=[^&]+/)?.[0]), before);
  assert.deepEqual(errors, []);
  await close();
});

test("a body of 60 vertices is dragged through the wind, and traced when it keeps still", async (context) => {
  const outline = Array.from({ length: 60 }, (_, k) => {
    const [t, r] = [(Math.PI * k) / 30, 0.8 * (1 + 0.15 * Math.sin((3 * Math.PI * k) / 30))];
    return `${(r * Math.cos(t)).toFixed(3)},${(0.6 * r * Math.sin(t)).toFixed(3)}`;
  });
  const { page, errors, close } = await openPage(session, `flow.html#outline=${outline.join(";")}&circulation=0&show=pressure,lines`);
  const start = await at(page, 0.1, 0.8);
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  // One move a frame; what the page does with it happens before the next.
  const rate = await page.locator("#flow").evaluate(async (canvas, { x, y }) => {
    const nextFrame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    const moves = 60;
    await nextFrame();
    const begin = performance.now();
    for (let k = 0; k < moves; k++) {
      canvas.dispatchEvent(new PointerEvent("pointermove", { pointerId: 1, clientX: x + k, clientY: y, bubbles: true }));
      await nextFrame();
    }
    return (1000 * moves) / (performance.now() - begin);
  }, start);
  await page.mouse.up();
  context.diagnostic(`dragging 60 vertices through the wind: ${rate.toFixed(0)} frames a second`);
  assert.ok(rate > 0, "it is drawn");
  const rough = await picture(page);
  await page.locator("#angle").fill("3");
  await page.locator('#flow[data-lines="traced"]').waitFor();
  assert.notEqual(await picture(page), rough);
  await screenshot(page, "flow-traced");
  assert.deepEqual(errors, []);
  await close();
});

test("an airfoil comes from a file, and a body from a stroke; one that crosses itself is refused in words", async () => {
  const { page, errors, close } = await openPage(session, "flow.html");
  const columns = naca("2415", 1, [0, 0]).map(([x, y]) => `${x.toFixed(5)} ${y.toFixed(5)}`);
  await page.locator("#file").setInputFiles({ name: "wing.dat", mimeType: "text/plain", buffer: Buffer.from(["NACA 2415", ...columns].join("\n")) });
  await page.waitForFunction(() => location.hash.includes("outline="));
  await settled(page, "ready");
  assert.ok((await circulation(page)) < -0.5, await reading(page));
  await page.locator("#draw").click();
  const way = [[0.4, 0.5], [0.45, 0.35], [0.6, 0.4], [0.62, 0.55], [0.5, 0.65], [0.41, 0.52]];
  const points = await Promise.all(way.map(([x, y]) => at(page, x, y)));
  await page.mouse.move(points[0].x, points[0].y);
  await page.mouse.down();
  for (const { x, y } of points.slice(1)) await page.mouse.move(x, y, { steps: 4 });
  await page.mouse.up();
  await settled(page, "ready");
  const drawn = page.url();
  assert.match(drawn, /outline=/);
  // Another body and back to one's own.
  await page.locator("#body").selectOption("circle");
  await page.waitForFunction(() => location.hash.includes("body=circle") && document.body.dataset.state === "ready");
  await page.locator("#body").selectOption("own");
  await page.waitForFunction((drawn) => location.href === drawn && document.body.dataset.state === "ready", drawn);
  await page.locator("#draw").click();
  const knot = await Promise.all([[0.3, 0.3], [0.6, 0.7], [0.6, 0.3], [0.3, 0.7], [0.3, 0.35]].map(([x, y]) => at(page, x, y)));
  await page.mouse.move(knot[0].x, knot[0].y);
  await page.mouse.down();
  for (const { x, y } of knot.slice(1)) await page.mouse.move(x, y, { steps: 4 });
  await page.mouse.up();
  assert.match(await page.locator("#remark p").innerText(), /crosses itself/);
  assert.equal(page.url(), drawn);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("#draw").getAttribute("aria-pressed"), "false");
  assert.deepEqual(errors, []);
  await close();
});

for (const [address, words] of /** @type {const} */ ([
  ["flow.html#body=toString", /“body=toString” must be one of wing/],
  ["flow.html#angle=900", /“angle=900” must be from -30 to 30/],
  ["flow.html#outline=1,2;3", /must be 3 to 400 points/],
  ["flow.html#vortices=1,2", /must be 1 to 6 of x,y,circulation/],
])) {
  test(`${address}: said in words, and the rest is drawn`, async () => {
    const { page, errors, close } = await openPage(session, address);
    assert.match(await page.locator("#remark p").innerText(), words);
    assert.match(await reading(page), /Circulation/);
    assert.deepEqual(errors, []);
    await close();
  });
}

for (const [name, width, height, colorScheme] of /** @type {const} */ ([["phone", 390, 844, "light"], ["desktop", 1280, 720, "dark"], ["wide", 2560, 1300, "light"]])) {
  test(`${name}, ${colorScheme}: the flow fits`, async () => {
    const { page, errors, close } = await openPage(session, "flow.html", { viewport: { width, height }, colorScheme });
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    assert.ok(overflow <= 0, `${overflow} pixels too wide`);
    const bottom = await page.locator("#flow").evaluate((canvas) => canvas.getBoundingClientRect().bottom);
    assert.ok(bottom <= height, "the picture is below the fold");
    await page.locator('#flow[data-lines="traced"]').waitFor();
    await screenshot(page, `flow-${name}-${colorScheme}`);
    assert.deepEqual(errors, []);
    await close();
  });
}
