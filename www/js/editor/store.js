// The page's state: a document (photo and region) with undo, and what is shown of it.

/** @typedef {import("./region.js").Region} Region */
/** @typedef {{ image: string, region: Region }} Document */
/** @typedef {{ mesh: boolean, grid: boolean }} Shown */
/** @typedef {"drag" | "commit" | "view" | "mode"} Change what happened: a drag goes on, an edit is complete, … */

export class Store {
  /** @type {Document} */ doc;
  /** @type {Shown} */ shown;
  /** @type {"edit" | "draw"} */ mode = "edit";
  /** The vertex that the keyboard and the Remove button act on. @type {number | null} */
  selected = null;
  /** @type {Document[]} */ #past = [];
  /** @type {Document[]} */ #future = [];
  /** The last complete document, while a drag is going on. @type {Document | null} */
  #before = null;
  /** @type {((change: Change) => void)[]} */ #listeners = [];

  /** @param {Document} doc @param {Shown} shown */
  constructor(doc, shown) {
    this.doc = doc;
    this.shown = shown;
  }

  /** @param {(change: Change) => void} listener */
  subscribe(listener) {
    this.#listeners.push(listener);
  }

  /** A step of a drag: seen at once, not yet in the history. @param {Region} region */
  drag(region) {
    this.#before ??= this.doc;
    this.doc = { ...this.doc, region };
    this.#tell("drag");
  }

  /** The end of a drag: one step of the history. */
  drop() {
    if (!this.#before) return;
    this.#remember(this.#before);
    this.#before = null;
    this.#tell("commit");
  }

  /** A complete edit. @param {Partial<Document>} changes */
  commit(changes) {
    this.#remember(this.#before ?? this.doc);
    this.#before = null;
    this.doc = { ...this.doc, ...changes };
    this.#clampSelection();
    this.#tell("commit");
  }

  /** The first document: nothing to go back to. @param {Document} doc */
  begin(doc) {
    this.doc = doc;
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  undo() {
    this.#travel(this.#past, this.#future);
  }

  redo() {
    this.#travel(this.#future, this.#past);
  }

  /** @param {Partial<Shown>} changes */
  show(changes) {
    this.shown = { ...this.shown, ...changes };
    this.#tell("view");
  }

  /** @param {"edit" | "draw"} mode */
  setMode(mode) {
    this.mode = mode;
    this.#tell("mode");
  }

  /** @param {number | null} index */
  select(index) {
    if (index === this.selected) return;
    this.selected = index;
    this.#tell("mode");
  }

  /** @param {Document} doc */
  #remember(doc) {
    this.#past.push(doc);
    if (this.#past.length > 200) this.#past.shift();
    this.#future = [];
  }

  /** @param {Document[]} from @param {Document[]} to */
  #travel(from, to) {
    const doc = from.pop();
    if (!doc) return;
    to.push(this.doc);
    this.doc = doc;
    this.#clampSelection();
    this.#tell("commit");
  }

  #clampSelection() {
    if (this.selected !== null && this.selected >= this.doc.region.boundary.length) this.selected = null;
  }

  /** @param {Change} change */
  #tell(change) {
    for (const listener of this.#listeners) listener(change);
  }
}
