// The worker of the lessons: pictures and questions come in, answers go out.

import init from "../../pkg/index.js";
import { answer, know } from "./answers.js";

const ready = init().then(
  () => true,
  (error) => self.postMessage({ broken: String(error?.message ?? error) }),
);

self.onmessage = async (/** @type {MessageEvent<{ picture: import("./answers.js").Known } | { question: import("./answers.js").Question }>} */ { data }) => {
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
