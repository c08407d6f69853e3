// What every page does with its elements.

/** @typedef {import("./scheduler.js").State} State */

/** @template {HTMLElement | SVGSVGElement} E @param {string} id @returns {E} */
export const element = (id) => /** @type {E} */ (/** @type {unknown} */ (document.getElementById(id)));

/** The state of the page, for its style and its tests. @param {State} state */
export function mark(state) {
  document.body.dataset.state = state;
}

/** A message over the picture that is kept, and the state that goes with it. @param {string} words @param {State} state */
export function say(words, state) {
  mark(state);
  element("notice").textContent = words;
}

/** @param {number | "begun" | null} progress the share that is done; null when nothing is under way */
export function showProgress(progress) {
  const bar = /** @type {HTMLProgressElement} */ (element("progress"));
  bar.hidden = progress === null;
  if (typeof progress === "number" && progress < 1) bar.value = progress;
  else bar.removeAttribute("value");
}

/** @param {string} message why WebAssembly did not start */
export function sayBroken(message) {
  say(`The page’s WebAssembly module could not be started: ${message}`, "failed");
}

/** The rows of the evidence. @param {[name: string, value: string, meaning: string][]} rows */
export function showEvidence(rows) {
  element("evidence").replaceChildren(
    ...rows.map(([name, value, meaning]) => {
      const row = document.createElement("div");
      for (const [tag, text, kind] of [["dt", name, ""], ["dd", value, ""], ["dd", meaning, "meaning"]]) {
        row.append(Object.assign(document.createElement(tag), { textContent: text, className: kind }));
      }
      return row;
    }),
  );
}

/** Saves a canvas's picture as a file. @param {HTMLCanvasElement} canvas @param {string} name */
export function saveCanvas(canvas, name) {
  canvas.toBlob((blob) => {
    if (!blob) return;
    const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }, "image/png");
}
