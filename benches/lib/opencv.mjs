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
    pixels: () => to.data.slice(),
    free: () => [from, to, map, none].forEach((mat) => mat.delete()),
  };
}

/**
 * Draws the middle of a square picture, turned, bilinear: as the affine map that it is, or as a homography.
 *
 * @param {{ data: Uint8Array, width: number, height: number }} picture RGBA
 * @param {number} size of the output
 * @param {number} scale texels for each pixel
 * @param {number} angle counter-clockwise, from the view to the picture
 * @param {boolean} [asHomography]
 */
export async function affine(picture, size, scale, angle, asHomography = false) {
  await load();
  const from = new cv.Mat(picture.height, picture.width, cv.CV_8UC4);
  from.data.set(picture.data);
  const [cos, sin] = [scale * Math.cos(angle), scale * Math.sin(angle)];
  // Pixel centres are whole numbers here.
  const [middle, away] = [(picture.width - 1) / 2, (size - 1) / 2];
  const rows = [cos, sin, middle - (cos + sin) * away, -sin, cos, middle - (cos - sin) * away];
  const matrix = cv.matFromArray(asHomography ? 3 : 2, 3, cv.CV_64F, asHomography ? [...rows, 0, 0, 1] : rows);
  const [to, dimensions, nothing] = [new cv.Mat(size, size, cv.CV_8UC4), new cv.Size(size, size), new cv.Scalar()];
  const warp = asHomography ? cv.warpPerspective : cv.warpAffine;
  return {
    draw: () => warp(from, to, matrix, dimensions, cv.INTER_LINEAR | cv.WARP_INVERSE_MAP, cv.BORDER_CONSTANT, nothing),
    pixels: () => to.data.slice(),
    free: () => [from, to, matrix].forEach((mat) => mat.delete()),
  };
}
