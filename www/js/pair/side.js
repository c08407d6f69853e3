// One of the two photos with its region: state, view, editing and the controls above it.

import { flatten, onGrid } from "../common/frame.js";
import { addPicture, loadPicture } from "../common/images.js";
import { element } from "../common/page.js";
import { photos } from "../common/photos.js";
import { Pen } from "../editor/pen.js";
import { Editor } from "../editor/edit.js";
import { PhotoView } from "../editor/photo-view.js";
import { photoRegion, shapeRegion, shapes } from "../editor/presets.js";
import { towardPoint } from "../editor/region.js";
import { Store } from "../editor/store.js";

/** @typedef {import("../common/images.js").Picture} Picture */
/** @typedef {import("../editor/store.js").Change} Change */
/** @typedef {import("../editor/store.js").Document} Document */

export class Side {
  store;
  view;
  /** @type {Picture} */ picture;
  #pen;
  /** @type {(name: string) => HTMLElement} */ #find;

  /** The pictures of a document first. @param {string} name @param {Document} doc */
  static async open(name, doc) {
    return new Side(name, doc, await loadPicture(doc.image));
  }

  /** @param {string} name the start of its elements' ids @param {Document} doc @param {Picture} picture */
  constructor(name, doc, picture) {
    this.#find = (part) => element(`${name}-${part}`);
    this.picture = picture;
    this.store = new Store(doc, { mesh: false, grid: false });
    this.view = new PhotoView(element(`${name}-photo`), element(`${name}-marks`));
    new Editor(this.store, this.view);
    this.#pen = new Pen(this.store, this.view);
    this.#connect();
  }

  /** Goes to another document. @param {Document} doc */
  async visit(doc) {
    this.picture = await loadPicture(doc.image);
    this.store.commit(doc);
  }

  /** @param {Blob} file */
  async openFile(file) {
    this.picture = await addPicture(file);
    this.store.commit({ image: this.picture.id, region: defaultRegion(this.picture.id, this.picture) });
  }

  /** Loads the picture that the document names, where that has changed. */
  async follow() {
    if (this.picture.id !== this.store.doc.image) this.picture = await loadPicture(this.store.doc.image);
  }

  /** The region as a job carries it. */
  get outline() {
    const { region } = this.store.doc;
    return { boundary: flatten(region.boundary), center: region.center, toward: towardPoint(region) };
  }

  /** The photo's frame on the panel's own pixels. @param {number} sharpness 1 for all of them */
  frame(sharpness) {
    const density = (window.devicePixelRatio || 1) * sharpness;
    const [width, height] = this.view.frame.pixels.map((n) => Math.min(1600, Math.max(32, Math.round(n * density))));
    return onGrid(this.picture.frame, [width, height]);
  }

  /** @param {import("../editor/photo-view.js").Layers} layers */
  draw(layers) {
    this.view.draw(this.picture, this.store, layers);
    const { doc, mode, canUndo, canRedo } = this.store;
    const photo = /** @type {HTMLSelectElement} */ (this.#find("choose-photo"));
    if (![...photo.options].some(({ value }) => value === doc.image)) photo.append(new Option(this.picture.title, doc.image));
    photo.value = doc.image;
    this.#find("draw").setAttribute("aria-pressed", String(mode === "draw"));
    this.#find("stage").dataset.mode = mode;
    /** @type {HTMLButtonElement} */ (this.#find("undo")).disabled = !canUndo;
    /** @type {HTMLButtonElement} */ (this.#find("redo")).disabled = !canRedo;
  }

  #connect() {
    const { store } = this;
    const photo = /** @type {HTMLSelectElement} */ (this.#find("choose-photo"));
    const shape = /** @type {HTMLSelectElement} */ (this.#find("choose-shape"));
    photo.append(...Object.entries(photos).map(([id, { title }]) => new Option(title, id)));
    shape.append(...Object.entries(shapes).map(([name, { title }]) => new Option(title, name)));
    photo.onchange = async () => {
      const picture = await loadPicture(photo.value);
      await this.visit({ image: picture.id, region: defaultRegion(picture.id, picture) });
    };
    shape.onchange = () => {
      store.commit({ region: shapeRegion(shape.value, ...this.picture.frame.pixels) });
      shape.value = "";
    };
    this.#find("draw").onclick = () => (store.mode === "draw" ? this.#pen.cancel() : this.#pen.begin());
    this.#find("undo").onclick = () => store.undo();
    this.#find("redo").onclick = () => store.redo();
  }
}

/** @param {string} id @param {Picture} picture */
function defaultRegion(id, picture) {
  return id in photos ? photoRegion(id) : shapeRegion("ellipse", ...picture.frame.pixels);
}
