// Files of what is seen: a worker of their own makes them, so that the page goes on; to cancel is to end it.

import { WORKER } from "./colours.js";

/** @typedef {import("./save-menu.js").Picture} Picture */
/** @typedef {import("./plate.js").Wanted} Wanted */
/** @typedef {import("./serve.js").Saved} Saved */

export class Saver {
  /** @type {Worker | null} */ #worker = null;
  /** @type {(() => void) | null} */ #giveUp = null;
  #script;

  /** @param {URL} script of the page's worker */
  constructor(script) {
    this.#script = script;
  }

  /** A file; null when it was cancelled. @param {object} job @param {Picture} picture @param {Wanted} wanted @param {(share: number) => void} onShare @returns {Promise<Blob | null>} */
  make(job, { pixels, frame, file }, wanted, onShare) {
    this.cancel();
    const worker = new Worker(this.#script, WORKER);
    this.#worker = worker;
    /** @type {Promise<Blob | null>} */
    const made = new Promise((resolve, reject) => {
      this.#giveUp = () => resolve(null);
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new Error("The file could not be made: its worker broke down, perhaps for want of memory. Try a smaller size."));
      };
      worker.onmessage = (/** @type {MessageEvent<Saved | { broken: string }>} */ { data }) => {
        if ("share" in data) onShare(data.share);
        else if ("file" in data) resolve(data.file);
        else if ("refusal" in data) reject(new Error(`The file could not be made: ${data.refusal}`));
        else reject(new Error(`The file could not be made: ${data.broken}`));
      };
      worker.postMessage({ save: { job, picture: { pixels, frame, file }, wanted } });
    });
    return made.finally(() => {
      worker.terminate();
      if (this.#worker === worker) this.#worker = null;
    });
  }

  /** Ends what is under way. */
  cancel() {
    this.#giveUp?.();
    this.#worker?.terminate();
    this.#worker = this.#giveUp = null;
  }
}

/** Hands a file to the visitor. @param {Blob} blob @param {string} name */
export function handOver(blob, name) {
  const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
