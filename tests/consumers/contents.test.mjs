// What goes along with the code in the tarball.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { root } from "../../tools/steps.mjs";
import { unpacked } from "./support/project.mjs";

test("licences and README go along", () => {
  for (const name of ["README.md", "LICENSE-MIT", "LICENSE-APACHE"]) assert.ok(existsSync(join(unpacked, name)), name);
});

test("every crate in the modules has its notice, with the text of a licence", () => {
  const [, ...parts] = readFileSync(join(unpacked, "pkg", "THIRD-PARTY-NOTICES.txt"), "utf8").split(/\n-{80}\n/);
  const notices = new Map(parts.map((part) => [part.trim().split(" ")[0], part]));
  const [, dependencies = ""] = readFileSync(join(root, "Cargo.toml"), "utf8").split(/^\[dependencies\]$/m);
  const direct = [...dependencies.split(/^\[/m)[0].matchAll(/^([\w-]+) = /gm)].map(([, name]) => name);
  assert.ok(direct.length >= 6);
  for (const name of [...direct, "wasm-bindgen", "js-sys", "hashbrown"]) assert.ok(notices.has(name), name);
  for (const [name, part] of notices) assert.match(part, /Permission|warrant|Under the terms of/i, name);
  assert.ok(!notices.has("criterion") && !notices.has("syn"), "crates that only build or test are not in it");
});
