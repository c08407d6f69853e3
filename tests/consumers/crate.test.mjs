// The crate as `cargo publish` would upload it: without a warning, with all that its targets read and nothing of the pages.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { root } from "../../tools/steps.mjs";

/** Of the pages' files, the tests read one: the glyphs that they solve. */
const GLYPHS = "www/letters.json";

/** What cargo prints, each stream. @param {string[]} args */
function cargo(...args) {
  const { status, stdout, stderr } = spawnSync("cargo", args, { cwd: root, encoding: "utf8", maxBuffer: 1 << 28 });
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
  for (const name of ["src/lib.rs", "README.md", "CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE", "docs/LIMITS.md", "tests/fixtures/blob100.json", GLYPHS]) {
    assert.ok(names.includes(name), name);
  }
  const strange = names.filter((name) => /\.m?js$|^(www|js|tools|node_modules|pkg|\.)/.test(name) && ![GLYPHS, ".cargo_vcs_info.json"].includes(name));
  assert.deepEqual(strange, []);
});

// Of the crate's own code, clippy's incompatible_msrv finds what the manifest's rust-version does not have.
test("what the crate depends on compiles with the Rust that it asks for", () => {
  const { packages } = JSON.parse(cargo("metadata", "--format-version", "1", "--locked").stdout);
  const minor = (/** @type {string} */ version) => Number(version.split(".")[1]);
  const own = packages.find((/** @type {any} */ { name }) => name === "conformal-warp").rust_version;
  const newer = packages.filter((/** @type {any} */ { rust_version }) => rust_version && minor(rust_version) > minor(own));
  assert.deepEqual(newer.map((/** @type {any} */ { name, rust_version }) => `${name} wants ${rust_version}`), []);
  assert.match(readFileSync(join(root, "README.md"), "utf8"), new RegExp(`Rust ${own}`), "README names it");
});
