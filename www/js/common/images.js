// Photos: those of the page by name, a visitor's own from a file; decoded once, scaled down where too large.

import { photoFrame } from "./frame.js";
import { photos } from "./photos.js";

/**
 * @typedef {object} Picture
 * @property {string} id
 * @property {string} title
 * @property {HTMLCanvasElement} canvas what is drawn under the region
 * @property {Uint8ClampedArray} pixels RGBA, what is warped
 * @property {import("./frame.js").Frame} frame
 * @property {Blob} [file] the picture itself, where it is larger than what is kept
 */

/** The longest side that is kept: beyond it a screen shows no more. */
const LONGEST = 2048;

/** @type {Map<string, Promise<Picture>>} */
const pictures = new Map();

/** A picture by id, loaded once. @param {string} id @returns {Promise<Picture>} */
export function loadPicture(id) {
  const known = pictures.get(id);
  if (known) return known;
  const photo = photos[id];
  if (!photo) return Promise.reject(new Error(`There is no picture named “${id}”.`));
  const loading = fetch(new URL(`../../images/${photo.file}`, import.meta.url))
    .then((response) => response.blob())
    .then((blob) => decodePicture(id, photo.title, blob));
  loading.catch(() => pictures.delete(id));
  pictures.set(id, loading);
  return loading;
}

let ownCount = 0;

/** A visitor's file, under an id of its own. @param {Blob} file @returns {Promise<Picture>} */
export async function addPicture(file) {
  const id = `own-${++ownCount}`;
  const name = file instanceof File ? file.name : "Pasted picture";
  const picture = await decodePicture(id, name, file).catch(() => {
    throw new Error(`“${name}” could not be read as a picture. Try a JPEG, PNG or WebP file.`);
  });
  pictures.set(id, Promise.resolve(picture));
  return picture;
}

/** @param {string} id @param {string} title @param {Blob} blob @returns {Promise<Picture>} */
async function decodePicture(id, title, blob) {
  const bitmap = await createImageBitmap(blob, { imageOrientation: "from-image" });
  const scale = Math.min(1, LONGEST / Math.max(bitmap.width, bitmap.height));
  const canvas = document.createElement("canvas");
  canvas.width = Math.max(1, Math.round(bitmap.width * scale));
  canvas.height = Math.max(1, Math.round(bitmap.height * scale));
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("This browser gives no 2d canvas.");
  context.imageSmoothingQuality = "high";
  context.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
  bitmap.close();
  const pixels = context.getImageData(0, 0, canvas.width, canvas.height).data;
  return { id, title, canvas, pixels, frame: photoFrame(canvas.width, canvas.height), ...(scale < 1 && { file: blob }) };
}
