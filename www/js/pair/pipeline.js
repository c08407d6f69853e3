// From two drawn regions to the picture of one in the other: both maps, the joint triangulation, the warp.

import { JointTriangulation, RegionMap, Texture } from "../../pkg/index.js";
import { flatten, unflatten } from "../common/frame.js";
import { SolvedMap } from "../editor/solved-map.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/probe.js").Side} Side */
/** @typedef {import("../editor/evidence.js").PairEvidence} Evidence */
/** @typedef {import("../editor/locate.js").Mesh} Mesh */
/** @typedef {import("../editor/solved-map.js").Outline} Outline */
/** @typedef {import("../editor/solved-map.js").Solved} Solved */
/** @typedef {{ version: number, fine: boolean, from: Outline, to: Outline, tolerance: number, maxErrorPixels: number, view: Frame }} Job */
/** Without a mesh, the picture was drawn point by point. @typedef {{ version: number, pixels: Uint8ClampedArray<ArrayBuffer>, view: Frame, mesh: Mesh | null, evidence: Evidence }} Result */
/** @typedef {import("../common/serve.js").Talk<Result>} Talk */
/** @template {{ version: number }} J @template {{ version: number }} R @typedef {import("../common/serve.js").Pipeline<J, R>} Pipeline */

/** A mesh whose pieces are farther off the map than this many times what was asked for is not shown. */
const OFF = 2;
/** Corners nearer to each other than this on the circle, in radians, may leave no room for a mesh: that is tried with maps of this tolerance, to so many pixels. */
const NARROW = 1e-4;
const ROUGH = 1e-3;
const COARSE = 2;
/** Meshes are not made finer than for a view so wide. */
const MESH_WIDTH = 0.5;
/** Rows that are drawn point by point before the page is listened to. */
const BAND = 16;
/** What the library says when the maps leave no room for a mesh. */
const NO_MESH = ["crowded", "invalid-mesh"];

/** @implements {Pipeline<Job, Result>} */
export class RegionsPipeline {
  /** @type {{ texture: Texture, frame: Frame } | null} */
  #picture = null;
  #from = new SolvedMap();
  #to = new SolvedMap();
  #roughFrom = new SolvedMap();
  #roughTo = new SolvedMap();
  /** The map between both regions of the last picture. @type {RegionMap | null} */
  #between = null;

  /** @param {Uint8ClampedArray} pixels @param {Frame} frame */
  setPicture(pixels, frame) {
    this.#picture?.texture.free();
    this.#picture = { texture: new Texture(pixels, ...frame.pixels), frame };
  }

  /** @param {Job} job @param {Talk} talk */
  async run(job, talk) {
    if (!this.#picture) throw new Error("There is no picture yet.");
    const { texture, frame } = this.#picture;
    const { view, version } = job;
    this.#forget();
    const from = this.#from.solve(job.from, job.tolerance, (stage, share) => talk.progress(stage, share / 3));
    const to = this.#to.solve(job.to, job.tolerance, (stage, share) => talk.progress(stage, (1 + share) / 3));
    // Also where there is a mesh: whoever draws finely may have none, and ask here.
    this.#between = RegionMap.between(from.map, to.map);
    const begin = performance.now();
    const joint = this.#triangulate(from, to, job);
    const meshed = performance.now();
    /** @type {Uint8ClampedArray} */
    let pixels;
    if (joint) {
      pixels = joint.warp(texture, { texture: frame, view, direction: "push-forward", quality: "trilinear" });
    } else {
      pixels = await pointByPoint(this.#between, texture, frame, view, talk);
    }
    const mesh = joint && { source: joint.source, target: joint.target, triangles: joint.triangles };
    /** @type {Evidence} */
    const evidence = {
      errorEstimate: Math.max(from.map.errorEstimate, to.map.errorEstimate),
      unknowns: from.map.unknowns + to.map.unknowns,
      nodes: (mesh?.source.length ?? 0) / 2,
      triangles: (mesh?.triangles.length ?? 0) / 3,
      flipped: joint?.flipped ?? 0,
      solveMs: from.ms + to.ms,
      meshMs: meshed - begin,
      warpMs: performance.now() - meshed,
    };
    joint?.free();
    /** @type {Result} */
    const result = { version, pixels: /** @type {Uint8ClampedArray<ArrayBuffer>} */ (pixels), view, mesh, evidence };
    const arrays = mesh ? [pixels, mesh.source, mesh.target, mesh.triangles] : [pixels];
    return { result, transfer: arrays.map(({ buffer }) => buffer) };
  }

  /** The mesh, if there is one that keeps to what was asked for. @param {Solved} from @param {Solved} to @param {Job} job */
  #triangulate(from, to, job) {
    const crowded = [from, to].some(({ map }) => narrowest(map.angles) < NARROW);
    if (crowded && job.tolerance < ROUGH) {
      // Where the boundary is crowded on the circle, rough maps soon tell whether a mesh is worth the time.
      const rough = [this.#roughFrom.solve(job.from, ROUGH, () => {}), this.#roughTo.solve(job.to, ROUGH, () => {})];
      const mesh = meshWithin(rough[0], rough[1], COARSE, job.view);
      if (!mesh) return null;
      mesh.free();
    }
    return meshWithin(from, to, job.maxErrorPixels, job.view);
  }

  /** Points carried by the map itself, where there is no mesh that the page could ask. @param {{ side: Side, points: Point[] }} question @returns {(Point | null)[] | null} */
  answer({ side, points }) {
    const flat = flatten(points);
    const images = side === "source" ? this.#between?.forward(flat) : this.#between?.inverse(flat);
    return images ? unflatten(images).map((p) => (Number.isFinite(p[0]) ? p : null)) : null;
  }

  #forget() {
    this.#between?.free();
    this.#between = null;
  }
}

/** @param {Solved} from @param {Solved} to @param {number} maxErrorPixels @param {Frame} view @returns {JointTriangulation | null} */
function meshWithin(from, to, maxErrorPixels, view) {
  const frame = { ...view, width: Math.max(view.width, MESH_WIDTH) };
  try {
    const joint = JointTriangulation.regionToRegion(from.map, to.map, { maxErrorPixels, frame });
    const { largestErrorPixels = 0 } = joint.evidence;
    if (largestErrorPixels <= OFF * maxErrorPixels) return joint;
    joint.free();
    return null;
  } catch (error) {
    if (NO_MESH.includes(/** @type {{ code?: string }} */ (error).code ?? "")) return null;
    throw error;
  }
}

/** The smallest angle between neighbours on the circle. @param {Float64Array} angles */
const narrowest = (angles) => angles.reduce((least, angle, k) => Math.min(least, (angles[(k + 1) % angles.length] - angle + 2 * Math.PI) % (2 * Math.PI)), Infinity);

/** @param {RegionMap} map @param {Texture} texture @param {Frame} frame @param {Frame} view @param {Talk} talk */
async function pointByPoint(map, texture, frame, view, talk) {
  const [width, height] = view.pixels;
  const out = new Uint8ClampedArray(4 * width * height);
  for (let row = 0; row < height; row += BAND) {
    const end = Math.min(height, row + BAND);
    const band = out.subarray(4 * width * row, 4 * width * end);
    map.warp(texture, { texture: frame, view, direction: "push-forward", quality: "trilinear", out: band, rows: [row, end] });
    talk.progress("picture", (2 + row / height) / 3);
    await talk.pause();
  }
  return out;
}
