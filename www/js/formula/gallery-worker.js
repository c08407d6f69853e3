// Draws the thumbnails of the gallery.

import init, { FormulaMap, Texture } from "../../pkg/formula/index.js";

/** @typedef {import("../../pkg/formula/index.js").Preset} Preset */
/** @typedef {{ presets: Preset[], textures: Record<Preset["picture"], Uint8ClampedArray>, side: number, textureSide: number }} Order */

self.onmessage = async (/** @type {MessageEvent<Order>} */ { data: { presets, textures, side, textureSide } }) => {
  await init();
  presets.forEach(({ formula, params, direction, texture: place, view, wrap, picture }, index) => {
    const map = new FormulaMap(formula, { params });
    const texture = new Texture(textures[picture], textureSide, textureSide, { wrap });
    const frames = { texture: { ...place, pixels: /** @type {[number, number]} */ ([textureSide, textureSide]) }, view: { ...view, pixels: /** @type {[number, number]} */ ([side, side]) } };
    self.postMessage({ index, pixels: map.warp(texture, { ...frames, direction }) });
    map.free();
    texture.free();
  });
};
