// A webcam's frame as both hemispheres of V1 receive it: map and geometry built, a new picture every time.

import { FoveatedTexture, RetinoCorticalMap, Texture } from "conformal-warp";
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
  const table = new Table("Cortex: 640 × 480 → both hemispheres at 512² each", { step: 44, time: 22 });
  const texture = new Texture(frame, columns, rows);
  const prepared = eyes.map(({ image, view }) => image.prepareWarp(texture, { texture: around, view }));
  const draw = () => prepared.forEach((warp, k) => warp.warp(texture, eyes[k].out));
  table.row("the geometry, once for a view and a gaze", ms(milliseconds(() => {
    for (const { image, view } of eyes) image.prepareWarp(texture, { texture: around, view }).free();
  })));
  table.row("a frame: the texture alone", ms(milliseconds(() => texture.replace(frame))));
  table.row("a frame: the pictures alone, trilinear", ms(milliseconds(draw)));
  const whole = milliseconds(() => {
    texture.replace(frame);
    draw();
  });
  table.row("a frame", new Target(whole, 25, ms));
  const stack = new FoveatedTexture(frame, { picture: around, fixation: [0, 0], side: 128 });
  const foveated = eyes.map(({ image, view }) => image.prepareFoveated(stack, { texture: around, view }));
  table.row(`a stack of ${stack.levels} levels of 128²`, ms(milliseconds(() => {
    foveated.forEach((warp, k) => warp.warpFoveated(stack, eyes[k].out));
  })));
}
