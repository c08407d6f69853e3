// How finely the pictures of a moving eye are drawn: as finely as the machine keeps up with.

/** Pixels along a side, beside those of a draft at its best. */
const SHARES = [1, 0.8, 0.64];
/** A draft may take so long for thirty of them a second to be seen, in milliseconds. */
const MOST = 20;
/** Where it takes less than this share of that, a finer one does not take too long. */
const EASY = 0.4;
/** So many drafts tell. */
const TOLD = 4;

export class Pace {
  #level = 0;
  /** @type {number[]} */ #times = [];

  /** Of a draft's pixels along a side. */
  get share() {
    return SHARES[this.#level];
  }

  /** @param {number} ms that a draft has taken */
  took(ms) {
    this.#times.push(ms);
    if (this.#times.length < TOLD) return;
    // Not the mean: one of them may have made a new map.
    const usual = this.#times.sort((a, b) => a - b)[TOLD >> 1];
    this.#times = [];
    if (usual > MOST) this.#level = Math.min(this.#level + 1, SHARES.length - 1);
    else if (usual < EASY * MOST) this.#level = Math.max(this.#level - 1, 0);
  }
}
