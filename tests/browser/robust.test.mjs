// Never a dead state: bad links, bad files, failing workers and servers, slow work, bad gestures.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { chosenPhoto, disk, drag, handle, middle, onPhoto, openPage, settled, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** What the page remarks on, once it does. @param {Page} page */
async function remark(page) {
  await page.locator("#remark").waitFor();
  return page.locator("#remark p").innerText();
}

/** A sum over a canvas's pixels, and how much of it is filled. @param {Page} page @param {string} id */
function canvas(page, id) {
  return page.evaluate((name) => {
    const element = /** @type {HTMLCanvasElement} */ (document.getElementById(name));
    const { data } = /** @type {CanvasRenderingContext2D} */ (element.getContext("2d")).getImageData(0, 0, element.width, element.height);
    let filled = 0;
    for (let at = 3; at < data.length; at += 4) filled += data[at] > 0 ? 1 : 0;
    return { width: element.width, filled: (4 * filled) / data.length, digest: data.reduce((sum, value) => (Math.imul(sum, 31) + value) | 0, 0) };
  }, id);
}

const hash = (/** @type {Page} */ page) => page.evaluate(() => location.hash);

for (const [address, words] of /** @type {const} */ ([
  ["#shape=toString", /“shape=toString” must be one of square, ell/],
  ["#image=__proto__", /“image=__proto__” must be one of astronaut/],
  ["#center=1,two", /“center=1,two” has something else than a number/],
  ["#image=own-1", /from somebody’s own computer/],
  ["#colour=red", /knows no “colour”/],
  ["regions.html#a.shape=constructor", /“a\.shape=constructor” must be one of/],
  ["formula.html#preset=__proto__", /“preset=__proto__” must be one of/],
  ["formula.html#f=z&view=0,0,-1", /needs a positive width/],
  ["cortex.html#model=toString", /“model=toString” must be one of/],
  ["cortex.html#angle=900", /“angle=900” must be from 5 to 150/],
])) {
  test(`${address}: said in words, left in the address, and the rest is drawn`, async () => {
    const { page, errors, close } = await openPage(session, address);
    assert.match(await remark(page), words);
    await page.waitForTimeout(400);
    assert.equal(await hash(page), address.slice(address.indexOf("#")));
    assert.deepEqual(errors, []);
    await close();
  });
}

test("an outline of 50,000 points in the address is refused, one of 2,000 is drawn", async () => {
  /** @param {number} count */
  const circle = (count) => Array.from({ length: count }, (_, k) => [Math.cos((2 * Math.PI * k) / count), Math.sin((2 * Math.PI * k) / count)].map((x) => (0.8 * x).toFixed(5)).join(",")).join(";");
  const { page, errors, close } = await openPage(session, `#region=${circle(50_000)}`);
  assert.match(await remark(page), /has 50000 points; at most 2000/);
  assert.deepEqual(errors, []);
  await close();
  const large = await openPage(session, `#region=${circle(2000)}`);
  assert.equal(await large.page.locator("#photo-marks .vertex").count(), 2000);
  assert.deepEqual(large.errors, []);
  await large.close();
});

test("a link in the text changes what it says and keeps the edited region", async () => {
  const { page, errors, close } = await openPage(session);
  const at = await middle(handle(page, "vertex", 0));
  await drag(page, at, { x: at.x - 40, y: at.y - 20 });
  await settled(page, "ready");
  const edited = await disk(page);
  const address = await hash(page);
  await page.locator('a[href="#show=grid"]').click();
  await page.waitForFunction(() => /** @type {HTMLInputElement | null} */ (document.getElementById("grid"))?.checked);
  assert.equal(await hash(page), `${address}&show=grid`);
  await settled(page, "ready");
  assert.equal((await disk(page)).digest, edited.digest);
  assert.deepEqual(errors, []);
  await close();
});

test("a shared formula that cannot be read stays in its field and in the address", async () => {
  const { page, errors, close } = await openPage(session, "formula.html#f=z%5E2%2B)");
  assert.equal(await page.locator("#formula").inputValue(), "z^2+)");
  assert.match(await page.locator("#mistake").innerText(), /expected/);
  await page.waitForTimeout(400);
  assert.equal(await hash(page), "#f=z%5E2%2B)");
  assert.deepEqual(errors, []);
  await close();
});

/** A page whose server answers some requests with a failure, as long as `failing` says so. @param {string} path @param {string} pattern @param {() => boolean} failing */
async function openFailing(path, pattern, failing) {
  const context = await session.browser.newContext({ viewport: { width: 1280, height: 720 } });
  const page = await context.newPage();
  await context.route(pattern, (route) => (failing() ? route.fulfill({ status: 404, body: "gone" }) : route.continue()));
  await page.goto(session.url + path);
  return { page, close: () => context.close() };
}

