// The crate's examples write the pictures that they promise.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { inflateSync } from "node:zlib";
import { root } from "../../tools/steps.mjs";

/** The bytes that a PNG's filtered rows hold, unpacked. @param {Buffer} png */
function unpack(png) {
  const parts = [];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) {
    if (png.toString("latin1", at + 4, at + 8) === "IDAT") parts.push(png.subarray(at + 8, at + 8 + png.readUInt32BE(at)));
  }
  return inflateSync(Buffer.concat(parts));
}

for (const [name, ...more] of [["formula", "(z - 1)/(z + 1)"], ["disk"], ["pair"], ["cortex"], ["fovea"]]) {
  test(`cargo run --example ${name}`, async (context) => {
    const folder = await mkdtemp(join(tmpdir(), "example-"));
    context.after(() => rm(folder, { recursive: true }));
    const out = join(folder, "out.png");
    const args = ["run", "--quiet", "--example", name, "--", "tests/fixtures/astronaut.jpg", out, ...more];
    assert.match(execFileSync("cargo", args, { cwd: root, encoding: "utf8" }), /512 x 512 pixels/);
    const rows = unpack(await readFile(out));
    assert.equal(rows.length, 512 * (1 + 4 * 512));
    assert.ok(new Set(rows).size > 200, "the picture has many colours");
  });
}
