// From a picture and a fixation point to what both hemispheres receive.

import { Texture } from "../../pkg/index.js";
import { cortexOf, HEMISPHERES } from "./models.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../../pkg/index.js").Quality} Quality */
/**
 * @typedef {object} Job
 * @property {number} version which state of the page this is for
 * @property {string} model
 * @property {number} fieldOfView in degrees, across the picture
 * @property {Point} fixation in the picture's plane
 * @property {Frame[]} views of the cortex in millimetres, one a hemisphere
 * @property {Quality} quality
 */
/** @typedef {{ version: number, quality: Quality, views: Frame[], pixels: Uint8ClampedArray<ArrayBuffer>[], warpMs: number }} Result */
/** @template {{ version: number }} J @template {{ version: number }} R @typedef {import("../common/serve.js").Pipeline<J, R>} Pipeline */

/** @implements {Pipeline<Job, Result>} */
export class CortexPipeline {
  /** @type {{ texture: Texture, frame: Frame } | null} */
  #picture = null;

  /** @param {Uint8ClampedArray} pixels @param {Frame} frame */
  setPicture(pixels, frame) {
    this.#picture?.texture.free();
    this.#picture = { texture: new Texture(pixels, ...frame.pixels), frame };
  }

  /** @param {Job} job */
  run({ version, model, fieldOfView, fixation, views, quality }) {
    if (!this.#picture) throw new Error("There is no picture yet.");
    const { texture, frame } = this.#picture;
    const begin = performance.now();
    const pixels = HEMISPHERES.map((hemisphere, k) => {
      const cortex = cortexOf(model, hemisphere);
      const image = cortex.seeing({ picture: frame, fieldOfView, fixation });
      const drawn = image.warp(texture, { texture: frame, view: views[k], quality });
      image.free();
      cortex.free();
      return /** @type {Uint8ClampedArray<ArrayBuffer>} */ (drawn);
    });
    /** @type {Result} */
    const result = { version, quality, views, pixels, warpMs: performance.now() - begin };
    return { result, transfer: pixels.map(({ buffer }) => buffer) };
  }
}
