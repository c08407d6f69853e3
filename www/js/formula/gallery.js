// The presets as small pictures to choose from.

import { FormulaMap, Texture } from "../../pkg/index.js";

/** @typedef {import("../../pkg/index.js").Preset} Preset */
/** @typedef {import("../common/images.js").Picture} Picture */

/** Pixels of a thumbnail, and of the texture that it is made from. */
const SIDE = 160;
const TEXTURE_SIDE = 256;

/**
 * Fills `list` with a link for each preset; pictures follow one by one, between other work.
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
  for (const [k, preset] of presets.entries()) {
    await new Promise((resolve) => setTimeout(resolve));
    paint(canvases[k], preset, textures[preset.picture]);
  }
}

/** @param {HTMLCanvasElement} canvas @param {Preset} preset @param {ImageData} image */
function paint(canvas, { formula, params, direction, texture: place, view, wrap }, image) {
  const context = canvas.getContext("2d");
  if (!context) return;
  const map = new FormulaMap(formula, { params });
  const texture = Texture.fromImageData(image, { wrap });
  map.paint(context, texture, {
    texture: { ...place, pixels: [image.width, image.height] },
    view: { ...view, pixels: [SIDE, SIDE] },
    direction,
  });
  map.free();
  texture.free();
}

/** @param {Picture} picture @returns {ImageData} */
function small({ canvas }) {
  const copy = new OffscreenCanvas(TEXTURE_SIDE, TEXTURE_SIDE);
  const context = copy.getContext("2d");
  if (!context) throw new Error("This browser gives no 2d canvas.");
  context.imageSmoothingQuality = "high";
  context.drawImage(canvas, 0, 0, TEXTURE_SIDE, TEXTURE_SIDE);
  return context.getImageData(0, 0, TEXTURE_SIDE, TEXTURE_SIDE);
}
