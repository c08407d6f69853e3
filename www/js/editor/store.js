// The state of a drawing: a document (photo and region) with undo, and what is shown of it.

import { History } from "../common/history.js";

/** @typedef {import("./region.js").Region} Region */
/** @typedef {{ image: string, region: Region }} Document */
/** What is shown over the pictures; `density`: rays of the grid, or field lines; `morph`: how far on the way from the region to the disk. @typedef {{ mesh: boolean, grid: boolean, field: boolean, heat: boolean, measure: boolean, density: number, morph: number }} Shown */

export const NOTHING_SHOWN = Object.freeze({ mesh: false, grid: false, field: false, heat: false, measure: false, density: 12, morph: 1 });

/** @extends {History<Document>} */
export class Store extends History {
  /** @type {Shown} */ shown;
  /** @type {"edit" | "draw"} */ mode = "edit";
  /** The vertex that the keyboard and the Remove button act on. @type {number | null} */
  selected = null;

  /** @param {Document} doc @param {Shown} shown */
  constructor(doc, shown) {
    super(doc);
    this.shown = shown;
  }

  get doc() {
    return this.value;
  }

  /** A step of a drag: seen at once, not yet in the history. @param {Region} region */
  drag(region) {
    this.dragTo({ region });
  }

  /** @param {Partial<Shown>} changes */
  show(changes) {
    this.shown = { ...this.shown, ...changes };
    this.tell("view");
  }

  /** Another part of the picture is looked at. */
  look() {
    this.tell("look");
  }

  /** @param {"edit" | "draw"} mode */
  setMode(mode) {
    if (mode === this.mode) return;
    this.mode = mode;
    this.tell("mode");
  }

  /** @param {number | null} index */
  select(index) {
    if (index === this.selected) return;
    this.selected = index;
    this.tell("mode");
  }

  /** @protected @override @param {import("../common/history.js").Change} change */
  tell(change) {
    if (this.selected !== null && this.selected >= this.doc.region.boundary.length) this.selected = null;
    super.tell(change);
  }
}
