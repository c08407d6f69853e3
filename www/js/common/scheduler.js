// Which jobs run, and when: a coarse one for every step of a drag, a fine one as soon as the hand rests. What the page is at.

import { Lane } from "./lane.js";

/** @typedef {import("./images.js").Picture} Picture */
/** @typedef {import("./serve.js").Failure} Failure */
/** @typedef {import("./serve.js").Versioned} Versioned */
/** What a scheduler adds to a job: which state it is for, and whether it is the best that will be made of it. @typedef {Versioned & { fine: boolean }} Scheduled */
/** How carefully a job is done. @typedef {{ tolerance: number, maxErrorPixels: number, sharpness: number }} Care */
/**
 * loading: nothing was drawn yet; working: the picture is of an older state; draft: it is coarse; ready; invalid: this state
 * cannot be drawn; failed: the workers do not start.
 * @typedef {"loading" | "working" | "draft" | "ready" | "invalid" | "failed"} State
 */
/**
 * @template R
 * @typedef {object} Listener
 * @property {(result: R, done: boolean) => void} onResult `done`: nothing better will come
 * @property {(state: State, words?: string) => void} onState without words, those that were said still hold
 * @property {(progress: number | "begun" | null) => void} onProgress the share that is done; null when nothing is under way
 * @property {(failure: Failure, shown: "draft" | "older" | "nothing") => string} failureWords
 */

/** @type {Care} */
const DRAFT = { tolerance: 1e-3, maxErrorPixels: 2, sharpness: 0.5 };
/** @type {Care} */
const FINE = { tolerance: 1e-8, maxErrorPixels: 0.35, sharpness: 1 };

/** How carefully a picture is drawn that is saved: triangles need not be finer than on the largest screen. @param {import("./frame.js").Point} pixels @returns {Omit<Care, "sharpness">} */
export const careFor = (pixels) => ({ tolerance: FINE.tolerance, maxErrorPixels: FINE.maxErrorPixels * Math.max(1, Math.max(...pixels) / SCREEN) });

/** Pixels of a large screen. */
const SCREEN = 2560;

/** A hand that has not moved for this long rests, in milliseconds. */
const REST = 200;
/** Progress is shown of what takes longer than this, in milliseconds. */
const WORTH_SHOWING = 150;
/** A draft is worth waiting for while the hand moves on; a fine picture of the past is not. In milliseconds. */
const DRAFT_PATIENCE = 4000;
const FINE_PATIENCE = 400;
/** One worker that does both keeps what it has found out: it is not replaced soon. */
const ONLY_PATIENCE = 5000;

/** @template {Scheduled} J a job @template {Versioned} R its result */
export class Scheduler {
  /** @type {State} */ #state = "loading";
  #listener;
  /** @type {Lane<J, R>} */ #draft;
  /** @type {Lane<J, R>} */ #fine;
  /** Counts the states of the page; answers to older ones are dropped once there is a newer one. */
  #version = 0;
  /** The newest answer. */
  #seen = { version: 0, fine: false };
  /** The newest state of which there is no picture. */
  #refused = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */ #rest;
  /** @type {ReturnType<typeof setTimeout> | undefined} */ #slow;
  #started = 0;
  /** Whether drafts are all that is wanted. */
  #following = false;

