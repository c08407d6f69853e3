// From a drawn region to a picture of the disk: the page's only way through the package, wherever it runs.

import { JointTriangulation, Texture } from "../../pkg/index.js";
import { diskFrame } from "../common/frame.js";
import { SolvedMap } from "../editor/solved-map.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../../pkg/index.js").RiemannMap} RiemannMap */
/**
 * @typedef {object} Job
 * @property {number} version which state of the page this is for
 * @property {boolean} fine
 * @property {Float64Array} boundary
 * @property {Point} center
 * @property {Point} toward
 * @property {number} tolerance of the solve
 * @property {number} maxErrorPixels how far the triangles may be off the map, in pixels of the view
 * @property {Frame} view
 */
/** @typedef {import("../editor/locate.js").Mesh} Mesh */
/** @typedef {import("../editor/evidence.js").DiskEvidence} Evidence */
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

/** @template {{ version: number }} J @template {{ version: number }} R @typedef {import("../common/serve.js").Pipeline<J, R>} Pipeline */
/** Meshes are not made finer than for a view so wide. */
const MESH_WIDTH = 0.5;

/** @implements {Pipeline<Job, Result>} */
export class RegionPipeline {
  /** @type {{ texture: Texture, frame: Frame } | null} */
  #picture = null;
  #solved = new SolvedMap();
  /** The last mesh: a new picture needs no other. @type {{ key: string, mesh: JointTriangulation, ms: number } | null} */
  #meshed = null;

  /** @param {Uint8ClampedArray} pixels @param {Frame} frame */
  setPicture(pixels, frame) {
    this.#picture?.texture.free();
    this.#picture = { texture: new Texture(pixels, ...frame.pixels), frame };
  }

  /** @param {Job} job @param {import("../common/serve.js").Talk<Result>} talk */
  run(job, { progress }) {
    if (!this.#picture) throw new Error("There is no picture yet.");
    const { texture, frame } = this.#picture;
    const { map, corners, ms: solveMs } = this.#solved.solve(job, job.tolerance, progress);
    const { mesh, ms: meshMs } = this.#mesh(job, map);
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

  /** @param {Job} job @param {RiemannMap} map */
  #mesh({ boundary, center, toward, tolerance, maxErrorPixels, view }, map) {
    // A mesh for all of the disk: one looks closer at the same, only so far at a finer one.
    const frame = { ...diskFrame(view.pixels[0]), width: Math.max(view.width, MESH_WIDTH) };
    const key = JSON.stringify([[...boundary], center, toward, tolerance, maxErrorPixels, frame]);
    if (this.#meshed?.key === key) return this.#meshed;
    const begin = performance.now();
    const mesh = JointTriangulation.regionToDisk(map, { maxErrorPixels, frame });
    this.#meshed?.mesh.free();
    this.#meshed = { key, mesh, ms: performance.now() - begin };
    return this.#meshed;
  }
}
