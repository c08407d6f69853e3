// Outlines that people have: every kind of text, by file, drop, paste and dialog, placed on the photo and said in words.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { chooseOutline, looksLikeOutline, pathParts, placedOn } from "../../www/js/editor/outline-text.js";
import { onPhoto, openPage, screenshot, settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

const square = [[0, 0], [4, 0], [4, 3], [0, 3]];
const ring = [...square, square[0]];
const hole = [[1, 1], [2, 1], [2, 2], [1, 1]];
const small = [[10, 10], [11, 10], [11, 11], [10, 10]];
/** @param {number[][]} points */
const wkt = (points) => `(${points.map((p) => p.join(" ")).join(", ")})`;

/** No curve is read in these texts. @param {string} text @returns {never} */
const noCurves = (text) => {
  throw new Error(`no curve: ${text}`);
};

test("columns, airfoils, WKT and points become the same square; holes and smaller outlines are left out in words", () => {
  /** @type {[string, RegExp][]} */
  const texts = [
    ["0 0\n4 0\n4 3\n0 3\n", /two columns/],
    ["x,y\n0,0\n4,0\n4,3\n0,3\n0,0\n", /two columns/],
    ["# a comment\n0\t0\n4\t0\n\n4\t3\n0\t3", /two columns/],
    [JSON.stringify(ring), /points in JSON/],
    [`POLYGON (${wkt(ring)}, ${wkt(hole)})`, /WKT\. A hole is left out/],
    [`SRID=4326;MULTIPOLYGON ((${wkt(small)}), (${wkt(ring)}, ${wkt(hole)}))`, /WKT, the largest of its 2 outlines\. A hole/],
  ];
  for (const [text, said] of texts) {
    const found = chooseOutline(text, noCurves);
    assert.deepEqual([...found.outline].sort(), [...square].sort(), text);
    assert.match(found.said, said);
  }
  const foil = chooseOutline("NACA 6\n 3. 3.\n\n0 0\n0.5 0.1\n1 0\n\n0 0\n0.5 -0.05\n1 0\n", noCurves);
  assert.match(foil.said, /airfoil/);
  assert.deepEqual(foil.outline, [[0.5, 0.1], [0, 0], [0.5, -0.05], [1, 0]]);
});

test("GeoJSON's degrees are drawn as on Mercator's map", () => {
  const polygon = { type: "Polygon", coordinates: [[[10, 60], [12, 60], [12, 61], [10, 61], [10, 60]]] };
  const { outline, said } = chooseOutline(JSON.stringify({ type: "FeatureCollection", features: [{ type: "Feature", properties: {}, geometry: polygon }] }), noCurves);
  assert.match(said, /Mercator/);
  const heights = outline.map(([, y]) => y);
  // At 60.5° a degree of latitude is 1/cos 60.5° times as long as one of longitude.
  assert.ok(Math.abs(Math.max(...heights) - Math.min(...heights) - 1 / Math.cos((60.5 * Math.PI) / 180)) < 1e-3, String(heights));
});

test("a path is taken apart where it begins anew; ten thousand corners become few; what fits a photo is placed on it", () => {
  assert.deepEqual(pathParts("m10 10 h5 v5 h-5 z m20 0 h10 v10 h-10z"), ["M10 10h5 v5 h-5 Z", "M30 10h10 v10 h-10Z"]);
  const circle = Array.from({ length: 10000 }, (_, k) => `${Math.cos(k / 1591.5)} ${Math.sin(k / 1591.5)}`).join("\n");
  const { outline, said } = chooseOutline(circle, noCurves);
  assert.ok(outline.length >= 60 && outline.length <= 400, String(outline.length));
  assert.match(said, /of its 10000 corners are kept/);
  const [placed] = placedOn([{ boundary: [[0, 0], [10, 0], [10, 1], [0, 1]] }], { center: [0, 0], width: 2, pixels: [300, 200] });
  assert.deepEqual(placed.boundary.map((p) => p.map((x) => Number(x.toFixed(6)))), [[-0.84, -0.084], [0.84, -0.084], [0.84, 0.084], [-0.84, 0.084]]);
});

test("what is no outline is told from what is one", () => {
  for (const text of ["", "hello", "[1, 2]", "12 monkeys", "Moving on"]) assert.ok(!looksLikeOutline(text), text);
  for (const text of ["M0 0L1 1", " POLYGON ((0 0))", "[[0, 0]", '{"type":"Polygon","coordinates":[]}', "0 0\n1 0\n1 1\n0 1\n0 0"]) assert.ok(looksLikeOutline(text), text);
  for (const text of ["hello", '{"a": 1}', "[[0,0],[1,0]]", "1 2\n3 4\n5 6\nfoo", "0 0\n1 1\n2 2", '{"type":"Topology"}', "{"]) {
    assert.throws(() => chooseOutline(text, noCurves), (error) => error instanceof Error && error.message.length > 20, text);
  }
});

/** Drops a file on the page. @param {Page} page @param {string} name @param {string} type @param {string} text @param {string} [target] */
const drop = (page, name, type, text, target = "body") =>
  page.evaluate(({ name, type, text, target }) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], name, { type }));
    const place = document.querySelector(target);
    for (const event of ["dragover", "drop"]) place?.dispatchEvent(new DragEvent(event, { dataTransfer, bubbles: true, cancelable: true }));
  }, { name, type, text, target });

