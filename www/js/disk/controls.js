// The buttons, menus and keys around the panels.

import { photos } from "../common/photos.js";
import { shapes } from "../editor/presets.js";

/** @typedef {import("../editor/store.js").Store} Store */
/**
 * @typedef {object} Actions
 * @property {() => void} draw
 * @property {() => void} remove
 * @property {() => void} reset
 * @property {() => void} upright
 * @property {() => void} save
 * @property {(id: string) => void} photo
 * @property {(name: string) => void} shape
 */

/** @template {HTMLElement} E @param {string} id @returns {E} */
const find = (id) => /** @type {E} */ (document.getElementById(id));

export class Controls {
  #store;
  /** @type {HTMLSelectElement} */ #photo = find("choose-photo");
  /** @type {HTMLSelectElement} */ #shape = find("choose-shape");
  /** @type {Record<string, HTMLButtonElement>} */
  #buttons = Object.fromEntries(
    ["draw", "remove", "undo", "redo", "reset", "mesh", "grid", "upright", "save", "open"].map((name) => [name, find(name)]),
  );

  /** @param {Store} store @param {Actions} actions */
  constructor(store, actions) {
    this.#store = store;
    const { draw, remove, undo, redo, reset, mesh, grid, upright, save, open } = this.#buttons;
    this.#photo.append(...Object.entries(photos).map(([id, { title }]) => new Option(title, id)));
    this.#shape.append(...Object.entries(shapes).map(([name, { title }]) => new Option(title, name)));
    this.#photo.onchange = () => actions.photo(this.#photo.value);
    this.#shape.onchange = () => {
      actions.shape(this.#shape.value);
      this.#shape.value = "";
    };
    draw.onclick = actions.draw;
    remove.onclick = actions.remove;
    reset.onclick = actions.reset;
    upright.onclick = actions.upright;
    save.onclick = actions.save;
    undo.onclick = () => store.undo();
    redo.onclick = () => store.redo();
    mesh.onclick = () => store.show({ mesh: !store.shown.mesh });
    grid.onclick = () => store.show({ grid: !store.shown.grid });
    open.onclick = () => find("file").click();
    window.addEventListener("keydown", (event) => this.#key(event));
  }

  /** Shows the state. @param {string} title of the picture */
  update(title) {
    const { doc, mode, selected, shown, canUndo, canRedo } = this.#store;
    const { draw, remove, undo, redo, mesh, grid } = this.#buttons;
    undo.disabled = !canUndo;
    redo.disabled = !canRedo;
    remove.disabled = selected === null || doc.region.boundary.length <= 3 || mode === "draw";
    draw.setAttribute("aria-pressed", String(mode === "draw"));
    mesh.setAttribute("aria-pressed", String(shown.mesh));
    grid.setAttribute("aria-pressed", String(shown.grid));
    if (![...this.#photo.options].some(({ value }) => value === doc.image)) this.#photo.append(new Option(title, doc.image));
    this.#photo.value = doc.image;
    document.body.dataset.mode = mode;
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    const key = event.key.toLowerCase();
    if (key === "z" && !event.shiftKey) this.#store.undo();
    else if (key === "y" || key === "z") this.#store.redo();
    else return;
    event.preventDefault();
  }
}
