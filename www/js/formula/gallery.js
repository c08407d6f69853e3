// The presets as small pictures to choose from, which a worker draws.

import { contextOf, drawnCanvas } from "../common/canvas.js";
import { imageOf, WORKER } from "../common/colours.js";

/** @typedef {import("../../pkg/formula/index.js").Preset} Preset */
/** @typedef {import("../common/images.js").Picture} Picture */

/** Pixels of a thumbnail, and of the texture that it is made from. */
const SIDE = 216;
const TEXTURE_SIDE = 256;

/**
 * Fills `list` with a link for each preset; pictures follow one by one. Where they cannot be drawn the titles stay.
 * @param {HTMLElement} list @param {Preset[]} presets @param {(kind: Preset["picture"]) => Promise<Picture>} picture
 */
export async function showGallery(list, presets, picture) {
  const canvases = presets.map(({ name, title, shows }) => {
    const canvas = Object.assign(document.createElement("canvas"), { width: SIDE, height: SIDE });
    const link = Object.assign(document.createElement("a"), { href: `#preset=${name}`, title: shows });
    link.append(canvas, title);
    const item = document.createElement("li");
    item.append(link);
    list.append(item);
    return canvas;
  });
  const textures = { photo: small(await picture("photo")), lattice: small(await picture("lattice")) };
  const worker = new Worker(new URL("./gallery-worker.js", import.meta.url), WORKER);
  worker.onerror = (event) => event.preventDefault();
  worker.onmessage = ({ data: { index, pixels } }) => {
    contextOf(canvases[index]).putImageData(imageOf(pixels, SIDE, SIDE), 0, 0);
    if (index === presets.length - 1) worker.terminate();
  };
  worker.postMessage({ presets, textures, side: SIDE, textureSide: TEXTURE_SIDE });
}

/** @param {Picture} picture */
function small({ canvas }) {
  return drawnCanvas([TEXTURE_SIDE, TEXTURE_SIDE], (context) => context.drawImage(canvas, 0, 0, TEXTURE_SIDE, TEXTURE_SIDE)).pixels;
}
