// What README.md and docs/ say can be done can be done: code that nothing runs does not get in, and every command and link leads
// somewhere. The code itself is run by readme.test.mjs, recipes.test.mjs, next.test.mjs, and in Rust by `cargo test --doc`.

import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { root } from "../../tools/steps.mjs";

const docs = readdirSync(join(root, "docs")).filter((name) => name.endsWith(".md")).map((name) => `docs/${name}`);
const documents = ["README.md", "CONTRIBUTING.md", "SECURITY.md", "tests/README.md", "tests/fixtures/README.md", ...docs];
const { scripts } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));

/** The languages whose blocks something runs, or that nobody can run. @type {Record<string, string[]>} */
const run = { "README.md": ["js", "html", "rust", "sh", "text"], "docs/RECIPES.md": ["js", "jsx", "ts", "svelte", "html"] };

for (const document of documents) {
  const text = readFileSync(join(root, document), "utf8");
  // Fences open and close in turn.
  const languages = [...text.matchAll(/^ *```(.*)$/gm)].filter((_, k) => k % 2 === 0).map(([, language]) => language);

  test(`${document}: code that is run`, () => {
    assert.deepEqual(languages.filter((language) => !run[document]?.includes(language)), []);
  });

  test(`${document}: commands that are there`, () => {
    const missing = [
      ...[...text.matchAll(/npm run ([\w:-]+)/g)].filter(([, name]) => !scripts[name]),
      ...[...text.matchAll(/npm (start|test)\b/g)].filter(([, name]) => !scripts[name]),
      ...[...text.matchAll(/\b(?:tools|tests|examples|benches|src)\/[\w/.-]+\.(?:mjs|rs|py|json)\b/g)].filter(([path]) => !existsSync(join(root, path))),
      ...[...text.matchAll(/--example (\w+)/g)].filter(([, name]) => !existsSync(join(root, "examples", `${name}.rs`))),
      ...[...text.matchAll(/--bench (\w+)/g)].filter(([, name]) => !existsSync(join(root, "benches", `${name}.rs`))),
    ];
    assert.deepEqual(missing.map(([command]) => command), []);
  });

  test(`${document}: links that lead to files`, () => {
    const targets = [...text.matchAll(/\]\(([^)\s]+)\)/g)].map(([, target]) => target).filter((target) => !/^(https?:|mailto:|#)/.test(target));
    assert.deepEqual(targets.filter((target) => !existsSync(join(root, dirname(document), target.split("#")[0]))), []);
  });
}
