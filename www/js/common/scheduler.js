// Which jobs run, and when: a coarse one for every step of a drag, a fine one as soon as the hand rests.

import { Lane } from "./lane.js";

/** @typedef {import("./images.js").Picture} Picture */
/** @typedef {import("./serve.js").Failure} Failure */
/** @typedef {import("./serve.js").Versioned} Versioned */
/** How carefully a job is done. @typedef {{ tolerance: number, maxErrorPixels: number, sharpness: number }} Care */
/** @typedef {"loading" | "working" | "draft" | "ready" | "invalid" | "failed"} State */
/**
 * @template R
 * @typedef {object} Listener
 * @property {(result: R, done: boolean) => void} onResult `done`: nothing better will come
 * @property {(failure: Failure) => void} onFailure
 * @property {(progress: number | "begun" | null) => void} onProgress the share that is done; null when nothing is under way
 * @property {(message: string) => void} onBroken
 */

/** @type {Care} */
const DRAFT = { tolerance: 1e-3, maxErrorPixels: 2, sharpness: 0.5 };
/** @type {Care} */
const FINE = { tolerance: 1e-8, maxErrorPixels: 0.35, sharpness: 1 };

/** A hand that has not moved for this long rests, in milliseconds. */
const REST = 200;
/** Progress is shown of what takes longer than this, in milliseconds. */
const WORTH_SHOWING = 150;
/** A draft is worth waiting for while the hand moves on; a fine picture of the past is not. In milliseconds. */
const DRAFT_PATIENCE = 4000;
const FINE_PATIENCE = 400;

/** @template {Versioned} J a job @template {Versioned} R its result */
export class Scheduler {
  #listener;
  /** @type {Lane<J, R>} */ #draft;
  /** @type {Lane<J, R>} */ #fine;
  /** Counts the states of the page; answers to older ones are dropped once there is a newer one. */
  #version = 0;
  /** The newest answer. */
  #seen = { version: 0, fine: false };
  /** @type {ReturnType<typeof setTimeout> | undefined} */ #rest;
  /** @type {ReturnType<typeof setTimeout> | undefined} */ #slow;
  #started = 0;

  /** @param {URL} script of the workers @param {Listener<R>} listener */
  constructor(script, listener) {
    this.#listener = listener;
    this.#draft = new Lane(script, DRAFT_PATIENCE, (answer) => this.#receive(answer, false));
    this.#fine = new Lane(script, FINE_PATIENCE, (answer) => this.#receive(answer, true));
  }

  /**
   * Computes a new state of the page.
   * @param {(care: Care) => Omit<J, "version">} job of this state @param {Picture} picture
   * @param {boolean} dragging whether more is to come
   */
  run(job, picture, dragging) {
    const version = ++this.#version;
    this.#draft.setPicture(picture);
    this.#fine.setPicture(picture);
    clearTimeout(this.#rest);
    this.#fine.abandon();
    this.#watch();
    this.#started = performance.now();
    /** @param {Care} care */
    const make = (care) => /** @type {J} */ ({ ...job(care), version });
    const fine = () => this.#fine.request(make(FINE));
    this.#draft.request(make(DRAFT));
    if (dragging) this.#rest = setTimeout(fine, REST);
    else fine();
  }

  /** @param {import("./serve.js").Reply<R>} answer @param {boolean} fine */
  #receive(answer, fine) {
    if ("broken" in answer) return this.#listener.onBroken(answer.broken);
    if ("progress" in answer) return this.#progress(answer.progress, fine);
    if ("failure" in answer) {
      if (answer.failure.version !== this.#version) return;
      this.#seen = { version: this.#version, fine: true };
      this.#settle();
      return this.#listener.onFailure(answer.failure);
    }
    const { version } = answer.result;
    if (version < this.#seen.version || (version === this.#seen.version && this.#seen.fine)) return;
    this.#seen = { version, fine };
    const done = fine && version === this.#version;
    if (done) this.#settle();
    this.#listener.onResult(answer.result, done);
  }

  /** Says that something is under way, once it takes long. */
  #watch() {
    clearTimeout(this.#slow);
    this.#slow = setTimeout(() => this.#listener.onProgress("begun"), WORTH_SHOWING);
  }

  #settle() {
    clearTimeout(this.#slow);
    this.#listener.onProgress(null);
  }

  /** @param {Versioned & { fraction: number }} progress @param {boolean} fine */
  #progress({ version, fraction }, fine) {
    if (!fine || version !== this.#version || performance.now() - this.#started < WORTH_SHOWING) return;
    this.#listener.onProgress(fraction);
  }
}
