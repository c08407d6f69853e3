// The formula's page where a function has many values, or bends angles: cuts that are turned, sheets, dilatations.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import init, { FormulaMap } from "conformal-warp";
import { cutAt, turned, wholeTurn } from "../../www/js/formula/cut.js";
import { cutLines } from "../../www/js/formula/cut-lines.js";
import { dilatationOver, dilatationWords, drawEllipses, placeWords, slopes } from "../../www/js/formula/dilatation.js";
import { preimage } from "../../www/js/formula/inverse.js";
import { middle, openPage, screenshot, settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

await init();

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** @param {string} hash @param {import("playwright-core").BrowserContextOptions} [options] */
const openFormula = (hash, options = {}) => openPage(session, `formula.html${hash}`, options);

/** Places that belong to no pattern. */
const places = Float64Array.from({ length: 200 }, (_, k) => 5 * ((0.13 + 0.7548776662466927 * k) % 1) - 2.5);

/** The largest difference, in shares of the values; NaN belongs to NaN. @param {Float64Array} values @param {Float64Array} others */
const apart = (values, others) => Math.max(...values.map((x, k) => (Number.isNaN(x) && Number.isNaN(others[k]) ? 0 : Math.abs(x - others[k]) / (1 + Math.abs(x)))));

/** In every manner of writing. */
const BRANCHING = [
  "log(z)", "log z", "log²(z)", "ln^2 z", "2πi log z", "zlog(z)", "izsqrt(z)", "√z", "√(z+1)^3", "z^0.5", "z^(1/3)", "z^a", "-z^a", "2z^a^2", "z²^a", "z^-0.5", "e^z log(z)",
  "|z|^0.5 + |log z|", "||z|-2| sqrt(z)", "log10(z)", "lg^2(z)", "pow(z,a)", "pow(z, 0.3, 1)", "log(z,1)", "sqrt(z,1)", "(n - m i) log(z) / pi", "f(z) = sqrt(z^2-1)", "w = log((z-1)/(z+1))",
  "sum(n,1,4,z^n/n + log(z+n))", "iterate(w, z, 3, w^0.5 + z)", "sin 2πz sqrt z", "Log(z)^2", "log(log(z))", "z̄^0.5", "x + i y^0.5", "sqrt(x)+I sqrt(y)", "z**0.5", "[z+1]^0.5", "a^z sqrt(z)",
  "besselj(1,z) z^0.5", "log(2) log(z)", "zz^.5", "γ Γ(z) + γ sqrt(z)", "log 2z w z", "conj z^0.5", "sin^2 z^0.5", "2e z^1.5", "1e-3z^1.5", "log(z)^2^a", "ln²(z)^3", "(z)(z+1)^a z", "|z^a|z^a", "asin(z) z^a",
];

test("a formula whose cuts lie where they always do is the formula, in every manner of writing", () => {
  for (const text of BRANCHING) {
    const names = FormulaMap.parameters(text);
    const params = Object.fromEntries(names.map((name, k) => [name, /** @type {[number, number]} */ ([0.7 + k, 0.3])]));
    const again = turned(text, names, { angle: 180, sheet: 0 });
    assert.ok(again, `${text} was not read`);
    const off = apart(new FormulaMap(text, { params }).eval(places), new FormulaMap(again.formula, { params }).eval(places));
    assert.ok(off < 1e-12, `${text} became ${again.formula}: ${off}`);
  }
  for (const text of ["z^2", "z^-3", "exp(z)", "2^z", "e^(z/2)", "|z|^0.5", "abs(z)^0.5", "log(2) z", "sum(n, 1, 5, z^n)", "z $ 2", "sqrt(2z"]) assert.equal(turned(text, [], { angle: 90, sheet: 0 }), null, text);
});

test("turned cuts give the branches that they promise: arg z in (θ − 2π, θ] + 2πk", () => {
  for (const [angle, sheet] of [[180, 0], [90, 0], [40, 1], [-135, -2], [0, 3]]) {
    /** @type {[string, (log: [number, number]) => [number, number]][]} */
    const cases = [
      ["log(z)", (log) => log],
      ["z^0.3", ([u, v]) => [Math.exp(0.3 * u) * Math.cos(0.3 * v), Math.exp(0.3 * u) * Math.sin(0.3 * v)]],
      ["√z", ([u, v]) => [Math.exp(0.5 * u) * Math.cos(0.5 * v), Math.exp(0.5 * u) * Math.sin(0.5 * v)]],
      ["log10(z)", ([u, v]) => [u / Math.LN10, v / Math.LN10]],
    ];
    for (const [text, closed] of cases) {
      const map = new FormulaMap(/** @type {import("../../www/js/formula/cut.js").Turned} */ (turned(text, [], { angle, sheet })).formula);
      const expected = Float64Array.from(
        Array.from({ length: places.length / 2 }, (_, k) => {
          const [x, y] = [places[2 * k], places[2 * k + 1]];
          const cut = (angle * Math.PI) / 180;
          const argument = Math.atan2(y, x) - 2 * Math.PI * Math.ceil((Math.atan2(y, x) - cut) / (2 * Math.PI));
          return closed([Math.log(Math.hypot(x, y)), argument + 2 * Math.PI * sheet]);
        }).flat(),
      );
      const off = apart(map.eval(places), expected);
      assert.ok(off < 1e-12, `${text} at ${angle}°, sheet ${sheet}: ${off}`);
    }
  }
  assert.deepEqual([540, 180, 181, -180, 90].map(cutAt), [{ angle: 180, sheet: 1 }, { angle: 180, sheet: 0 }, { angle: -179, sheet: 1 }, { angle: 180, sheet: -1 }, { angle: 90, sheet: 0 }]);
  for (const turn of [-1000.5, -180, 0, 359, 777]) assert.equal(wholeTurn(cutAt(turn)), turn);
});

test("cuts are found where they lie: of √(z² − 1) turned to 0° on the real axis beyond ±1", () => {
  const pieces = cutLines(new FormulaMap("z^2 - 1"), 0, { center: [0.01, 0.02], width: 4 });
  assert.ok(pieces.length > 40);
  const ends = pieces.flat();
  assert.ok(ends.every(([x, y]) => Math.abs(y) < 1e-3 && Math.abs(x) > 0.97), "beside the axis");
  assert.ok(Math.min(...ends.map(([x]) => x)) < -1.9 && Math.max(...ends.map(([x]) => x)) > 1.9);
  // A pole, over which the sign jumps, is no cut; nor is a half of the line that has the opposite angle.
  assert.ok(cutLines(new FormulaMap("1/z"), 90, { center: [0.01, 0.02], width: 4 }).flat().every(([x, y]) => Math.abs(x) < 0.02 && y < 0.05));
});

test("dilatations are those of closed forms, and their words say what happens", () => {
  const at = Float64Array.of(0.6, 0.3, -1.2, 0.7);
  /** @type {[string, (x: number, y: number) => number[]][]} f_z and f_z̄ */
  const cases = [
    ["z^2", (x, y) => [2 * x, 2 * y, 0, 0]],
    ["conj(z)", () => [0, 0, 1, 0]],
    ["z + conj(z)^2/2", (x, y) => [1, 0, x, -y]],
    ["x + 2 i y", () => [1.5, 0, -0.5, 0]],
    ["z |z|", (x, y) => [1.5 * Math.hypot(x, y), 0, (x * x - y * y) / (2 * Math.hypot(x, y)), (x * y) / Math.hypot(x, y)]],
  ];
  for (const [text, closed] of cases) {
    const { p, q } = slopes(new FormulaMap(text), at);
    for (const k of [0, 2]) {
      const wanted = closed(at[k], at[k + 1]);
      [p[k], p[k + 1], q[k], q[k + 1]].forEach((value, n) => assert.ok(Math.abs(value - wanted[n]) < 1e-8, `${text}: ${value} is not ${wanted[n]}`));
    }
  }
  const view = { center: /** @type {[number, number]} */ ([0, 0]), width: 2, pixels: /** @type {[number, number]} */ ([50, 50]) };
  const words = (/** @type {string} */ text) => {
    const found = dilatationOver(new FormulaMap(text), view);
    return found && dilatationWords(found).replaceAll("\u2060", "");
  };
  assert.equal(words("z^2"), null);
  assert.equal(words("conj(z)^2"), "Not analytic: angles are kept, but the other way round (f_z = 0).");
  assert.equal(words("z + 0.5 conj(z)"), "Not analytic: circles become ellipses, up to 3.00 times as long as wide (|μ| up to 0.50).");
  assert.equal(words("|z|"), "Not analytic: all is pressed onto curves (|μ| = 1).");
  assert.match(words("z + conj(z)^2") ?? "", /in places turned the other way round/);
  assert.match(words("z + 2 conj(z)") ?? "", /turned the other way round, up to 3\.00 .*\|μ\| at least 2\.00/);
  assert.equal(placeWords(slopes(new FormulaMap("x + 2 i y"), at.slice(0, 2))), "f stretches 2 times along and 1 across: |f_z| = 1.5, |f_z̄| = 0.5, μ = −0.333.");
});

test("ellipses are those that f takes to circles, and filled where f turns them over", () => {
  const view = { center: /** @type {[number, number]} */ ([0.5, 0.5]), width: 1, pixels: /** @type {[number, number]} */ ([200, 200]) };
  const drawn = (/** @type {string} */ text) => {
    const out = new Uint8ClampedArray(4 * 200 * 200);
    drawEllipses(new FormulaMap(text), { view, out, rows: [0, 200] }, { spacing: 1, width: 2, ink: [255, 255, 255, 255] });
    return (/** @type {number} */ x, /** @type {number} */ y) => out[4 * (Math.floor((0.5 - y) * 200) * 200 + Math.floor((0.5 + x) * 200))] / 255;
  };
  // x + 2iy takes an ellipse to a circle that is half as high as wide; of the area of a circle with radius 0.34.
  const tall = drawn("x + 2 i y");
  assert.ok(tall(0.46, 0) > 0.9 && tall(0, 0.46 / 2) > 0.9 && tall(0, 0) === 0 && tall(0, 0.46) === 0);
  const over = drawn("conj(z)");
  assert.ok(over(0.34, 0) > 0.9 && over(0, 0.34) > 0.9 && over(0, 0) > 0.3);
});

test("values are found back also where angles are bent", () => {
  const map = new FormulaMap("z + conj(z)^2/2");
  const [u, v, x, y] = map.eval(Float64Array.of(0.3, 0.4, 0.31, 0.4));
  const found = preimage(map, [[u, v], [x, y]], { center: [0, 0], width: 1.6 });
  found.forEach((p, k) => assert.ok(p && Math.hypot(p[0] - [0.3, 0.31][k], p[1] - 0.4) < 1e-8, `${p}`));
});

/** Colours in places of the right panel, in shares of its sides. @param {Page} page @param {[number, number][]} places @returns {Promise<number[][]>} */
const colours = (page, places) =>
  page.evaluate((places) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("target"));
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    return places.map(([x, y]) => [...context.getImageData(Math.floor(x * canvas.width), Math.floor(y * canvas.height), 1, 1).data]);
  }, places);

