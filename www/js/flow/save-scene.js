// The menu under Save for pages that draw scenes.

import { offerToSave } from "../common/save-menu.js";

/** @typedef {import("./scene.js").Scene} Scene */

/** Nothing of a visitor's lies under a scene. */
const NO_PHOTO = { pixels: new Uint8ClampedArray(4), frame: { center: /** @type {[number, number]} */ ([0, 0]), width: 1, pixels: /** @type {[number, number]} */ ([1, 1]) } };

/**
 * @param {object} what
 * @param {string} what.name of the files @param {string} what.drawing what lines the SVG file has
 * @param {HTMLCanvasElement} what.canvas @param {{ scene: Scene | null }} what.view @param {() => string} what.address of the state
 */
export function offerScene({ name, drawing, canvas, view, address }) {
  offerToSave({
    name,
    script: new URL("./scene-worker.js", import.meta.url),
    picture: () => NO_PHOTO,
    photo: false,
    shape: () => view.scene?.grid.pixels ?? [canvas.clientWidth, canvas.clientHeight],
    job: (pixels, kind) => {
      const { scene } = view;
      if (!scene) throw new Error("There is no picture yet.");
      return { version: 0, scene, frame: { ...scene.grid, pixels }, density: pixels[0] / canvas.clientWidth, drawing: kind === "drawing", name };
    },
    drawing,
    address,
  });
}
