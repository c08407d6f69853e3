// Planes that the formula does not change: drawn once, however often a hand moves what it depends on.

/** @typedef {Uint8ClampedArray<ArrayBuffer>} Pixels */

/** A coarse picture, a draft and a fine one. */
const MOST = 3;

export class StillPlanes {
  /** By all that they depend on, the one used last at the end. @type {Map<string, Pixels>} */
  #kept = new Map();

  /** A copy of the plane that was drawn like this, if one was. @param {string} key @returns {Pixels | undefined} */
  copy(key) {
    const pixels = this.#kept.get(key);
    if (pixels) this.#last(key, pixels);
    return pixels?.slice();
  }

  /** Keeps a copy. @param {string} key @param {Pixels} pixels */
  keep(key, pixels) {
    this.#last(key, pixels.slice());
    if (this.#kept.size > MOST) this.#kept.delete(/** @type {string} */ (this.#kept.keys().next().value));
  }

  forget() {
    this.#kept.clear();
  }

  /** @param {string} key @param {Pixels} pixels */
  #last(key, pixels) {
    this.#kept.delete(key);
    this.#kept.set(key, pixels);
  }
}