  /** @param {URL} script of the workers @param {Listener<R>} listener @param {1 | 2} [workers] one for drafts and one for fine pictures, or one for both */
  constructor(script, listener, workers = 2) {
    this.#listener = listener;
    /** @param {number} patience @returns {Lane<J, R>} */
    const lane = (patience) => new Lane(script, patience, (reply, job) => this.#receive(reply, job?.fine ?? false));
    this.#draft = lane(workers === 1 ? ONLY_PATIENCE : DRAFT_PATIENCE);
    this.#fine = workers === 1 ? this.#draft : lane(FINE_PATIENCE);
  }

  get state() {
    return this.#state;
  }

  /**
   * Computes a new state of the page.
   * @param {(care: Care) => Omit<J, keyof Scheduled>} job of this state @param {Picture} picture
   * @param {boolean} dragging whether more is to come
   */
  run(job, picture, dragging) {
    const version = ++this.#version;
    this.#following = false;
    this.#draft.setPicture(picture);
    this.#fine.setPicture(picture);
    clearTimeout(this.#rest);
    this.#fine.abandon();
    this.#watch();
    if (this.#state !== "loading") this.#enter("working");
    const fine = () => this.#fine.request(/** @type {J} */ ({ ...job(FINE), version, fine: true }));
    this.#draft.request(/** @type {J} */ ({ ...job(DRAFT), version, fine: false }));
    if (dragging) this.#rest = setTimeout(fine, REST);
    else fine();
  }

  /** Draws pictures that follow each other, each with a draft's care and none better: a camera's. @param {(care: Care) => Omit<J, keyof Scheduled>} job @param {Picture} picture */
  follow(job, picture) {
    this.#following = true;
    this.#fine.abandon();
    clearTimeout(this.#rest);
    this.#settle();
    this.#draft.setPicture(picture);
    this.#draft.request(/** @type {J} */ ({ ...job(DRAFT), version: ++this.#version, fine: false }));
  }

  /** Ends what is under way; the picture stays as it is. */
  stop() {
    clearTimeout(this.#rest);
    this.#draft.stop();
    this.#fine.stop();
    this.#settle();
    const drawn = this.#seen.version === this.#version;
    this.#enter(drawn ? "ready" : "invalid", drawn ? "Stopped: this picture is a coarse one." : "Stopped: the picture is an older one.");
  }

  /** What the worker that draws drafts says about its last result. @param {unknown} question @returns {Promise<any>} */
  ask(question) {
    return this.#draft.ask(question);
  }

  /** @param {State} state @param {string} [words] none: what was said still holds */
  #enter(state, words) {
    this.#state = state;
    this.#listener.onState(state, words);
  }

  /** @param {import("./serve.js").Reply<R>} reply @param {boolean} fine */
  #receive(reply, fine) {
    if ("broken" in reply) this.#broken(reply.broken);
    else if ("progress" in reply) this.#progress(reply.progress, fine);
    else if ("failure" in reply) this.#failed(reply.failure, fine);
    else if ("partial" in reply) this.#show(reply.partial, fine, false);
    else if ("result" in reply) this.#show(reply.result, fine, fine || this.#following);
  }

  /** @param {string} why */
  #broken(why) {
    this.#settle();
    this.#enter("failed", `The page’s workers could not be started: ${why}. What you drew is kept; they are tried again, now and with your next change.`);
  }

  /** @param {Failure} failure @param {boolean} fine */
  #failed(failure, fine) {
    const current = this.#seen.version === this.#version;
    if (failure.version !== this.#version || (current && (this.#seen.fine || !fine))) return;
    if (fine) this.#settle();
    if (!current) this.#refused = failure.version;
    const words = this.#listener.failureWords(failure, current ? "draft" : this.#seen.version ? "older" : "nothing");
    this.#enter(current ? "ready" : "invalid", words);
  }

  /** @param {R} result @param {boolean} fine @param {boolean} last */
  #show(result, fine, last) {
    const { version } = result;
    if (version < this.#seen.version || (version === this.#seen.version && this.#seen.fine && !fine)) return;
    this.#seen = { version, fine };
    const done = last && version === this.#version;
    if (done) this.#settle();
    this.#listener.onResult(result, done);
    // A picture of an earlier state may come after the newest one was refused: why it was is still to be read.
    if (version === this.#version || this.#refused !== this.#version) this.#enter(done ? "ready" : "draft", "");
  }

  /** Says that something is under way, once it takes long. */
  #watch() {
    this.#started = performance.now();
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