const HANDLE = '#target-marks [data-part="cut"]';

/** Waits until the address says where the cut is and the picture is drawn. @param {Page} page @param {(angle: number, sheet: number) => boolean} holds */
async function cutIs(page, holds) {
  await page.waitForURL((url) => {
    const fields = new URLSearchParams(url.hash.slice(1));
    return holds(Number(fields.get("cut") ?? 180), Number(fields.get("sheet") ?? 0));
  });
  await settled(page, "ready");
}

test("the cut of log z is turned by its handle: what it sweeps changes, the rest stays; once around is the next sheet", async () => {
  const { page, errors, close } = await openFormula("#f=log(z)&view=0,0,4&colours=hue");
  await page.locator(`${HANDLE}[visibility=visible]`).waitFor();
  // At 135°, which the cut is to sweep, and at ±45°.
  /** @type {[number, number][]} */
  const spots = [[0.3, 0.3], [0.7, 0.3], [0.7, 0.7]];
  const before = await colours(page, spots);
  const { x, y } = await middle(page.locator("#target"));
  const handle = await middle(page.locator(`${HANDLE} .dot`));
  assert.ok(handle.x < x - 40 && Math.abs(handle.y - y) < 3, "it sits on the negative axis");
  const radius = x - handle.x;
  const at = (/** @type {number} */ degrees) => /** @type {const} */ ([x + radius * Math.cos((degrees * Math.PI) / 180), y - radius * Math.sin((degrees * Math.PI) / 180)]);
  await page.mouse.move(handle.x, handle.y);
  await page.mouse.down();
  for (let degrees = 170; degrees >= 90; degrees -= 20) await page.mouse.move(...at(degrees));
  await page.mouse.move(...at(90));
  await cutIs(page, (angle) => Math.abs(angle - 90) < 2);
  const there = await colours(page, spots);
  assert.notDeepEqual(there[0], before[0]);
  assert.deepEqual(there.slice(1), before.slice(1));
  assert.match(await page.locator("#evidence").innerText(), /have their cut at (89|9[01])°, on sheet 0/);
  await screenshot(page, "formula-cut");
  // On, all the way round against the clock, slower than the answers come.
  for (const target of [180, 270, 360, 450]) {
    for (let degrees = target - 70; degrees <= target; degrees += 10) await page.mouse.move(...at(degrees));
    await cutIs(page, (angle, sheet) => Math.abs(angle + 360 * sheet - target) < 2);
  }
  await page.mouse.up();
  assert.equal(await page.locator("#sheet").inputValue(), "1");
  assert.notDeepEqual(await colours(page, spots), there);
  // By keys, by the slider and by the number.
  await page.locator(HANDLE).focus();
  await page.keyboard.press("ArrowLeft");
  await cutIs(page, (angle, sheet) => Math.abs(angle - 88) < 2 && sheet === 1);
  await page.locator("#cut-angle").fill("90");
  await page.locator("#sheet").fill("0");
  await cutIs(page, (angle, sheet) => angle === 90 && sheet === 0);
  const again = await colours(page, spots);
  again.forEach((colour, k) => colour.forEach((byte, n) => assert.ok(Math.abs(byte - there[k][n]) < 4, `${colour} is not ${there[k]}`)));
  // An address holds it.
  await page.reload();
  await settled(page, "ready");
  assert.deepEqual(await colours(page, spots), again);
  await page.locator(`${HANDLE}[aria-valuetext="90 degrees, sheet 0"]`).waitFor();
  assert.deepEqual(errors, []);
  await close();
});

