// The state of a drawing: a document (photo and region) with undo, and what is shown of it.

import { History } from "../common/history.js";
import { pointsOf } from "./region.js";

/** @typedef {import("./region.js").Region} Region */
/** @typedef {{ image: string, region: Region }} Document */
/** @typedef {"edit" | "draw" | "hole"} Mode */
/** What is shown over the pictures; `density`: rays of the grid, or field lines; `morph`: how far on the way from the region to the disk; `onto`: what a region with holes becomes, if somebody chose. @typedef {{ mesh: boolean, grid: boolean, field: boolean, heat: boolean, measure: boolean, density: number, morph: number, onto: Onto | null }} Shown */
/** @typedef {typeof ONTO[number]} Onto */

/** A ring, the disk with slits in it, the disk with round holes. */
export const ONTO = /** @type {const} */ (["ring", "slits", "circles"]);

export const NOTHING_SHOWN = Object.freeze({ mesh: false, grid: false, field: false, heat: false, measure: false, density: 12, morph: 1, onto: null });

/** @extends {History<Document>} */
export class Store extends History {
  /** @type {Shown} */ shown;
  /** What presses do: edit, or draw a region or a hole in it. @type {Mode} */ mode = "edit";
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

  /** @param {Mode} mode */
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
    if (this.selected !== null && this.selected >= pointsOf(this.doc.region).length) this.selected = null;
    super.tell(change);
  }
}
