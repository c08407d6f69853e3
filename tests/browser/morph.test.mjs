// From the region to the disk: every step is a conformal map of the region, begins with it and ends with the disk.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { radiusAt, wayBetween } from "../../www/js/disk/homotopy.js";
import { disk, drag, handle, middle, onPhoto, openPage, screenshot, settled, startBrowser } from "./support/page.mjs";

/** @type {Awaited<ReturnType<typeof startBrowser>>} */
let session;
before(async () => {
  session = await startBrowser();
});
after(() => session.close());

/** The Riemann map of the disk |z − 0.1| < 0.5 with f(0.3) = 0 and f'(0.3) > 0, and its inverse, by hand. */
const known = {
  angles: new Float64Array([0]),
  derivative: () => Float64Array.of(1 / (0.5 * (1 - 0.4 ** 2)), 0),
  fromDisk: (/** @type {Float64Array} */ points) => {
    const images = new Float64Array(points.length);
    for (let k = 0; k < points.length; k += 2) {
      // (w + a)/(1 + a w), a = 0.4
      const [u, v] = [points[k], points[k + 1]];
      const [x, y, p, q] = [u + 0.4, v, 1 + 0.4 * u, 0.4 * v];
      const size = p * p + q * q;
      images[k] = 0.1 + (0.5 * (x * p + y * q)) / size;
      images[k + 1] = (0.5 * (y * p - x * q)) / size;
    }
    return images;
  },
};
/** @param {number} s */
const way = (s) => wayBetween(/** @type {import("../../www/pkg/index.js").RiemannMap} */ (/** @type {unknown} */ (known)), [0.3, 0], s);

test("the way begins with the region itself and ends with the disk", () => {
  const w = Float64Array.of(0.3, -0.2, 0.9, 0.1, 0, 0);
  const [begun, ended] = [way(0).carry(w), way(1).carry(w)];
  known.fromDisk(w).forEach((value, k) => assert.ok(Math.abs(begun[k] - value) < 1e-12, `${begun} and ${known.fromDisk(w)}`));
  w.forEach((value, k) => assert.ok(Math.abs(ended[k] - value) < 1e-3, `${ended} and ${w}`));
  assert.equal(radiusAt(0), 1);
  assert.equal(radiusAt(1), 0);
});

test("every step is conformal and one to one: the outline never crosses itself, and equal crosses stay square", () => {
  for (const s of [0.1, 0.35, 0.6, 0.9]) {
    const { carry, outline } = way(s);
    let turned = 0;
    for (let k = 0; k < outline.length; k += 2) {
      const at = (/** @type {number} */ n) => [outline[n % outline.length], outline[(n + 1) % outline.length]];
      const [[ax, ay], [bx, by], [cx, cy]] = [at(k), at(k + 2), at(k + 4)];
      turned += Math.atan2((bx - ax) * (cy - by) - (by - ay) * (cx - bx), (bx - ax) * (cx - bx) + (by - ay) * (cy - by));
    }
    // The corner itself is there twice, without a direction in between.
    assert.ok(Math.abs(turned - 2 * Math.PI) < 0.02, `turned by ${turned}`);
    const h = 1e-5;
    const [ox, oy, rx, ry, ux, uy] = carry(Float64Array.of(0.2, 0.5, 0.2 + h, 0.5, 0.2, 0.5 + h));
    assert.ok(Math.hypot(ux - ox + (ry - oy), uy - oy - (rx - ox)) < 1e-4 * Math.hypot(rx - ox, ry - oy), "a cross is bent");
    assert.ok(outline.every((value) => Math.abs(value) <= 1 + 1e-12), "it is seen whole");
  }
});

test("the slider goes there, its words and the address say where, and play ends on the disk", async () => {
  const { page, errors, close } = await openPage(session, "#shape=ell&show=grid");
  const whole = await disk(page);
  await page.locator("#morph").fill("0.4");
  await settled(page, "ready");
  assert.match(await page.locator("#disk-words").innerText(), /On the way.*r = 0\.84/);
  await page.waitForURL(/morph=0\.4/);
  assert.equal(await page.locator("#disk-marks .rim").isVisible(), false);
  const between = await disk(page);
  assert.notEqual(between.digest, whole.digest);
  await screenshot(page, "morph");
  // There is nothing to travel on; the region can be edited all the same.
  const url = page.url();
  const { x, y } = await middle(page.locator("#disk"));
  await drag(page, { x, y }, { x: x + 40, y });
  assert.equal(page.url(), url);
  await drag(page, await middle(handle(page, "center")), await onPhoto(page, 0.3, 0.7));
  await settled(page, "ready");
  assert.notEqual((await disk(page)).digest, between.digest);
  await page.keyboard.press("Control+z");
  await page.locator("#morph").focus();
  await page.keyboard.press("End");
  await settled(page, "ready");
  assert.equal((await disk(page)).digest, whole.digest);
  await page.getByRole("button", { name: "Play the way" }).click();
  await page.waitForFunction(() => Number(/** @type {HTMLInputElement} */ (document.getElementById("morph")).value) < 0.9);
  await page.waitForFunction(() => /** @type {HTMLInputElement} */ (document.getElementById("morph")).value === "1");
  await settled(page, "ready");
  assert.equal((await disk(page)).digest, whole.digest);
  assert.ok(!page.url().includes("morph"));
  assert.deepEqual(errors, []);
  await close();
});
