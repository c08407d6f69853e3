// From a drawn region to a picture of the disk: the page's only way through the package, wherever it runs.

import { JointTriangulation, Region, RiemannMap, Texture } from "../../pkg/index.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/**
 * @typedef {object} Job
 * @property {number} version which state of the page this is for
 * @property {Float64Array} boundary
 * @property {Point} center
 * @property {Point} toward
 * @property {number} tolerance of the solve
 * @property {number} maxErrorPixels how far the triangles may be off the map, in pixels of the view
 * @property {Frame} view
 */
/** @typedef {{ source: Float64Array, target: Float64Array, triangles: Uint32Array }} Mesh */
/**
 * @typedef {object} Evidence
 * @property {number} errorEstimate
 * @property {number} unknowns
 * @property {number} conformalRadius
 * @property {number} nodes
 * @property {number} triangles
 * @property {number} flipped
 * @property {number} solveMs
 * @property {number} meshMs
 * @property {number} warpMs
 */
/**
 * @typedef {object} Result
 * @property {number} version
 * @property {Uint8ClampedArray<ArrayBuffer>} pixels
 * @property {Frame} view
 * @property {Mesh} mesh
 * @property {Float64Array} corners the boundary as the library keeps it: counter-clockwise
 * @property {Float64Array} angles of the corners, on the circle
 * @property {Evidence} evidence
 */

/** @typedef {import("../common/serve.js").Progress} Progress */
/** @template {{ version: number }} J @template {{ version: number }} R @typedef {import("../common/serve.js").Pipeline<J, R>} Pipeline */
/**
 * A map and its mesh, with what they were made from: all of it, and the outline alone.
 * @typedef {{ key: string, outline: string, corners: Float64Array, map: RiemannMap, mesh: JointTriangulation, solveMs: number, meshMs: number }} Solved
 */

/** @implements {Pipeline<Job, Result>} */
export class RegionPipeline {
  /** @type {{ texture: Texture, frame: Frame } | null} */
  #picture = null;
  /** The last map and its mesh: a new picture needs no other, a new vector no other factorisation. @type {Solved | null} */
  #solved = null;

  /** @param {Uint8ClampedArray} pixels @param {Frame} frame */
  setPicture(pixels, frame) {
    this.#picture?.texture.free();
    this.#picture = { texture: new Texture(pixels, ...frame.pixels), frame };
  }

  /** @param {Job} job @param {Progress} onProgress */
  run(job, onProgress) {
    if (!this.#picture) throw new Error("There is no picture yet.");
    const { texture, frame } = this.#picture;
    const { corners, map, mesh, solveMs, meshMs } = this.#solve(job, onProgress);
    const begin = performance.now();
    const pixels = mesh.warp(texture, { texture: frame, view: job.view, direction: "push-forward", quality: "trilinear" });
    const warpMs = performance.now() - begin;
    const { source, target, triangles } = mesh;
    /** @type {Result} */
    const result = {
      version: job.version,
      pixels: /** @type {Uint8ClampedArray<ArrayBuffer>} */ (pixels),
      view: job.view,
      mesh: { source, target, triangles },
      corners,
      angles: map.angles,
      evidence: {
        errorEstimate: map.errorEstimate,
        unknowns: map.unknowns,
        conformalRadius: map.conformalRadius,
        nodes: source.length / 2,
        triangles: triangles.length / 3,
        flipped: mesh.flipped,
        solveMs,
        meshMs,
        warpMs,
      },
    };
    return { result, transfer: [pixels, source, target, triangles].map(({ buffer }) => buffer) };
  }

  /** @param {Job} job @param {Progress} onProgress @returns {Solved} */
  #solve(job, onProgress) {
    const { boundary, center, toward, tolerance, maxErrorPixels, view } = job;
    const outline = JSON.stringify([[...boundary], tolerance]);
    const key = JSON.stringify([outline, center, toward, maxErrorPixels, view]);
    const last = this.#solved;
    if (last?.key === key) return last;
    const begin = performance.now();
    const { map, corners } =
      last?.outline === outline
        ? { map: last.map.withCenter({ center, toward, onProgress }), corners: last.corners }
        : solveAfresh(job, onProgress);
    const solved = performance.now();
    const mesh = JointTriangulation.regionToDisk(map, { maxErrorPixels, frame: view });
    last?.map.free();
    last?.mesh.free();
    this.#solved = { key, outline, corners, map, mesh, solveMs: solved - begin, meshMs: performance.now() - solved };
    return this.#solved;
  }
}

/** @param {Job} job @param {Progress} onProgress */
function solveAfresh({ boundary, center, toward, tolerance }, onProgress) {
  const region = new Region({ boundary, center, toward });
  try {
    return { map: RiemannMap.solve(region, { tolerance, onProgress }), corners: region.boundary };
  } finally {
    region.free();
  }
}