/** @param {Page} page @param {string} text */
const paste = (page, text) =>
  page.evaluate((text) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", text);
    document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true }));
  }, text);

/** Waits for words. @param {Page} page @param {string} words */
const said = (page, words) => page.waitForFunction((wanted) => !document.getElementById("remark")?.hidden && document.querySelector("#remark p")?.textContent?.includes(wanted), words);

/** Corners of the region. @param {Page} page @param {string} marks */
const corners = (page, marks) => page.locator(`#${marks} [data-part="vertex"]`).count();

test("outlines come by drop, paste and dialog, and a drawing of one shape is no photo", async () => {
  const { page, errors, close } = await openPage(session);
  await drop(page, "foil.dat", "", "NACA\n1 0\n0.5 0.1\n0 0\n0.5 -0.1\n");
  await said(page, "“foil.dat”: Read two columns of numbers.");
  assert.equal(await corners(page, "photo-marks"), 4);
  await settled(page, "ready");
  const [low, high] = [await onPhoto(page, 0.08, 0), await onPhoto(page, 0.92, 0)];
  const places = await page.locator('#photo-marks [data-part="vertex"]').evaluateAll((all) => all.map((dot) => dot.getBoundingClientRect()).map(({ x, width }) => x + width / 2));
  assert.ok(Math.abs(Math.min(...places) - low.x) < 1.5 && Math.abs(Math.max(...places) - high.x) < 1.5, "it is as large as fits");

  await paste(page, `MULTIPOLYGON ((${wkt(ring)}), (${wkt([[0, 0], [9, 0], [9, 9], [5, 12], [0, 9], [0, 0]])}))`);
  await said(page, "the largest of its 2 outlines");
  assert.equal(await corners(page, "photo-marks"), 5);

  const shape = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"><polygon points="0,0 9,0 9,9"/></svg>';
  await drop(page, "shape.svg", "image/svg+xml", shape);
  await said(page, "Read an SVG drawing.");
  assert.equal(await corners(page, "photo-marks"), 3);
  assert.equal(await page.locator("#choose-photo option:checked").innerText(), "Astronaut");
  await drop(page, "picture.svg", "image/svg+xml", shape.replace("<polygon", '<rect width="10" height="10" fill="red"/><polygon'));
  await page.waitForFunction(() => document.querySelector("#choose-photo option:checked")?.textContent === "picture.svg");
  await settled(page, "ready");

  await page.locator("#choose-shape").selectOption("read");
  await page.locator("#read-dialog textarea").fill("hello");
  await page.locator("#read-dialog button", { hasText: "Use it" }).click();
  await page.waitForFunction(() => document.querySelector("#read-dialog .refusal")?.textContent?.includes("nothing that can be read here"));
  await screenshot(page, "read-dialog");
  const two = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 30 30"><g transform="translate(3 0)"><path d="M0 0h2v2h-2zM5 5l9 0 0 9-4 4-5-4z"/><circle cx="1" cy="1" r="0.5"/></g></svg>';
  await page.locator("#read-dialog input[type=file]").setInputFiles({ name: "two.svg", mimeType: "image/svg+xml", buffer: Buffer.from(two) });
  await page.waitForFunction(() => /** @type {HTMLTextAreaElement | null} */ (document.querySelector("#read-dialog textarea"))?.value.startsWith("<svg"));
  await page.locator("#read-dialog button", { hasText: "Use it" }).click();
  await said(page, "the largest of its 3 outlines");
  assert.equal(await corners(page, "photo-marks"), 5);
  assert.ok(await page.locator("#read-dialog").isHidden());
  await settled(page, "ready");
  await screenshot(page, "outline-read");

  await drop(page, "list.txt", "text/plain", "1 2\n3 4\nmilk\n5 6");
  await said(page, "“list.txt” gives no outline. Line 3 has no two numbers: “milk”.");
  assert.equal(await corners(page, "photo-marks"), 5, "what was drawn is kept");
  await page.keyboard.press("Control+z");
  await settled(page, "ready");
  assert.deepEqual(errors, []);
  await close();
});

test("on two photos an outline goes to the side that it was dropped on, or asked for", async () => {
  const { page, errors, close } = await openPage(session, "regions.html");
  const [from, to] = [await corners(page, "from-marks"), await corners(page, "to-marks")];
  await drop(page, "a.wkt", "", `POLYGON (${wkt(ring)})`, "#to-stage");
  await said(page, "Read WKT.");
  assert.deepEqual([await corners(page, "from-marks"), await corners(page, "to-marks")], [from, 4]);
  assert.notEqual(to, 4);
  await page.locator("#from-choose-shape").selectOption("read");
  await page.locator("#read-dialog textarea").fill("0 0\n2 0\n1 1");
  await page.locator("#read-dialog button", { hasText: "Use it" }).click();
  await said(page, "Read two columns");
  assert.deepEqual([await corners(page, "from-marks"), await corners(page, "to-marks")], [3, 4]);
  await settled(page, "ready");
  assert.deepEqual(errors, []);
  await close();
});

test("where no outline is drawn, its file is refused in words", async () => {
  const { page, errors, close } = await openPage(session, "formula.html");
  await drop(page, "a.wkt", "", `POLYGON (${wkt(ring)})`);
  await said(page, "Outlines are drawn on the pages of regions.");
  assert.deepEqual(errors, []);
  await close();
});
