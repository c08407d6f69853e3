// Outlines of lines, arcs and Bézier curves on the page: drawn by hand, by handles, by letters and from files.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { arcThrough, asBezier, converted, pointOn, reversed, splitAt } from "../../www/js/editor/curve.js";
import { fitted } from "../../www/js/editor/fit.js";
import { area, nearestOnBoundary } from "../../www/js/editor/geometry.js";
import { counterClockwise, polygonOf } from "../../www/js/editor/outline.js";
import { planePath, readPath } from "../../www/js/editor/path.js";
import { canRemove, convertEdge, makeRegion, moveHandle, moveVertex, removeVertex, splitEdge } from "../../www/js/editor/region.js";
import { disk, drag, handle, middle, onPhoto, openPage, screenshot, settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("../../www/js/common/frame.js").Point} Point */
/** @typedef {import("../../www/js/editor/curve.js").Curve} Curve */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** @param {Point} p @param {Point} q */
const apart = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);

/** @type {[a: Point, b: Point, curve: Curve][]} */
const edges = [
  [[0, 0], [2, 1], null],
  [[0, 0], [2, 1], { kind: "arc", bulge: 0.4 }],
  [[0, 0], [2, 1], { kind: "arc", bulge: -2.5 }],
  [[0, 0], [2, 1], { kind: "curve", first: [1, -1], second: [3, 0] }],
  ...[true, false].flatMap((large) => [true, false].map((left) => /** @type {[Point, Point, Curve]} */ ([[0, 0], [2, 1], { kind: "ellipse", radii: [3, 1], turn: 20, large, left }]))),
];

test("an edge's parts, the edge run backwards and what it is converted to lie where it lies", () => {
  for (const [a, b, curve] of edges) {
    const { at, before, after } = splitAt(a, b, curve, 0.3);
    for (const t of [0.05, 0.2, 0.6, 0.95]) {
      const p = pointOn(a, b, curve, t);
      const part = t < 0.3 ? pointOn(a, at, before, t / 0.3) : pointOn(at, b, after, (t - 0.3) / 0.7);
      assert.ok(apart(p, part) < 1e-12, `${curve?.kind} ${t}`);
      assert.ok(apart(p, pointOn(b, a, reversed(curve), 1 - t)) < 1e-12, `${curve?.kind} ${t}`);
    }
    const middle = pointOn(a, b, curve, 0.5);
    assert.deepEqual(converted(a, b, curve, "line"), null);
    const arc = converted(a, b, curve, "arc");
    assert.equal(arc?.kind, "arc");
    if (curve) assert.ok(nearestOnBoundary(polygonOf({ boundary: [a, b], curves: [arc, null] }), middle).distance < 5e-3, curve.kind);
    if (curve?.kind !== "ellipse") assert.ok(apart(pointOn(a, b, asBezier(a, b, curve), 0.5), middle) < 1e-12);
    const again = arcThrough(a, b, pointOn(a, b, curve, 0.4));
    if (curve?.kind === "arc") assert.ok(again?.kind === "arc" && Math.abs(again.bulge - curve.bulge) < 1e-12);
  }
  assert.equal(arcThrough([0, 0], [2, 0], [1, 0]), null);
});

test("paths are read as they are written, and what is none is refused in words", () => {
  for (const path of ["M-1,0L1,0A1,1 0 0 1 -1,0Z", "M0,0A2,1 30 1 1 1,1Z", "M0,0C1,-1 2,0 2,2C0.5,2 0,1 0,0Z", "M1,0A1,1 0 0 1 -1,0A1,1 0 0 1 1,0Z"]) {
    assert.equal(planePath(readPath(path), (x) => String(Number(x.toFixed(6)))), path);
  }
  assert.ok(Math.abs(area(polygonOf(readPath("M-1 0H1A1 1 0 0 1-1 0Z"))) - Math.PI / 2) < 3e-3);
  // Radii that are too small are enlarged; a quadratic curve is a cubic one.
  assert.ok(Math.abs(area(polygonOf(readPath("M-1 0H1A.1.1 0 0 1-1 0Z"))) - Math.PI / 2) < 3e-3);
  assert.ok(Math.abs(area(polygonOf(readPath("M0 0Q1-2 2 0Z"))) - 4 / 3) < 3e-3);
  for (const [path, words] of /** @type {[string, RegExp][]} */ ([["M0 0L1 1Z", /no inside/], ["M0 0L1 1L0 1ZM3 3L4 4L3 4Z", /after its end/], ["M0 0l1 1Z", /“l”/], ["M0 0L1Z", /2 numbers after “L”/], ["", /two points/], ["M0 0L1 NaN", /2 numbers/]])) {
    assert.throws(() => readPath(path), words);
  }
});

