// A worker of a pool: it keeps objects under numbers, and answers one task after another.

import * as made from "./classes.js";
import { loader } from "./load.js";
import { builtin } from "./source.js";

/** @typedef {import("./crew.js").Task} Task */

const port = builtin("node:worker_threads")?.parentPort;
const { init } = loader(() => new Uint8Array());
/** @type {Map<number, any>} */
const objects = new Map();

const post = (/** @type {unknown} */ message, /** @type {any[]} */ transfer = []) =>
  port ? port.postMessage(message, transfer) : /** @type {any} */ (globalThis).postMessage(message, transfer);

/** @param {{ id: number, module?: WebAssembly.Module, task?: Task, free?: number }} message */
async function hear({ id, module, task, free }) {
  if (free !== undefined) {
    objects.get(free)?.free();
    objects.delete(free);
    return;
  }
  try {
    if (module) await init(module);
    const value = task && perform(id, task);
    post({ id, value }, ArrayBuffer.isView(value) ? [value.buffer] : []);
  } catch (/** @type {any} */ error) {
    post({ id, error: { ...error, message: String(error?.message ?? error), cause: undefined } });
  }
}

/**
 * @param {number} id
 * @param {Task} task
 */
function perform(id, { kind, name, key = "", self, args, keep, cancel, progress }) {
  const given = args.map((/** @type {any} */ arg) => (arg?.kept === undefined ? arg : found(arg.kept)));
  if (cancel || progress) tell(id, given, cancel, progress);
  const made_ = /** @type {any} */ (made)[name];
  const object = self === undefined ? undefined : found(self);
  const value = kind === "new" ? new made_(...given) : kind === "static" ? made_[key](...given) : kind === "get" ? object[key] : object[key](...given);
  if (keep === undefined) return value;
  objects.set(keep, value);
  return undefined;
}

/** @param {number} kept */
function found(kept) {
  const object = objects.get(kept);
  if (!object) throw Object.assign(new Error("An object of the pool was freed, or could not be made."), { code: "freed" });
  return object;
}

/**
 * Puts an `onProgress` into the options of a solve.
 *
 * @param {number} id
 * @param {any[]} given
 * @param {Int32Array} [cancel]
 * @param {boolean} [progress]
 */
function tell(id, given, cancel, progress) {
  const at = given.length - 1;
  const onProgress = (/** @type {string} */ stage, /** @type {number} */ fraction) => {
    if (progress) post({ id, progress: [stage, fraction] });
    return !cancel || Atomics.load(cancel, 0) === 0;
  };
  const last = given[at];
  if (Object.prototype.toString.call(last) === "[object Object]" && !("view" in last) && !("__wbg_ptr" in last)) given[at] = { ...last, onProgress };
}

if (port) port.on("message", hear);
else globalThis.addEventListener("message", (event) => hear(/** @type {MessageEvent} */ (event).data));