for (const path of ["", "regions.html", "formula.html", "cortex.html"]) {
  test(`${path || "index.html"}: a photo that the server does not have is said so, and the page goes on`, async () => {
    const { page, close } = await openFailing(path, "**/images/*.jpg", () => true);
    await settled(page, "ready");
    assert.match(await remark(page), /could not be loaded: the server answered 404/);
    await close();
  });

  test(`${path || "index.html"}: a worker that does not start is tried again`, async () => {
    let count = 0;
    const { page, close } = await openFailing(path, "**/worker.js", () => count++ < 2);
    await settled(page, "ready");
    assert.ok(count > 2);
    assert.equal(await page.locator("#notice").innerText(), "");
    await close();
  });
}

test("a worker that cannot start at all is said so; once it can, the next change draws what was kept", async () => {
  let broken = true;
  const { page, close } = await openFailing("#shape=star", "**/disk/worker.js", () => broken);
  await settled(page, "failed");
  assert.match(await page.locator("#notice").innerText(), /workers could not be started.*What you drew is kept/);
  broken = false;
  const at = await middle(handle(page, "vertex", 0));
  await drag(page, at, { x: at.x - 10, y: at.y });
  await settled(page, "ready");
  assert.equal(await page.locator("#photo-marks .vertex").count(), 10);
  await close();
});

test("a slow formula shows a coarse picture, progress and a way to stop; then the next one is drawn", async () => {
  const { page, errors, close } = await openPage(session, "formula.html#f=z");
  const before = await canvas(page, "target");
  await page.locator("#formula").fill("sum(n, 1, 1000, z^n/n)");
  await settled(page, "draft");
  const coarse = await canvas(page, "target");
  assert.ok(coarse.width < before.width / 2 && coarse.digest !== before.digest);
  assert.match(await page.locator("#evidence").innerText(), /coarse/);
  await page.locator("#stop").waitFor();
  await page.waitForFunction(() => document.querySelector("progress")?.hasAttribute("value"));
  await page.locator("#stop").click();
  assert.match(await page.locator("#notice").innerText(), /^Stopped/);
  assert.ok(await page.locator("#busy").isHidden());
  await page.locator("#formula").fill("z^2");
  await settled(page, "ready");
  assert.equal((await canvas(page, "target")).width, before.width);
  assert.equal(await page.locator("#notice").innerText(), "");
  assert.deepEqual(errors, []);
  await close();
});

test("cortex: a blind spot outside V1 stops nothing else; what is saved is what could be drawn; undo brings it back", async () => {
  const { page, errors, close } = await openPage(session, "cortex.html");
  const note = page.locator(".note").nth(1);
  const good = await hash(page);
  const place = await middle(page.locator('#beside-marks [data-part="center"]'));
  await drag(page, place, { x: place.x, y: place.y - 200 });
  await page.locator(".refused").waitFor();
  assert.match(await note.innerText(), /blind spot must lie inside/);
  await settled(page, "ready");
  const [upper, lower] = [await canvas(page, "cortex"), await canvas(page, "beside")];
  // The gaze, the angle, marks and the photo still work for the panel that is good.
  const at = await middle(page.locator("#seen"));
  await page.mouse.click(at.x - 60, at.y + 40);
  await settled(page, "ready");
  const looked = await canvas(page, "cortex");
  assert.notEqual(looked.digest, upper.digest);
  await page.locator("#field-of-view").fill("80");
  await settled(page, "ready");
  assert.notEqual((await canvas(page, "cortex")).digest, looked.digest);
  await page.locator("#choose-photo").selectOption("coffee");
  await settled(page, "ready");
  assert.equal((await canvas(page, "beside")).digest, lower.digest, "the refused panel keeps its picture");
  assert.equal(await hash(page), good);
  for (let k = 0; k < 4; k++) await page.keyboard.press("Control+z");
  await page.waitForFunction(() => !document.querySelector(".refused"));
  await settled(page, "ready");
  assert.equal((await canvas(page, "cortex")).digest, upper.digest);
  await page.keyboard.press("Control+y");
  await page.locator(".refused").waitFor();
  await page.locator("#reset").click();
  await page.waitForFunction(() => !document.querySelector(".refused"));
  assert.deepEqual(errors, []);
  await close();
});

