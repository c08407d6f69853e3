// A value with undo: drags are seen at once and become one step when they end.

/** @typedef {"drag" | "commit" | "view" | "mode" | "look"} Change what happened: a drag goes on, an edit is complete, … */

const LONGEST = 200;

/** Steps are numbered over all histories of a page, so that it knows which was the last. */
let steps = 0;

/** A number for a step; histories that take part in one step share it. */
export const newStep = () => ++steps;

/** @template T */
export class History {
  /** @type {T} */ value;
  /** @type {{ value: T, step: number }[]} */ #past = [];
  /** @type {{ value: T, step: number }[]} */ #future = [];
  /** The last complete value, while a drag is going on. @type {T | null} */
  #before = null;
  /** @type {((change: Change) => void)[]} */ #listeners = [];

  /** @param {T} value */
  constructor(value) {
    this.value = value;
  }

  /** @param {(change: Change) => void} listener */
  subscribe(listener) {
    this.#listeners.push(listener);
  }

  /** Tells those who listen. @protected @param {Change} change */
  tell(change) {
    for (const listener of this.#listeners) listener(change);
  }

  /** The first value: nothing to go back to. @param {T} value */
  begin(value) {
    this.value = value;
  }

  get dragging() {
    return this.#before !== null;
  }

  /** A step of a drag: seen at once, not yet in the history. @param {Partial<T>} changes */
  dragTo(changes) {
    this.#before ??= this.value;
    this.value = { ...this.value, ...changes };
    this.tell("drag");
  }

  /** The end of a drag: one step of the history. */
  drop() {
    if (this.#before === null) return;
    this.#remember(this.#before, newStep());
    this.#before = null;
    this.tell("commit");
  }

  /** Gives a drag up: all is as before. */
  giveUp() {
    if (this.#before === null) return;
    this.value = this.#before;
    this.#before = null;
    this.tell("commit");
  }

  /** A complete edit. @param {Partial<T>} changes @param {number} [step] a number that is shared with another history */
  commit(changes, step = newStep()) {
    this.#remember(this.#before ?? this.value, step);
    this.#before = null;
    this.value = { ...this.value, ...changes };
    this.tell("commit");
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  /** The number of the step that undo would take back; 0 for none. */
  get lastStep() {
    return this.#past.at(-1)?.step ?? 0;
  }

  /** The number of the step that redo would bring back; Infinity for none. */
  get nextStep() {
    return this.#future.at(-1)?.step ?? Infinity;
  }

  undo() {
    if (this.#before !== null) return this.giveUp();
    this.#travel(this.#past, this.#future);
  }

  redo() {
    this.#travel(this.#future, this.#past);
  }

  /** @param {T} value @param {number} step */
  #remember(value, step) {
    this.#past.push({ value, step });
    if (this.#past.length > LONGEST) this.#past.shift();
    this.#future = [];
  }

  /** @param {{ value: T, step: number }[]} from @param {{ value: T, step: number }[]} to */
  #travel(from, to) {
    const found = from.pop();
    if (!found) return;
    to.push({ value: this.value, step: found.step });
    this.value = found.value;
    this.tell("commit");
  }
}

/** Takes back the last step of several histories; those that share it go together. @param {History<any>[]} histories */
export function undoLast(histories) {
  const held = histories.find(({ dragging }) => dragging);
  if (held) return held.giveUp();
  const last = Math.max(...histories.map(({ lastStep }) => lastStep));
  for (const history of histories) if (last && history.lastStep === last) history.undo();
}

/** Brings back the step that was taken back last. @param {History<any>[]} histories */
export function redoNext(histories) {
  const next = Math.min(...histories.map(({ nextStep }) => nextStep));
  for (const history of histories) if (next < Infinity && history.nextStep === next) history.redo();
}
