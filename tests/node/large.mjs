// Pictures of 100 megapixels: what the module's memory grows to, which it never gives back.

import assert from "node:assert/strict";
import { test } from "node:test";
import init, { FormulaMap, FoveatedTexture, Texture } from "conformal-warp";

const [width, height] = [12_000, 8_400];
const rgba = new Uint8ClampedArray(4 * width * height);
const frame = { center: /** @type {[number, number]} */ ([0, 0]), width: 2, pixels: /** @type {[number, number]} */ ([width, height]) };
const megabytes = async () => (await init()).memory.buffer.byteLength / 1e6;

// Opaque, but for what nobody has painted; a mark in the last row.
new Uint32Array(rgba.buffer, 0, width * (height - 1)).fill(0xff604020);
rgba.set([1, 2, 3, 255], rgba.length - 4);

test("levels of a foveated picture take 22 MB, and the module little more", async () => {
  await init();
  const stack = new FoveatedTexture(rgba, { picture: frame, fixation: [1, -0.7], side: 896 });
  assert.ok(stack.bytes < 23e6, `${stack.bytes} bytes`);
  const most = await megabytes();
  assert.ok(most < 40, `${most} MB`);
  stack.free();
});

test("a texture, a warp from it and another picture in its place take less than 0.6 GB", async () => {
  const texture = new Texture(rgba, width, height);
  const view = { ...frame, pixels: /** @type {[number, number]} */ ([600, 420]) };
  const whole = new FormulaMap("z").warp(texture, { texture: frame, view, quality: "trilinear" });
  const middle = 4 * (600 * 210 + 300);
  assert.deepEqual([...whole.subarray(middle, middle + 4)], [0x20, 0x40, 0x60, 255]);
  // The lower right corner, texel by texel.
  const corner = { center: /** @type {[number, number]} */ ([1 - 1 / 12_000, -0.7 + 1 / 12_000]), width: 2 / 12_000, pixels: /** @type {[number, number]} */ ([1, 1]) };
  const last = new FormulaMap("z").warp(texture, { texture: frame, view: corner, quality: "nearest" });
  assert.deepEqual([...last], [1, 2, 3, 255]);
  texture.replace(rgba);
  const other = Texture.fromImageData({ data: rgba.subarray(0, 4 * width), width, height: 1 });
  assert.deepEqual(other.size, [width, 1]);
  const most = await megabytes();
  assert.ok(most < 600, `${most} MB`);
  for (const made of [texture, other]) made.free();
});
