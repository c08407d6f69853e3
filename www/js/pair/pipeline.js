// From two drawn regions to the picture of one in the other: both maps, the joint triangulation, the warp.

import { JointTriangulation, RegionMap, Texture } from "../../pkg/index.js";
import { flatten, known, scaledTo } from "../common/frame.js";
import { pointByPoint } from "../common/point-by-point.js";
import { carriedHeat, DRAFT_HEAT, fenceOf, FINE_HEAT, heatOf, regionLines } from "../editor/field.js";
import { heatPixels } from "../editor/overlays.js";
import { readOutline } from "../editor/read-outline.js";
import { SolvedMap } from "../editor/solved-map.js";
import { goesByRings } from "./holes.js";
import { plateOf } from "./plate.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/probe.js").Side} Side */
/** @typedef {import("../editor/evidence.js").PairEvidence | import("../editor/evidence.js").HoledEvidence} Evidence */
/** @typedef {import("../editor/locate.js").Mesh} Mesh */
/** @typedef {import("../editor/solved-map.js").Outline} Outline */
/** @typedef {import("../editor/solved-map.js").Solved} Solved */
/** @typedef {{ version: number, fine: boolean, from: Outline, to: Outline, tolerance: number, maxErrorPixels: number, view: Frame, show: import("../editor/overlays.js").Wishes }} Job */
/** @typedef {Record<Side, import("../editor/overlays.js").Over>} Over */
/** A job whose picture is to be saved, over the second photo. @typedef {Job & { behind: import("../common/serve.js").PictureMessage }} SavedJob */
/** Without a mesh, the picture was drawn point by point; `dilatation`: how much longer than wide the map makes small circles. @typedef {{ version: number, pixels: Uint8ClampedArray<ArrayBuffer>, view: Frame, mesh: Mesh | null, over: Over, dilatation: number, evidence: Evidence }} Result */
/** @typedef {import("../common/serve.js").Talk<Result>} Talk */
/** @template {{ version: number }} J @template {{ version: number }} R @typedef {import("../common/serve.js").Pipeline<J, R>} Pipeline */

/** A mesh that could not be made as fine as was asked for is shown all the same where it is off the map by so many times that at most. */
const OFF = 2;
/** A mesh that takes longer is given up for a picture drawn point by point; in milliseconds. */
const PATIENCE = 4000;
/** Meshes are not made finer than for a view so wide. */
const MESH_WIDTH = 0.5;
/** What the library says when the maps leave no room for a mesh, or it was given up. */
const NO_MESH = ["cancelled", "crowded", "invalid-mesh"];

/** @implements {Pipeline<Job, Result>} */
export class RegionsPipeline {
  /** @type {{ texture: Texture, frame: Frame } | null} */
  #picture = null;
  #from = new SolvedMap();
  #to = new SolvedMap();
  /** What goes by rings; loaded where there are holes. @type {import("./rings.js").RingImage | null} */
  #rings = null;
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
    const byRings = goesByRings(job);
    this.#forget();
    return byRings ? (await this.#loadRings()).run(job, this.#picture, talk) : this.#draw(job, this.#picture, talk);
  }

  /** @param {Job} job @param {{ texture: Texture, frame: Frame }} picture @param {Talk} talk */
  async #draw(job, { texture, frame }, talk) {
    const { view, version } = job;
    const from = this.#from.solve(job.from, job.tolerance, (stage, share) => talk.progress(stage, share / 3));
    const to = this.#to.solve(job.to, job.tolerance, (stage, share) => talk.progress(stage, (1 + share) / 3));
    // Also where there is a mesh: whoever draws finely may have none, and ask here.
    this.#between = RegionMap.between(from.map, to.map);
    const begin = performance.now();
    const joint = triangulated(from, to, job, (share) => talk.progress("mesh", (2 + share) / 3));
    const meshed = performance.now();
    /** @type {Uint8ClampedArray} */
    let pixels;
    if (joint) {
      pixels = joint.warp(texture, { texture: frame, view, direction: "push-forward", quality: "trilinear" });
    } else {
      pixels = await pointByPoint(this.#between, texture, frame, view, (share) => talk.progress("picture", (2 + share) / 3), job.fine ? talk.pause : null);
    }
    const warped = performance.now();
    const over = overOf(job, from, to, this.#between, joint);
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
      warpMs: warped - meshed,
    };
    joint?.free();
    /** @type {Result} */
    const result = { version, pixels: /** @type {Uint8ClampedArray<ArrayBuffer>} */ (pixels), view, mesh, over, dilatation: 1, evidence };
    const arrays = [pixels, ...(mesh ? [mesh.source, mesh.target, mesh.triangles] : []), ...heatPixels(over)];
    return { result, transfer: arrays.map(({ buffer }) => buffer) };
  }

