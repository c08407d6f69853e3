// A pool of workers with the package's own classes, whose methods return promises.
//
// Objects exist once in each worker, made there by the same calls, which give the same bits, or, where one solve is enough, sent
// there as bytes. Pictures are drawn in bands of rows and many points in parts, one for each worker. Only finished bands travel,
// and they are handed over, not copied.

import { checkArguments, describe, withArticle } from "./check.js";
import { Kept, Member, checkWorker, usualCount } from "./crew.js";
import { failure } from "./failure.js";
import { checkMaker } from "./guard.js";
import { compiledModule } from "./load.js";
import { beside, isMoved } from "./place.js";
import { calls } from "./signatures.js";
import { builtin } from "./source.js";

/** @typedef {import("./crew.js").Task} Task */
/** @typedef {{ pool: Pool, kept: number, name: string, bands?: [number, number][], columns?: number }} Handle */

/** The handle behind an object of the pool's. @type {WeakMap<object, Handle>} */
const handles = new WeakMap();
/** Calls that take long, and whose result can travel. */
const SOLVES = new Set(["solve", "withCenter"]);
/** Fewer points than this are not worth dividing. */
const PART = 1 << 14;
const MOST_WORKERS = 256;
/** @type {import("./check.js").Parameter[]} */
const PARAMETERS = [["options", { fields: { workers: ["Count", 1], worker: ["function", 1], source: ["unknown", 1] } }, 1]];

/**
 * @param {{ workers?: number, worker?: () => any, source?: import("./entry.js").InitSource }} [options]
 * @returns {Promise<any>}
 */
export async function createPool(options) {
  const [given = {}] = checkArguments("createPool()", PARAMETERS, [options]);
  const { workers = usualCount(), worker = spawn, source } = /** @type {any} */ (given);
  if (workers < 1 || workers > MOST_WORKERS) {
    const message = `The option "workers" cannot be used: expected a whole number from 1 to ${MOST_WORKERS}, found ${workers}.`;
    throw failure("invalid-option", message, { option: "workers" });
  }
  const module = await compiledModule(source, () => beside(() => new URL("conformal_warp_bg.wasm", import.meta.url)));
  const members = Array.from({ length: workers }, () => new Member(checkWorker(worker()), module));
  try {
    await Promise.all(members.map(({ ready }) => ready));
  } catch (error) {
    for (const member of members) member.end();
    throw error;
  }
  return new Pool(members).face();
}

function spawn() {
  const NodeWorker = builtin("node:worker_threads")?.Worker;
  const isNode = NodeWorker && typeof Worker === "undefined";
  if (isNode) return new NodeWorker(beside(() => new URL("pool-worker.js", import.meta.url)));
  if (isMoved(import.meta.url)) return new Worker(beside(() => new URL("pool-worker.js", import.meta.url)), { type: "module" });
  // Bundlers know this form, and take the worker along.
  return new Worker(new URL("./pool-worker.js", import.meta.url), { type: "module" });
}

class Pool {
  #next = 0;

  /** @param {Member[]} members */
  constructor(members) {
    this.members = members;
  }

  /** What users see: the classes, `size` and `close()`. */
  face() {
    /** @type {Record<string, unknown>} */
    const face = {
      size: this.members.length,
      close: () => this.members.forEach((member) => member.end()),
    };
    for (const [name, signature] of Object.entries(calls)) if (!Array.isArray(signature)) face[name] = this.#class(name, signature);
    return Object.freeze(face);
  }

