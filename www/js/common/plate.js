// What is given away of a page, made in a worker: a picture of any size as a PNG file, band by band, or its lines as an SVG file.

import { imageOf, offscreen, SPACE } from "./colours.js";
import { onGrid, scaleOf, toPixels } from "./frame.js";
import { drawLayers, svgFile } from "./layers.js";
import { PngWriter } from "./png.js";

/** @typedef {import("./frame.js").Frame} Frame */
/** @typedef {import("./frame.js").Point} Point */
/** @typedef {import("./layers.js").Layer} Layer */
/** @typedef {{ name: string, frame: Frame, layers: Layer[] }} Panel */
/**
 * A picture that can be drawn in bands, and its lines.
 * @typedef {object} Plate
 * @property {Frame} frame of the picture
 * @property {number} band rows that are drawn at once
 * @property {(rows: [number, number]) => Uint8ClampedArray} draw RGBA
 * @property {((rows: [number, number]) => Uint8ClampedArray) | null} [tint] colours over it, with the lines
 * @property {{ picture: CanvasImageSource, frame: Frame }} [behind] what lies under the picture
 * @property {PredefinedColorSpace} [space] of what is drawn, if not that of photos
 * @property {Panel[]} panels the lines of the picture's plane last
 * @property {() => void} free
 */
/** Rows that are usually drawn at once. */
export const BAND = 256;

/** What is wanted: `density` pixels of the picture stand for one of the panel. @typedef {{ kind: "picture" | "drawing", lines: boolean, density: number, title: string }} Wanted */

/** A picture's file is read at so many pixels at most. */
const MOST_PIXELS = 6e7;

/** Its bytes as a file. @param {Plate} plate @param {Wanted} wanted @param {(share: number) => void} onShare @returns {Promise<Blob>} */
export async function fileOf(plate, { kind, lines, density, title }, onShare) {
  if (kind === "drawing") return new Blob([svgFile(plate.panels, title)], { type: "image/svg+xml" });
  const { frame, band } = plate;
  const [width, height] = frame.pixels;
  const png = new PngWriter([width, height], plate.space ?? SPACE);
  const layers = (lines && plate.panels.at(-1)?.layers) || [];
  const tint = lines && plate.tint;
  for (let row = 0; row < height; row += band) {
    /** @type {[number, number]} */
    const rows = [row, Math.min(height, row + band)];
    const pixels = plate.draw(rows);
    const bands = [pixels, ...(tint ? [tint(rows)] : [])];
    await png.write(layers.length || bands.length > 1 || plate.behind ? composed(plate, bands, rows, layers, density) : pixels);
    onShare(rows[1] / height);
  }
  return png.end();
}

/** Bands over what lies under them, and lines over them. @param {Plate} plate @param {Uint8ClampedArray[]} bands @param {[number, number]} rows @param {Layer[]} layers @param {number} density */
function composed({ frame, behind, space }, bands, [from, to], layers, density) {
  const [width, height] = [frame.pixels[0], to - from];
  const context = offscreen(width, height, space);
  if (behind) {
    const { center, width: across, pixels } = behind.frame;
    const ratio = pixels[1] / pixels[0];
    const [left, top] = toPixels(frame, [center[0] - across / 2, center[1] + (across * ratio) / 2]);
    const side = across * scaleOf(frame);
    context.imageSmoothingQuality = "high";
    context.drawImage(behind.picture, left, top - from, side, side * ratio);
  }
  for (const pixels of bands) {
    const band = offscreen(width, height, space);
    band.putImageData(imageOf(pixels, width, height, space), 0, 0);
    context.drawImage(band.canvas, 0, 0);
  }
  context.translate(0, -from);
  drawLayers({ context, frame, density }, layers);
  return context.getImageData(0, 0, width, height).data;
}

/** @typedef {import("./serve.js").PictureMessage} PictureMessage */

/** A picture as large as its file has it, cut to the shape of its frame about the middle. @param {PictureMessage} picture @returns {Promise<PictureMessage>} */
export async function inFull({ pixels, frame, file }) {
  const bitmap = file && (await createImageBitmap(file, { imageOrientation: "from-image" }).catch(() => null));
  if (!bitmap) return { pixels, frame };
  const ratio = frame.pixels[0] / frame.pixels[1];
  const [across, down] = [Math.min(bitmap.width, bitmap.height * ratio), Math.min(bitmap.height, bitmap.width / ratio)];
  const scale = Math.min(1, Math.sqrt(MOST_PIXELS / (across * down)));
  const [width, height] = [across, down].map((side) => Math.max(1, Math.round(side * scale)));
  const context = offscreen(width, height);
  context.imageSmoothingQuality = "high";
  context.drawImage(bitmap, (bitmap.width - across) / 2, (bitmap.height - down) / 2, across, down, 0, 0, width, height);
  bitmap.close();
  return { pixels: context.getImageData(0, 0, width, height).data, frame: onGrid(frame, [width, height]) };
}

/** A picture to be drawn from. @param {PictureMessage} picture @returns {Promise<ImageBitmap>} */
export const bitmapOf = ({ pixels, frame, file }) =>
  createImageBitmap(file ?? imageOf(pixels, ...frame.pixels), { imageOrientation: "from-image" });
