// A worker as seen from the page: it works on one job at a time, and only the newest waits.

/** @typedef {import("./images.js").Picture} Picture */
/** @typedef {import("./serve.js").Versioned} Versioned */
/** @template R @typedef {import("./serve.js").Reply<R>} Reply */

/** @template {Versioned} J a job @template {Versioned} R its result */
export class Lane {
  /** @type {Worker | null} */ #worker = null;
  /** @type {Picture | null} */ #picture = null;
  /** The picture that the worker has. @type {Picture | null} */ #handed = null;
  /** @type {J | null} */ #running = null;
  /** @type {J | null} */ #waiting = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */ #timer;
  #script;
  #patience;
  #onAnswer;

  /**
   * @param {URL} script of the worker, which calls `serveJobs`
   * @param {number} patience how long a job may go on that nobody waits for any more, in milliseconds; then its worker is replaced
   * @param {(answer: Reply<R>) => void} onAnswer
   */
  constructor(script, patience, onAnswer) {
    this.#script = script;
    this.#patience = patience;
    this.#onAnswer = onAnswer;
    this.#start();
  }

  /** The picture for the jobs that follow. @param {Picture} picture */
  setPicture(picture) {
    this.#picture = picture;
  }

  /** Runs the job next; one that was waiting is forgotten. @param {J} job */
  request(job) {
    this.#waiting = job;
    if (this.#running) this.#hurry();
    else this.#next();
  }

  /** Forgets the waiting job, and the running one unless it ends soon: the page has moved on. */
  abandon() {
    this.#waiting = null;
    if (this.#running) this.#hurry();
  }

  #hurry() {
    this.#timer ??= setTimeout(() => this.#restart(), this.#patience);
  }

  #start() {
    const worker = new Worker(this.#script, { type: "module" });
    worker.onmessage = ({ data }) => this.#receive(data);
    worker.onerror = (event) => {
      event.preventDefault();
      this.#receive({ broken: event.message || "its script could not be loaded" });
    };
    this.#worker = worker;
    this.#handed = null;
  }

  #restart() {
    this.#worker?.terminate();
    this.#start();
    this.#next();
  }

  /** There is no WebAssembly here: jobs wait for ever. */
  #stop() {
    clearTimeout(this.#timer);
    this.#worker?.terminate();
    this.#worker = null;
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
    this.#onAnswer(reply);
    if ("broken" in reply) this.#stop();
    else if ("failure" in reply && reply.failure.code === "crashed") this.#restart();
    else if (!("progress" in reply)) this.#next();
  }
}
