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

/**
 * `awaits`: the task's argument comes in a message that `gives` it; what is asked later is done after it.
 *
 * @typedef {{ id: number, module?: WebAssembly.Module, task?: Task, free?: number, awaits?: number, gives?: number, value?: unknown }} Message
 */

/** What is awaited or given, by number. @type {Map<number, { given: Promise<unknown>, give(value: unknown): void }>} */
const gifts = new Map();

/** @param {number} kept */
function gift(kept) {
  const known = gifts.get(kept);
  if (known) return known;
  /** @type {(value: unknown) => void} */
  let give = () => undefined;
  const given = new Promise((resolve) => (give = resolve));
  const made = { given, give };
  gifts.set(kept, made);
  return made;
}

/** The end of what is being done. */
let last = Promise.resolve();

/** @param {Message} message */
function hear(message) {
  if (message.gives !== undefined) gift(message.gives).give(message.value);
  // What cannot be freed, after a crash, keeps nobody waiting.
  else last = last.then(() => answer(message)).catch(() => undefined);
}

/** A pool has no way to load the module again in one worker. */
const CRASHED = "A worker of the pool has crashed, for want of memory or by a fault of the module: close the pool, and make a new one.";

/** @param {Message} message */
async function answer({ id, module, task, free, awaits }) {
  if (free !== undefined) {
    objects.get(free)?.free();
    objects.delete(free);
    return;
  }
  try {
    if (module) await init(module);
    if (task && awaits !== undefined) task.args = [{ value: await received(awaits) }];
    const value = task && perform(id, task);
    post({ id, value }, ArrayBuffer.isView(value) ? [value.buffer] : []);
  } catch (/** @type {any} */ error) {
    const message = error?.code === "crashed" ? CRASHED : String(error?.message ?? error);
    post({ id, error: { ...error, message, cause: undefined } });
  }
}

/**
 * @param {number} id
 * @param {Task} task
 */
function perform(id, { kind, name, key = "", self, args, keep, cancel, progress }) {
  const given = args.map((/** @type {any} */ arg) => ("value" in arg ? arg.value : found(arg.kept)));
  if (cancel || progress) tell(id, given, cancel, progress);
  if (key === "prepare") given[0] = given[0].onProgress;
  const made_ = /** @type {any} */ (made)[name];
  const object = self === undefined ? undefined : found(self);
  const value = kind === "new" ? new made_(...given) : kind === "static" ? made_[key](...given) : kind === "get" ? object[key] : object[key](...given);
  if (keep === undefined) return value;
  objects.set(keep, value);
  return undefined;
}

/** @param {number} kept */
async function received(kept) {
  const value = await gift(kept).given;
  gifts.delete(kept);
  return value ?? missing();
}

/** @param {number} kept */
function found(kept) {
  return objects.get(kept) ?? missing();
}

/** @returns {never} */
function missing() {
  throw Object.assign(new Error("An object of the pool was freed, or could not be made."), { code: "freed" });
}

/**
 * Puts an `onProgress` into the options of a solve, or of what is prepared.
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