  /**
   * @param {string} name
   * @param {any} signature
   */
  #class(name, signature) {
    const pool = this;
    const made = function (/** @type {unknown[]} */ ...args) {
      checkMaker(name, signature, new.target !== undefined);
      return pool.#make(name, { kind: "new", name, args });
    };
    Object.defineProperty(made, "name", { value: name });
    for (const key of Object.keys(signature.static)) {
      const makes = signature.makes?.[key];
      /** @type {any} */ (made)[key] = (/** @type {unknown[]} */ ...args) =>
        makes ? this.#make(makes, { kind: "static", name, key, args }) : this.#ask({ kind: "static", name, key, args });
    }
    return made;
  }

  /**
   * An object that all workers make, at once and without waiting: what is asked of it comes after.
   *
   * @param {string} name of its class
   * @param {Task} task
   * @param {[number, number][]} [bands] of rows, one for each worker, if each makes its part
   */
  #make(name, task, bands) {
    const kept = this.#next++;
    const call = this.#read(task);
    const { progress } = call;
    const isSolve = SOLVES.has(task.key ?? "") && "fromBytes" in /** @type {any} */ (calls)[name].static;
    const made = isSolve
      ? this.#solve(name, { ...call.task, keep: kept }, progress)
      : this.members.map((member, k) =>
          member.run({ ...call.task, keep: kept, args: withRows(call.task.args, bands?.[k]) }, k === 0 ? progress : undefined),
        );
    const ready = call.untilAborted(Promise.all(made).then(() => undefined));
    // Who does not look at `ready` hears of it from the first thing asked.
    ready.catch(() => undefined);
    return this.#object({ pool: this, kept, name, bands }, ready);
  }

  /**
   * The first worker solves, and the others get its map: none of them takes up what it is asked later before.
   *
   * @param {string} name of the class
   * @param {Task & { keep: number }} task
   * @param {(stage: string, fraction: number) => void} [progress]
   */
  #solve(name, task, progress) {
    const [first, ...others] = this.members;
    const solved = first.run(task, progress);
    if (others.length === 0) return [solved];
    const bytes = first.run({ kind: "method", name, key: "toBytes", self: task.keep, args: [] });
    return [solved, ...others.map((member) => member.receive(name, task.keep, bytes))];
  }

  /**
   * @param {Handle} handle
   * @param {Promise<void>} ready
   */
  #object(handle, ready) {
    const signature = /** @type {any} */ (calls)[handle.name];
    const free = () => this.members.forEach((member) => member.free(handle.kept));
    const isMethod = (/** @type {string} */ key) => Object.hasOwn(signature.methods, key) && key !== "paint";
    const object = new Proxy(Object.create(null), {
      get: (_, key) => {
        // A promise that gives this object must not take it for one.
        if (key === "then") return undefined;
        if (key === "ready") return ready;
        if (key === "free" || key === Symbol.dispose) return free;
        if (typeof key !== "string") return undefined;
        const { kept: self, name } = handle;
        // What looks at any object, as consoles do, asks for nothing.
        if (!isMethod(key) && !signature.properties.includes(key)) return undefined;
        if (handle.bands && (key === "size" || key === "bytes")) return ready.then(() => this.#whole(key, handle));
        if (!isMethod(key)) return ready.then(() => this.#ask({ kind: "get", name, key, self, args: [] }));
        return (/** @type {unknown[]} */ ...args) => this.#call(handle, ready, signature, key, args);
      },
    });
    handles.set(object, handle);
    return object;
  }

  /**
   * @param {Handle} handle
   * @param {Promise<void>} ready
   * @param {any} signature
   * @param {string} key
   * @param {unknown[]} args
   */
  #call(handle, ready, signature, key, args) {
    const { kept: self, name } = handle;
    /** @type {Task} */
    const task = { kind: "method", name, key, self, args };
    const view = viewOf(args);
    const makes = signature.makes?.[key];
    if (makes) return this.#make(makes, task, view && key.startsWith("prepare") ? this.#bands(view) : undefined);
    const isDrawn = key.startsWith("warp") || key === "overlay";
    return ready.then(() => {
      if (isDrawn && handle.bands) return this.#gather(task, handle.bands, args[1]);
      if (isDrawn && view) return this.#gather(task, this.#bands(view), /** @type {any} */ (args.at(-1)).out);
      const points = args.length === 1 && args[0] instanceof Float64Array ? args[0] : undefined;
      if (key === "prepare") return this.#prepare(task);
      return points && points.length >= 2 * PART ? this.#divide(task, points) : this.#ask(task);
    });
  }

  /**
   * @param {any} view options of a drawing
   * @returns {[number, number][]} a band of rows for each worker
   */
  #bands({ view, rows }) {
    const [first, end] = rows ?? [0, view.pixels[1]];
    const edge = (/** @type {number} */ k) => first + Math.round(((end - first) * k) / this.members.length);
    return this.members.map((_, k) => [edge(k), edge(k + 1)]);
  }

  /**
   * The size of a picture that is prepared in bands, or the memory of all of them.
   *
   * @param {"size" | "bytes"} key
   * @param {Handle} handle
   */
  async #whole(key, { kept: self, name, bands = [] }) {
    const parts = await Promise.all(this.members.map((member) => member.run({ kind: "get", name, key, self, args: [] })));
    if (key === "bytes") return parts.reduce((sum, bytes) => sum + bytes, 0);
    return [parts[0][0], bands[bands.length - 1][1] - bands[0][0]];
  }

  /**
   * Bands of rows, put together.
   *
   * @param {Task} task
   * @param {[number, number][]} bands
   * @param {any} out
   */
  async #gather(task, bands, out) {
    check("out", out ?? undefined, "a Uint8ClampedArray", (value) => Object.prototype.toString.call(value) === "[object Uint8ClampedArray]");
    const call = this.#read(task);
    const drawn = this.members.map((member, k) => {
      // An overlay is drawn over what is there.
      const under = out && task.key === "overlay" ? rowsOf(out, bands, k) : undefined;
      return member.run({ ...call.task, args: withRows(call.task.args, bands[k], out, under) });
    });
    const parts = await call.untilAborted(Promise.all(drawn));
    const length = lengthOf(parts);
    if (out && out.length !== length) {
      throw failure("wrong-length", `out must have ${length} numbers; it has ${out.length}.`);
    }
    return joined(parts, out ?? new Uint8ClampedArray(length));
  }

  /**
   * Many points in parts, put together.
   *
   * @param {Task} task
   * @param {Float64Array} points
   */
  async #divide(task, points) {
    const step = 2 * Math.ceil(points.length / 2 / this.members.length);
    const parts = await Promise.all(
      this.members.map((member, k) => member.run({ ...task, args: [points.slice(k * step, (k + 1) * step)] })),
    );
    return joined(parts, new parts[0].constructor(lengthOf(parts)));
  }

  /** Every worker prepares its own; the first tells how far it is. @param {Task} task */
  async #prepare(task) {
    const call = this.#read({ ...task, args: [{ onProgress: task.args[0] ?? undefined }] });
    await call.untilAborted(Promise.all(this.members.map((member, k) => member.run(call.task, k === 0 ? call.progress : undefined))));
  }

  /** One worker's answer; they take turns. @param {Task} task */
  async #ask(task) {
    const call = this.#read(task);
    return call.untilAborted(this.members[this.#next++ % this.members.length].run(call.task, call.progress));
  }

  /**
   * A call as workers take it: objects by their numbers, `signal` and `onProgress` apart.
   *
   * @param {Task} task
   */
  #read(task) {
    /** @type {AbortSignal | undefined} */
    let signal;
    /** @type {((stage: string, fraction: number) => unknown) | undefined} */
    let onProgress;
    const args = task.args.map((arg) => {
      const handle = typeof arg === "object" && arg !== null ? handles.get(arg) : undefined;
      if (handle && handle.pool !== this) {
        throw failure("invalid-argument", `${withArticle(handle.name, "A")} of another pool was given: its workers are not this pool's.`);
      }
      if (handle) return new Kept(handle.kept);
      if (Object.prototype.toString.call(arg) !== "[object Object]") return arg;
      const { signal: given, onProgress: told, ...rest } = /** @type {any} */ (arg);
      if (told !== undefined && "view" in rest) {
        throw failure("invalid-option", "There is no option \"onProgress\" of drawings; a signal aborts them.", { option: "onProgress" });
      }
      signal = given ?? signal;
      onProgress = told ?? onProgress;
      return rest;
    });
    check("signal", signal, "an AbortSignal", isSignal);
    check("onProgress", onProgress, "a function", (value) => typeof value === "function");
    signal?.throwIfAborted();
    // Where memory can be shared, a solve under way is told to stop; elsewhere its result is dropped.
    const cancel = typeof SharedArrayBuffer === "function" ? new Int32Array(new SharedArrayBuffer(4)) : undefined;
    const stop = () => cancel && Atomics.store(cancel, 0, 1);
    signal?.addEventListener("abort", stop, { once: true });
    /** @type {(thrown: unknown) => void} */
    let fail = () => undefined;
    const failed = new Promise((_, reject) => (fail = reject));
    failed.catch(() => undefined);
    const progress = onProgress && (async (/** @type {string} */ stage, /** @type {number} */ fraction) => {
      try {
        if ((await onProgress?.(stage, fraction)) === false) stop();
      } catch (thrown) {
        stop();
        fail(thrown);
      }
    });
    const cancels = signal !== undefined || onProgress !== undefined;
    return {
      task: { ...task, args, ...(cancels && { cancel, progress: progress !== undefined }) },
      progress,
      /** @template T @param {Promise<T>} work @returns {Promise<T>} */
      untilAborted(work) {
        const told = progress ? Promise.race([work, /** @type {Promise<any>} */ (failed)]) : work;
        if (!signal) return told;
        const aborted = signal;
        return new Promise((resolve, reject) => {
          const abort = () => reject(aborted.reason);
          aborted.addEventListener("abort", abort, { once: true });
          const rest = () => {
            aborted.removeEventListener("abort", abort);
            aborted.removeEventListener("abort", stop);
          };
          told.then(resolve, reject).finally(rest);
        });
      },
    };
  }
}

