// Formulas as warps, beside OpenCV.js looking up the same map, which is computed for it beforehand.

import { FormulaMap, Texture } from "conformal-warp";
import { remapper } from "./lib/opencv.mjs";
import { coordinates, picture } from "./lib/pictures.mjs";
import { Table, Target, ms, ratio } from "./lib/table.mjs";
import { inTurns } from "./lib/timing.mjs";

const formulas = ["z^2", "log(z)", "cos(z)", "((z^2 + 1)(z - 2i)/(z + 3) + sin(z)/(z^3 - 4i) + exp(z/2)/4)/2"];
/** At most this share of OpenCV's time. */
const shares = /** @type {const} */ ({ bilinear: 0.5, trilinear: 0.7, best: 2.5 });

export default async function bench() {
  const image = picture(1024);
  const texture = new Texture(image.data, image.width, image.height, { wrap: "repeat" });
  const around = /** @type {import("./lib/pictures.mjs").Frame} */ ({ center: [0, 0], width: 4, pixels: [1024, 1024] });
  const table = new Table("Warp by a formula from a 1024² picture, OpenCV.js 4.12 remap (bilinear, float map) in turns", {
    output: 6, formula: 8, quality: 9, time: 8, "per megapixel": 13, OpenCV: 8, "against OpenCV": 18,
  });
  /** @type {Record<string, number[]>} */
  const times = {};
  for (const size of [1024, 2048]) {
    const view = { ...around, pixels: /** @type {[number, number]} */ ([size, size]) };
    const out = new Uint8ClampedArray(4 * size * size);
    for (const text of formulas) {
      const map = new FormulaMap(text);
      const peer = await remapper(image, size, size, coordinates(view, around, (points) => map.eval(points)), "BORDER_WRAP");
      for (const [quality, share] of /** @type {[keyof typeof shares, number][]} */ (Object.entries(shares))) {
        const time = inTurns({ ours: () => map.warp(texture, { texture: around, view, quality, out }), peer: peer.draw });
        const name = text.length > 8 ? "20 nodes" : text;
        const against = new Target(time.ours / time.peer, share, ratio);
        table.row(`${size}²`, name, quality, ms(time.ours), ms((time.ours * 1e6) / size ** 2), ms(time.peer), against);
        (times[`${size}² ${quality}`] ??= []).push(time.ours);
      }
      peer.free();
      map.free();
    }
  }
  texture.free();

  const alike = new Table("The slowest formula against the fastest", { output: 16, ratio: 18 });
  for (const [name, list] of Object.entries(times)) {
    alike.row(name, new Target(Math.max(...list) / Math.min(...list), 1.5, ratio));
  }
}
