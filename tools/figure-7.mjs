// node tools/figure-7.mjs: the README's picture of a scene as the visual cortex receives it, docs/figure-7.jpg.
// The package must be built (npm run build).

import init, { FoveatedTexture, Region, RetinoCorticalMap, RiemannMap } from "conformal-warp";
import { readJpeg, save, sheet } from "./pictures.mjs";
import { main, step } from "./steps.mjs";

/** @typedef {import("./pictures.mjs").Pixels} Pixels */

/** Human V1 as a dipole (k, a, b of Polimeni 2006), scaled to the mean area that was measured. */
const MODEL = { k: 15, a: 0.69, b: 80, area: 2643 };
const PICTURE = { center: /** @type {[number, number]} */ ([0, 0]), width: 2 };
/** Pixels of a hemisphere. */
const SIZE = /** @type {[number, number]} */ ([600, 350]);
/** Between the eyes. */
const FIXATION = /** @type {[number, number]} */ ([-0.125, 0.6]);
const FIELD_OF_VIEW = 80;
/** The blind spot, 15° temporal and 1.5° below, and a point a little further out. */
const BLIND_SPOT = [15, -1.5, 15.001, -1.5];
/** Eccentricities of the rings, in degrees. */
const RINGS = [1, 2, 5, 10, 20, 40];
/** Of outlines, and of lines over nothing. */
const DARK = [90, 90, 110];

await main(async () => {
  await init();
  const photo = readJpeg("astronaut.jpg");
  const picture = { ...PICTURE, pixels: /** @type {[number, number]} */ ([photo.width, photo.height]) };
  const foveated = await step("foveated texture", (note) => {
    const texture = new FoveatedTexture(photo.data, { picture, fixation: FIXATION, side: 128 });
    note(`${texture.levels} levels`);
    return texture;
  });
  const outline = await step("Symm's map of the outline", (note) => solveOutline(note));
  await step("both hemispheres", () => {
    const [right, left] = /** @type {const} */ (["right", "left"]).map((hemisphere) => {
      const { map, boundary, direction } = outline;
      const cortex = RetinoCorticalMap.outline(map, { direction, hemisphere });
      const seen = cortex.seeing({ picture, fieldOfView: FIELD_OF_VIEW, fixation: FIXATION });
      const side = hemisphere === "left" ? 1 : -1;
      const view = { center: /** @type {[number, number]} */ ([side * 43, 0]), width: 90, pixels: SIZE };
      const data = seen.warpFoveated(foveated, { texture: picture, view, quality: "best" });
      const pixels = { width: SIZE[0], height: SIZE[1], data };
      const closed = Float64Array.of(...boundary, boundary[0], boundary[1]);
      for (const eccentricity of RINGS) {
        stroke(pixels, view, cortex.toCortex(ring(eccentricity, side)));
        stroke(photo, picture, seen.toPicture(cortex.toCortex(ring(eccentricity, side))));
      }
      for (const azimuth of [-90, -45, 0, 45, 90]) {
        stroke(pixels, view, cortex.toCortex(ray(azimuth, side)));
        stroke(photo, picture, seen.toPicture(cortex.toCortex(ray(azimuth, side))));
      }
      stroke(pixels, view, closed.map((x, k) => (k % 2 === 0 ? side * x : x)), DARK);
      return pixels;
    });
    save("figure-7.jpg", sheet([right, photo, left], 3));
  });
});

/** A point of the field in degrees → the stereographic half disk, its radius taken for 90. @param {number[]} point */
function onDisk([x, y]) {
  const e = Math.hypot(x, y);
  const scale = (90 * Math.tan((e * Math.PI) / 360)) / e;
  return [x * scale, y * scale];
}

/**
 * Symm's map of a left hemisphere's outline, and the direction of the horizontal meridian at the blind spot. That lies where
 * the corners of the field go to the outline's: the dipole of the half disk has both there.
 *
 * @param {(text: string) => void} note
 */