/** @param {any} value */
function isSignal(value) {
  return ["throwIfAborted", "addEventListener", "removeEventListener"].every((name) => typeof value[name] === "function");
}

/**
 * @param {string} option
 * @param {any} value
 * @param {string} expected
 * @param {(value: any) => boolean} fits
 */
function check(option, value, expected, fits) {
  if (value === undefined || (value !== null && fits(value))) return;
  throw failure("invalid-option", `The option "${option}" cannot be used: expected ${expected}, found ${describe(value)}.`, { option });
}

/**
 * The options of a drawing among the arguments of a call.
 *
 * @param {unknown[]} args
 * @returns {any}
 */
function viewOf(args) {
  const last = /** @type {any} */ (args.at(-1));
  const isView = Array.isArray(last?.view?.pixels) && Number.isInteger(last.view.pixels[1]);
  // What cannot be divided into rows is refused by the worker, in its words.
  const rows = last?.rows ?? [0, 0];
  return isView && Array.isArray(rows) && rows.length === 2 && rows.every(Number.isInteger) && !handles.has(last) ? last : undefined;
}

/**
 * The arguments with a band of rows in their options, and with the band of what is to be drawn over, if anything.
 *
 * @param {unknown[]} args
 * @param {[number, number]} [rows]
 * @param {unknown} [out]
 * @param {Uint8ClampedArray} [under]
 */
function withRows(args, rows, out, under) {
  if (!rows) return args;
  return args.flatMap((/** @type {any} */ arg) => {
    if (out !== undefined && arg === out) return [];
    return arg?.view?.pixels ? [{ ...arg, rows, out: under }] : [arg];
  });
}

/**
 * A copy of what a picture has in a band.
 *
 * @param {Uint8ClampedArray} picture of all bands
 * @param {[number, number][]} bands
 * @param {number} k
 */
function rowsOf(picture, bands, k) {
  const [first, end] = [bands[0][0], bands[bands.length - 1][1]];
  const [from, to] = bands[k].map((row) => ((row - first) / (end - first)) * picture.length);
  return picture.slice(from, to);
}

/** @param {ArrayLike<unknown>[]} parts */
const lengthOf = (parts) => parts.reduce((sum, part) => sum + part.length, 0);

/**
 * Parts one after the other, put into an array of their length.
 *
 * @param {any[]} parts
 * @param {any} whole
 */
function joined(parts, whole) {
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
