// What a visitor's browser fetches before the first picture is complete, as a server sends it in brotli; photos and fonts apart.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { brotliCompressSync, constants } from "node:zlib";
import { root } from "../../tools/steps.mjs";
import { settled, startBrowser } from "./support/page.mjs";

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** The goal, in bytes. The module of all maps alone is larger; the page of formulas has use for the small one, and meets it. */
const GOAL = 350_000;
/** What the modules weigh now, and may not outgrow unseen; tools/sizes.mjs holds them by gzip. */
const MODULE = 570_000;
const SMALL_MODULE = 172_000;
/** What all else weighs now, and a little. @type {Record<string, number>} */
const PAGES = { "": 143_000, "regions.html": 137_000, "formula.html": 108_000, "cortex.html": 131_000, "flow.html": 93_000, "fields.html": 72_000, "lessons.html": 61_000 };

/** @param {Buffer} bytes */
const brotli = (bytes) => brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length } }).length;

/** Each file is packed once. @type {Map<string, number>} */
const packed = new Map();

/** @param {string} name as the server knows it */
function weightOf(name) {
  const known = packed.get(name) ?? brotli(readFileSync(join(root, "www", name.endsWith("/") ? `${name}index.html` : name)));
  packed.set(name, known);
  return known;
}

for (const [path, most] of Object.entries(PAGES)) {
  test(`${path || "index.html"}: the first picture weighs what it may`, async (context) => {
    const visitor = await session.browser.newContext({ viewport: { width: 1280, height: 720 } });
    const page = await visitor.newPage();
    /** What the page and its workers ask for. @type {Set<string>} */
    const asked = new Set();
    visitor.on("request", (request) => asked.add(new URL(request.url()).pathname));
    await page.goto(session.url + path);
    if (path === "lessons.html") {
      const first = page.locator('[id^="figure-"]').first();
      await first.scrollIntoViewIfNeeded();
      await page.locator('[id^="figure-"][data-state="ready"]').first().waitFor();
    } else await settled(page, "ready");
    const sizes = [...asked].filter((name) => !/\.(woff2|jpg|jpeg|png|webp|avif)$/.test(name)).map((name) => ({ name, sent: weightOf(name) }));
    const [module, rest] = [true, false].map((wasm) => sizes.filter(({ name }) => name.endsWith(".wasm") === wasm).reduce((sum, { sent }) => sum + sent, 0));
    const kB = (/** @type {number} */ bytes) => `${(bytes / 1000).toFixed(1)} kB`;
    const [largest] = sizes.filter(({ name }) => !name.endsWith(".wasm")).sort((a, b) => b.sent - a.sent);
    context.diagnostic(`${path || "index.html"}: ${kB(module + rest)} in brotli, ${kB(module)} of them the module; the goal is ${kB(GOAL)}; ${sizes.length} files, the largest beside it ${largest.name} with ${kB(largest.sent)}`);
    const mostModule = path === "formula.html" ? SMALL_MODULE : MODULE;
    assert.ok(module > 0 && module <= mostModule, `the module weighs ${module} bytes, and may weigh ${mostModule}`);
    assert.ok(rest > 0 && rest <= most, `the rest weighs ${rest} bytes, and may weigh ${most}`);
    await visitor.close();
  });
}
