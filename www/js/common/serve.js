// The worker's end of a lane: pictures, jobs and questions come in; results, progress and errors go out.

import { fileOf, inFull } from "./plate.js";

/** @typedef {import("./frame.js").Frame} Frame */
/** Anything that belongs to one state of the page. @typedef {{ version: number }} Versioned */
/** `file` holds the picture larger than `pixels`. @typedef {{ pixels: Uint8ClampedArray, frame: Frame, file?: Blob }} PictureMessage */
/** @typedef {Versioned & { code: string, message: string, position?: number }} Failure */
/** @typedef {(stage: string, fraction: number) => void} Progress */
/** @typedef {{ picture: PictureMessage } | { job: any } | { question: any, id: number } | { hurry: true } | { save: Order<any> }} Message */
/** A file that is wanted of a job's picture, once. @template J @typedef {{ job: J, picture: PictureMessage, wanted: import("./plate.js").Wanted }} Order */
/** @typedef {{ file: Blob } | { share: number } | { refusal: string }} Saved */
/**
 * @template R
 * @typedef {{ result: R } | { partial: R } | { failure: Failure } | { progress: Versioned & { fraction: number } } | { answer: any, id: number } | { broken: string }} Reply
 * `partial`: a better one will follow; `broken`: WebAssembly did not start
 */
/** @template R @typedef {{ result: R, transfer: ArrayBufferLike[] }} Done */
/**
 * How a pipeline speaks while it works.
 * @template R
 * @typedef {object} Talk
 * @property {Progress} progress
 * @property {(done: Done<R>) => void} show a result before the last one
 * @property {() => Promise<void>} pause lets messages in; throws when the page has moved on
 */
/**
 * What does the work: `run` gives a result, and the buffers in it that may be handed over instead of copied; `answer` says
 * what the page asks about the last one.
 * @template {Versioned} J @template {Versioned} R
 * @typedef {object} Pipeline
 * @property {(pixels: Uint8ClampedArray, frame: Frame, file?: Blob) => void} setPicture
 * @property {(job: J, talk: Talk<R>) => Done<R> | Promise<Done<R>>} run
 * @property {(question: any) => any} [answer]
 * @property {(job: any, onShare: (share: number) => void) => Promise<import("./plate.js").Plate>} [plate] what can be saved of a job, which then says more
 */

/** A job that nobody waits for any more. */
const SUPERSEDED = Object.assign(new Error("The page has moved on."), { code: "superseded" });

/**
 * Answers this worker's messages by a pipeline.
 * @template {Versioned} J @template {Versioned} R
 * @param {Pipeline<J, R>} pipeline
 * @param {() => Promise<unknown>} init loads the module that it uses
 */
export function serveJobs(pipeline, init) {
  /** @param {Reply<R>} reply @param {ArrayBufferLike[]} [transfer] */
  const post = (reply, transfer = []) => self.postMessage(reply, { transfer: /** @type {Transferable[]} */ (transfer) });
  const ready = init().then(
    () => true,
    (error) => post({ broken: String(error?.message ?? error) }),
  );
  let hurried = false;

  /** @param {J} job */
  const run = async (job) => {
    const { version } = job;
    hurried = false;
    try {
      const { result, transfer } = await pipeline.run(job, {
        progress: (_, fraction) => post({ progress: { version, fraction } }),
        show: (done) => post({ partial: done.result }, done.transfer),
        pause: async () => {
          await new Promise((resolve) => setTimeout(resolve));
          if (hurried) throw SUPERSEDED;
        },
      });
      post({ result }, transfer);
    } catch (error) {
      post({ failure: describe(version, error) });
    }
  };

  self.onmessage = async (/** @type {MessageEvent<Message>} */ { data }) => {
    if (!(await ready)) return;
    if ("hurry" in data) hurried = true;
    else if ("save" in data) await save(pipeline, data.save);
    else if ("picture" in data) pipeline.setPicture(data.picture.pixels, data.picture.frame, data.picture.file);
    else if ("question" in data) post({ answer: attempt(() => pipeline.answer?.(data.question)), id: data.id });
    else await run(data.job);
  };
}

/** The share of a file's time that goes into what must be known before it can be drawn. */
const PREPARING = 0.25;

/** Answers an order with a file. @template {Versioned} J @param {Pipeline<J, any>} pipeline @param {Order<J>} order */
async function save(pipeline, { job, picture, wanted }) {
  /** @param {Saved} reply */
  const post = (reply) => self.postMessage(reply);
  try {
    const { pixels, frame, file } = await inFull(picture);
    pipeline.setPicture(pixels, frame, file);
    const plate = await pipeline.plate?.(job, (share) => post({ share: PREPARING * share }));
    if (!plate) throw new Error("This page gives no such file.");
    post({ file: await fileOf(plate, wanted, (share) => post({ share: PREPARING + (1 - PREPARING) * share })) });
    plate.free();
  } catch (error) {
    post({ refusal: error instanceof Error ? error.message : String(error) });
  }
}

/** What a question is worth: an answer, or none. @template T @param {() => T} work @returns {T | null} */
function attempt(work) {
  try {
    return work();
  } catch {
    return null;
  }
}

/** @param {number} version @param {unknown} error @returns {Failure} */
function describe(version, error) {
  // A trapped instance of WebAssembly is in no state to be used again: the page starts another worker.
  if (error instanceof WebAssembly.RuntimeError) return { version, code: "crashed", message: error.message };
  const { code = "failed", message = String(error), position } =
    /** @type {{ code?: string, message?: string, position?: number }} */ (error);
  return { version, code, message, position };
}
