// Photos: those of the page by name, a visitor's own from a file; decoded once, scaled down where too large.

import { drawnCanvas } from "./canvas.js";
import { photoFrame } from "./frame.js";
import { drawLattice } from "./lattice.js";
import { forgetPhotos, keepPhoto, keptPhotos } from "./kept.js";
import { photos } from "./photos.js";

/**
 * @typedef {object} Picture
 * @property {string} id
 * @property {string} title
 * @property {HTMLCanvasElement} canvas what is drawn under the region
 * @property {Uint8ClampedArray} pixels RGBA, what is warped
 * @property {import("./frame.js").Frame} frame
 * @property {Blob} [file] the picture itself, where it is larger than what is kept
 * @property {[number, number]} [fullSize] pixels of the file, where it is larger
 */

/** The longest side that is kept: beyond it a screen shows no more. */
const LONGEST = 2048;
/** The longest side of a drawing that names no size, or a small one. */
const DRAWING = 1024;

/** @type {Map<string, Promise<Picture>>} */
const pictures = new Map();

/** A visitor's own photos that this browser keeps. @type {Map<string, import("./kept.js").Kept>} */
const own = new Map((await keptPhotos()).map((photo) => [photo.id, photo]));

/** Ids and titles of the visitor's own photos. */
export const ownPictures = () => [...own.values()].map(({ id, title }) => ({ id, title }));

/** A visitor's own photo as it came; undefined for others. @param {string} id */
export const ownFile = (id) => own.get(id);

/** Forgets the visitor's own photos; one that is shown stays. */
export async function forgetOwn() {
  await forgetPhotos();
  for (const id of own.keys()) pictures.delete(id);
  own.clear();
  window.dispatchEvent(new Event("own-pictures"));
}

/** Whether there is a picture of that id, loaded or not. @param {string} id */
export const knowsPicture = (id) => photos.has(id) || pictures.has(id) || own.has(id);

/** A picture by id, loaded once; the error says in words what is wrong. @param {string} id @returns {Promise<Picture>} */
export function loadPicture(id) {
  const known = pictures.get(id);
  if (known) return known;
  const photo = photos.get(id);
  const mine = own.get(id);
  if (!photo && !mine) return Promise.reject(new Error(`There is no picture named “${id}”.`));
  const loading = photo ? fetchPhoto(id, photo) : decodePicture(id, mine?.title ?? "", mine?.blob ?? new Blob());
  loading.catch(() => pictures.delete(id));
  pictures.set(id, loading);
  return loading;
}

/** @param {string} id @param {import("./photos.js").Photo} photo */
async function fetchPhoto(id, { title, file }) {
  const address = new URL(`../../images/${file}`, import.meta.url);
  const response = await fetch(address).catch(() => {
    throw new Error(`The photo “${title}” could not be loaded: the connection failed. Choose it again to try once more.`);
  });
  if (!response.ok) throw new Error(`The photo “${title}” could not be loaded: the server answered ${response.status}. Choose it again to try once more.`);
  return decodePicture(id, title, await response.blob());
}

/**
 * What stands in for a photo that cannot be loaded: a lattice of its size, so that all else goes on.
 * @param {string} id @returns {Picture}
 */
export function standIn(id) {
  const { title = "Picture", size = /** @type {[number, number]} */ ([512, 512]) } = photos.get(id) ?? {};
  return { id, title, ...drawnCanvas(size, (context) => drawLattice(context, size)), frame: photoFrame(...size) };
}

/** A visitor's file, under an id of its own. @param {Blob} file @returns {Promise<Picture>} */
export async function addPicture(file) {
  const name = file instanceof File ? file.name : "Pasted picture";
  if (/hei[cf]$/i.test(file.type) || /\.hei[cf]$/i.test(name)) {
    throw new Error(`“${name}” is an HEIC photo, which this browser cannot read. Save it as JPEG or PNG first.`);
  }
  // Nobody else's photo has this id: a link to it that comes from elsewhere is told from one's own.
  const id = `own-${crypto.getRandomValues(new Uint32Array(2)).join("")}`;
  const picture = await decodePicture(id, name, file).catch(() => {
    throw new Error(`“${name}” could not be read as a picture. Try a JPEG, PNG, WebP or SVG file.`);
  });
  pictures.set(id, Promise.resolve(picture));
  own.set(id, { id, title: name, blob: file });
  await keepPhoto({ id, title: name, blob: file });
  window.dispatchEvent(new Event("own-pictures"));
  return picture;
}

/** @param {string} id @param {string} title @param {Blob} blob @returns {Promise<Picture>} */
async function decodePicture(id, title, blob) {
  const { image, size, close } = await (/svg/.test(blob.type) ? decodeDrawing(blob) : decodePhoto(blob));
  const scale = Math.min(1, LONGEST / Math.max(...size));
  const [width, height] = size.map((side) => Math.max(1, Math.round(side * scale)));
  const drawn = drawnCanvas([width, height], (context) => context.drawImage(image, 0, 0, width, height));
  close();
  return { id, title, ...drawn, frame: photoFrame(width, height), ...(scale < 1 && { file: blob, fullSize: size }) };
}

/** @typedef {{ image: CanvasImageSource, size: [number, number], close: () => void }} Decoded */

/** @param {Blob} blob @returns {Promise<Decoded>} */
async function decodePhoto(blob) {
  const image = await createImageBitmap(blob, { imageOrientation: "from-image" });
  return { image, size: [image.width, image.height], close: () => image.close() };
}

/** An SVG file, as an image: no script in it runs. @param {Blob} blob @returns {Promise<Decoded>} */
async function decodeDrawing(blob) {
  const image = new Image();
  image.src = URL.createObjectURL(blob);
  await image.decode();
  const [width, height] = [image.naturalWidth || DRAWING, image.naturalHeight || DRAWING];
  const scale = Math.max(1, DRAWING / Math.max(width, height));
  return { image, size: [width * scale, height * scale], close: () => URL.revokeObjectURL(image.src) };
}
