// One of the two photos with its region: state, view, editing and the controls above it.

import { deviceGrid } from "../common/canvas.js";
import { onGrid } from "../common/frame.js";
import { addPicture, loadPicture } from "../common/images.js";
import { element, PhotoOpener, pictureFor, wantedPicture } from "../common/page.js";
import { PhotoChoice } from "../common/photo-choice.js";
import { Drawing } from "../editor/drawing.js";
import { Editor } from "../editor/edit.js";
import { PhotoView } from "../editor/photo-view.js";
import { defaultRegion, LETTER, listShapes, READ, shapeRegion } from "../editor/presets.js";
import { carried, makeRegion } from "../editor/region.js";
import { offerRepair } from "../editor/repair-button.js";
import { NOTHING_SHOWN, Store } from "../editor/store.js";

/** @typedef {import("../common/images.js").Picture} Picture */
/** @typedef {import("../editor/store.js").Document} Document */

export class Side {
  store;
  view;
  editor;
  /** @type {Picture} */ picture;
  #drawing;
  #photos = new PhotoOpener();
  #photo;
  /** @type {(name: string) => HTMLElement} */ #find;

  /** The pictures of a document first. @param {string} name @param {Document} doc @param {(side: Side, kind: string) => void} wishOutline asks for an outline of the visitor's own, or a letter */
  static async open(name, doc, wishOutline) {
    return new Side(name, doc, await pictureFor(doc.image), wishOutline);
  }

  /** @param {string} name the start of its elements' ids @param {Document} doc @param {Picture} picture @param {(side: Side, kind: string) => void} wishOutline */
  constructor(name, doc, picture, wishOutline) {
    this.#find = (part) => element(`${name}-${part}`);
    this.picture = picture;
    const store = new Store(doc, NOTHING_SHOWN);
    this.store = store;
    this.view = new PhotoView(element(`${name}-photo`), element(`${name}-marks`), () => store.look());
    this.editor = new Editor(store, this.view);
    this.#drawing = new Drawing(store, this.view, (outline) => this.useOutline(outline));
    this.#photo = new PhotoChoice(/** @type {HTMLSelectElement} */ (this.#find("choose-photo")), (id) => this.#open(loadPicture(id)));
    this.#connect((kind) => wishOutline(this, kind));
    offerRepair(store, this.#find("stage"));
  }

  /** Goes to another document. @param {Document} doc @param {number} [step] shared with the other side */
  async visit(doc, step) {
    this.#drawing.cancel();
    this.picture = await pictureFor(doc.image);
    this.store.commit(doc, step);
  }

  /** @param {Blob} file */
  openFile(file) {
    return this.#open(addPicture(file));
  }

  /** @param {Promise<Picture>} loading */
  #open(loading) {
    return this.#photos.open(loading, (picture) => {
      this.#drawing.cancel();
      this.picture = picture;
      this.store.commit({ image: picture.id, region: defaultRegion(picture) });
    });
  }

  /** Loads the picture that the document names, where that has changed. */
  async follow() {
    if (this.picture.id !== this.store.doc.image) this.picture = (await wantedPicture(() => this.store.doc.image)) ?? this.picture;
  }

  /** The region as a job carries it. */
  get outline() {
    return carried(this.store.doc.region);
  }

  /** What is seen of the photo, on the panel's own pixels. @param {number} sharpness 1 for all of them */
  frame(sharpness) {
    return onGrid(this.view.frame, deviceGrid(this.view.frame.pixels, sharpness));
  }

  /** @param {import("../editor/photo-view.js").Layers} layers */
  draw(layers) {
    this.view.draw(this.picture, this.store, layers);
    const { mode, canUndo, canRedo } = this.store;
    this.#photo.show(this.picture);
    for (const what of ["draw", "hole"]) this.#find(what).setAttribute("aria-pressed", String(mode === what));
    this.#find("stage").dataset.mode = mode === "edit" ? "edit" : "draw";
    /** @type {HTMLButtonElement} */ (this.#find("undo")).disabled = !canUndo;
    /** @type {HTMLButtonElement} */ (this.#find("redo")).disabled = !canRedo;
  }

  /** Takes an outline as the region, and holes in it. @param {import("../editor/outline.js").Outline} outline @param {import("../editor/outline.js").Outline[]} [holes] */
  useOutline(outline, holes) {
    this.#replace(makeRegion(outline, undefined, undefined, holes));
  }

  /** @param {import("../editor/region.js").Region} region */
  #replace(region) {
    this.#drawing.cancel();
    this.store.commit({ region });
  }

  /** @param {(kind: string) => void} wishOutline asks for an outline of the visitor's own, or a letter */
  #connect(wishOutline) {
    const { store } = this;
    const shape = /** @type {HTMLSelectElement} */ (this.#find("choose-shape"));
    listShapes(shape);
    shape.onchange = () => {
      if (shape.value === READ || shape.value === LETTER) wishOutline(shape.value);
      else this.#replace(shapeRegion(shape.value, this.picture.frame.pixels));
      shape.value = "";
    };
    for (const what of /** @type {const} */ (["draw", "hole"])) this.#find(what).onclick = () => this.#drawing.toggle(what);
  }
}
