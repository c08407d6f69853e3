// The page of the visual cortex: the halves of the field go where they belong, and the gaze moves.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { chosenPhoto, middle, openPage, openQuarters, screenshot, settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** @param {string} [hash] @param {import("playwright-core").BrowserContextOptions} [options] */
const openCortex = (hash = "", options = {}) => openPage(session, `cortex.html${hash}`, options);

/**
 * The picture of both cortices: pixels in shares of its width and height, the share that is filled, a sum over all.
 *
 * @param {Page} page
 * @param {[number, number][]} [places]
 */
function cortex(page, places = []) {
  return canvasOf(page, "cortex", places);
}

/**
 * @param {Page} page
 * @param {string} id of a canvas
 * @param {[number, number][]} [places]
 */
function canvasOf(page, id, places = []) {
  return page.evaluate(([id, wanted]) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(id));
    const { width, height } = canvas;
    const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).getImageData(0, 0, width, height);
    let filled = 0;
    for (let at = 3; at < data.length; at += 4) filled += data[at] / 255;
    const samples = wanted.map(([x, y]) => {
      const at = 4 * (Math.floor(y * height) * width + Math.floor(x * width));
      return [...data.slice(at, at + 4)];
    });
    return { samples, filled: filled / (width * height), digest: data.reduce((sum, value) => (Math.imul(sum, 31) + value) | 0, 0) };
  }, /** @type {const} */ ([id, places]));
}

test("opening shows what both hemispheres receive, with the model's source", async () => {
  const { page, errors, close } = await openCortex();
  const { filled } = await cortex(page);
  assert.ok(filled > 0.2 && filled < 0.9, `${filled} of the panel is filled`);
  const notes = await page.locator(".note").allInnerTexts();
  assert.match(notes[0], /Schira and others, 2010.*2910 mm²/);
  assert.match(notes[1], /Symm.*2643 mm² a hemisphere.*lands \d·10⁻\S+ mm from its place/);
  assert.match(await page.locator("#evidence").innerText(), /Adams, Sincich and Horton.*Drawn in \d+ ms from a foveated picture of 2 levels/);
  const curves = await page.locator("#plot .curve").evaluateAll((paths) => paths.filter((path) => path.getAttribute("d")?.startsWith("M")).length);
  assert.equal(curves, 8, "four curves, each with its key");
  await screenshot(page, "cortex");
  await page.locator("#lines").click();
  await settled(page, "ready");
  await screenshot(page, "cortex-bare");
  assert.deepEqual(errors, []);
  await close();
});

test("the right of the field is seen at the right, the upper half above", async () => {
  const { page, errors, close } = await openCortex("#angle=100&lines=0");
  await openQuarters(page);
  const { samples } = await cortex(page, [[0.35, 0.4], [0.65, 0.4], [0.65, 0.6], [0.35, 0.6]]);
  assert.deepEqual(samples, [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255, 255, 255, 255]]);
  // Far to the left of the red quarter's corner: all of the picture lies to the right of the gaze.
  const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await page.locator("#seen").boundingBox());
  await page.mouse.click(box.x + 1, box.y + 0.25 * box.height);
  await settled(page, "ready");
  const looked = await cortex(page, [[0.35, 0.4], [0.65, 0.4], [0.65, 0.6]]);
  assert.equal(looked.samples[0][3], 0, "the right hemisphere sees nothing");
  assert.deepEqual(looked.samples.slice(1), [[255, 0, 0, 255], [255, 0, 0, 255]]);
  assert.deepEqual(errors, []);
  await close();
});

test("gaze, angle and model change the picture, and the address holds them", async () => {
  const { page, errors, close } = await openCortex("#image=coffee");
  const seen = [(await cortex(page)).digest];
  /** @param {string} what */
  const changed = async (what) => {
    await settled(page, "ready");
    const { digest } = await cortex(page);
    assert.ok(!seen.includes(digest), `${what} changes nothing`);
    seen.push(digest);
  };
  const at = await middle(page.locator("#seen"));
  await page.mouse.click(at.x - 30, at.y - 20);
  await changed("a click");
  await page.locator("#seen-marks").focus();
  await page.keyboard.press("ArrowRight");
  await changed("an arrow key");
  await page.locator("#field-of-view").fill("80");
  await changed("the angle");
  await page.locator("#model").selectOption("monopole");
  await changed("the model");
  await page.locator("#model").selectOption("wedge");
  await changed("the wedge");
  await page.locator(".shear input").first().fill("0.8");
  await changed("the shear");
  await page.waitForURL(/model=wedge.*shear=0.8/);
  const other = await openCortex(new URL(page.url()).hash);
  assert.equal((await page.locator("#angle").innerText()), "80°");
  await other.close();
  await page.mouse.move(0, 0);
  const panel = await middle(page.locator("#cortex"));
  await page.mouse.move(panel.x + 60, panel.y);
  const reading = () => /looks [\d.]+° away .* gives [\d.]+ mm to each degree/.test(document.getElementById("reading")?.textContent ?? "");
  await page.waitForFunction(reading);
  assert.deepEqual(errors, []);
  await close();
});