  /** A picture of any size over the second photo, and its lines, to be saved. @param {SavedJob} job @param {(share: number) => void} onShare @returns {Promise<import("../common/plate.js").Plate>} */
  async plate(job, onShare) {
    if (!this.#picture) throw new Error("There is no picture yet.");
    if (goesByRings(job)) return (await this.#loadRings()).plate(job, this.#picture, onShare);
    const from = this.#from.solve(job.from, job.tolerance, (_, share) => onShare(share / 3));
    const to = this.#to.solve(job.to, job.tolerance, (_, share) => onShare((1 + share) / 3));
    const joint = triangulated(from, to, job, (share) => onShare((2 + share) / 3));
    const between = RegionMap.between(from.map, to.map);
    return plateOf(job, this.#picture, {
      map: joint ?? between,
      heat: job.show.heat ? stretchOf(from, to, between, FINE_HEAT) : null,
      over: overOf({ ...job, fine: true, show: { ...job.show, heat: false } }, from, to, between, joint),
      mesh: joint,
      free: () => {
        joint?.free();
        between.free();
      },
    });
  }

  /** An outline from text; points carried by the map itself, where there is no mesh that the page could ask. @param {{ what: "points", side: Side, points: Point[] } | import("../editor/read-outline.js").OutlineQuestion} question */
  answer(question) {
    if (question.what === "outline") return readOutline(question.text, true);
    const { side, points } = question;
    if (!this.#between) return this.#rings?.carry(side, points) ?? null;
    const flat = flatten(points);
    return known(side === "source" ? this.#between.forward(flat) : this.#between.inverse(flat));
  }

  #forget() {
    this.#between?.free();
    this.#between = null;
    this.#rings?.forget();
  }

  async #loadRings() {
    return (this.#rings ??= new (await import("./rings.js")).RingImage());
  }
}

/** What both maps say over the pictures: what goes to circles and rays, harmonic measure, how much the first is enlarged. @param {Job} job @param {Solved} from @param {Solved} to @param {RegionMap} between @param {JointTriangulation | null} joint @returns {Over} */
function overOf({ show: { grid, heat, measure }, fine, view }, from, to, between, joint) {
  const stretch = heat ? stretchOf(from, to, between, fine ? FINE_HEAT : DRAFT_HEAT) : null;
  const [source, target] = [from, to].map(({ map, outline }) => ({ lines: grid ? regionLines(map, grid, fine) : [], fence: measure ? fenceOf(map, outline) : null }));
  return { source: { ...source, heat: stretch }, target: { ...target, heat: stretch && (joint ? carriedHeat(joint, stretch, view) : carriedHeat(between, stretch, scaledTo(view, FINE_HEAT / 2))) } };
}

/** How much the map stretches, beside its stretch at the centre. @param {Solved} from @param {Solved} to @param {RegionMap} between @param {number} side pixels */
const stretchOf = (from, to, between, side) => heatOf(between, from.map.conformalRadius / to.map.conformalRadius, from.corners, side);

/**
 * The mesh, if there is one that keeps to what was asked for, and soon.
 * @param {Solved} from @param {Solved} to @param {Job} job @param {(share: number) => void} onShare @returns {JointTriangulation | null}
 */
function triangulated(from, to, { maxErrorPixels, view }, onShare) {
  const frame = { ...view, width: Math.max(view.width, MESH_WIDTH) };
  const latest = performance.now() + PATIENCE;
  /** @param {string} _ @param {number} share */
  const onProgress = (_, share) => {
    onShare(share);
    return performance.now() < latest;
  };
  try {
    const joint = JointTriangulation.regionToRegion(from.map, to.map, { maxErrorPixels, frame, onProgress });
    const { stop, largestErrorPixels = 0 } = joint.evidence;
    if (stop === "density" || largestErrorPixels <= OFF * maxErrorPixels) return joint;
    joint.free();
    return null;
  } catch (error) {
    if (NO_MESH.includes(/** @type {{ code?: string }} */ (error).code ?? "")) return null;
    throw error;
  }
}
