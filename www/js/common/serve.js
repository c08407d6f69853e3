// The worker's end of a lane: pictures and jobs come in; results, progress and errors go out.

import init from "../../pkg/index.js";

/** @typedef {import("./frame.js").Frame} Frame */
/** Anything that belongs to one state of the page. @typedef {{ version: number }} Versioned */
/** `file` holds the picture larger than `pixels`. @typedef {{ pixels: Uint8ClampedArray, frame: Frame, file?: Blob }} PictureMessage */
/** @typedef {Versioned & { code: string, message: string, position?: number }} Failure */
/** @typedef {(stage: string, fraction: number) => void} Progress */
/**
 * @template R
 * @typedef {{ result: R } | { failure: Failure } | { progress: Versioned & { fraction: number } } | { broken: string }} Reply
 * `broken`: WebAssembly did not start
 */
/** @template R @typedef {{ result: R, transfer: ArrayBufferLike[] }} Done */
/**
 * What does the work: `run` gives a result, and the buffers in it that may be handed over instead of copied.
 * @template {Versioned} J @template {Versioned} R
 * @typedef {object} Pipeline
 * @property {(pixels: Uint8ClampedArray, frame: Frame, file?: Blob) => void} setPicture
 * @property {(job: J, onProgress: Progress) => Done<R> | Promise<Done<R>>} run
 */

/** Answers this worker's messages by a pipeline. @template {Versioned} J @template {Versioned} R @param {Pipeline<J, R>} pipeline */
export function serveJobs(pipeline) {
  /** @param {Reply<R>} reply @param {ArrayBufferLike[]} [transfer] */
  const post = (reply, transfer = []) => self.postMessage(reply, { transfer: /** @type {Transferable[]} */ (transfer) });
  const ready = init().catch((error) => post({ broken: String(error?.message ?? error) }));

  self.onmessage = async (/** @type {MessageEvent<{ picture: PictureMessage } | { job: J }>} */ { data }) => {
    await ready;
    if ("picture" in data) return pipeline.setPicture(data.picture.pixels, data.picture.frame, data.picture.file);
    const { version } = data.job;
    try {
      const { result, transfer } = await pipeline.run(data.job, (_, fraction) => post({ progress: { version, fraction } }));
      post({ result }, transfer);
    } catch (error) {
      post({ failure: describe(version, error) });
    }
  };
}

/** @param {number} version @param {unknown} error @returns {Failure} */
function describe(version, error) {
  // A trapped instance of WebAssembly is in no state to be used again: the page starts another worker.
  if (error instanceof WebAssembly.RuntimeError) return { version, code: "crashed", message: error.message };
  const { code = "failed", message = String(error), position } =
    /** @type {{ code?: string, message?: string, position?: number }} */ (error);
  return { version, code, message, position };
}