test("what has no cut has no controls for one; pushed forward the cut lies in the left plane", async () => {
  const { page, errors, close } = await openFormula("#f=sqrt(z)&view=0,0,4&way=push-forward&cut=120&sheet=1");
  await page.locator('#source-marks [data-part="cut"][visibility=visible]').waitFor();
  assert.equal(await page.locator("#cut").isVisible(), true);
  assert.equal(await page.locator("#cut-value").innerText(), "120°");
  await page.locator("#formula").fill("z^2");
  await page.waitForURL(/f=z%5E2/);
  await settled(page, "ready");
  assert.equal(await page.locator("#cut").isVisible(), false);
  await page.locator('#source-marks [data-part="cut"][visibility=hidden]').waitFor({ state: "attached" });
  assert.ok(!page.url().includes("cut="), page.url());
  await page.goto(`${session.url}formula.html#f=log(z)&cut=999`);
  await page.reload();
  await settled(page, "ready");
  assert.match(await page.locator("#remark").innerText(), /“cut=999” must be from -180 to 180/);
  assert.deepEqual(errors, []);
  await close();
});

test("on a phone a finger turns the cut, and the page does not scroll", async () => {
  const { page, errors, close } = await openFormula("#f=log(z)&view=0,0,4&colours=hue", { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await page.locator(`${HANDLE}[visibility=visible]`).waitFor();
  const [{ x, y }, from] = [await middle(page.locator("#target")), await middle(page.locator(`${HANDLE} .dot`))];
  const finger = await page.context().newCDPSession(page);
  /** @param {string} type @param {{ x: number, y: number }[]} touchPoints */
  const send = (type, touchPoints) => finger.send("Input.dispatchTouchEvent", /** @type {any} */ ({ type, touchPoints }));
  // A little beside the handle.
  await send("touchStart", [{ x: from.x + 8, y: from.y + 8 }]);
  const radius = x - from.x;
  for (let degrees = 170; degrees >= 120; degrees -= 10) {
    const angle = (degrees * Math.PI) / 180;
    await send("touchMove", [{ x: x + radius * Math.cos(angle) + 8, y: y - radius * Math.sin(angle) + 8 }]);
  }
  await send("touchEnd", []);
  await cutIs(page, (angle) => Math.abs(angle - 120) < 3);
  assert.equal(await page.evaluate(() => window.scrollY), 0);
  assert.deepEqual(errors, []);
  await close();
});

test("a formula of a thousand terms is cut too, and typing goes on", async () => {
  const { page, errors, close } = await openFormula("#f=z&view=0,0,2");
  await page.locator("#formula").fill("log(sum(n,1,1000,z^n/n^2)+1)");
  await page.locator(`${HANDLE}[visibility=visible]`).waitFor();
  await page.locator("#formula").fill("z^2");
  await page.locator(`${HANDLE}[visibility=hidden]`).waitFor({ state: "attached" });
  await settled(page, "ready");
  assert.deepEqual(errors, []);
  await close();
});

test("a formula that bends angles says both dilatations under the pointer, and shows them as ellipses", async () => {
  const { page, errors, close } = await openFormula("#f=x%2B2i+y&view=0,0,4&around=0,0,4");
  await page.waitForFunction(() => document.getElementById("evidence")?.textContent?.replaceAll("\u2060", "").startsWith("Not analytic: circles become ellipses, up to 2.00 times as long as wide (|μ| up to 0.33)."));
  const { x, y } = await middle(page.locator("#target"));
  await page.mouse.move(x + 40, y + 30);
  const words = () => page.waitForFunction(() => document.getElementById("reading")?.textContent === "f stretches 2 times along and 1 across: |f_z| = 1.5, |f_z̄| = 0.5, μ = −0.333.");
  await words();
  // From the other plane too, by the way back.
  const other = await middle(page.locator("#source"));
  await page.mouse.move(other.x + 90, other.y + 40);
  await words();
  const sum = () => page.evaluate(() => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("target"));
    return canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data.reduce((sum, value) => (Math.imul(sum, 31) + value) | 0, 0);
  });
  const plain = await sum();
  await page.locator("#lines").selectOption("ellipses");
  await page.waitForURL(/lines=ellipses/);
  await settled(page, "ready");
  assert.notEqual(await sum(), plain);
  await screenshot(page, "formula-ellipses");
  assert.deepEqual(errors, []);
  await close();
});
