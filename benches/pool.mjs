// Pictures drawn by 1, 2 and 4 workers, beside one thread without a pool.

import { availableParallelism } from "node:os";
import { FormulaMap, Texture } from "conformal-warp";
import { createPool } from "conformal-warp/pool";
import { picture } from "./lib/pictures.mjs";
import { Table, ms, ratio } from "./lib/table.mjs";
import { inTurns, millisecondsOf } from "./lib/timing.mjs";

export default async function bench() {
  const image = picture(1024);
  const frame = /** @type {import("./lib/pictures.mjs").Frame} */ ({ center: [0, 0], width: 4, pixels: [2048, 2048] });
  const options = { texture: { ...frame, pixels: /** @type {[number, number]} */ ([1024, 1024]) }, view: frame, quality: /** @type {const} */ ("best") };
  const table = new Table(`z² in the best quality, 2048², by a pool on ${availableParallelism()} cores`, { workers: 14, time: 9, "against one thread": 18 });
  const alone = { map: new FormulaMap("z^2"), texture: new Texture(image.data, 1024, 1024, { wrap: "repeat" }) };
  const { ours } = inTurns({ ours: () => alone.map.warp(alone.texture, options) }, 5);
  table.row("none", ms(ours), ratio(1));
  alone.map.free();
  alone.texture.free();
  for (const workers of [1, 2, 4]) {
    const pool = await createPool({ workers });
    const [map, texture] = [new pool.FormulaMap("z^2"), new pool.Texture(image.data, 1024, 1024, { wrap: "repeat" })];
    const time = await millisecondsOf(() => map.warp(texture, options));
    table.row(workers, ms(time), ratio(time / ours));
    pool.close();
  }
}
