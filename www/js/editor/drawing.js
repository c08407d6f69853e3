// Drawing by hand: one pen for regions and for holes in them.

import { Pen } from "./pen.js";
import { addHole } from "./region.js";

/** @typedef {import("./outline.js").Outline} Outline */

export class Drawing {
  #store;
  #pen;
  /** What is drawn next. @type {"draw" | "hole"} */
  #wanted = "draw";

  /** @param {import("./store.js").Store} store @param {import("./photo-view.js").PhotoView} view @param {(outline: Outline) => void} useOutline of a region; a hole goes into the store's */
  constructor(store, view, useOutline) {
    this.#store = store;
    /** @param {Outline} outline as it was drawn */
    const use = (outline) => {
      if (this.#wanted === "hole") store.commit({ region: addHole(store.doc.region, outline) });
      else useOutline(outline);
    };
    this.#pen = new Pen({
      view,
      isActive: () => store.mode !== "edit",
      onMode: (drawing) => store.setMode(drawing ? this.#wanted : "edit"),
      onOutline: (boundary) => use({ boundary }),
      onStroke: use,
    });
  }

  /** Begins to draw a region, or a hole in it; once more, and it is given up. @param {"draw" | "hole"} what */
  toggle(what) {
    if (this.#store.mode === what) return this.cancel();
    this.cancel();
    this.#wanted = what;
    this.#pen.begin();
  }

  cancel() {
    this.#pen.cancel();
  }
}
