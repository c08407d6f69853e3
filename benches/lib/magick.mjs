// The peer: ImageMagick's distort, which averages over ellipses (EWA), for the conformal maps that it knows: similarities.

import { readFileSync } from "node:fs";
import { peer, peerFile } from "./peers.mjs";

/** @type {any} */
let magick;

async function load() {
  if (magick) return;
  magick = await peer(peerFile("@imagemagick/magick-wasm").replace("index.umd.cjs", "index.js"));
  await magick.initializeImageMagick(readFileSync(peerFile("@imagemagick/magick-wasm/magick.wasm")));
}

/**
 * Draws the middle of a square picture, turned.
 *
 * @param {{ data: Uint8Array, width: number, height: number }} picture RGBA
 * @param {number} size of the output
 * @param {number} scale texels for each pixel
 * @param {number} angle counter-clockwise, from the view to the picture
 */
export async function ewa(picture, size, scale, angle) {
  await load();
  const raw = new magick.MagickReadSettings({ format: magick.MagickFormat.Rgba, width: picture.width, height: picture.height, depth: 8 });
  const source = magick.MagickImage.create(picture.data, raw);
  source.virtualPixelMethod = magick.VirtualPixelMethod.Edge;
  const settings = new magick.DistortSettings(magick.DistortMethod.ScaleRotateTranslate);
  settings.viewport = new magick.MagickGeometry(0, 0, size, size);
  const middle = (/** @type {number} */ pixels) => [pixels / 2, pixels / 2];
  const parameters = [...middle(picture.width), 1 / scale, (angle * 180) / Math.PI, ...middle(size)];
  /** @type {Uint8Array | undefined} */
  let drawn;
  return {
    // The copy is a reference to the pixels; what distorts is the second step.
    draw() {
      source.clone((/** @type {any} */ copy) => {
        copy.distort(settings, parameters);
        drawn = copy.getPixels((/** @type {any} */ pixels) => pixels.toByteArray(0, 0, size, size, "RGBA"));
      });
    },
    pixels: () => /** @type {Uint8Array} */ (drawn),
    free: () => source.dispose(),
  };
}