test("a region keeps its shape when points are added, and its direction of running", () => {
  const leaf = makeRegion(readPath("M0 0C1-1 2 0 2 2A2.5 2.5 0 0 1 0 0Z"));
  const turned = makeRegion(counterClockwise({ boundary: [...leaf.boundary].reverse(), curves: [reversed(leaf.curves?.[0] ?? null), reversed(leaf.curves?.[1] ?? null)] }));
  assert.ok(Math.abs(area(polygonOf(turned)) - area(polygonOf(leaf))) < 1e-9);
  const far = (/** @type {Point[]} */ points, /** @type {Point[]} */ polygon) => Math.max(...points.map((p) => nearestOnBoundary(polygon, p).distance));
  let region = leaf;
  for (const [edge, at] of /** @type {[number, Point][]} */ ([[0, [1, -0.3]], [2, [0.3, 1.5]], [0, [0.5, -0.3]]])) region = splitEdge(region, edge, at);
  assert.equal(region.boundary.length, 5);
  assert.ok(far(polygonOf(region), polygonOf(leaf)) < 5e-3 && far(polygonOf(leaf), polygonOf(region)) < 5e-3);
  // A corner takes its control points along; a smooth joint stays one when a handle turns, unless it is to break.
  const moved = moveVertex(region, 1, [region.boundary[1][0] + 0.1, region.boundary[1][1]]);
  const [before, after] = [region.curves?.[1], moved.curves?.[1]];
  assert.ok(before?.kind === "curve" && after?.kind === "curve" && Math.abs(after.first[0] - before.first[0] - 0.1) < 1e-12);
  const bent = moveHandle(region, 1, "first", [region.boundary[1][0] + 0.2, region.boundary[1][1] + 0.1]);
  const second = bent.curves?.[0];
  const [jx, jy] = region.boundary[1];
  assert.ok(second?.kind === "curve" && Math.abs((second.second[0] - jx) * 0.1 - (second.second[1] - jy) * 0.2) < 1e-12 && second.second[0] < jx);
  assert.deepEqual(moveHandle(region, 1, "first", [1.2, 0], true).curves?.[0], region.curves?.[0]);
  while (canRemove(region, 1)) region = removeVertex(region, 1);
  assert.equal(region.boundary.length, 2);
  assert.equal(convertEdge(region, 0, "line"), region, "two points need a curve");
});

test("a stroke becomes few curves, with the corners that were drawn", () => {
  /** @type {(count: number, at: (turns: number) => Point) => Point[]} */
  const line = (count, at) => Array.from({ length: count }, (_, k) => at(k / count));
  const circle = fitted(line(300, (s) => [100 * Math.cos(2 * Math.PI * s), 100 * Math.sin(2 * Math.PI * s)]), 1.2, 10);
  assert.ok(circle.boundary.length <= 8, String(circle.boundary.length));
  for (const p of polygonOf(circle)) assert.ok(Math.abs(Math.hypot(...p) - 100) < 1.5);
  // Three straight sides, drawn by a hand that trembles.
  /** @type {Point[]} */
  const tips = [[0, 0], [200, 10], [90, 150]];
  const triangle = fitted(line(240, (s) => {
    const [side, t] = [Math.floor(3 * s), (3 * s) % 1];
    const [a, b] = [tips[side], tips[(side + 1) % 3]];
    return [a[0] + t * (b[0] - a[0]) + 0.4 * Math.sin(40 * s), a[1] + t * (b[1] - a[1]) + 0.4 * Math.cos(57 * s)];
  }), 1.2, 10);
  assert.ok(triangle.boundary.length <= 5, String(triangle.boundary.length));
  for (const tip of tips) assert.ok(triangle.boundary.some((p) => apart(p, tip) < 4), `${tip}`);
});

