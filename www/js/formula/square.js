// Square pictures, which tile the plane alike both ways: photos cropped, and a drawn lattice.

import { drawnCanvas } from "../common/canvas.js";
import { photoFrame } from "../common/frame.js";
import { loadPicture } from "../common/images.js";
import { drawLattice } from "../common/lattice.js";

/** @typedef {import("../common/images.js").Picture} Picture */

const LATTICE_SIZE = 768;

/** A picture by id, as a square. @param {string} id @returns {Promise<Picture>} */
export async function loadSquare(id) {
  return id === "lattice" ? lattice(id) : cropped(await loadPicture(id));
}

/** The middle of a picture. @param {Picture} picture @returns {Picture} */
export function cropped({ id, title, canvas, file, fullSize }) {
  const side = Math.min(canvas.width, canvas.height);
  const [x, y] = [(canvas.width - side) / 2, (canvas.height - side) / 2];
  return { id, title, ...drawnCanvas([side, side], (context) => context.drawImage(canvas, x, y, side, side, 0, 0, side, side)), frame: photoFrame(side, side), ...(file && fullSize && { file, fullSize: /** @type {[number, number]} */ ([Math.min(...fullSize), Math.min(...fullSize)]) }) };
}

/** The lattice, in the place of a picture of that id. @param {string} id @returns {Picture} */
export function lattice(id) {
  const size = /** @type {[number, number]} */ ([LATTICE_SIZE, LATTICE_SIZE]);
  return { id, title: "Lattice", ...drawnCanvas(size, (context) => drawLattice(context, size)), frame: photoFrame(...size) };
}
