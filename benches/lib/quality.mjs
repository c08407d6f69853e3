// What a picture should be, and how far another is from it.

/** Samples a pixel has in each direction. */
const SAMPLES = 16;

/**
 * The mean of what all points of each pixel show, by 256 of them, in bytes as they are.
 *
 * @param {import("conformal-warp").FormulaMap} map pulled back
 * @param {import("conformal-warp").Texture} texture
 * @param {import("./pictures.mjs").Frame} around the texture's frame
 * @param {import("./pictures.mjs").Frame} view
 * @returns {Float64Array} RGB of each pixel
 */
export function averaged(map, texture, around, view) {
  const [columns, rows] = view.pixels;
  const fine = { ...view, pixels: /** @type {[number, number]} */ ([columns * SAMPLES, rows * SAMPLES]) };
  const mean = new Float64Array(3 * columns * rows);
  const out = new Uint8ClampedArray(4 * columns * SAMPLES * SAMPLES);
  for (let row = 0; row < rows; row++) {
    const band = /** @type {[number, number]} */ ([row * SAMPLES, (row + 1) * SAMPLES]);
    map.warp(texture, { texture: around, view: fine, quality: "nearest", rows: band, out });
    for (let k = 0; k < out.length; k += 4) {
      const at = 3 * (row * columns + Math.floor((k / 4 % (columns * SAMPLES)) / SAMPLES));
      for (let channel = 0; channel < 3; channel++) mean[at + channel] += out[k + channel] / SAMPLES ** 2;
    }
  }
  return mean;
}

/**
 * Peak signal to noise, without the outermost pixels, where pictures end differently.
 *
 * @param {ArrayLike<number>} rgba of a square
 * @param {Float64Array} truth RGB
 */
export function decibels(rgba, truth) {
  const size = Math.sqrt(truth.length / 3);
  const edge = 4;
  let [squares, count] = [0, 0];
  for (let y = edge; y < size - edge; y++) {
    for (let x = edge; x < size - edge; x++) {
      for (let channel = 0; channel < 3; channel++) {
        squares += (rgba[4 * (y * size + x) + channel] - truth[3 * (y * size + x) + channel]) ** 2;
        count++;
      }
    }
  }
  return 10 * Math.log10(255 ** 2 / (squares / count));
}