/** @param {Page} page */
const pointCount = (page) => page.locator('#photo-marks [data-part="vertex"]').count();

/** @param {Page} page */
const knobCount = (page) => page.locator('#photo-marks [data-part="handle"]').count();

/** The conformal radius that the page shows. @param {Page} page */
const radius = async (page) => (await page.locator("#evidence").innerText()).match(/Conformal radius\s+([\d.]+)/)?.[1];

/** The path in the address. @param {Page} page */
const path = (page) => new URLSearchParams(page.url().split("#")[1]).get("path");

test("a half disk in the address has the conformal radius 0.6 at i/2; bent by its handle it is another", async () => {
  const { page, errors, close } = await openPage(session, "#path=M-1,0L1,0A1,1,0,0,1,-1,0Z&center=0,0.5&toward=1,0");
  assert.equal(await radius(page), "0.6000");
  assert.deepEqual([await pointCount(page), await knobCount(page)], [2, 1]);
  assert.equal((await disk(page)).thinnestInside, 255);
  const knob = await middle(handle(page, "handle", 1));
  const top = await onPhoto(page, 0.5, 0);
  assert.ok(Math.abs(knob.x - top.x) < 1 && Math.abs(knob.y - top.y) < 1, "the handle is the arc's middle");
  await drag(page, knob, { x: knob.x, y: knob.y + 40 });
  await settled(page, "ready");
  assert.notEqual(await radius(page), "0.6000");
  assert.match(path(page) ?? "", /^M-1,0L1,0A1\.0\d+,/);
  await page.keyboard.press("Control+z");
  await settled(page, "ready");
  assert.equal(await radius(page), "0.6000");
  // By the keyboard, too.
  await handle(page, "handle", 1).focus();
  await page.keyboard.press("Shift+ArrowDown");
  await settled(page, "ready");
  assert.notEqual(await radius(page), "0.6000");
  assert.match((await handle(page, "handle", 1).getAttribute("aria-label")) ?? "", /Middle of the arc/);
  assert.deepEqual(errors, []);
  await close();
});

test("edges are made arcs, curves and lines by key, by the toolbar and by a menu at the edge", async () => {
  const { page, errors, close } = await openPage(session, "#shape=square");
  const straight = await radius(page);
  await handle(page, "vertex", 1).focus();
  await page.keyboard.press("a");
  await settled(page, "ready");
  assert.match(path(page) ?? "", /^M[^AC]*A[^AC]*Z$/);
  const arc = Number(await radius(page));
  assert.ok(arc > Number(straight), "an arc outwards makes the region larger");
  await page.keyboard.press("c");
  await settled(page, "ready");
  assert.match(path(page) ?? "", /^M[^AC]*C[^AC]*Z$/);
  assert.ok(Math.abs(Number(await radius(page)) - arc) < 5e-3, "a curve like the arc");
  assert.equal(await knobCount(page), 2);
  await page.keyboard.press("l");
  await settled(page, "ready");
  assert.equal(path(page), null);
  assert.equal(await radius(page), straight);

  await page.locator("#choose-edge").selectOption("arc");
  await settled(page, "ready");
  assert.equal(Number(await radius(page)), arc);
  assert.equal(await page.locator("#choose-edge").inputValue(), "arc");

  const [a, b] = [await middle(handle(page, "vertex", 2)), await middle(handle(page, "vertex", 3))];
  await page.mouse.click((a.x + b.x) / 2, (a.y + b.y) / 2, { button: "right" });
  await page.getByRole("menuitem", { name: /Curve/ }).click();
  await settled(page, "ready");
  assert.match(path(page) ?? "", /A.*C/);
  // A point put on the curve leaves it as it is.
  const before = await radius(page);
  await handle(page, "vertex", 2).focus();
  await page.keyboard.press("+");
  await settled(page, "ready");
  assert.equal(await pointCount(page), 5);
  assert.equal(await radius(page), before);
  assert.deepEqual(errors, []);
  await close();
});

