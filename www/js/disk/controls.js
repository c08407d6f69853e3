// The buttons, menus and keys around the panels.

import { onUndoKeys } from "../common/keys.js";
import { press } from "../common/page.js";
import { PhotoChoice } from "../common/photo-choice.js";
import { canRemove } from "../editor/region.js";
import { listShapes } from "../editor/presets.js";
import { showMenu } from "../editor/show-menu.js";

/** @typedef {import("../common/images.js").Picture} Picture */
/** @typedef {import("../editor/store.js").Store} Store */
/**
 * @typedef {object} Actions
 * @property {() => void} draw
 * @property {() => void} hole
 * @property {() => void} remove
 * @property {() => void} reset
 * @property {() => void} upright
 * @property {() => void} stop
 * @property {(id: string) => void} photo
 * @property {(name: string) => void} shape
 */

/** @template {HTMLElement} E @param {string} id @returns {E} */
const find = (id) => /** @type {E} */ (document.getElementById(id));

/** @template {string} N @param {N[]} names */
const findAll = (...names) => /** @type {Record<N, HTMLButtonElement>} */ (Object.fromEntries(names.map((name) => [name, find(name)])));

export class Controls {
  #store;
  #photo;
  /** @type {HTMLSelectElement} */ #shape = find("choose-shape");
  #buttons = findAll("draw", "hole", "remove", "undo", "redo", "reset", "upright", "open", "stop");

  #showShown;

  /** @param {Store} store @param {Actions} actions @param {HTMLElement} probe the row of a menu */
  constructor(store, actions, probe) {
    this.#store = store;
    this.#showShown = showMenu(store, find("show"), [probe]);
    const { draw, hole, remove, undo, redo, reset, upright, open, stop } = this.#buttons;
    this.#photo = new PhotoChoice(find("choose-photo"), actions.photo);
    listShapes(this.#shape);
    this.#shape.onchange = () => {
      actions.shape(this.#shape.value);
      this.#shape.value = "";
    };
    draw.onclick = actions.draw;
    hole.onclick = actions.hole;
    remove.onclick = actions.remove;
    reset.onclick = actions.reset;
    upright.onclick = actions.upright;
    stop.onclick = actions.stop;
    undo.onclick = () => store.undo();
    redo.onclick = () => store.redo();
    open.onclick = () => find("file").click();
    onUndoKeys(
      () => store.undo(),
      () => store.redo(),
    );
  }

  /** Shows the state. @param {Picture} picture */
  update(picture) {
    const { doc, mode, selected, canUndo, canRedo } = this.#store;
    const { remove, undo, redo } = this.#buttons;
    undo.disabled = !canUndo;
    redo.disabled = !canRedo;
    remove.disabled = selected === null || !canRemove(doc.region, selected) || mode !== "edit";
    press("draw", mode === "draw");
    press("hole", mode === "hole");
    this.#showShown(doc.region.holes ? ["mesh", "measure"] : []);
    this.#photo.show(picture);
    document.body.dataset.mode = mode === "edit" ? "edit" : "draw";
  }
}
