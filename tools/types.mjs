// From the types that wasm-bindgen generates to the package's own, and to the same as data, by which js/check.js checks
// arguments: a type is written once, in src/wasm/.

import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { Failure, root } from "./steps.mjs";

/** @typedef {import("../js/check.js").Type} Type */
/** @typedef {import("../js/check.js").Parameter} Parameter */
/** @typedef {import("../js/guard.js").Signature} Signature */

/** Typed arrays that the package makes have a buffer of their own, which can be transferred. */
const ARRAYS = /\b(Float64Array|Uint32Array|Uint8Array|Uint8ClampedArray)\b(?!<)/g;
const BUILT_IN = /^(number|string|boolean|Count|Float64Array|Uint32Array|Uint8Array|Uint8ClampedArray)$/;

/**
 * @param {string} generated the text of wasm-bindgen's declarations
 * @param {string} entry the text of js/entry.d.ts
 */
export function makeTypes(generated, entry) {
  const [ours] = generated.split("\nexport type InitInput");
  const withoutNote = ours.replace(/^\/\* (tslint|eslint).*\n/gm, "");
  const text = [
    "// The types of the npm package; made by tools/types.mjs.",
    "",
    entry.replace(/^\/\/.*\n\n?/, ""),
    "declare global {",
    "  interface SymbolConstructor {",
    "    readonly dispose: unique symbol;",
    "  }",
    "}",
    "",
    "/** What an error's `code` can be. */",
    `export type ErrorCode = ${errorCodes().map((code) => `"${code}"`).join(" | ")};`,
    "",
    owned(withoutNote).trim(),
    "",
  ].join("\n");
  return { text, ...readSignatures(withoutNote) };
}

