// The workers behind a pool: starting them, and asking each for things, in order.

import { failure } from "./failure.js";
import { builtin } from "./source.js";

/**
 * What a worker is asked. Objects stay with the workers, under numbers.
 *
 * @typedef {{ kind: "new" | "static" | "method" | "get", name: string, key?: string, self?: number, args: unknown[], keep?: number,
 *   cancel?: Int32Array, progress?: boolean }} Task
 */

/**
 * @typedef {{ post(message: unknown): void, listen(heard: (message: any) => void, failed: (error: any) => void): void, end(): void }} Line
 */

/**
 * A browser's worker or Node's, behind one face.
 *
 * @param {any} worker
 * @returns {Line}
 */
function lineTo(worker) {
  if (typeof worker.on === "function") {
    // A pool that nobody waits for lets the process end.
    worker.unref?.();
    return {
      post: (message) => worker.postMessage(message),
      listen: (heard, failed) => ["message", "error", "exit"].forEach((event) => worker.on(event, event === "message" ? heard : failed)),
      end: () => worker.terminate(),
    };
  }
  return {
    post: (message) => worker.postMessage(message),
    listen(heard, failed) {
      worker.addEventListener("message", (/** @type {any} */ event) => heard(event.data));
      worker.addEventListener("error", failed);
    },
    end: () => worker.terminate(),
  };
}

/**
 * A worker of the caller's own, as far as that can be seen.
 *
 * @param {any} worker
 */
export function checkWorker(worker) {
  const has = (/** @type {string} */ name) => typeof worker?.[name] === "function";
  if (has("postMessage") && has("terminate") && (has("on") || has("addEventListener"))) return worker;
  const message = 'The option "worker" cannot be used: expected a function that gives a Worker; what it gave is none.';
  throw failure("invalid-option", message, { option: "worker" });
}

/** An object that the workers have. */
export class Kept {
  /** @param {number} number under which they have it */
  constructor(number) {
    this.number = number;
  }
}

/** One worker, which answers in the order in which it is asked. */
export class Member {
  /** @type {Map<number, { resolve(value: unknown): void, reject(error: unknown): void, progress?(stage: string, fraction: number): void }>} */
  #waiting = new Map();
  #next = 0;
  #line;
  /** Why it answers no more, if so. @type {Error | undefined} */
  #gone;

  /**
   * @param {any} worker
   * @param {WebAssembly.Module} module
   */
  constructor(worker, module) {
    this.#line = lineTo(worker);
    this.#line.listen((message) => this.#hear(message), (error) => this.#fail(error));
    this.ready = this.#ask({ module });
  }

  /**
   * @param {Task} task
   * @param {(stage: string, fraction: number) => void} [progress]
   * @returns {Promise<any>}
   */
  run(task, progress) {
    const args = task.args.map((arg) => (arg instanceof Kept ? { kept: arg.number } : { value: arg }));
    return this.#ask({ task: { ...task, args } }, progress);
  }

  /**
   * Makes an object from its bytes as soon as they are there, and nothing else before.
   *
   * @param {string} name of its class
   * @param {number} kept
   * @param {Promise<Uint8Array>} bytes
   */
  receive(name, kept, bytes) {
    const received = this.#ask({ awaits: kept, task: { kind: "static", name, key: "fromBytes", args: [], keep: kept } });
    const give = (/** @type {Uint8Array | undefined} */ value) => this.#gone || this.#line.post({ gives: kept, value });
    bytes.then(give, () => give(undefined));
    return received;
  }

  /** @param {number} kept */
  free(kept) {
    if (!this.#gone) this.#line.post({ free: kept });
  }

  end() {
    this.#fail(failure("pool-closed", "The pool was closed before this was done."));
    this.#line.end();
  }

  /**
   * @param {object} message
   * @param {(stage: string, fraction: number) => void} [progress]
   */
  #ask(message, progress) {
    if (this.#gone) return Promise.reject(this.#gone);
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject, progress });
      try {
        this.#line.post({ id, ...message });
      } catch (/** @type {any} */ error) {
        this.#waiting.delete(id);
        reject(failure("invalid-argument", `A pool's workers cannot be sent this: ${withoutStop(error.message)}.`, { cause: error }));
      }
    });
  }

  /** @param {any} message */
  #hear({ id, value, error, progress }) {
    const asked = this.#waiting.get(id);
    if (!asked) return;
    if (progress) return asked.progress?.(progress[0], progress[1]);
    this.#waiting.delete(id);
    if (error) asked.reject(Object.assign(new Error(error.message), error));
    else asked.resolve(value);
  }

  /** @param {any} cause */
  #fail(cause) {
    const why = cause?.message ? `: ${withoutStop(cause.message)}` : "";
    const message = `A worker of the pool could not be started or has stopped${why}. Where a bundler does not take conformal-warp/pool's worker along, give createPool() one: { worker: () => new Worker(…) }.`;
    const error = cause?.code === "pool-closed" ? cause : failure("pool-failed", message, { cause });
    this.#gone ??= error;
    for (const { reject } of this.#waiting.values()) reject(error);
    this.#waiting.clear();
  }
}

/** A sentence that another one goes on after. @param {string} message */
const withoutStop = (message) => message.replace(/\.$/, "");

/** How many workers this machine has use for. */
export function usualCount() {
  const cores = typeof navigator === "object" && navigator.hardwareConcurrency;
  return Math.max(1, Math.min(cores || (builtin("node:os")?.availableParallelism?.() ?? 4), 8));
}
