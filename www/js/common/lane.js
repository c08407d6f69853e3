// A worker as seen from the page: it works on one job at a time, and only the newest waits. One that fails is replaced.

import { startWorker } from "./start-worker.js";

/** @typedef {import("./images.js").Picture} Picture */
/** @typedef {import("./serve.js").Versioned} Versioned */
/** @template R @typedef {import("./serve.js").Reply<R>} Reply */

/** A worker that does not start is tried again after these times, in milliseconds, and then with the next job. */
const RETRIES = [300, 1500, 6000];

/** @template {Versioned} J a job @template {Versioned} R its result */
export class Lane {
  /** @type {Worker | null} */ #worker = null;
  /** @type {Picture | null} */ #picture = null;
  /** The picture that the worker has. @type {Picture | null} */ #handed = null;
  /** @type {J | null} */ #running = null;
  /** @type {J | null} */ #waiting = null;
  /** Replaces a worker that goes on for too long. @type {ReturnType<typeof setTimeout> | undefined} */ #timer;
  /** Starts again a worker that has failed. @type {ReturnType<typeof setTimeout> | undefined} */ #retry;
  #failures = 0;
  /** @type {Map<number, (answer: any) => void>} */ #questions = new Map();
  #asked = 0;
  #script;
  #patience;
  #onReply;

  /**
   * @param {URL} script of the worker, which calls `serveJobs`
   * @param {number} patience how long a job may go on that nobody waits for any more, in milliseconds; then its worker is replaced
   * @param {(reply: Reply<R>, job: J | null) => void} onReply
   */
  constructor(script, patience, onReply) {
    this.#script = script;
    this.#patience = patience;
    this.#onReply = onReply;
    this.#start();
  }

  /** The picture for the jobs that follow. @param {Picture} picture */
  setPicture(picture) {
    this.#picture = picture;
  }

  /** Runs the job next; one that was waiting is forgotten. @param {J} job */
  request(job) {
    this.#waiting = job;
    if (!this.#worker) {
      // Where another start is under way it takes the job.
      if (this.#retry === undefined) this.#restart();
    } else if (this.#running) this.#hurry();
    else this.#next();
  }

  /** Forgets the waiting job, and the running one unless it ends soon: the page has moved on. */
  abandon() {
    this.#waiting = null;
    if (this.#running) this.#hurry();
  }

  /** Ends what is under way at once. */
  stop() {
    this.#waiting = null;
    if (this.#running) this.#restart();
  }

  /** What the worker says about its last result; null where it says nothing. @param {unknown} question @returns {Promise<any>} */
  ask(question) {
    if (!this.#worker) return Promise.resolve(null);
    const id = ++this.#asked;
    this.#worker.postMessage({ question, id });
    return new Promise((resolve) => this.#questions.set(id, resolve));
  }

  #hurry() {
    this.#worker?.postMessage({ hurry: true });
    this.#timer ??= setTimeout(() => this.#restart(), this.#patience);
  }

  #start() {
    const worker = startWorker(this.#script, (data) => this.#receive(data), (why) => this.#fail(why));
    worker.onmessageerror = () => this.#fail("its answer could not be read");
    this.#worker = worker;
    this.#handed = null;
  }

  #end() {
    this.#worker?.terminate();
    this.#worker = null;
    clearTimeout(this.#timer);
    clearTimeout(this.#retry);
    this.#timer = this.#retry = undefined;
    for (const resolve of this.#questions.values()) resolve(null);
    this.#questions.clear();
  }

  #restart() {
    this.#end();
    this.#start();
    this.#next();
  }

  /** The worker is of no use: another one takes the job over, after a while. @param {string} broken why */
  #fail(broken) {
    this.#waiting ??= this.#running;
    this.#running = null;
    this.#end();
    const pause = RETRIES[this.#failures++];
    if (pause !== undefined) this.#retry = setTimeout(() => this.#restart(), pause);
    else this.#failures = RETRIES.length;
    this.#onReply({ broken }, null);
  }

  #next() {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    this.#running = this.#waiting;
    this.#waiting = null;
    if (!this.#running || !this.#worker || !this.#picture) return;
    if (this.#handed !== this.#picture) {
      const { pixels, frame, file } = this.#picture;
      this.#worker.postMessage({ picture: { pixels, frame, file } });
      this.#handed = this.#picture;
    }
    this.#worker.postMessage({ job: this.#running });
  }

  /** @param {Reply<R>} reply */
  #receive(reply) {
    if ("broken" in reply) return this.#fail(reply.broken);
    if ("answer" in reply) {
      this.#questions.get(reply.id)?.(reply.answer);
      this.#questions.delete(reply.id);
      return;
    }
    const job = this.#running;
    if ("result" in reply) this.#failures = 0;
    // The worker goes on while the page shows what it has done.
    if ("failure" in reply && reply.failure.code === "crashed") this.#restart();
    else if ("result" in reply || "failure" in reply) this.#next();
    if (!("failure" in reply && reply.failure.code === "superseded")) this.#onReply(reply, job);
  }
}
