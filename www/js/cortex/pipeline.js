// From a picture and a fixation point to what both hemispheres receive, and to what of it can be recovered.

import { FoveatedTexture, Texture } from "../../pkg/index.js";
import { cortexOf, HEMISPHERES } from "./maps.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../../pkg/index.js").Quality} Quality */
/** @typedef {import("../../pkg/index.js").RetinoCorticalMap} RetinoCorticalMap */
/** @typedef {import("./models.js").Spec} Spec */
/** @typedef {Uint8ClampedArray<ArrayBuffer>} Pixels */
/**
 * @typedef {object} Job
 * @property {number} version which state of the page this is for
 * @property {Spec[]} specs one a panel
 * @property {number} fieldOfView in degrees, across the picture
 * @property {Point} fixation in the picture's plane
 * @property {Frame[]} views of the cortex in millimetres, one a hemisphere
 * @property {boolean} fine
 * @property {{ dots: number, view: Frame } | null} recover the first panel's cortex keeps so many dots a millimetre
 */
/**
 * @typedef {object} Result
 * @property {number} version
 * @property {boolean} fine
 * @property {Frame[]} views
 * @property {Pixels[][]} panels one picture a hemisphere
 * @property {Pixels | null} recovered
 * @property {number} levels of the foveated texture
 * @property {number} warpMs
 */
/** @template {{ version: number }} J @template {{ version: number }} R @typedef {import("../common/serve.js").Pipeline<J, R>} Pipeline */

/** Pixels along each side of a level: about what a hemisphere has on the screen. */
const SIDE = 384;

/** @implements {Pipeline<Job, Result>} */
export class CortexPipeline {
  /** @type {{ pixels: Uint8ClampedArray, texture: Texture, frame: Frame } | null} */
  #picture = null;
  /** The picture as large as its file has it, where that is larger. @type {Promise<ImageBitmap> | null} */
  #large = null;
  /** @type {{ fixation: Point, texture: FoveatedTexture } | null} */
  #foveated = null;

  /** @param {Uint8ClampedArray} pixels @param {Frame} frame @param {Blob} [file] */
  setPicture(pixels, frame, file) {
    this.#picture?.texture.free();
    this.#foveated?.texture.free();
    this.#foveated = null;
    this.#large?.then((bitmap) => bitmap.close());
    this.#picture = { pixels, texture: new Texture(pixels, ...frame.pixels), frame };
    this.#large = file ? createImageBitmap(file, { imageOrientation: "from-image" }) : null;
  }

  /** @param {Job} job */
  async run({ version, specs, fieldOfView, fixation, views, fine, recover }) {
    if (!this.#picture) throw new Error("There is no picture yet.");
    const { texture, frame } = this.#picture;
    const stack = fine ? await this.#around(fixation) : null;
    const begin = performance.now();
    /** @param {Spec} spec @param {(cortex: RetinoCorticalMap, image: ReturnType<RetinoCorticalMap["seeing"]>, k: number) => Pixels} draw */
    const bothOf = (spec, draw) =>
      HEMISPHERES.map((hemisphere, k) => {
        const cortex = cortexOf(spec, hemisphere);
        const image = cortex.seeing({ picture: frame, fieldOfView, fixation });
        const drawn = draw(cortex, image, k);
        image.free();
        cortex.free();
        return drawn;
      });
    const panels = specs.map((spec) =>
      bothOf(spec, (_, image, k) => {
        const options = { texture: frame, view: views[k], quality: /** @type {Quality} */ (fine ? "best" : "trilinear") };
        return /** @type {Pixels} */ (stack ? image.warpFoveated(stack, options) : image.warp(texture, options));
      }),
    );
    /** @type {Pixels | undefined} */
    let recovered;
    if (recover) {
      const { dots, view } = recover;
      bothOf(specs[0], (cortex, image) => {
        const options = { texture: frame, cortex: cortex.frame(dots), view, ...(recovered && { out: recovered }) };
        recovered = /** @type {Pixels} */ (image.recover(texture, options));
        return recovered;
      });
    }
    const warpMs = performance.now() - begin;
    /** @type {Result} */
    const result = { version, fine, views, panels, recovered: recovered ?? null, levels: stack?.levels ?? 0, warpMs };
    return { result, transfer: [...panels.flat(), ...(recovered ? [recovered] : [])].map(({ buffer }) => buffer) };
  }

  /** The picture with full detail around the fixation point. @param {Point} fixation */
  async #around(fixation) {
    const picture = this.#picture;
    if (!picture) return null;
    const known = this.#foveated;
    if (known && known.fixation[0] === fixation[0] && known.fixation[1] === fixation[1]) return known.texture;
    const bitmap = await this.#large?.catch(() => null);
    const texture = bitmap
      ? cutFrom(bitmap, picture.frame, fixation)
      : new FoveatedTexture(picture.pixels, { picture: picture.frame, fixation, side: SIDE });
    known?.texture.free();
    this.#foveated = { fixation, texture };
    return texture;
  }
}

/** The crops of a picture that is too large to be held as pixels: the browser scales each. @param {ImageBitmap} bitmap @param {Frame} frame @param {Point} fixation */
function cutFrom(bitmap, frame, fixation) {
  const { width, height } = bitmap;
  const picture = { ...frame, pixels: /** @type {Point} */ ([width, height]) };
  const context = new OffscreenCanvas(SIDE, SIDE).getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("This browser gives no 2d canvas.");
  context.imageSmoothingQuality = "high";
  /** @type {FoveatedTexture | undefined} */
  let stack;
  for (const crop of FoveatedTexture.crops({ picture, fixation, side: SIDE })) {
    const scale = width / frame.width;
    const side = crop.width * scale;
    const left = (crop.center[0] - frame.center[0]) * scale + width / 2 - side / 2;
    const top = height / 2 - (crop.center[1] - frame.center[1]) * scale - side / 2;
    context.clearRect(0, 0, SIDE, SIDE);
    context.drawImage(bitmap, left, top, side, side, 0, 0, SIDE, SIDE);
    const texture = Texture.fromImageData(context.getImageData(0, 0, SIDE, SIDE));
    if (stack) stack.add(texture, crop);
    else stack = FoveatedTexture.of(texture, crop);
  }
  if (!stack) throw new Error("The picture has no crops.");
  return stack;
}
