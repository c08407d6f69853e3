// Questions to one worker: of each asker the newest waits, the others are forgotten.

import { startWorker } from "./start-worker.js";

/** @typedef {import("./images.js").Picture} Picture */
/** @typedef {{ asker: string, question: any, resolve: (answer: any) => void, reject: (error: Error) => void }} Letter */

/** A worker that ends unexpectedly is tried again so often in a row. */
const TRIES = 3;

export class Courier {
  /** @type {Worker | null} */ #worker = null;
  /** @type {Letter | null} */ #out = null;
  /** @type {Letter[]} */ #waiting = [];
  /** @type {Map<string, Picture>} */ #pictures = new Map();
  /** Pictures that the worker has. @type {Set<string>} */ #handed = new Set();
  #failures = 0;
  #script;

  /** @param {URL} script of the worker */
  constructor(script) {
    this.#script = script;
  }

  /**
   * What the worker answers; null where a newer question of the same asker has taken its place.
   * @param {string} asker @param {any} question @returns {Promise<any>}
   */
  ask(asker, question) {
    return new Promise((resolve, reject) => {
      const older = this.#waiting.findIndex((letter) => letter.asker === asker);
      if (older >= 0) this.#waiting.splice(older, 1)[0].resolve(null);
      this.#waiting.push({ asker, question, resolve, reject });
      this.#next();
    });
  }

  /** A picture that questions name by its id. @param {Picture} picture */
  know(picture) {
    this.#pictures.set(picture.id, picture);
  }

  #start() {
    this.#handed.clear();
    return startWorker(this.#script, (data) => this.#receive(data), (why) => this.#fail(why));
  }

  #next() {
    if (this.#out) return;
    this.#out = this.#waiting.shift() ?? null;
    if (!this.#out) return;
    this.#worker ??= this.#start();
    const { question } = this.#out;
    const picture = this.#pictures.get(question.picture);
    if (picture && !this.#handed.has(picture.id)) {
      this.#worker.postMessage({ picture: { id: picture.id, pixels: picture.pixels, frame: picture.frame } });
      this.#handed.add(picture.id);
    }
    this.#worker.postMessage({ question });
  }

  /** @param {{ answer: any } | { refusal: string } | { broken: string }} reply */
  #receive(reply) {
    if ("broken" in reply) return this.#fail(reply.broken);
    const letter = this.#out;
    this.#out = null;
    this.#failures = 0;
    if ("answer" in reply) letter?.resolve(reply.answer);
    else letter?.reject(new Error(reply.refusal));
    this.#next();
  }

  /** The worker is of no use: another one takes over, some times. @param {string} why */
  #fail(why) {
    this.#worker?.terminate();
    this.#worker = null;
    const letter = this.#out;
    this.#out = null;
    if (letter && ++this.#failures < TRIES) this.#waiting.unshift(letter);
    else letter?.reject(new Error(`It could not be computed: ${why}. Reload the page to try again.`));
    this.#next();
  }
}
