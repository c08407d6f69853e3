// From two drawn regions to the picture of one in the other: both maps, the joint triangulation, the warp.

import { JointTriangulation, Texture } from "../../pkg/index.js";
import { SolvedMap } from "../editor/solved-map.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/serve.js").Progress} Progress */
/** @typedef {import("../editor/locate.js").Mesh} Mesh */
/** @typedef {import("../editor/solved-map.js").Outline} Outline */
/** @typedef {{ version: number, from: Outline, to: Outline, tolerance: number, maxErrorPixels: number, view: Frame }} Job */
/** @typedef {import("../editor/evidence.js").PairEvidence} Evidence */
/** @typedef {{ version: number, pixels: Uint8ClampedArray<ArrayBuffer>, view: Frame, mesh: Mesh, evidence: Evidence }} Result */
/** @template {{ version: number }} J @template {{ version: number }} R @typedef {import("../common/serve.js").Pipeline<J, R>} Pipeline */

/** @implements {Pipeline<Job, Result>} */
export class RegionsPipeline {
  /** @type {{ texture: Texture, frame: Frame } | null} */
  #picture = null;
  #from = new SolvedMap();
  #to = new SolvedMap();

  /** @param {Uint8ClampedArray} pixels @param {Frame} frame */
  setPicture(pixels, frame) {
    this.#picture?.texture.free();
    this.#picture = { texture: new Texture(pixels, ...frame.pixels), frame };
  }

  /** @param {Job} job @param {Progress} onProgress */
  run({ version, from, to, tolerance, maxErrorPixels, view }, onProgress) {
    if (!this.#picture) throw new Error("There is no picture yet.");
    const { texture, frame } = this.#picture;
    const [a, b] = [this.#from.solve(from, tolerance, onProgress), this.#to.solve(to, tolerance, onProgress)];
    const begin = performance.now();
    const joint = JointTriangulation.regionToRegion(a.map, b.map, { maxErrorPixels, frame: view });
    const meshed = performance.now();
    const pixels = /** @type {Uint8ClampedArray<ArrayBuffer>} */ (
      joint.warp(texture, { texture: frame, view, direction: "push-forward", quality: "trilinear" })
    );
    const { source, target, triangles, flipped } = joint;
    joint.free();
    /** @type {Evidence} */
    const evidence = {
      errorEstimate: Math.max(a.map.errorEstimate, b.map.errorEstimate),
      unknowns: a.map.unknowns + b.map.unknowns,
      nodes: source.length / 2,
      triangles: triangles.length / 3,
      flipped,
      solveMs: a.ms + b.ms,
      meshMs: meshed - begin,
      warpMs: performance.now() - meshed,
    };
    /** @type {Result} */
    const result = { version, pixels, view, mesh: { source, target, triangles }, evidence };
    return { result, transfer: [pixels, source, target, triangles].map(({ buffer }) => buffer) };
  }
}
