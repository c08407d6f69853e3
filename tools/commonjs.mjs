// The package for `require`: each entry with its modules in one file.

import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { root, run } from "./steps.mjs";

/**
 * @param {string} folder holds the modules; the files are written beside them
 * @param {string[]} entries
 */
export async function toCommonJs(folder, entries) {
  const modules = await translate(folder);
  for (const entry of entries) writeFileSync(join(folder, `${entry}.cjs`), bundle(modules, entry));
}

/**
 * @param {string} folder
 * @returns {Promise<Map<string, string>>} the modules' texts by their names
 */
async function translate(folder) {
  const work = mkdtempSync(join(tmpdir(), "commonjs-"));
  try {
    const names = readdirSync(folder).filter((name) => name.endsWith(".js"));
    for (const name of names) {
      // Only modules themselves have import.meta; what stands for it is in the head of the bundle.
      writeFileSync(join(work, name), readFileSync(join(folder, name), "utf8").replaceAll("import.meta.url", "HERE"));
    }
    const tsc = join(root, "node_modules", "typescript", "bin", "tsc");
    const form = ["--allowJs", "--module", "commonjs", "--moduleResolution", "bundler", "--target", "es2022", "--noCheck"];
    const files = names.map((name) => join(work, name));
    await run(process.execPath, [tsc, "--ignoreConfig", ...form, "--types", "", "--outDir", join(work, "out"), ...files]);
    return new Map(names.map((name) => [`./${name}`, readFileSync(join(work, "out", name), "utf8")]));
  } finally {
    rmSync(work, { recursive: true });
  }
}

/**
 * @param {Map<string, string>} modules
 * @param {string} entry
 */
export function bundle(modules, entry) {
  const parts = reachable(modules, `./${entry}.js`).map(
    (name) => `${JSON.stringify(name)}(exports, require) {\n${modules.get(name)}\n},`,
  );
  return [
    '"use strict";',
    'const HERE = typeof __filename === "string" ? "file://" + encodeURI(__filename.replace(/^(?=[A-Za-z]:)/, "/").replaceAll("\\\\", "/")) : typeof document === "object" ? document.currentScript?.src : undefined;',
    "const modules = {",
    ...parts,
    "};",
    "const loaded = {};",
    "function load(name) {",
    "  if (!loaded[name]) modules[name](loaded[name] = {}, load);",
    "  return loaded[name];",
    "}",
    `module.exports = load("./${entry}.js");`,
    "",
  ].join("\n");
}

/**
 * @param {Map<string, string>} modules
 * @param {string} entry
 */
function reachable(modules, entry) {
  const found = [entry];
  for (const name of found) {
    for (const [, other] of (modules.get(name) ?? "").matchAll(/require\("(\.\/[\w.-]+)"\)/g)) {
      if (!found.includes(other)) found.push(other);
    }
  }
  return found;
}
