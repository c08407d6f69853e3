// The worker's end of a courier: pictures and questions come in, answers and refusals go out.

import init from "../../pkg/index.js";

/** @typedef {{ id: string, pixels: Uint8ClampedArray, frame: import("./frame.js").Frame }} Known a picture that questions name by its id */

/** Answers this worker's messages. @param {(question: any) => any} answer @param {(picture: Known) => void} [know] */
export function serveAnswers(answer, know = () => {}) {
  const ready = init().then(
    () => true,
    (error) => self.postMessage({ broken: String(error?.message ?? error) }),
  );
  self.onmessage = async (/** @type {MessageEvent<{ picture: Known } | { question: any }>} */ { data }) => {
    if (!(await ready)) return;
    if ("picture" in data) return know(data.picture);
    try {
      self.postMessage({ answer: answer(data.question) });
    } catch (error) {
      // A trapped instance of WebAssembly answers nothing any more.
      if (error instanceof WebAssembly.RuntimeError) self.postMessage({ broken: error.message });
      else self.postMessage({ refusal: error instanceof Error ? error.message : String(error) });
    }
  };
}
