// What a strict TypeScript project without the DOM writes.
import init, { Region, RiemannMap, FormulaMap, Texture, JointTriangulation, initSync, presets } from "conformal-warp";
import type { ConformalWarpError, ErrorCode, Frame, FrameOptions, MeshOptions, PlacementOptions, WarpOptions } from "conformal-warp";
import initInline from "conformal-warp/inline";
import address from "conformal-warp/wasm";
const text: string = address;
void initInline; void text; void initSync;
await init();
const frame: Frame = { center: [0, 0], width: 2, pixels: [8, 8] };
const same: FrameOptions = frame;
// @ts-expect-error a frame has pixel counts that are numbers
const wrong: FrameOptions = { center: [0, 0], width: 2, pixels: ["8", 8] };
void wrong;
const region = new Region({ boundary: new Float64Array([0, 0, 1, 0, 0, 1]), center: [0.2, 0.2], toward: [1, 0] });
const map = RiemannMap.solve(region, { onProgress: (stage, fraction) => stage !== "" && fraction < 2 });
const texture = new Texture(new Uint8ClampedArray(4), 1, 1);
const options: WarpOptions = { texture: frame, view: same };
const pixels: Uint8ClampedArray<ArrayBuffer> = new FormulaMap("z").warp(texture, options);
const buffer: ArrayBuffer = map.toDisk(new Float64Array(2)).buffer;
void buffer; void pixels;
const spaced: MeshOptions = { spacing: 0.1 };
const exact: MeshOptions = { frame, maxErrorPixels: 0.1, route: "exact" };
// @ts-expect-error either one or the other
const both: MeshOptions = { frame, spacing: 1 };
// @ts-expect-error one of them
const none: MeshOptions = {};
void both; void none; void exact;
JointTriangulation.regionToDisk(map, spaced);
const place: PlacementOptions = presets()[0].view;
void place;
const code: ErrorCode = "self-intersecting";
// @ts-expect-error no such code
const noCode: ErrorCode = "oops";
void noCode;
export const report = (error: ConformalWarpError) => error.code === code;
import { createPool } from "conformal-warp/pool";
const pool = await createPool({ workers: 2 });
const pooled = pool.RiemannMap.solve(new pool.Region({ boundary: new Float64Array(6), center: [0, 0], toward: [1, 0] }), { signal: undefined });
const radius: number = await pooled.conformalRadius;
const drawn: Uint8ClampedArray<ArrayBuffer> = await pooled.warp(new pool.Texture(new Uint8ClampedArray(4), 1, 1), options);
// @ts-expect-error an object of the pool's, not of this thread
void pool.RiemannMap.solve(region);
void radius; void drawn;
