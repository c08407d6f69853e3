// Which jobs run, and when: a coarse one for every step of a drag, a fine one as soon as the hand rests.

import { Lane } from "../common/lane.js";
import { flatten } from "../common/frame.js";
import { Locator } from "./locate.js";
import { meshEdges } from "./overlay.js";
import { pulledBackGrid } from "./polar.js";
import { towardPoint } from "./region.js";

/** @typedef {import("./pipeline.js").Job} Job */
/** @typedef {import("./pipeline.js").Result} Result */
/** @typedef {import("../common/serve.js").Failure} Failure */
/** @typedef {import("./disk-view.js").DiskView} DiskView */
/** What a result gives to draw with. @typedef {{ result: Result, edges: Uint32Array, grid: import("../common/frame.js").Point[][], locator: Locator }} Outcome */
/** @typedef {"loading" | "working" | "draft" | "ready" | "invalid" | "failed"} State */
/**
 * @typedef {object} Listener
 * @property {(outcome: Outcome, state: State) => void} onOutcome
 * @property {(failure: Failure) => void} onFailure
 * @property {(progress: number | "begun" | null) => void} onProgress the share that is done; null when nothing is under way
 * @property {(message: string) => void} onBroken
 */

const WORKER = new URL("./worker.js", import.meta.url);

const DRAFT = { tolerance: 1e-3, maxErrorPixels: 2, sharpness: 0.5 };
const FINE = { tolerance: 1e-8, maxErrorPixels: 0.35, sharpness: 1 };

/** A hand that has not moved for this long rests, in milliseconds. */
const REST = 200;
/** Progress is shown of what takes longer than this, in milliseconds. */
const WORTH_SHOWING = 150;
/** A draft is worth waiting for while the hand moves on; a fine picture of the past is not. In milliseconds. */
const DRAFT_PATIENCE = 4000;
const FINE_PATIENCE = 400;

export class Solver {
  #disk;
  #listener;
  /** @type {Lane<Job, Result>} */ #draft;
  /** @type {Lane<Job, Result>} */ #fine;
  /** Counts the states of the page; answers to older ones are dropped. */
  #version = 0;
  /** The version and fineness of what is shown. */
  #seen = { version: 0, fine: false };
  /** @type {ReturnType<typeof setTimeout> | undefined} */ #rest;
  /** @type {ReturnType<typeof setTimeout> | undefined} */ #slow;
  #started = 0;

  /** @param {DiskView} disk @param {Listener} listener */
  constructor(disk, listener) {
    this.#disk = disk;
    this.#listener = listener;
    this.#draft = new Lane(WORKER, DRAFT_PATIENCE, (answer) => this.#receive(answer, false));
    this.#fine = new Lane(WORKER, FINE_PATIENCE, (answer) => this.#receive(answer, true));
  }

  /**
   * Computes a state of the page.
   * @param {import("./store.js").Document} doc @param {import("../common/images.js").Picture} picture
   * @param {boolean} dragging whether more is to come
   */
  solve(doc, picture, dragging) {
    const version = ++this.#version;
    const { boundary, center } = doc.region;
    const fields = { version, boundary: flatten(boundary), center, toward: towardPoint(doc.region) };
    this.#draft.setPicture(picture);
    this.#fine.setPicture(picture);
    clearTimeout(this.#rest);
    this.#fine.abandon();
    this.#watch();
    this.#started = performance.now();
    const fine = () => this.#fine.request({ ...fields, ...FINE, view: this.#disk.view(FINE.sharpness) });
    this.#draft.request({ ...fields, ...DRAFT, view: this.#disk.view(DRAFT.sharpness) });
    if (dragging) this.#rest = setTimeout(fine, REST);
    else fine();
  }

  /** @param {import("../common/serve.js").Reply<Result>} answer @param {boolean} fine */
  #receive(answer, fine) {
    if ("broken" in answer) return this.#listener.onBroken(answer.broken);
    if ("progress" in answer) return this.#progress(answer.progress, fine);
    if ("failure" in answer) {
      if (answer.failure.version !== this.#version) return;
      this.#settle();
      return this.#listener.onFailure(answer.failure);
    }
    const { version } = answer.result;
    const seen = this.#seen;
    if (version < seen.version || (version === seen.version && seen.fine)) return;
    this.#seen = { version, fine };
    const { mesh } = answer.result;
    const locator = new Locator(mesh);
    const outcome = { result: answer.result, edges: meshEdges(mesh.triangles), grid: pulledBackGrid(locator), locator };
    const done = fine && version === this.#version;
    if (done) this.#settle();
    this.#listener.onOutcome(outcome, done ? "ready" : "draft");
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

  /** @param {{ version: number, fraction: number }} progress @param {boolean} fine */
  #progress({ version, fraction }, fine) {
    if (!fine || version !== this.#version || performance.now() - this.#started < WORTH_SHOWING) return;
    this.#listener.onProgress(fraction);
  }
}
