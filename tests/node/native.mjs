// The package, compiled and optimised for wasm, gives the numbers of the native crate.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import init, { Region, RiemannMap } from "conformal-warp";
import { root } from "../../tools/steps.mjs";

const names = ["sc_4_101", "sc_6_102", "sc_9_103", "sc_15_104", "sc_24_105", "neck", "slot", "spike", "blob100"];
const files = names.map((name) => `tests/fixtures/${name}.json`);

/** @param {string} file */
function regionIn(file) {
  const { vertices, center, toward } = JSON.parse(readFileSync(`${root}/${file}`, "utf8"));
  return new Region({ boundary: new Float64Array(vertices.flat()), center, toward });
}

/**
 * @param {string} what
 * @param {Float64Array} found
 * @param {(number | null)[]} expected null for NaN
 */
function assertSame(what, found, expected) {
  assert.equal(found.length, expected.length, what);
  found.forEach((x, k) => {
    const y = expected[k] ?? NaN;
    assert.ok(Math.abs(x - y) <= 1e-12 || (Number.isNaN(x) && Number.isNaN(y)), `${what} ${k}: ${x} against ${y}`);
  });
}

test("a map solved in wasm has the native map's numbers to 1e-12", async () => {
  await init();
  const options = /** @type {const} */ ({ cwd: root, encoding: "utf8", maxBuffer: 1 << 26 });
  const native = JSON.parse(execFileSync("cargo", ["run", "--quiet", "--example", "solve", "--", ...files], options));
  files.forEach((file, k) => {
    const region = regionIn(file);
    // As the example. At looser tolerances a panel may be halved or not by the last digit of its residual.
    const map = RiemannMap.solve(region, { tolerance: 1e-10 });
    assert.equal(map.unknowns, native[k].unknowns, file);
    assert.ok(Math.abs(map.conformalRadius / native[k].conformalRadius - 1) <= 1e-12, `${file}: conformal radius`);
    // 0 and a whole turn are the same angle.
    const chord = (/** @type {ArrayLike<number>} */ angles) => Float64Array.from(angles, (angle) => Math.sin(angle / 2));
    assertSame(`${file}: angle`, chord(map.angles), [...chord(native[k].angles)]);
    const [x, y] = region.center;
    const midpoints = region.boundary.map((v, at) => (v + (at % 2 === 0 ? x : y)) / 2);
    assertSame(`${file}: image`, map.toDisk(midpoints), native[k].images);
  });
});
