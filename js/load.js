// Loading the wasm module: once, however often and from whichever entry of the package it is asked for.

import { abandon, imports, use } from "./conformal_warp.js";
import { failure } from "./failure.js";
import { EXPORT, FILE } from "./module.js";
import { fetchModule, isFetchable } from "./source.js";
import { state } from "./state.js";

/** @typedef {import("./entry.js").InitOutput} InitOutput */
/** @typedef {import("./entry.js").InitSource} InitSource */

/**
 * `init` and `initSync` for an entry that brings its own source.
 *
 * @param {() => InitSource} usual where the entry has the module
 * @param {() => BufferSource} [usualBytes] its bytes, if the entry has them at once
 */
export function loader(usual, usualBytes) {
  /**
   * Loads the module; every other call of this package must wait for it. Further calls, also at the same time, get the
   * same promise; after a failure the next call tries again.
   *
   * @param {InitSource | Promise<InitSource>} [source] where the .wasm is: an address, a response, its bytes or a compiled
   *   module. By default the one that this entry of the package brings.
   * @returns {Promise<InitOutput>} the instance's raw exports, of which `memory` may be of interest
   */
  function init(source) {
    if (!isSource(source)) return Promise.reject(wrongSource());
    state.loading ??= start(source, usual).catch((error) => {
      state.loading = undefined;
      throw error;
    });
    return state.loading;
  }

  /**
   * Loads the module again, into a memory of its own: after a crash. What was made before is gone.
   *
   * @returns {Promise<InitOutput>}
   */
  init.reset = () => {
    abandon();
    const { module } = state;
    state.output = state.loading = state.crashed = undefined;
    return init(module);
  };

  /**
   * Loads the module at once, from its bytes or a compiled module: for places where nothing can be awaited.
   *
   * @param {BufferSource | WebAssembly.Module} [source]
   * @returns {InitOutput}
   */
  function initSync(source) {
    if (source === undefined && state.output) return state.output;
    const given = source ?? usualBytes?.();
    if (!isModule(given) && !isBytes(given)) {
      const message = "initSync() needs the module's bytes or a WebAssembly.Module.";
      throw Object.assign(new TypeError(message), { code: "invalid-argument", argument: "source" });
    }
    if (state.output) return state.output;
    const module = ours(isModule(given) ? given : compileSync(given), "what was given to initSync()");
    const output = instantiateSync(module);
    state.loading = Promise.resolve(output);
    return output;
  }

  return { init, initSync };
}

/**
 * @param {InitSource | Promise<InitSource> | undefined} source
 * @param {() => InitSource} usual
 */
async function start(source, usual) {
  const module = await compile((await source) ?? usual());
  try {
    return finish(module, await WebAssembly.instantiate(module, imports()));
  } catch (error) {
    throw explain(error, "the module given to init()");
  }
}

/**
 * The compiled module alone, for those who hand it to workers.
 *
 * @param {InitSource | Promise<InitSource> | undefined} source
 * @param {() => InitSource} usual
 * @returns {Promise<WebAssembly.Module>}
 */
export async function compiledModule(source, usual) {
  state.module ??= await compile((await source) ?? usual());
  return state.module;
}

/**
 * Of a module that was loaded twice at once, the first instance stays.
 *
 * @param {WebAssembly.Module} module
 * @param {WebAssembly.Instance} instance
 * @returns {InitOutput}
 */
function finish(module, instance) {
  if (!state.output) {
    state.output = use(instance);
    state.module = module;
  }
  return state.output;
}

/**
 * @param {InitSource} source
 * @returns {Promise<WebAssembly.Module>}
 */
async function compile(source) {
  if (isModule(source)) return ours(source, "the module given to init()");
  if (!isSource(source)) throw wrongSource();
  const found = isBytes(source) ? { bytes: source, from: "the bytes given to init()" } : await fetchModule(source);
  try {
    return ours("response" in found ? await WebAssembly.compileStreaming(found.response) : await WebAssembly.compile(found.bytes), found.from);
  } catch (error) {
    throw explain(error, found.from);
  }
}

/**
 * A module, if it is this package's.
 *
 * @param {WebAssembly.Module} module
 * @param {string} from
 */
function ours(module, from) {
  if (WebAssembly.Module.exports(module).some(({ name }) => name === EXPORT)) return module;
  throw failure("not-wasm", `What came from ${from} is WebAssembly, but not this package's ${FILE}.`);
}

/** @param {BufferSource} bytes */
function compileSync(bytes) {
  try {
    return new WebAssembly.Module(bytes);
  } catch (error) {
    throw explain(error, "the bytes given to initSync()");
  }
}

/** @param {WebAssembly.Module} module */
function instantiateSync(module) {
  try {
    return finish(module, new WebAssembly.Instance(module, imports()));
  } catch (error) {
    throw explain(error, "the module given to initSync()");
  }
}

/**
 * @param {any} error
 * @param {string} from
 */
function explain(error, from) {
  if (/** @type {any} */ (error)?.code) return error;
  if (error instanceof WebAssembly.LinkError || error instanceof TypeError) {
    const message = `What came from ${from} is WebAssembly, but not this package's of this version: ${error.message}`;
    return failure("not-wasm", message, { cause: error });
  }
  // Content security policies, and some servers' runtimes, forbid compiling; the engine's message says so.
  if (!(error instanceof WebAssembly.CompileError)) return Object.assign(error, { code: "load-failed" });
  const message = `What came from ${from} is not this package's WebAssembly module, or may not be compiled here: ${error.message}`;
  return Object.assign(new WebAssembly.CompileError(message), { code: "not-wasm", cause: error });
}

/**
 * What can lead to a module; of a promise that is seen when it is kept.
 *
 * @param {any} source
 */
function isSource(source) {
  const isAbsent = source === undefined || source === null;
  return isAbsent || typeof source.then === "function" || isModule(source) || isBytes(source) || isFetchable(source);
}

function wrongSource() {
  const message = "init() takes an address, a Response, the module's bytes or a WebAssembly.Module.";
  return failure("invalid-argument", message, { argument: "source" });
}

/** @param {unknown} value @returns {value is WebAssembly.Module} */
function isModule(value) {
  return Object.prototype.toString.call(value) === "[object WebAssembly.Module]";
}

/** @param {unknown} value @returns {value is BufferSource} */
function isBytes(value) {
  return ArrayBuffer.isView(value) || Object.prototype.toString.call(value) === "[object ArrayBuffer]";
}
