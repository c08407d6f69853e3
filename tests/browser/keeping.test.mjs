// Work is kept: own photos over reloads and between pages until they are forgotten, regions along the links, a link to copy.

import assert from "node:assert/strict";
import { cp, mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { chosenPhoto, drag, handle, middle, openPage, openQuarters, screenshot, settled, startBrowser } from "./support/page.mjs";
import { contentPolicy, serve } from "../../tools/server.mjs";
import { root } from "../../tools/steps.mjs";

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

test("a visitor's own photo outlives a reload, goes to the other pages, and can be forgotten", async () => {
  const { page, errors, close } = await openPage(session);
  assert.ok(await page.locator("#own-photos").isHidden());
  await openQuarters(page);
  await page.reload();
  await chosenPhoto(page, "quarters.png");
  for (const name of ["Formula", "Visual cortex", "Region to region"]) {
    await page.locator("nav a", { hasText: name }).click();
    const menu = name === "Region to region" ? "#from-choose-photo" : "#choose-photo";
    await page.waitForFunction((id) => document.querySelector(`${id} option:checked`)?.textContent === "quarters.png", menu);
  }
  await settled(page, "ready");
  await page.locator("#forget").scrollIntoViewIfNeeded();
  await screenshot(page, "own-photos");
  await page.locator("#forget").click();
  await page.locator("#own-photos").waitFor({ state: "hidden" });
  await page.goto(session.url);
  await settled(page, "ready");
  assert.ok(!(await page.locator("#choose-photo option").allInnerTexts()).includes("quarters.png"));
  assert.deepEqual(errors, []);
  await close();
});

test("the region goes along to another page and comes back as it was left there", async () => {
  const { page, errors, close } = await openPage(session);
  const at = await middle(handle(page, "vertex", 0));
  await drag(page, at, { x: at.x - 40, y: at.y - 20 });
  await settled(page, "ready");
  const region = await page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get("region"));
  await page.locator("nav a", { hasText: "Region to region" }).click();
  await settled(page, "ready");
  assert.equal(await page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get("a.region")), region);
  await page.locator("nav a", { hasText: "Formula" }).click();
  await settled(page, "ready");
  await page.locator("nav a", { hasText: "Region to disk" }).click();
  await settled(page, "ready");
  assert.equal(await page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get("region")), region);
  assert.deepEqual(errors, []);
  await close();
});

test("Copy link copies the address of what is seen", async () => {
  const { page, errors, close } = await openPage(session, "#shape=star", { permissions: ["clipboard-read", "clipboard-write"] });
  await page.locator("#save").click();
  await page.locator("#copy-link").click();
  await page.waitForFunction(() => document.getElementById("copy-link")?.textContent === "Copied");
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), page.url());
  await screenshot(page, "copy-link");
  assert.deepEqual(errors, []);
  await close();
});

for (const name of ["", "regions.html", "formula.html", "cortex.html"]) {
  test(`${name || "index.html"}: code from text and from elsewhere is refused, and the page needs none`, async () => {
    const { page, errors, close } = await openPage(session, name);
    assert.deepEqual(errors, []);
    const refused = await page.evaluate(async () => {
      /** @type {Set<string>} */
      const directives = new Set();
      document.addEventListener("securitypolicyviolation", ({ effectiveDirective }) => directives.add(effectiveDirective));
      const inline = document.createElement("script");
      inline.textContent = "window.ran = true";
      document.body.append(inline);
      await fetch("https://example.com/").catch(() => {});
      await new Promise((resolve) => setTimeout(resolve, 300));
      return { directives: [...directives].sort(), ran: "ran" in window };
    });
    assert.deepEqual(refused.directives, ["connect-src", "script-src-elem"]);
    assert.equal(refused.ran, false);
    await close();
  });
}

test("the pages work from any path of a host", async () => {
  const folder = await mkdtemp(join(tmpdir(), "site-"));
  await cp(join(root, "www"), join(folder, "some", "where"), { recursive: true });
  const server = await serve(folder, 0, contentPolicy);
  const { page, errors, close } = await openPage({ ...session, url: server.url }, "some/where/");
  await page.locator("nav a", { hasText: "Formula" }).click();
  await settled(page, "ready");
  assert.equal(new URL(page.url()).pathname, "/some/where/formula.html");
  assert.deepEqual(errors, []);
  await close();
  await server.close();
  await rm(folder, { recursive: true });
});
