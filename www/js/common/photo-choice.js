// The menu of photos: those of the page, and what else is or was shown.

import { knowsPicture, ownPictures } from "./images.js";
import { photos } from "./photos.js";

/** @typedef {import("./images.js").Picture} Picture */

export class PhotoChoice {
  #select;

  /** @param {HTMLSelectElement} select @param {(id: string) => void} onChoose @param {[id: string, title: string][]} [more] before the photos */
  constructor(select, onChoose, more = []) {
    this.#select = select;
    const titles = [...more, ...[...photos].map(([id, { title }]) => /** @type {[string, string]} */ ([id, title]))];
    select.append(...titles.map(([id, title]) => new Option(title, id)));
    for (const { id, title } of ownPictures()) this.#add(id, title);
    select.onchange = () => onChoose(select.value);
  }

  /** Shows which picture it is. A visitor's own stays to be chosen again; what cannot be had again, as the camera's, goes. @param {Picture} picture */
  show({ id, title }) {
    const added = [...this.#select.options].filter(({ dataset }) => dataset.added);
    for (const option of added) if (option.value !== id && !knowsPicture(option.value)) option.remove();
    if (![...this.#select.options].some(({ value }) => value === id)) this.#add(id, title);
    this.#select.value = id;
  }

  /** @param {string} id @param {string} title */
  #add(id, title) {
    const option = new Option(title, id);
    option.dataset.added = "true";
    this.#select.append(option);
  }
}
