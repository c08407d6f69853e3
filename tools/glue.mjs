// What wasm-bindgen generates, as the package needs it: without a loader of its own, and with instances told apart.

import { Failure } from "./steps.mjs";

/**
 * @param {string} generated the text of wasm-bindgen's module for the web
 * @returns {string}
 */
export function adaptGlue(generated) {
  const [calls] = split(generated, "\nasync function __wbg_load(");
  return [
    [/new FinalizationRegistry\(ptr => wasm\.(\w+)\(ptr, 1\)\)/g, "new FinalizationRegistry(({ ptr, from }) => from === made && wasm.$1(ptr, 1))"],
    [/\.register\((\w+), \1\.__wbg_ptr, \1\)/g, ".register($1, mark($1), $1)"],
    // A text decoder is made when it is needed: test environments that imitate browsers may have none.
    [/^let cachedTextDecoder = new TextDecoder\(.*\);\ncachedTextDecoder\.decode\(\);$/m, "let cachedTextDecoder;"],
    [/^( *)return cachedTextDecoder\.decode\(/m, "$1cachedTextDecoder ??= textDecoder();\n$1return cachedTextDecoder.decode("],
    [/^const cachedTextEncoder = new TextEncoder\(\);$/m, "const cachedTextEncoder = textEncoder();"],
  ].reduce((text, [from, to]) => replace(text, /** @type {RegExp} */ (from), /** @type {string} */ (to)), undescribed(calls)) + ADDED;
}

/**
 * Without the descriptions, which the types have as well.
 *
 * @param {string} text
 */
function undescribed(text) {
  return text.replace(/^ *\/\*\*\n(?: *\*.*\n)*? *\*\/\n/gm, "");
}

const ADDED = `
function textDecoder() {
    const { TextDecoder: Decoder } = globalThis.TextDecoder ? globalThis : globalThis.process.getBuiltinModule("node:util");
    return new Decoder("utf-8", { ignoreBOM: true, fatal: true });
}

function textEncoder() {
    const { TextEncoder: Encoder } = globalThis.TextEncoder ? globalThis : globalThis.process.getBuiltinModule("node:util");
    return new Encoder();
}

/** Which instance objects were made by: another one for each instance. */
let made = {};

function mark(object) {
    Object.defineProperty(object, "__wbg_from", { value: made });
    return { ptr: object.__wbg_ptr, from: made };
}

export function isCurrent(object) {
    return object.__wbg_from === made;
}

export function use(instance) {
    made = {};
    return __wbg_finalize_init(instance);
}

export function abandon() {
    made = {};
    wasm = wasmInstance = undefined;
}

export { __wbg_get_imports as imports };
`;

/**
 * @param {string} text
 * @param {RegExp} from
 * @param {string} to
 */
function replace(text, from, to) {
  if (!from.test(text)) throw new Failure(`wasm-bindgen no longer generates ${from}: tools/glue.mjs must follow it.`);
  from.lastIndex = 0;
  return text.replace(from, to);
}

/**
 * @param {string} text
 * @param {string} where
 */
function split(text, where) {
  const parts = text.split(where);
  if (parts.length !== 2) throw new Failure(`wasm-bindgen no longer generates "${where.trim()}": tools/glue.mjs must follow it.`);
  return parts;
}
