// What the scripts that draw the README's pictures share: JPEG in and out, pictures side by side.

import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import jpeg from "jpeg-js";
import { root } from "./steps.mjs";

/** @typedef {{ width: number, height: number, data: Uint8ClampedArray }} Pixels RGBA with straight alpha */

const GAP = 12;

/**
 * Pictures in rows of so many, each in the middle of its cell, on white.
 *
 * @param {Pixels[]} pictures
 * @param {number} columns
 * @returns {Pixels}
 */
export function sheet(pictures, columns) {
  const rows = Math.ceil(pictures.length / columns);
  const inColumn = (/** @type {number} */ column) => pictures.filter((_, index) => index % columns === column);
  const inRow = (/** @type {number} */ row) => pictures.slice(row * columns, (row + 1) * columns);
  const widths = Array.from({ length: columns }, (_, column) => Math.max(...inColumn(column).map(({ width }) => width)));
  const heights = Array.from({ length: rows }, (_, row) => Math.max(...inRow(row).map(({ height }) => height)));
  const before = (/** @type {number[]} */ sizes, /** @type {number} */ index) =>
    sizes.slice(0, index).reduce((sum, size) => sum + size + GAP, 0);
  const total = { width: before(widths, columns) - GAP, height: before(heights, rows) - GAP };
  const data = new Uint8ClampedArray(4 * total.width * total.height).fill(255);
  pictures.forEach((picture, index) => {
    const [column, row] = [index % columns, Math.floor(index / columns)];
    const left = before(widths, column) + Math.floor((widths[column] - picture.width) / 2);
    const top = before(heights, row) + Math.floor((heights[row] - picture.height) / 2);
    lay({ ...total, data }, picture, left, top);
  });
  return { ...total, data };
}

/**
 * One picture over another, which is opaque.
 *
 * @param {Pixels} below
 * @param {Pixels} above
 * @param {number} left
 * @param {number} top
 */
export function lay(below, above, left, top) {
  for (let row = 0; row < above.height; row++) {
    for (let column = 0; column < above.width; column++) {
      const from = 4 * (row * above.width + column);
      const to = 4 * ((top + row) * below.width + left + column);
      const alpha = above.data[from + 3] / 255;
      for (let channel = 0; channel < 3; channel++) {
        below.data[to + channel] += alpha * (above.data[from + channel] - below.data[to + channel]);
      }
    }
  }
}

/** @param {string} name @returns {Pixels} */
export function readJpeg(name) {
  const { width, height, data } = jpeg.decode(readFileSync(join(root, "www", "images", name)), { useTArray: true });
  return { width, height, data: new Uint8ClampedArray(data) };
}

/** @param {string} name @param {Pixels} pixels */
export function save(name, { width, height, data }) {
  const docs = join(root, "docs");
  mkdirSync(docs, { recursive: true });
  const { data: bytes } = jpeg.encode({ width, height, data: Buffer.from(data.buffer) }, 84);
  writeFileSync(join(docs, name), bytes);
}