test("what the cortex recovers is sharp where the eye looks", async () => {
  const { page, errors, close } = await openCortex();
  /** Mean difference of neighbours in a square of the photo's panel, at a share of its width and height. @param {number} x @param {number} y */
  const detail = (x, y) =>
    page.evaluate(([x, y]) => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("seen"));
      const side = Math.round(canvas.width / 8);
      const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
      const { data } = context.getImageData(Math.round(x * canvas.width - side / 2), Math.round(y * canvas.height - side / 2), side, side);
      let sum = 0;
      for (let at = 4; at < data.length; at += 4) if (at % (4 * side)) sum += Math.abs(data[at] - data[at - 4]);
      return sum / (side * side);
    }, [x, y]);
  const [face, badge] = [await detail(0.435, 0.22), await detail(0.33, 0.74)];
  await page.locator("#dots").selectOption("2");
  await settled(page, "ready");
  const [recovered, lost] = [await detail(0.435, 0.22), await detail(0.33, 0.74)];
  assert.ok(recovered > 0.5 * face, `the face: ${face} became ${recovered}`);
  assert.ok(lost < 0.4 * badge, `the badge: ${badge} became ${lost}`);
  await screenshot(page, "cortex-recovered");
  assert.deepEqual(errors, []);
  await close();
});

test("a large file keeps its detail where the eye looks", async () => {
  const { page, errors, close } = await openCortex("#angle=100&lines=0");
  // Stripes of three pixels in the middle, too fine for a picture scaled to fit a screen.
  const url = await page.evaluate(() => {
    const canvas = Object.assign(document.createElement("canvas"), { width: 6000, height: 4000 });
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    context.fillStyle = "#fff";
    context.fillRect(0, 0, 6000, 4000);
    context.fillStyle = "#000";
    for (let x = 2700; x < 3300; x += 6) context.fillRect(x, 1700, 3, 600);
    return canvas.toDataURL("image/png");
  });
  const buffer = Buffer.from(url.slice(url.indexOf(",") + 1), "base64");
  await page.locator("#file").setInputFiles({ name: "large.png", mimeType: "image/png", buffer });
  await chosenPhoto(page, "large.png");
  await settled(page, "ready");
  assert.match(await page.locator("#evidence").innerText(), /of 5 levels/);
  // Along the horizontal meridian of the left hemisphere, from the fovea on.
  const line = (await cortex(page, Array.from({ length: 40 }, (_, k) => [0.505 + 0.002 * k, 0.5]))).samples.map(([red]) => red);
  assert.ok(Math.max(...line) > 220 && Math.min(...line) < 35, `shades from ${Math.min(...line)} to ${Math.max(...line)}`);
  await screenshot(page, "cortex-large");
  assert.deepEqual(errors, []);
  await close();
});