test("a letter is a region as it is drawn; a link to it is the same letter", async () => {
  const { page, errors, close } = await openPage(session);
  await page.locator("#choose-shape").selectOption("letter");
  await page.keyboard.type("%&");
  await page.locator("dialog:open input").fill("☃");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.querySelector("dialog[open] .refusal")?.textContent?.includes("no outline of “☃”"));
  await page.locator("dialog:open input").fill("J");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.querySelector("#remark p")?.textContent?.includes("The letter “J”"));
  await settled(page, "ready");
  assert.ok((await pointCount(page)) > 15);
  assert.equal((await disk(page)).thinnestInside, 255);
  await screenshot(page, "letter");
  const shown = await radius(page);
  const again = await openPage(session, page.url().slice(page.url().indexOf("#")));
  assert.equal(await radius(again.page), shown);
  assert.deepEqual([...errors, ...again.errors], []);
  await again.close();
  await close();
});

test("a file's curves stay curves; strokes are drawn as curves", async () => {
  const { page, errors, close } = await openPage(session);
  await page.evaluate(() => {
    const dataTransfer = new DataTransfer();
    const text = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"><path d="M1 5a4 4 0 0 1 8 0q-1 4-4 4t-4-4zM4 4h1v1z"/></svg>';
    dataTransfer.items.add(new File([text], "cap.svg", { type: "image/svg+xml" }));
    for (const event of ["dragover", "drop"]) document.body.dispatchEvent(new DragEvent(event, { dataTransfer, bubbles: true, cancelable: true }));
  });
  await page.waitForFunction(() => document.querySelector("#remark p")?.textContent?.includes("its curves as they are."));
  await settled(page, "ready");
  // Half a circle comes as two quarters.
  assert.equal((path(page) ?? "").replace(/[^MLACZ]/g, ""), "MCAACZ");
  assert.equal(await pointCount(page), 7, "the triangle in it is its hole");

  await page.locator("#draw").click();
  const start = await onPhoto(page, 0.25, 0.75);
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  // A half disk: along its diameter, and back around.
  for (let k = 1; k <= 40; k++) {
    const at = await onPhoto(page, 0.25 + (0.5 * k) / 40, 0.75);
    await page.mouse.move(at.x, at.y);
  }
  for (let k = 1; k <= 60; k++) {
    const at = await onPhoto(page, 0.5 + 0.25 * Math.cos((Math.PI * k) / 60), 0.75 - 0.25 * Math.sin((Math.PI * k) / 60));
    await page.mouse.move(at.x, at.y);
  }
  await page.mouse.up();
  await settled(page, "ready");
  assert.ok((await pointCount(page)) <= 8, String(await pointCount(page)));
  assert.match(path(page) ?? "", /C/);
  await screenshot(page, "stroke");
  assert.deepEqual(errors, []);
  await close();
});

test("a cusp that points inwards is refused in words, a horn is not; regions of curves go into each other; overlays follow curves", async () => {
  const { page, errors, close } = await openPage(session, "#shape=heart&show=measure,grid");
  await screenshot(page, "heart-measure");
  await page.goto(session.url + "regions.html");
  await settled(page, "ready");
  await page.locator("#from-choose-shape").selectOption("half");
  await settled(page, "ready");
  await page.locator("#to-choose-shape").selectOption("heart");
  await settled(page, "ready");
  assert.match(await page.locator("#evidence").innerText(), /Turned over\s+none/);
  await screenshot(page, "half-to-heart");
  await page.goto(session.url + "#path=M0,0A.5,.5,0,0,1,-.5,.5L-1,.5L-1,-.5L1,-.5L1,.5L.5,.5A.5,.5,0,0,1,0,0Z");
  await settled(page, "invalid");
  assert.match(await page.locator("#notice").innerText(), /turns back on itself/);
  // A tip without an angle that is the region's own is solved, and nothing to be repaired.
  await page.goto(session.url + "#path=M1,0A1,1,0,0,1,-1,0A.5,.5,0,0,0,0,0A.5,.5,0,0,0,1,0Z&center=0,.7&toward=0,1&show=grid");
  await settled(page, "ready");
  assert.match(await page.locator("#evidence").innerText(), /Turned over\s+none/);
  assert.ok(await page.getByRole("button", { name: "Repair outline" }).isHidden());
  await screenshot(page, "arbelos");
  assert.deepEqual(errors, []);
  await close();
});
