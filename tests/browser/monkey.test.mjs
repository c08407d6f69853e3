// Somebody who presses, drags, types and turns everything at random breaks no page: no error is thrown, the page comes to rest with a
// picture or with words, its address can be opened again, and from there all is as at first.
//
// MONKEY=120 node --test tests/browser/monkey.test.mjs is two minutes a page; SEED=7 another monkey.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openPage, startBrowser } from "./support/page.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {() => number} Random */

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** How long each page has the monkey, in seconds, and which monkey that is. */
const SECONDS = Number(process.env.MONKEY ?? 5);
const SEED = Number(process.env.SEED ?? 1);

/** Numbers from 0 to 1 that a seed determines. @param {number} seed @returns {Random} */
function randomFrom(seed) {
  let state = (seed * 2654435761) >>> 0 || 1;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
}

/** What leads away from the page, or asks the machine for something. */
const LEFT_ALONE = "#open, #from-open, #to-open, #open-state, #camera, #forget, #present, [id^=save-], #copy-link, #copy-embed, nav a";

const KEYS = ["Escape", "Delete", "Insert", "Tab", "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Shift+ArrowUp", "PageUp", "PageDown", "+", "-", "0", "1", "2", "l", "a", "c", "Control+z", "Control+y", "Enter", " "];
const FORMULAS = ["z^2", "log(z)", "sqrt(z^2-1)", "z + conj(z)/2", "1/(", "", "a z + b", "sum(n,1,200,z^n/n)", "gamma(z)", "z^^2", "|z|", "conj(z)^2", "(z-1)^a", "besselj(2,z)", "🐒", "iterate(w,z,6,w^2+t)"];

/** @param {Random} random @param {number} low @param {number} high */
const between = (random, low, high) => low + (high - low) * random();
/** @template T @param {Random} random @param {T[]} list @returns {T} */
const one = (random, list) => list[Math.floor(random() * list.length)];

/** A place over a random picture that is in view. @param {Page} page @param {Random} random */
async function placeIn(page, random) {
  const boxes = await page.locator(".stage:visible, figure.live:visible").evaluateAll((all) =>
    all.map((stage) => stage.getBoundingClientRect().toJSON()).filter(({ top, bottom }) => bottom > 0 && top < innerHeight),
  );
  const box = one(random, boxes);
  return box ? { x: box.x + box.width * between(random, -0.05, 1.05), y: box.y + box.height * between(random, -0.05, 1.05) } : { x: 100, y: 100 };
}

/** The controls that can be used now, as many times as a hand is likely to take them. @param {Page} page */
const controls = (page) =>
  page.evaluate((left) => {
    const all = [...document.querySelectorAll("main button, main select, main input, main [role=button], main [role=slider], main a[href^='#']")];
    return all.flatMap((element, index) => {
      const box = element.getBoundingClientRect();
      const usable = box.width && box.height && !element.matches(left) && !element.closest(left) && !(/** @type {HTMLButtonElement} */ (element).disabled) && getComputedStyle(element).visibility !== "hidden";
      return usable ? [{ index, tag: element.tagName, type: element.getAttribute("type") ?? "", name: element.id || element.getAttribute("aria-label") || element.textContent?.trim() || "" }] : [];
    });
  }, LEFT_ALONE);

/** Does one thing. @param {Page} page @param {Random} random @returns {Promise<string>} what it was */
async function act(page, random) {
  const dice = random();
  if (dice < 0.3) {
    const [from, to] = [await placeIn(page, random), await placeIn(page, random)];
    await page.mouse.move(from.x, from.y);
    await page.mouse.down({ button: random() < 0.05 ? "right" : "left" });
    await page.mouse.move(to.x, to.y, { steps: 1 + Math.floor(5 * random()) });
    if (random() < 0.15) await page.keyboard.press("Escape");
    await page.mouse.up();
    return `drag ${[from.x, from.y, to.x, to.y].map(Math.round)}`;
  }
  if (dice < 0.42) {
    const key = one(random, KEYS);
    await page.keyboard.press(key);
    return `key ${key}`;
  }
  if (dice < 0.52) {
    const at = await placeIn(page, random);
    await page.mouse.move(at.x, at.y);
    await page.keyboard.down("Control");
    await page.mouse.wheel(0, between(random, -800, 800));
    await page.keyboard.up("Control");
    return "wheel";
  }
  if (dice < 0.6) {
    const at = await placeIn(page, random);
    await page.mouse.click(at.x, at.y, { clickCount: random() < 0.3 ? 2 : 1 });
    return `click ${Math.round(at.x)}, ${Math.round(at.y)}`;
  }
  if (dice < 0.63) {
    const size = { width: Math.round(between(random, 330, 1500)), height: Math.round(between(random, 400, 1000)) };
    await page.setViewportSize(size);
    return `size ${size.width} × ${size.height}`;
  }
  const control = one(random, await controls(page));
  if (!control) return "nothing";
  const number = random();
  const text = one(random, FORMULAS);
  await page.evaluate(({ index, number, text }) => {
    const element = document.querySelectorAll("main button, main select, main input, main [role=button], main [role=slider], main a[href^='#']")[index];
    const change = () => ["input", "change"].forEach((name) => element.dispatchEvent(new Event(name, { bubbles: true })));
    if (element instanceof HTMLSelectElement) {
      const options = [...element.options].filter((option) => !option.hidden && !option.disabled);
      if (options.length) element.value = options[Math.floor(number * options.length)].value;
      change();
    } else if (element instanceof HTMLInputElement && element.type === "range") {
      element.value = String(Number(element.min) + number * (Number(element.max) - Number(element.min)));
      change();
    } else if (element instanceof HTMLInputElement && element.type === "number") {
      element.value = String(Math.round(20 * (number - 0.5)));
      change();
    } else if (element instanceof HTMLInputElement && element.type === "text") {
      element.value = text;
      change();
    } else if (element instanceof HTMLElement && !(element instanceof HTMLInputElement && element.type === "file")) element.click();
    else if (element instanceof SVGElement) element.focus();
  }, { index: control.index, number, text });
  return `${control.tag.toLowerCase()} ${control.name}`;
}