/** Every code that the sources name. */
function errorCodes() {
  const codes = new Set();
  const collect = (/** @type {string} */ folder, /** @type {RegExp} */ file, /** @type {RegExp} */ form) => {
    for (const name of /** @type {string[]} */ (readdirSync(join(root, folder), { recursive: true })).filter((n) => file.test(n))) {
      for (const [, code] of readFileSync(join(root, folder, name), "utf8").matchAll(form)) codes.add(code);
    }
  };
  collect("src", /error\.rs$/, /Self::\w+(?: \{ \.\. \})? => "([a-z-]+)"/g);
  collect("src/wasm", /\.rs$/, /Failure::new\(\s*"([a-z-]+)"/g);
  collect("js", /\.js$/, /(?:failure\(\s*|code: )"([a-z-]+)"/g);
  return [...codes, "invalid-option"].filter((code, k, all) => all.indexOf(code) === k).sort();
}

/** @param {string} text */
function owned(text) {
  const result = (/** @type {string} */ type) => type.replace(ARRAYS, "$1<ArrayBuffer>");
  return text.replace(/^( {4}(?:static )?\w+\(.*\): |    readonly \w+: |export function .*\): )([^:]*;)$/gm, (_, head, type) => head + result(type));
}

/**
 * @param {string} text
 * @returns {{ types: Record<string, Type>, calls: Record<string, Signature | Parameter[]> }}
 */
function readSignatures(text) {
  const bare = text.replace(/\/\*\*[\s\S]*?\*\//g, "");
  /** @type {Record<string, Type>} */
  const types = {};
  /** @type {Record<string, Signature | Parameter[]>} */
  const calls = {};
  for (const [, name, body] of bare.matchAll(/^export interface (\w+)[^{]*\{\n([\s\S]*?)^\}/gm)) {
    const methods = [...body.matchAll(/^\s*(\w+)\(/gm)].map(([, method]) => method);
    // What only is read may be an object of the platform's, with more to it.
    const open = /^\s*readonly /m.test(body);
    types[name] = methods.length > 0 ? { methods } : { fields: fieldsOf(body), ...(open && { open }) };
  }
  for (const [, name, type] of bare.matchAll(/^export type (\w+) =\s+([\s\S]*?);\n/gm)) {
    if (name !== "Count") types[name] = parse(type);
  }
  for (const [, name, body] of bare.matchAll(/^export class (\w+) \{\n([\s\S]*?)^\}/gm)) calls[name] = readClass(body);
  const made = (/** @type {string} */ name) => name in calls && !Array.isArray(calls[name]);
  for (const call of Object.values(calls)) {
    if (Array.isArray(call) || !call.makes) continue;
    call.makes = Object.fromEntries(Object.entries(call.makes).filter(([, name]) => made(name)));
  }
  for (const [, name, parameters] of bare.matchAll(/^export function (\w+)\((.*)\): /gm)) {
    if (!/^(init|initSync)$/.test(name)) calls[name] = readParameters(parameters);
  }
  return { types: used(types, calls), calls };
}

/**
 * @param {string} body
 * @returns {Record<string, [type: Type, optional: 0 | 1]>}
 */
function fieldsOf(body) {
  const fields = [...body.matchAll(/^\s*(?:readonly )?(\w+)(\?)?: (.*);$/gm)];
  return Object.fromEntries(fields.map(([, name, mark, type]) => [name, [parse(type), mark ? 1 : 0]]));
}

/**
 * @param {string} body
 * @returns {Signature}
 */
function readClass(body) {
  /** @type {Required<Pick<Signature, "static" | "methods" | "makes" | "properties">> & Signature} */
  const found = { static: {}, methods: {}, makes: {}, properties: [] };
  for (const [, modifier, name, parameters, result] of body.matchAll(/^ {4}(private |static )?(\w+)\((.*?)\)(?:: (.*))?;$/gm)) {
    if (name === "free") continue;
    if (result) found.makes[name] = result;
    if (name !== "constructor") found[modifier === "static " ? "static" : "methods"][name] = readParameters(parameters);
    else if (modifier !== "private ") found.new = readParameters(parameters);
  }
  found.properties = [...body.matchAll(/^ {4}readonly (\w+): /gm)].map(([, name]) => name);
  return found;
}

/**
 * @param {string} text
 * @returns {Parameter[]}
 */
function readParameters(text) {
  return splitTop(text, ",").map((parameter) => {
    const [, name, mark, type] = /** @type {RegExpExecArray} */ (/^(\w+)(\?)?: ([\s\S]*)$/.exec(parameter));
    return [name, parse(type), mark ? 1 : 0];
  });
}

/**
 * @param {string} given
 * @returns {Type}
 */
function parse(given) {
  const text = given.trim();
  // Narrower unions of an interface's options are for the compiler alone.
  const narrowed = /Omit<(\w+),/.exec(text);
  if (narrowed) return narrowed[1];
  if (/^\(.*\) => /.test(text)) return "function";
  const parts = splitTop(text, "|").filter((part) => part !== "null" && part !== "undefined");
  if (parts.length > 1) {
    const literals = parts.every((part) => part.startsWith('"'));
    return literals ? { oneOf: parts.map((part) => JSON.parse(part)) } : { any: parts.map(parse) };
  }
  const [one] = parts;
  if (one.startsWith('"')) return { oneOf: [JSON.parse(one)] };
  if (one.endsWith("[]")) return { list: parse(one.slice(0, -2)) };
  if (one.startsWith("[")) return { tuple: splitTop(one.slice(1, -1), ",").map((item) => parse(item.replace(/^\w+: /, ""))) };
  const record = /^Record<string, ([\s\S]*)>$/.exec(one);
  if (record) return { record: parse(record[1]) };
  if (!/^\w+$/.test(one)) throw new Failure(`tools/types.mjs cannot read the type ${given}.`);
  return one;
}

/**
 * Splits at a separator outside of all brackets.
 *
 * @param {string} text
 * @param {string} separator
 */
function splitTop(text, separator) {
  const parts = [];
  let depth = 0;
  let start = 0;
  for (let k = 0; k < text.length; k++) {
    if ("([{<".includes(text[k])) depth++;
    else if (")]}".includes(text[k]) || (text[k] === ">" && text[k - 1] !== "=")) depth--;
    else if (text[k] === separator && depth === 0) {
      parts.push(text.slice(start, k));
      start = k + 1;
    }
  }
  return [...parts, text.slice(start)].map((part) => part.trim()).filter(Boolean);
}

/**
 * The types that arguments can be of, and those inside them; every name must be declared.
 *
 * @param {Record<string, Type>} types
 * @param {Record<string, Signature | Parameter[]>} calls
 */
function used(types, calls) {
  /** @type {Record<string, Type>} */
  const kept = {};
  const visit = (/** @type {unknown} */ node) => {
    if (Array.isArray(node)) return node.forEach(visit);
    if (typeof node === "object" && node !== null) return Object.values(node).forEach(visit);
    if (typeof node !== "string" || kept[node] || !types[node]) return;
    kept[node] = types[node];
    visit(types[node]);
  };
  visit(calls);
  const names = new Set([...Object.keys(types), ...Object.keys(calls), "ErrorCode", "function"]);
  const check = (/** @type {Type} */ type) => {
    if (typeof type === "string") {
      if (!names.has(type) && !BUILT_IN.test(type)) throw new Failure(`src/wasm/ uses the type ${type} and does not declare it.`);
    } else if ("any" in type) type.any.forEach(check);
    else if ("tuple" in type) type.tuple.forEach(check);
    else if ("list" in type) check(type.list);
    else if ("record" in type) check(type.record);
    else if ("fields" in type) for (const [field] of Object.values(type.fields)) check(field);
  };
  Object.values(types).forEach(check);
  const parameters = Object.values(calls).flatMap((call) =>
    Array.isArray(call) ? call : [call.new ?? [], ...Object.values(call.static ?? {}), ...Object.values(call.methods ?? {})].flat(),
  );
  for (const [, type] of parameters) check(type);
  return kept;
}