test("an outline is drawn, read from text and turned by its landmark", async () => {
  const { page, errors, close } = await openCortex("#beside=own");
  const note = page.locator(".note").nth(1);
  const area = async () => Number((await note.innerText()).match(/(\d+) mm²/)?.[1]);
  assert.equal(await area(), 2643);
  // A corner at a time, in mm of the panel.
  await page.locator(".draw").nth(1).click();
  const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await page.locator("#beside-marks").boundingBox());
  for (const [x, y] of [[0.52, 0.5], [0.6, 0.8], [0.9, 0.8], [0.9, 0.2], [0.6, 0.2], [0.52, 0.5]]) await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
  await settled(page, "ready");
  const drawn = await area();
  assert.ok(drawn > 1500 && drawn < 2500, `${drawn} mm²`);
  await page.waitForURL(/own=/);
  // From text, in centimetres.
  await page.locator(".read").nth(1).click();
  await page.locator("#outline-text").fill("M0 0 h8 q1 2 0 4 h-8");
  await page.locator("#outline-scale").fill("0");
  await page.locator("#outline-form .primary").click();
  await page.locator("#outline-scale").fill("10");
  await page.locator("#outline-text").fill("[[0, 0], [8, 4], [8, 0], [0, 4]]");
  await page.locator("#outline-form .primary").click();
  await page.waitForFunction(() => /crosses or touches itself/.test(document.getElementById("outline-refusal")?.textContent ?? ""));
  // From an SVG file, whose first path is not drawn and whose outline is scaled.
  const file = '<svg xmlns="http://www.w3.org/2000/svg"><defs><path id="a" d="M0 0 h1 v1 z"/></defs><g transform="scale(2)"><path d="M0 0 h4 q.5 1 0 2 h-4 z"/></g></svg>';
  await page.locator("#outline-file").setInputFiles({ name: "v1.svg", mimeType: "image/svg+xml", buffer: Buffer.from(file) });
  await page.waitForFunction(() => /scale/.test(/** @type {HTMLTextAreaElement} */ (document.getElementById("outline-text")).value));
  await page.locator("#outline-form .primary").click();
  await page.locator("#outline-dialog").waitFor({ state: "hidden" });
  await settled(page, "ready");
  assert.ok(Math.abs((await area()) - 3333) < 10, `${await area()} mm²`);
  const before = await canvasOf(page, "beside");
  const handle = await middle(page.locator('#beside-marks [data-part="direction"]'));
  await page.mouse.move(handle.x, handle.y);
  await page.mouse.down();
  await page.mouse.move(handle.x - 20, handle.y - 30, { steps: 3 });
  await page.mouse.up();
  await settled(page, "ready");
  const turned = await canvasOf(page, "beside");
  assert.notEqual(turned.digest, before.digest);
  await page.locator('#beside-marks [data-part="center"]').focus();
  await page.keyboard.press("ArrowLeft");
  await settled(page, "ready");
  assert.notEqual((await canvasOf(page, "beside")).digest, turned.digest);
  await page.waitForURL(/at-own=/);
  await page.locator("#circles").click();
  await settled(page, "ready");
  await screenshot(page, "cortex-outline");
  // Outside, the landmark has no map: the panel says so.
  const place = await middle(page.locator('#beside-marks [data-part="center"]'));
  await page.mouse.move(place.x, place.y);
  await page.mouse.down();
  await page.mouse.move(place.x, place.y - 200, { steps: 3 });
  await page.mouse.up();
  await page.waitForFunction(() => /must lie inside/.test(document.querySelectorAll(".note")[1]?.textContent ?? ""));
  assert.deepEqual(errors, []);
  await close();
});

test("drafts of a moving eye are as fine as the machine keeps up with", async () => {
  const { page, close } = await openPage(session, "cortex.html");
  const shares = await page.evaluate(async () => {
    const { Pace } = await import(new URL("js/cortex/pace.js", location.href).href);
    const pace = new Pace();
    return [12, 30, 30, 30, 12, 3].map((ms) => {
      // One that made a new map is no rule.
      for (const each of [ms, ms, 400, ms]) pace.took(each);
      return pace.share;
    });
  });
  assert.deepEqual(shares, [1, 0.8, 0.64, 0.64, 0.64, 0.8]);
  await close();
});

test("the camera is seen live", async () => {
  const { page, errors, close } = await openCortex("#lines=0");
  await page.locator("#camera").click();
  await page.waitForFunction(() => /A frame of the camera is drawn in \d+ ms/.test(document.getElementById("evidence")?.textContent ?? ""));
  const seen = new Set();
  for (let k = 0; k < 40 && seen.size < 3; k++) {
    seen.add((await cortex(page)).digest);
    await page.waitForTimeout(100);
  }
  assert.ok(seen.size >= 3, "the picture moves");
  await screenshot(page, "cortex-camera");
  await page.locator("#camera").click();
  await chosenPhoto(page, "Astronaut");
  await settled(page, "ready");
  assert.match(await page.locator("#evidence").innerText(), /from a foveated picture/);
  assert.deepEqual(errors, []);
  await close();
});

for (const [name, width, height] of /** @type {const} */ ([["desktop", 1440, 900], ["laptop", 1280, 720], ["phone", 390, 844]])) {
  test(`${name}: nothing is cut off`, async () => {
    const { page, errors, close } = await openCortex("", { viewport: { width, height } });
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    assert.ok(overflow <= 0, `${overflow} pixels too wide`);
    await screenshot(page, `cortex-${name}`);
    assert.deepEqual(errors, []);
    await close();
  });
}
