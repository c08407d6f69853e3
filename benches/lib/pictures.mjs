// Pictures to warp, and where an output pixel looks in them.

/** @typedef {{ center: [number, number], width: number, pixels: [number, number] }} Frame */

/**
 * A picture with detail of every size, the same on every run.
 *
 * @param {number} size
 */
export function picture(size) {
  const data = new Uint8Array(4 * size * size);
  let seed = 1;
  for (let k = 0; k < size * size; k++) {
    const [x, y] = [k % size, Math.floor(k / size)];
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    const checker = ((x >> 5) ^ (y >> 5)) & 1 ? 180 : 40;
    const noise = (seed >>> 24) & 15;
    data.set([checker + noise, (x * 240) / size + noise, (y * 240) / size + noise, 255], 4 * k);
  }
  return { data, width: size, height: size };
}

/**
 * For each pixel of `view`, the coordinates (in OpenCV's sense: whole numbers are pixel centres) in `texture` of the
 * point that `map` takes the pixel's point to.
 *
 * @param {Frame} view
 * @param {Frame} texture
 * @param {(points: Float64Array) => Float64Array} map
 */
export function coordinates(view, texture, map) {
  const [columns, rows] = view.pixels;
  const size = view.width / columns;
  const points = new Float64Array(2 * columns * rows);
  for (let k = 0; k < columns * rows; k++) {
    points[2 * k] = view.center[0] + ((k % columns) + 0.5 - columns / 2) * size;
    points[2 * k + 1] = view.center[1] - (Math.floor(k / columns) + 0.5 - rows / 2) * size;
  }
  const images = map(points);
  const texel = texture.width / texture.pixels[0];
  return Float32Array.from(images, (value, k) =>
    k % 2 === 0
      ? (value - texture.center[0]) / texel + texture.pixels[0] / 2 - 0.5
      : (texture.center[1] - value) / texel + texture.pixels[1] / 2 - 0.5,
  );
}
