// What a TypeScript project in a browser writes.
import { FormulaMap, Texture } from "conformal-warp";
const canvas = document.createElement("canvas");
const context = canvas.getContext("2d")!;
const texture = Texture.fromImageData(context.getImageData(0, 0, 1, 1));
const frame = { center: [0, 0] as [number, number], width: 1, pixels: [1, 1] as [number, number] };
const pixels = new FormulaMap("z").warp(texture, { texture: frame, view: frame });
context.putImageData(new ImageData(pixels, 1, 1), 0, 0);
new FormulaMap("z").paint(context, texture, { texture: frame, view: frame });
new FormulaMap("z").paint(new OffscreenCanvas(1, 1).getContext("2d")!, texture, { texture: frame, view: frame });
import init from "conformal-warp";
await init(fetch("x")); await init(new URL("x:")); await init(new Uint8Array(1)); await init(new WebAssembly.Module(new Uint8Array(1))); await init.reset();
