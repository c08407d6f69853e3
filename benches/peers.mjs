// The same pictures by other libraries in one run: time, and how near each comes to what a picture should be.

import { FormulaMap, Texture } from "conformal-warp";
import { ewa } from "./lib/magick.mjs";
import { affine, remapper } from "./lib/opencv.mjs";
import { coordinates, picture } from "./lib/pictures.mjs";
import { averaged, decibels } from "./lib/quality.mjs";
import { Table, decibel, ms } from "./lib/table.mjs";
import { inTurns } from "./lib/timing.mjs";
import { mapim } from "./lib/vips.mjs";

/** @typedef {{ name: string, draw(): ArrayLike<number> | void, pixels?(): ArrayLike<number>, free?(): void }} Rival */

const SIZE = 512;
const ANGLE = 0.35;
const cases = [
  { title: "shrunk to a third and turned", formula: `3 e^(${ANGLE} i) z`, view: 0.5, scale: 3 },
  { title: "enlarged 2.5 times and turned", formula: `0.4 e^(${ANGLE} i) z`, view: 0.5, scale: 0.4 },
  { title: "z²/2, shrunk up to 6 times", formula: "z^2/2", view: 2 },
];

export default async function bench() {
  const image = picture(2048);
  const texture = new Texture(image.data, image.width, image.height, { wrap: "clamp", light: "plain" });
  const around = /** @type {import("./lib/pictures.mjs").Frame} */ ({ center: [0, 0], width: 2, pixels: [2048, 2048] });
  for (const { title, formula, view: width, scale } of cases) {
    const view = /** @type {import("./lib/pictures.mjs").Frame} */ ({ ...around, width, pixels: [SIZE, SIZE] });
    const map = new FormulaMap(formula);
    const truth = averaged(map, texture, around, view);
    const out = new Uint8ClampedArray(4 * SIZE * SIZE);
    const places = coordinates(view, around, (points) => map.eval(points));
    const table = new Table(`A picture of 2048², ${title}, ${SIZE}²: milliseconds, and dB against the mean of 256 samples a pixel`, {
      "who, how": 46, time: 9, "per megapixel": 13, PSNR: 8,
    });
    /** @type {Rival[]} */
    const rivals = /** @type {const} */ (["bilinear", "trilinear", "best"]).map((quality) => ({
      name: `conformal-warp, ${quality}`,
      draw: () => map.warp(texture, { texture: around, view, quality, out }),
    }));
    rivals.push({ name: "OpenCV.js 4.12 remap, bilinear, map given", ...(await remapper(image, SIZE, SIZE, places)) });
    if (scale !== undefined) {
      // Texels for each pixel of the view.
      const texels = scale * (view.width / SIZE) * (around.pixels[0] / around.width);
      rivals.push({ name: "OpenCV.js 4.12 warpAffine, bilinear", ...(await affine(image, SIZE, texels, ANGLE)) });
      rivals.push({ name: "OpenCV.js 4.12 warpPerspective, bilinear", ...(await affine(image, SIZE, texels, ANGLE, true)) });
      rivals.push({ name: "ImageMagick (magick-wasm) distort, EWA", ...(await ewa(image, SIZE, texels, ANGLE)) });
    }
    for (const kernel of ["bilinear", "bicubic", "lbb"]) {
      rivals.push({ name: `wasm-vips mapim, ${kernel}, map given`, ...(await mapim(image, SIZE, SIZE, places, kernel)) });
    }
    const source = new Uint8ClampedArray(4 * SIZE * SIZE);
    rivals.push({ name: "copying as many bytes (the floor)", draw: () => void out.set(source) });
    const times = inTurns(Object.fromEntries(rivals.map(({ name, draw }) => [name, draw])), 5);
    for (const { name, draw, pixels, free } of rivals) {
      const drawn = name.startsWith("copying") ? undefined : (pixels?.() ?? /** @type {ArrayLike<number>} */ (draw()));
      table.row(name, ms(times[name]), ms((times[name] * 1e6) / SIZE ** 2), drawn ? decibel(decibels(drawn, truth)) : "–");
      free?.();
    }
    map.free();
  }
  texture.free();
}
