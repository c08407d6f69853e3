// What every page does with its elements.

import { loadPicture, standIn } from "./images.js";

/** @typedef {import("./images.js").Picture} Picture */
/** @typedef {import("./scheduler.js").State} State */

/** @template {HTMLElement | SVGSVGElement} E @param {string} id @returns {E} */
export const element = (id) => /** @type {E} */ (/** @type {unknown} */ (document.getElementById(id)));

/** How a page shows what it is at: its state for style and tests, words over the picture that is kept, progress. */
export const statusOfPage = {
  /** @param {State} state @param {string} [words] none: those that are shown still hold */
  onState(state, words) {
    document.body.dataset.state = state;
    if (words !== undefined && element("notice").textContent !== words) element("notice").textContent = words;
  },

  /** @param {number | "begun" | null} progress the share that is done; null when nothing is under way */
  onProgress(progress) {
    const bar = /** @type {HTMLProgressElement} */ (element("progress"));
    /** @type {HTMLElement} */ (element("busy")).hidden = progress === null;
    if (typeof progress === "number" && progress < 1) bar.value = progress;
    else bar.removeAttribute("value");
  },
};

/** @param {boolean} on @param {string} id of a button that can be on */
export const press = (id, on) => element(id).setAttribute("aria-pressed", String(on));

/** Says what went wrong beside the picture, which stays as good as it was; "" for nothing. @param {string} words */
export function remark(words) {
  say(words, false);
}

/** Says what was done. @param {string} words */
export function tell(words) {
  say(words, true);
  clearTimeout(fading);
  fading = setTimeout(() => element("remark").classList.contains("well") && say("", true), TOLD);
}

/** What was done is said for so long, in milliseconds. */
const TOLD = 10_000;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let fading;

/** @param {string} words @param {boolean} well */
function say(words, well) {
  const place = /** @type {HTMLElement} */ (element("remark"));
  place.hidden = words === "";
  place.classList.toggle("well", well);
  const text = place.querySelector("p");
  if (text) text.textContent = words;
}

/** @param {unknown} error */
export const wordsOf = (error) => (error instanceof Error ? error.message : String(error));

/**
 * Waits for what a visitor asked for. Where that fails the page stays as it was, and says why.
 * @template T @param {Promise<T>} work @param {(value: T) => void} use
 */
export async function attempt(work, use) {
  try {
    const value = await work;
    remark("");
    use(value);
  } catch (error) {
    remark(wordsOf(error));
  }
}

/** A picture by id; where it cannot be had the page says so, and something stands in for it. @param {string} id */
export function pictureFor(id) {
  return awaited(
    loadPicture(id).catch((error) => {
      remark(wordsOf(error));
      return standIn(id);
    }),
  );
}

/** The picture that is wanted; null where another one is by the time it is there, as that is followed too. @param {() => string} wanted its id */
export async function wantedPicture(wanted) {
  const id = wanted();
  const found = await pictureFor(id);
  return wanted() === id ? found : null;
}

/** For pictures of one place: of several that are asked for the last one is shown, however long the others take. */
export class PhotoOpener {
  #asked = 0;

  /** Waits for a picture that a visitor asked for, as attempt does. @param {Promise<Picture>} loading @param {(picture: Picture) => void} use */
  open(loading, use) {
    const mine = ++this.#asked;
    return attempt(awaited(loading), (picture) => mine === this.#asked && use(picture));
  }
}

let waiting = 0;

/** Says by the page's element that something is waited for: to those who see, those who hear, and tests. @template T @param {Promise<T>} work @returns {Promise<T>} */
async function awaited(work) {
  document.body.ariaBusy = String(++waiting > 0);
  try {
    return await work;
  } finally {
    document.body.ariaBusy = String(--waiting > 0);
  }
}

/** Puts the place for remarks on the page, and makes sure that no error is silent. */
export function watchErrors() {
  const place = Object.assign(document.createElement("div"), { id: "remark", className: "remark", hidden: true });
  place.setAttribute("role", "alert");
  const dismiss = Object.assign(document.createElement("button"), { type: "button", textContent: "Dismiss", onclick: () => remark("") });
  place.append(document.createElement("p"), dismiss);
  document.body.append(place);
  /** @param {unknown} reason */
  const complain = (reason) => remark(`Something on this page went wrong: ${wordsOf(reason)}. What you see is kept; reload the page if it does not answer.`);
  window.addEventListener("error", ({ error, message }) => complain(error ?? message));
  window.addEventListener("unhandledrejection", ({ reason }) => complain(reason));
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
