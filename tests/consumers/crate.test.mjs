// The crate as `cargo publish` would upload it: without a warning, with all that its targets read and nothing of the pages.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { root } from "../../tools/steps.mjs";

/** What cargo prints, each stream. @param {string[]} args */
function cargo(...args) {
  const { status, stdout, stderr } = spawnSync("cargo", args, { cwd: root, encoding: "utf8" });
  assert.equal(status, 0, stderr);
  return { stdout, stderr };
}

// Verifying compiles everything again: `cargo publish --dry-run` does that before a release.
test("cargo package has nothing to warn of", () => {
  const { stderr } = cargo("package", "--no-verify", "--allow-dirty");
  assert.doesNotMatch(stderr, /warning/, stderr);
  const [, size, unit] = stderr.match(/Packaged \d+ files, .*\(([\d.]+)([KM]iB) compressed\)/) ?? assert.fail(stderr);
  assert.ok(unit === "KiB" || Number(size) < 2, `${size} ${unit}`);
});

test("the crate holds its sources, tests and fixtures, and nothing of npm's", () => {
  const names = cargo("package", "--list", "--allow-dirty").stdout.trim().split("\n");
  for (const name of ["src/lib.rs", "README.md", "CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE", "docs/LIMITS.md", "tests/fixtures/blob100.json"]) {
    assert.ok(names.includes(name), name);
  }
  const strange = names.filter((name) => /\.m?js$|^(www|js|tools|node_modules|pkg|\.)/.test(name) && name !== ".cargo_vcs_info.json");
  assert.deepEqual(strange, []);
});
