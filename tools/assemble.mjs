// A module's folder in the package: what wasm-bindgen generates, the hand-written entries of js/, and types.

import { cpSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { toCommonJs } from "./commonjs.mjs";
import { adaptGlue } from "./glue.mjs";
import { Failure, root } from "./steps.mjs";
import { makeTypes } from "./types.mjs";

/**
 * @param {string} generated the folder of wasm-bindgen's output
 * @param {string} module the optimised .wasm
 * @param {string} folder where the package's files go
 * @param {string} [part] the name of a module that is a part of the whole
 */
export async function assemble(generated, module, folder, part) {
  const source = (/** @type {string} */ name) => {
    const text = readFileSync(join(root, "js", name), "utf8");
    return part ? forPart(text, part) : text;
  };
  const write = (/** @type {string} */ name, /** @type {string} */ text) => writeFileSync(join(folder, name), text);
  for (const name of readdirSync(join(root, "js"))) if (name.endsWith(".js")) write(name, source(name));

  const declared = readFileSync(join(generated, "conformal_warp.d.ts"), "utf8");
  const { text, types, calls } = makeTypes(declared, source("entry.d.ts"));
  if (Object.keys(calls).length === 0) throw new Failure("wasm-bindgen exported nothing.");
  cpSync(module, join(folder, part ? `${part}_bg.wasm` : "conformal_warp_bg.wasm"));
  write("conformal_warp.js", adaptGlue(readFileSync(join(generated, "conformal_warp.js"), "utf8")));
  write("signatures.js", signatures(types, calls));
  write("classes.js", classes(Object.keys(calls)));
  write("bytes.js", bytes(readFileSync(module)));

  write("index.d.ts", text);
  write("index.d.cts", text);
  for (const kind of ["ts", "cts"]) {
    const from = kind === "ts" ? "./index.js" : "./index.cjs";
    write(`inline.d.${kind}`, `export * from "${from}";\nexport { default } from "${from}";\n`);
    write(`wasm.d.${kind}`, `/** The module's address, as bundlers hand it out. */\ndeclare const address: string;\nexport default address;\n`);
  }
  for (const [to, index] of [["pool.d.ts", "./index.js"], ["pool.d.cts", "./index.cjs"]]) {
    write(to, source("pool-types.d.ts").replace('"conformal-warp"', `"${index}"`));
  }
  write("conformal_warp.d.ts", internalTypes(Object.keys(calls)));
  await toCommonJs(folder, ["index", "inline", "pool"]);
}

/**
 * The names of a part's files and entries, in the places of the whole's.
 *
 * @param {string} text
 * @param {string} part
 */
function forPart(text, part) {
  return text
    .replaceAll("conformal_warp_bg.wasm", `${part}_bg.wasm`)
    .replaceAll('"region_new"', '"formulamap_new"')
    .replaceAll('"conformal-warp/pkg/"', `"conformal-warp/pkg/${part}/"`)
    .replaceAll(/"conformal-warp\/(wasm|inline)"/g, `"conformal-warp/${part}/$1"`);
}

/**
 * @param {Record<string, unknown>} types
 * @param {Record<string, unknown>} calls
 */
function signatures(types, calls) {
  const lines = (/** @type {Record<string, unknown>} */ table) =>
    Object.entries(table).map(([name, entry]) => `  ${name}: ${JSON.stringify(entry)},`);
  return [
    "// Made by tools/types.mjs from the package's types: what arguments must be.",
    '/** @type {Record<string, import("./check.js").Type>} */',
    "export const types = {",
    ...lines(types),
    "};",
    '/** @type {Record<string, any>} */',
    "export const calls = {",
    ...lines(calls),
    "};",
    "",
  ].join("\n");
}

/** @param {string[]} names */
function classes(names) {
  return [
    "// Made by tools/assemble.mjs: every class and function that wasm-bindgen generates, guarded (see guard.js).",
    'import * as generated from "./conformal_warp.js";',
    'import { guard } from "./guard.js";',
    'import { calls } from "./signatures.js";',
    ...names.map((name) => `export const ${name} = guard(generated.${name}, "${name}", calls.${name});`),
    "",
  ].join("\n");
}

/** @param {Buffer} wasm */
function bytes(wasm) {
  return [
    "// Made by tools/assemble.mjs: the module in the form of text.",
    `const BASE64 = "${wasm.toString("base64")}";`,
    "",
    "/** @returns {Uint8Array<ArrayBuffer>} */",
    "export function bytes() {",
    "  const text = atob(BASE64);",
    "  const decoded = new Uint8Array(text.length);",
    "  for (let k = 0; k < text.length; k++) decoded[k] = text.charCodeAt(k);",
    "  return decoded;",
    "}",
    "",
  ].join("\n");
}

/**
 * The generated module as js/ sees it.
 *
 * @param {string[]} names
 */
function internalTypes(names) {
  return [
    "// Made by tools/assemble.mjs: what js/ uses of the generated module.",
    'import type { InitOutput } from "./index.js";',
    ...names.map((name) => `export const ${name}: typeof import("./index.js").${name};`),
    "export function imports(): WebAssembly.Imports;",
    "/** Throws unless the module has room for so many bytes. */",
    "export function roomFor(bytes: number): void;",
    "/** Makes an instance the one that all calls go to. */",
    "export function use(instance: WebAssembly.Instance): InitOutput;",
    "/** Lets the instance go, with all that it made. */",
    "export function abandon(): void;",
    "/** Whether the instance in use made this object. */",
    "export function isCurrent(object: unknown): boolean;",
    "",
  ].join("\n");
}