for (const name of ["", "formula.html", "cortex.html"]) {
  test(`${name || "index.html"}: of two photos the one that was chosen last is shown, though the other comes later`, async () => {
    const { page, errors, close } = await openPage(session, name);
    /** @type {(value?: unknown) => void} */
    let send = () => {};
    const sent = new Promise((resolve) => (send = resolve));
    await page.route(/coffee\.jpg/, async (route) => {
      await sent;
      await route.continue();
    });
    await page.locator("#choose-photo").selectOption("coffee");
    await page.locator('body[aria-busy="true"]').waitFor();
    const arrived = page.waitForResponse(/coffee\.jpg/);
    await page.locator("#choose-photo").selectOption("chelsea");
    await page.waitForFunction(() => location.hash.includes("image=chelsea"));
    send();
    await arrived;
    await settled(page, "ready");
    await chosenPhoto(page, "Cat");
    assert.match(await hash(page), /image=chelsea/);
    assert.deepEqual(errors, []);
    await close();
  });
}

test("cortex: an outline that crosses itself is refused, a reload is not empty", async () => {
  const { page, errors, close } = await openPage(session, "cortex.html#beside=own&own=0,0,40,20,40,-20,0,20");
  await page.locator(".refused").waitFor();
  assert.match(await page.locator(".note").nth(1).innerText(), /crosses or touches itself/);
  assert.ok((await canvas(page, "cortex")).filled > 0.1);
  assert.deepEqual(errors, []);
  await close();
});

test("cortex: the scene as it is recovered follows a new photo and a new size", async () => {
  const { page, errors, close } = await openPage(session, "cortex.html#dots=1");
  await page.setViewportSize({ width: 900, height: 700 });
  await page.locator("#choose-photo").selectOption("coffee");
  await page.setViewportSize({ width: 1100, height: 700 });
  await chosenPhoto(page, "Coffee");
  await page.waitForTimeout(300);
  await settled(page, "ready");
  assert.ok((await canvas(page, "seen")).filled > 0.9);
  assert.equal(await page.locator("#remark").isVisible(), false);
  assert.deepEqual(errors, []);
  await close();
});

test("an SVG picture is opened; an HEIC one is refused in words", async () => {
  const { page, errors, close } = await openPage(session);
  const drawing = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"><rect width="10" height="10" fill="#0f0"/></svg>';
  await page.locator("#file").setInputFiles({ name: "green.svg", mimeType: "image/svg+xml", buffer: Buffer.from(drawing) });
  await chosenPhoto(page, "green.svg");
  await settled(page, "ready");
  assert.deepEqual((await disk(page, [[0.3, 0.3]])).samples, [[0, 255, 0, 255]]);
  await page.locator("#file").setInputFiles({ name: "phone.heic", mimeType: "image/heic", buffer: Buffer.from("ftypheic") });
  assert.match(await remark(page), /“phone\.heic” is an HEIC photo.*JPEG/);
  await page.getByRole("button", { name: "Dismiss" }).click();
  assert.equal(await page.locator("#remark").isVisible(), false);
  assert.deepEqual(errors, []);
  await close();
});

test("formula: a file that is no picture says so beside the formula, which is not wrong", async () => {
  const { page, errors, close } = await openPage(session, "formula.html#f=z");
  await page.locator("#file").setInputFiles({ name: "notes.txt", mimeType: "text/plain", buffer: Buffer.from("no picture") });
  assert.match(await remark(page), /could not be read as a picture/);
  assert.equal(await page.locator("#formula").getAttribute("aria-invalid"), "false");
  assert.equal(await page.locator("#mistake").innerText(), "");
  assert.deepEqual(errors, []);
  await close();
});

/** Corners clicked on the photo, in shares of it. @param {Page} page @param {[number, number][]} corners */
async function click(page, corners) {
  for (const [x, y] of corners) {
    const at = await onPhoto(page, x, y);
    await page.mouse.click(at.x, at.y);
  }
}

test("while drawing, Ctrl Z takes the last corner back and Ctrl Y brings it again; a shape or a photo ends the drawing", async () => {
  const { page, errors, close } = await openPage(session);
  const points = () => page.locator("#photo-marks .vertex").count();
  const first = await points();
  await page.locator("#draw").click();
  await click(page, [[0.2, 0.2], [0.8, 0.2], [0.8, 0.8], [0.4, 0.6], [0.2, 0.8]]);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+y");
  assert.equal(await points(), first, "the document's own history is not touched");
  await page.keyboard.press("Enter");
  await settled(page, "ready");
  assert.equal(await points(), 4);
  await page.locator("#draw").click();
  await click(page, [[0.2, 0.2], [0.8, 0.2]]);
  await page.locator("#choose-shape").selectOption("star");
  assert.equal(await page.locator("#draw").getAttribute("aria-pressed"), "false");
  await settled(page, "ready");
  assert.equal(await points(), 10);
  await page.locator("#draw").click();
  await page.locator("#choose-photo").selectOption("coffee");
  await page.locator('#draw[aria-pressed="false"]').waitFor();
  assert.deepEqual(errors, []);
  await close();
});

