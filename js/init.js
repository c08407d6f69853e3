// Loading the wasm module: once, however often and from wherever it is asked for.

import load, { initSync as loadSync } from "./conformal_warp.js";
import { setReady } from "./guard.js";

/** @typedef {import("./conformal_warp.js").InitOutput} InitOutput */
/** @typedef {URL | string | Request | Response | BufferSource | WebAssembly.Module} InitSource */

/** @type {Promise<InitOutput> | undefined} */
let loading;

/**
 * Loads the module; every other call of this package must wait for it. Further calls, also at the same time, get the
 * same promise; after a failure the next call tries again.
 *
 * @param {InitSource | Promise<InitSource>} [source] where the .wasm is: an address, a response, its bytes or a compiled
 *   module. By default the file beside this one, in browsers and under Node.
 * @returns {Promise<InitOutput>} the instance's raw exports, of which `memory` may be of interest
 */
export default function init(source) {
  loading ??= start(source).catch((error) => {
    loading = undefined;
    throw error;
  });
  return loading;
}

/**
 * Loads the module at once, from its bytes or a compiled module: for places where nothing can be awaited.
 *
 * @param {BufferSource | WebAssembly.Module} source
 * @returns {InitOutput}
 */
export function initSync(source) {
  if (source === undefined) throw new TypeError("initSync() needs the module's bytes or a WebAssembly.Module.");
  const output = loadSync({ module: source });
  loading ??= Promise.resolve(output);
  setReady();
  return output;
}

/** @param {InitSource | Promise<InitSource>} [source] */
async function start(source) {
  const given = await source;
  const output = await load({ module_or_path: (await fromDisk(given)) ?? given });
  setReady();
  return output;
}

/**
 * Node's fetch does not read files: there, the default source and file: addresses are read from the disk.
 *
 * @param {InitSource} [source]
 */
async function fromDisk(source) {
  if (typeof process === "undefined" || !process.versions?.node) return undefined;
  const address = source ?? new URL("conformal_warp_bg.wasm", import.meta.url);
  const isFile = address instanceof URL ? address.protocol === "file:" : String(address).startsWith("file:");
  if (!isFile) return undefined;
  const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ "node:fs/promises");
  return readFile(address instanceof URL ? address : new URL(String(address)));
}
