// From an address or a response to the bytes of the .wasm, in browsers, workers and under Node.

import { failure } from "./failure.js";
import { ENTRY, FILE, INLINE } from "./module.js";

/** What to do where a bundler has not taken the .wasm along. */
const ADVICE = `The bundler or server must serve ${FILE}: pass its address, init(url), or import "${INLINE}", which needs no file.`;

/** @typedef {{ from: string } & ({ bytes: BufferSource } | { response: Response })} Found */

/**
 * @param {string | URL | Request | Response} source
 * @returns {Promise<Found>} a response whose type says that it can be compiled as it arrives, or else bytes
 */
export async function fetchModule(source) {
  if (isResponse(source)) return readResponse(source);
  const from = String(/** @type {any} */ (source).url ?? source);
  const bytes = from.startsWith("file:") ? readFile(from) : undefined;
  if (bytes) return { bytes, from };
  try {
    return await readResponse(await fetch(source), from);
  } catch (/** @type {any} */ error) {
    if (error?.code === "load-failed") throw error;
    throw failure("load-failed", `The module could not be fetched from ${from}: ${error.message}. ${ADVICE}`, { cause: error });
  }
}

/**
 * @param {Response} response
 * @param {string} [from]
 * @returns {Promise<Found>}
 */
async function readResponse(response, from = response.url || "a response") {
  if (response.bodyUsed) throw failure("load-failed", `The response from ${from} was read before: give init() a fresh one.`);
  if (!response.ok) throw failure("load-failed", `The module is not at ${from}: the answer was ${response.status}. ${ADVICE}`);
  const type = response.headers.get("Content-Type") ?? "something";
  const streams = type.startsWith("application/wasm") && typeof WebAssembly.compileStreaming === "function";
  if (streams && typeof Response === "function" && response instanceof Response) return { response, from };
  const bytes = new Uint8Array(await response.arrayBuffer());
  // Development servers answer with their page where they have no file.
  const isWasm = bytes[0] === 0 && bytes[1] === 0x61 && bytes[2] === 0x73 && bytes[3] === 0x6d;
  if (isWasm) return { bytes, from };
  throw failure("load-failed", `The module is not at ${from}: what came is ${type}. ${ADVICE}`);
}

/**
 * Node's fetch does not read files.
 *
 * @param {string} address
 * @returns {Uint8Array<ArrayBuffer> | undefined}
 */
function readFile(address) {
  const fs = builtin("node:fs");
  if (!fs) return undefined;
  try {
    return new Uint8Array(fs.readFileSync(new URL(address)));
  } catch (/** @type {any} */ error) {
    const installed = findInstalled(address);
    if (installed) return new Uint8Array(fs.readFileSync(installed));
    throw failure("load-failed", `The module could not be read: ${error.message}. ${ADVICE}`, { cause: error });
  }
}

/**
 * The package's .wasm as Node finds it from a bundle that was written elsewhere.
 *
 * @param {string} from a file's address
 * @returns {string | undefined}
 */
export function findInstalled(from) {
  const createRequire = builtin("node:module")?.createRequire;
  if (!createRequire) return undefined;
  try {
    return createRequire(new URL(from)).resolve(ENTRY);
  } catch {
    return undefined;
  }
}

/**
 * A module of Node's own: an import of it would be an error in bundles for browsers, and so would a bare `process` for Parcel.
 *
 * @template {"node:fs" | "node:module" | "node:os" | "node:url" | "node:worker_threads"} Name
 * @param {Name} name
 * @returns {ReturnType<typeof process.getBuiltinModule<Name>> | undefined}
 */
export function builtin(name) {
  return globalThis.process?.getBuiltinModule?.(name);
}

/** Whether this is an address, a request or a response. @param {any} source */
export function isFetchable(source) {
  return typeof source === "string" || source instanceof URL || typeof source.url === "string" || isResponse(source);
}

/** @param {unknown} value @returns {value is Response} */
function isResponse(value) {
  return typeof (/** @type {any} */ (value)?.arrayBuffer) === "function" && typeof (/** @type {any} */ (value).ok) === "boolean";
}