test("Escape gives a drag up, of a point, of the disk, of the cortex's gaze and of a view", async () => {
  const { page, errors, close } = await openPage(session);
  const good = await disk(page);
  const rim = await page.locator("#disk").boundingBox();
  if (!rim) throw new Error("The disk is not on the page.");
  for (const from of [await middle(handle(page, "vertex", 3)), { x: rim.x + 0.6 * rim.width, y: rim.y + 0.5 * rim.height }]) {
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + 30, from.y + 20, { steps: 3 });
    await page.keyboard.press("Escape");
    await page.mouse.move(from.x + 60, from.y + 20);
    await page.mouse.up();
    await settled(page, "ready");
    assert.equal((await disk(page)).digest, good.digest);
  }
  assert.ok(await page.locator("#undo").isDisabled());
  assert.deepEqual(errors, []);
  await close();
  for (const [path, id] of [["cortex.html", "seen"], ["formula.html#f=z&image=coffee", "target"]]) {
    const other = await openPage(session, path);
    await other.page.waitForTimeout(300);
    const address = await hash(other.page);
    const at = await middle(other.page.locator(`#${id}`));
    await other.page.mouse.move(at.x, at.y);
    await other.page.mouse.down();
    await other.page.mouse.move(at.x + 50, at.y + 30, { steps: 3 });
    await other.page.keyboard.press("Escape");
    await other.page.mouse.up();
    await settled(other.page, "ready");
    await other.page.waitForTimeout(300);
    assert.equal(await hash(other.page), address);
    assert.deepEqual(other.errors, []);
    await other.close();
  }
});

test("a center that a removed point would leave outside moves inside", async () => {
  // The middle lies in the tip that goes.
  const { page, errors, close } = await openPage(session, "#region=-0.5,-0.5;0.5,-0.5;0,0.9&center=0,0.6&toward=0,-0.5");
  const edge = await middle(handle(page, "edge", 1));
  await drag(page, edge, { x: edge.x + 8, y: edge.y });
  await settled(page, "ready");
  const tip = await middle(handle(page, "vertex", 3));
  await page.mouse.dblclick(tip.x, tip.y);
  await settled(page, "ready");
  assert.equal(await page.locator("#notice").innerText(), "");
  assert.equal((await disk(page)).thinnestInside, 255);
  assert.deepEqual(errors, []);
  await close();
});

test("the hook that a hand leaves at the end of a stroke is cut off", async () => {
  const { page, errors, close } = await openPage(session);
  await page.locator("#draw").click();
  const start = await onPhoto(page, 0.8, 0.5);
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  // Beyond the whole turn, and across where it began.
  for (let k = 1; k <= 84; k++) {
    const angle = (2 * Math.PI * k) / 80;
    const radius = k < 70 ? 0.3 : 0.3 + 0.004 * (k - 79);
    const at = await onPhoto(page, 0.5 + radius * Math.cos(angle), 0.5 - radius * Math.sin(angle));
    await page.mouse.move(at.x, at.y);
  }
  await page.mouse.up();
  await settled(page, "ready");
  assert.equal(await page.locator("#notice").innerText(), "");
  assert.deepEqual(errors, []);
  await close();
});

test("quick drags of the disk are not lost", async () => {
  const { page, errors, close } = await openPage(session);
  const good = await disk(page);
  const box = await page.locator("#disk").boundingBox();
  if (!box) throw new Error("The disk is not on the page.");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await drag(page, { x, y }, { x: x + 20, y });
  await drag(page, { x: x + 20, y }, { x: x + 20, y: y + 25 });
  await settled(page, "ready");
  assert.notEqual((await disk(page)).digest, good.digest);
  // Each was a step of its own.
  await page.locator("#undo").click();
  await page.locator("#undo").click();
  await settled(page, "ready");
  assert.equal((await disk(page)).digest, good.digest);
  assert.deepEqual(errors, []);
  await close();
});

test("without JavaScript the page says what it needs", async () => {
  const context = await session.browser.newContext({ javaScriptEnabled: false });
  const page = await context.newPage();
  for (const path of ["", "regions.html", "formula.html", "cortex.html"]) {
    await page.goto(session.url + path);
    assert.match(await page.locator(".noscript").innerText(), /needs JavaScript/);
  }
  await context.close();
});
