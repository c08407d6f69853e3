// Square pictures, which tile the plane alike both ways: photos cropped, and a drawn lattice.

import { loadPicture } from "../common/images.js";
import { photoFrame } from "../common/frame.js";

/** @typedef {import("../common/images.js").Picture} Picture */

const LATTICE_SIZE = 768;
const LATTICE_CELLS = 8;

/** A picture by id, as a square. @param {string} id @returns {Promise<Picture>} */
export async function loadSquare(id) {
  return id === "lattice" ? drawLattice() : cropped(await loadPicture(id));
}

/** The middle of a picture. @param {Picture} picture @returns {Picture} */
export function cropped({ id, title, canvas }) {
  const side = Math.min(canvas.width, canvas.height);
  const [x, y] = [(canvas.width - side) / 2, (canvas.height - side) / 2];
  return drawn(id, title, side, (context) => context.drawImage(canvas, x, y, side, side, 0, 0, side, side));
}

/** Coloured cells between dark lines: each place is known by its colour. @returns {Picture} */
function drawLattice() {
  const cell = LATTICE_SIZE / LATTICE_CELLS;
  return drawn("lattice", "Lattice", LATTICE_SIZE, (context) => {
    for (let i = 0; i < LATTICE_CELLS; i++) {
      for (let j = 0; j < LATTICE_CELLS; j++) {
        const turns = Math.atan2(LATTICE_CELLS / 2 - j - 0.5, i + 0.5 - LATTICE_CELLS / 2) / (2 * Math.PI);
        const light = (i + j) % 2 ? 0.86 : 0.93;
        context.fillStyle = `oklch(${light} 0.09 ${360 * turns})`;
        context.fillRect(i * cell, j * cell, cell, cell);
      }
    }
    context.strokeStyle = "#27304f";
    for (let k = 0; k <= LATTICE_CELLS; k++) {
      context.lineWidth = k === LATTICE_CELLS / 2 ? cell / 9 : cell / 18;
      context.stroke(new Path2D(`M${k * cell} 0V${LATTICE_SIZE}M0 ${k * cell}H${LATTICE_SIZE}`));
    }
  });
}

/** @param {string} id @param {string} title @param {number} side @param {(context: CanvasRenderingContext2D) => void} draw @returns {Picture} */
function drawn(id, title, side, draw) {
  const canvas = Object.assign(document.createElement("canvas"), { width: side, height: side });
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("This browser gives no 2d canvas.");
  draw(context);
  return { id, title, canvas, pixels: context.getImageData(0, 0, side, side).data, frame: photoFrame(side, side) };
}
