// The peer: libvips' mapim, one thread. It only looks up a map that somebody has already computed.

import { peer } from "./peers.mjs";

/** @type {any} */
let vips;

async function load() {
  if (vips) return;
  vips = await (await peer("wasm-vips")).default();
  vips.concurrency(1);
  // Every drawing is to be drawn.
  vips.Cache.max(0);
}

/**
 * @param {{ data: Uint8Array, width: number, height: number }} picture RGBA
 * @param {number} width of the output
 * @param {number} height
 * @param {Float32Array} coordinates x and y in the picture, for each output pixel
 * @param {string} kernel
 */
export async function mapim(picture, width, height, coordinates, kernel) {
  await load();
  const source = vips.Image.newFromMemory(picture.data, picture.width, picture.height, 4, vips.BandFormat.uchar).copy({ interpretation: "srgb" });
  const index = vips.Image.newFromMemory(new Uint8Array(coordinates.buffer), width, height, 2, vips.BandFormat.float);
  const interpolate = vips.Interpolate.newFromName(kernel);
  /** @type {Uint8Array | undefined} */
  let drawn;
  return {
    draw() {
      const image = source.mapim(index, { interpolate });
      drawn = image.writeToMemory();
      image.delete();
    },
    pixels: () => /** @type {Uint8Array} */ (drawn),
    free: () => [source, index, interpolate].forEach((object) => object.delete()),
  };
}
