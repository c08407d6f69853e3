// The peer: OpenCV.js' remap, one thread. It only looks up a map that somebody has already computed.

import { createRequire } from "node:module";

/** @type {any} */
let cv;

/** Loads OpenCV once. It is not to be awaited: its module has a `then` that resolves to the module itself. */
async function load() {
  if (cv) return;
  const module = createRequire(import.meta.url)("@techstark/opencv-js");
  if (!module.Mat) {
    await new Promise((resolve) => {
      module.onRuntimeInitialized = () => resolve(undefined);
    });
  }
  cv = module;
}

/**
 * Draws a picture through a map given by coordinates, bilinear.
 *
 * @param {{ data: Uint8Array, width: number, height: number }} picture RGBA
 * @param {number} width of the output
 * @param {number} height
 * @param {Float32Array} coordinates x and y in the picture, for each output pixel
 * @param {"BORDER_CONSTANT" | "BORDER_WRAP"} [border] transparent around the picture, or the picture again
 */
export async function remapper(picture, width, height, coordinates, border = "BORDER_CONSTANT") {
  await load();
  const from = new cv.Mat(picture.height, picture.width, cv.CV_8UC4);
  from.data.set(picture.data);
  const map = new cv.Mat(height, width, cv.CV_32FC2);
  map.data32F.set(coordinates);
  const [to, none, nothing] = [new cv.Mat(height, width, cv.CV_8UC4), new cv.Mat(), new cv.Scalar()];
  return {
    draw: () => cv.remap(from, to, map, none, cv.INTER_LINEAR, cv[border], nothing),
    free: () => [from, to, map, none].forEach((mat) => mat.delete()),
  };
}