/** Comes to rest: with a picture, or with words why there is none. @param {Page} page */
const rests = (page) =>
  page.waitForFunction(() => {
    const { state } = document.body.dataset;
    return state === "ready" || ((state === "invalid" || state === "failed") && document.getElementById("notice")?.textContent !== "");
  }, undefined, { timeout: 60_000 });

/** Of a page that is left alone but for what the monkey does: a link to another page, by Tab and Enter, would end it. @param {Page} page */
async function stayOn(page) {
  page.on("dialog", (dialog) => dialog.dismiss());
  await page.evaluate(() => window.addEventListener("click", (event) => {
    const link = event.target instanceof Element && event.target.closest("a[href]");
    if (link && !link.getAttribute("href")?.startsWith("#")) event.preventDefault();
  }, true));
}

for (const path of ["", "regions.html", "formula.html", "cortex.html", "flow.html", "fields.html"]) {
  test(`${path || "index.html"}: a monkey of ${SECONDS} s breaks nothing`, async (context) => {
    const random = randomFrom(SEED + path.length);
    const { page, errors, close } = await openPage(session, path);
    await stayOn(page);
    /** @type {string[]} */
    const done = [];
    const end = Date.now() + 1000 * SECONDS;
    const words = () => `seed ${SEED}, after ${done.length} things, the last ones ${done.slice(-12).join("; ")}`;
    while (Date.now() < end && !errors.length) done.push(await act(page, random));
    await page.keyboard.press("Escape");
    await rests(page).catch((error) => assert.fail(`${error.message}: ${words()}`));
    assert.deepEqual(errors, [], words());
    const broken = await page.evaluate(() => (document.getElementById("remark")?.hidden ? "" : (document.querySelector("#remark p")?.textContent ?? "")));
    assert.doesNotMatch(broken, /went wrong/, words());
    // What it left can be opened again.
    const address = page.url();
    await page.reload();
    await rests(page).catch((error) => assert.fail(`${address} does not open: ${error.message}`));
    assert.doesNotMatch(await page.locator("#remark p").innerText(), /could not be read altogether/, `${address}: ${words()}`);
    assert.deepEqual(errors, [], address);
    await page.goto("about:blank");
    await page.goto(session.url + path);
    await page.waitForFunction(() => document.body.dataset.state === "ready");
    context.diagnostic(`${done.length} things in ${SECONDS} s, seed ${SEED}`);
    await close();
  });
}

test(`lessons.html: a monkey of ${SECONDS} s breaks nothing`, async (context) => {
  const random = randomFrom(SEED);
  const { page, errors, close } = await openPage(session, "lessons.html");
  await stayOn(page);
  const figures = await page.locator("figure.live").all();
  /** @type {string[]} */
  const done = [];
  const end = Date.now() + 1000 * SECONDS;
  while (Date.now() < end && !errors.length) {
    if (done.length % 6 === 0) await one(random, figures).scrollIntoViewIfNeeded();
    done.push(await act(page, random));
  }
  const words = `seed ${SEED}, after ${done.length} things, the last ones ${done.slice(-12).join("; ")}`;
  await page.keyboard.press("Escape");
  for (const figure of figures) {
    await figure.scrollIntoViewIfNeeded();
    const id = await figure.getAttribute("id");
    await page.waitForFunction((id) => document.getElementById(id)?.dataset.state === "ready", id ?? "").catch((error) => assert.fail(`${id}: ${error.message}: ${words}`));
  }
  assert.deepEqual(errors, [], words);
  context.diagnostic(`${done.length} things in ${SECONDS} s, seed ${SEED}`);
  await close();
});
