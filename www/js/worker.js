// A pipeline in a worker: pictures and jobs come in; results, progress and errors go out.

import { Pipeline } from "./pipeline.js";

/** @typedef {import("./pipeline.js").Job} Job */
/** @typedef {import("./pipeline.js").Result} Result */
/** @typedef {{ pixels: Uint8ClampedArray, frame: import("./frame.js").Frame }} PictureMessage */
/** @typedef {{ picture: PictureMessage } | { job: Job }} Request */
/** @typedef {{ version: number, code: string, message: string }} Failure */
/**
 * @typedef {{ result: Result } | { failure: Failure } | { progress: { version: number, fraction: number } }
 *   | { broken: string }} Reply `broken`: WebAssembly did not start
 */

const pipeline = new Pipeline();

/** @param {Reply} reply @param {Transferable[]} [transfer] */
const post = (reply, transfer = []) => self.postMessage(reply, { transfer });

const ready = Pipeline.ready().catch((error) => post({ broken: String(error?.message ?? error) }));

self.onmessage = async (/** @type {MessageEvent<Request>} */ { data }) => {
  await ready;
  if ("picture" in data) return pipeline.setPicture(data.picture.pixels, data.picture.frame);
  const { job } = data;
  try {
    const result = pipeline.run(job, (_, fraction) => post({ progress: { version: job.version, fraction } }));
    const { mesh } = result;
    post({ result }, [result.pixels, mesh.source, mesh.target, mesh.triangles].map((array) => array.buffer));
  } catch (error) {
    post({ failure: describe(job.version, error) });
  }
};

/** @param {number} version @param {unknown} error @returns {Failure} */
function describe(version, error) {
  // A trapped instance of WebAssembly is in no state to be used again: the page starts another worker.
  if (error instanceof WebAssembly.RuntimeError) return { version, code: "crashed", message: error.message };
  const { code = "failed", message = String(error) } = /** @type {{ code?: string, message?: string }} */ (error);
  return { version, code, message };
}
