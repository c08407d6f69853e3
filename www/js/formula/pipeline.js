// From a formula to two pictures: the texture's own plane, and what the formula makes of it.

import { FormulaMap, Texture } from "../../pkg/index.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../../pkg/index.js").Direction} Direction */
/** @typedef {import("../../pkg/index.js").Quality} Quality */
/** @typedef {import("../../pkg/index.js").Wrap} Wrap */
/** @typedef {"none" | "cartesian" | "polar" | "stretch" | "argument"} Lines what is drawn over the pictures */
/**
 * @typedef {object} Job
 * @property {number} version which state of the page this is for
 * @property {string} formula
 * @property {Record<string, Point>} params
 * @property {Direction} direction
 * @property {Wrap} wrap
 * @property {Lines} lines
 * @property {Frame} texture where the picture lies
 * @property {Frame} source the view of the texture's plane
 * @property {Frame} target the view of the warped plane
 * @property {Quality} quality
 */
/** @typedef {Uint8ClampedArray<ArrayBuffer>} Pixels */
/** @typedef {{ version: number, quality: Quality, source: Frame, target: Frame, sourcePixels: Pixels, targetPixels: Pixels, warpMs: number }} Result */
/** @template {{ version: number }} J @template {{ version: number }} R @typedef {import("../common/serve.js").Pipeline<J, R>} Pipeline */

/** Heat and argument leave this much of the picture to be seen. */
const OPACITY = 0.55;

/** @implements {Pipeline<Job, Result>} */
export class FormulaPipeline {
  /** @type {{ pixels: Uint8ClampedArray, size: Point } | null} */
  #picture = null;
  /** The picture, made ready for one way of going on beyond its edges. @type {{ wrap: Wrap, texture: Texture } | null} */
  #ready = null;

  /** @param {Uint8ClampedArray} pixels @param {Frame} frame */
  setPicture(pixels, frame) {
    this.#picture = { pixels, size: frame.pixels };
    this.#ready?.texture.free();
    this.#ready = null;
  }

  /** @param {Job} job */
  run(job) {
    const texture = this.#texture(job.wrap);
    const map = new FormulaMap(job.formula, { params: job.params });
    const identity = new FormulaMap("z");
    try {
      const { texture: frame, source, target, quality, direction } = job;
      const sourcePixels = identity.warp(texture, { texture: frame, view: source, quality });
      const begin = performance.now();
      const targetPixels = map.warp(texture, { texture: frame, view: target, direction, quality });
      const warpMs = performance.now() - begin;
      // The map's lines lie in the plane that it is evaluated on; the straight ones are what they go to.
      const pulling = direction === "pull-back";
      drawLines(map, job, pulling ? target : source, pulling ? targetPixels : sourcePixels);
      drawStraightLines(identity, job, pulling ? source : target, pulling ? sourcePixels : targetPixels);
      const pixels = /** @type {{ sourcePixels: Pixels, targetPixels: Pixels }} */ ({ sourcePixels, targetPixels });
      /** @type {Result} */
      const result = { version: job.version, quality, source, target, ...pixels, warpMs };
      return { result, transfer: [pixels.sourcePixels.buffer, pixels.targetPixels.buffer] };
    } finally {
      map.free();
      identity.free();
    }
  }

  /** @param {Wrap} wrap */
  #texture(wrap) {
    if (this.#ready?.wrap === wrap) return this.#ready.texture;
    if (!this.#picture) throw new Error("There is no picture yet.");
    const { pixels, size } = this.#picture;
    this.#ready?.texture.free();
    this.#ready = { wrap, texture: new Texture(pixels, ...size, { wrap }) };
    return this.#ready.texture;
  }
}

/** @param {FormulaMap} map @param {Job} job @param {Frame} view @param {Uint8ClampedArray} out */
function drawLines(map, { lines, texture, quality }, view, out) {
  if (lines === "none") return;
  const width = quality === "best" ? 2 : 1;
  map.overlay({ kind: lines, view, out, opacity: OPACITY, width, spacing: texture.width / 8 });
}

/** @param {FormulaMap} identity @param {Job} job @param {Frame} view @param {Uint8ClampedArray} out */
function drawStraightLines(identity, job, view, out) {
  if (job.lines === "cartesian" || job.lines === "polar") drawLines(identity, job, view, out);
}
