// A webcam's frame as both hemispheres of V1 receive it: map built, a new picture every time.

import { RetinoCorticalMap, Texture } from "conformal-warp";
import { picture } from "./lib/pictures.mjs";
import { Table, Target, ms } from "./lib/table.mjs";
import { milliseconds } from "./lib/timing.mjs";

/** @typedef {import("./lib/pictures.mjs").Frame} Frame */

const [columns, rows] = [640, 480];
/** @type {Frame} */
const around = { center: [0, 0], width: 4 / 3, pixels: [columns, rows] };

export default async function bench() {
  const { data } = picture(columns);
  const frame = data.subarray(0, 4 * columns * rows);
  const eyes = /** @type {const} */ (["left", "right"]).map((hemisphere) => {
    // Polimeni 2006: k = 15 mm, a = 0.69°, b = 80°.
    const map = RetinoCorticalMap.model({ k: 15, a: 0.69, b: 80, hemisphere });
    const image = map.seeing({ picture: around, fieldOfView: 60, fixation: [0, 0] });
    /** @type {Frame} */
    const view = { center: [hemisphere === "left" ? 32 : -32, 0], width: 70, pixels: [512, 512] };
    return { image, view, out: new Uint8ClampedArray(4 * 512 * 512) };
  });
  const table = new Table("Cortex: 640 × 480 → both hemispheres at 512² each", { step: 34, time: 22 });
  const texture = new Texture(frame, columns, rows);
  const draw = (/** @type {Texture} */ from) => {
    for (const { image, view, out } of eyes) image.warp(from, { texture: around, view, out, quality: "trilinear" });
  };
  table.row("the texture alone", ms(milliseconds(() => new Texture(frame, columns, rows).free())));
  table.row("the pictures alone, trilinear", ms(milliseconds(() => draw(texture))));
  const whole = milliseconds(() => {
    const fresh = new Texture(frame, columns, rows);
    draw(fresh);
    fresh.free();
  });
  table.row("the whole frame", new Target(whole, 25, ms));
  texture.free();
}