function solveOutline(note) {
  const model = RetinoCorticalMap.model(MODEL);
  const [x, y, ahead, up] = model.toCortex(new Float64Array([...onDisk(BLIND_SPOT.slice(0, 2)), ...onDisk(BLIND_SPOT.slice(2))]));
  const boundary = RetinoCorticalMap.modelOutline(MODEL, 400);
  const map = RiemannMap.solve(new Region({ boundary, center: [x, y], toward: [boundary[0], boundary[1]] }));
  note(`${map.unknowns} unknowns, error ${map.errorEstimate.toExponential(0)}`);
  return { map, boundary, direction: Math.atan2(up - y, ahead - x) };
}

/**
 * A half ring of the visual field, in degrees.
 *
 * @param {number} eccentricity
 * @param {number} side 1 on the right, −1 on the left
 */
function ring(eccentricity, side) {
  const angles = Array.from({ length: 181 }, (_, k) => ((k - 90) * Math.PI) / 180);
  return new Float64Array(angles.flatMap((a) => [side * eccentricity * Math.cos(a), eccentricity * Math.sin(a)]));
}

/**
 * A ray of the visual field from the fovea to its edge.
 *
 * @param {number} azimuth in degrees from the horizontal
 * @param {number} side
 */
function ray(azimuth, side) {
  const a = (azimuth * Math.PI) / 180;
  const radii = Array.from({ length: 200 }, (_, k) => 0.01 * 8999 ** (k / 199));
  return new Float64Array(radii.flatMap((r) => [side * r * Math.max(0, Math.cos(a)), r * Math.sin(a)]));
}

/**
 * Draws a line of points given in the plane.
 *
 * @param {Pixels} pixels
 * @param {{ center: [number, number], width: number, pixels: [number, number] }} frame
 * @param {Float64Array} points
 * @param {number[]} [color]
 */
function stroke(pixels, frame, points, color = [255, 255, 255]) {
  const size = frame.width / frame.pixels[0];
  const column = (/** @type {number} */ k) => (points[k] - frame.center[0]) / size + frame.pixels[0] / 2 - 0.5;
  const row = (/** @type {number} */ k) => frame.pixels[1] / 2 - (points[k + 1] - frame.center[1]) / size - 0.5;
  /** @type {Map<number, number>} */
  const cover = new Map();
  for (let k = 0; k + 3 < points.length; k += 2) {
    const [x0, y0, x1, y1] = [column(k), row(k), column(k + 2), row(k + 2)];
    const steps = Math.ceil(3 * Math.hypot(x1 - x0, y1 - y0));
    for (let i = 0; i <= steps; i++) dot(cover, pixels, x0 + ((x1 - x0) * i) / steps, y0 + ((y1 - y0) * i) / steps);
  }
  for (const [at, share] of cover) {
    const opacity = 0.75 * share;
    // Where nothing is drawn yet, white would not be seen, and the line's colour counts alone.
    const empty = pixels.data[at + 3] === 0;
    const [weight, drawn] = empty ? [1, DARK] : [opacity, color];
    for (let channel = 0; channel < 3; channel++) {
      pixels.data[at + channel] += weight * (drawn[channel] - pixels.data[at + channel]);
    }
    pixels.data[at + 3] = Math.max(pixels.data[at + 3], 255 * opacity);
  }
}

/**
 * Covers the pixels around a point, at most fully.
 *
 * @param {Map<number, number>} cover
 * @param {Pixels} pixels
 * @param {number} x
 * @param {number} y
 */
function dot(cover, { width, height }, x, y) {
  for (let row = Math.ceil(y - 1); row <= y + 1; row++) {
    for (let column = Math.ceil(x - 1); column <= x + 1; column++) {
      if (row < 0 || column < 0 || row >= height || column >= width) continue;
      const at = 4 * (row * width + column);
      const share = Math.max(0, 1.1 - Math.hypot(column - x, row - y));
      cover.set(at, Math.min(1, Math.max(cover.get(at) ?? 0, share)));
    }
  }
}
