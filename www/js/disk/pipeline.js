// From a drawn region to a picture of the disk: the page's only way through the package, wherever it runs.

import { JointTriangulation, Texture } from "../../pkg/index.js";
import { diskFrame, flatten, scaledTo } from "../common/frame.js";
import { arrowLines, meshEdges } from "../common/layers.js";
import { BAND } from "../common/plate.js";
import { carriedHeat, CIRCLE_FENCE, diskLines, DRAFT_HEAT, fenceOf, FINE_HEAT, heatOf, regionLines, UNIT_CIRCLE } from "../editor/field.js";
import { drawnLayers, heatPixels } from "../editor/overlays.js";
import { readOutline } from "../editor/read-outline.js";
import { SolvedMap } from "../editor/solved-map.js";
import { HoledImage } from "./holed.js";
import { wayBetween } from "./homotopy.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../../pkg/index.js").RiemannMap} RiemannMap */
/**
 * @typedef {object} Job
 * @property {number} version which state of the page this is for
 * @property {boolean} fine
 * @property {Float64Array} boundary
 * @property {Float64Array} corners
 * @property {string} path
 * @property {string[]} holes
 * @property {import("../editor/store.js").Onto} onto what a region with holes becomes
 * @property {Point} center
 * @property {Point} toward
 * @property {number} tolerance of the solve
 * @property {number} maxErrorPixels how far the triangles may be off the map, in pixels of the view
 * @property {Frame} view
 * @property {import("../editor/overlays.js").Wishes} show
 * @property {number} morph how far on the way from the region, 0, to the disk, 1
 */
/** @typedef {import("../editor/overlays.js").Over} Over */
/** @typedef {import("./homotopy.js").Way} Way */
/** @typedef {Uint8ClampedArray<ArrayBuffer>} Pixels */
/** @typedef {import("../common/plate.js").Plate} Plate */
/** @typedef {import("../editor/locate.js").Mesh} Mesh */
/** @typedef {import("../editor/evidence.js").DiskEvidence | import("../editor/evidence.js").HoledEvidence} Evidence */
/**
 * @typedef {object} Result
 * @property {number} version
 * @property {Pixels} pixels
 * @property {Frame} view
 * @property {Mesh | null} mesh region to disk; none where there are holes
 * @property {{ onto: import("../editor/store.js").Onto, lines: Float64Array[] } | null} walls what holes have become
 * @property {{ target: Float64Array, outline: Float64Array, center: Point, toward: Point } | null} way what is shown instead of the disk: the nodes of the mesh, the outline and the vector
 * @property {{ source: Over, target: Over }} over
 * @property {Float64Array} corners the ends of the boundary's edges
 * @property {Float64Array} angles of the corners, on the circle
 * @property {Evidence} evidence
 */

/** `shape`: what it was made for, but for center and direction. @typedef {{ shape: string, key: string, center: Point, mesh: JointTriangulation, ms: number }} Meshed */
/** @template {{ version: number }} J @template {{ version: number }} R @typedef {import("../common/serve.js").Pipeline<J, R>} Pipeline */
const PUSHED = { direction: /** @type {const} */ ("push-forward") };
/** Meshes are not made finer than for a view so wide. */
const MESH_WIDTH = 0.5;
/** While a vector is moved, the nodes of a mesh serve centers so far from its own: then its errors are hardly larger. */
const CARRIED = 0.15;

/** @implements {Pipeline<Job, Result>} */
export class RegionPipeline {
  /** @type {{ texture: Texture, frame: Frame } | null} */
  #picture = null;
  #solved = new SolvedMap();
  #holed = new HoledImage();
  /** The last mesh: a new picture needs no other. @type {Meshed | null} */
  #meshed = null;
  /** The same nodes for a vector that is being moved. @type {Meshed | null} */
  #carried = null;

  /** @param {Uint8ClampedArray} pixels @param {Frame} frame */
  setPicture(pixels, frame) {
    this.#picture?.texture.free();
    this.#picture = { texture: new Texture(pixels, ...frame.pixels), frame };
  }

  /** @param {Job} job @param {import("../common/serve.js").Talk<Result>} talk */
  run(job, talk) {
    if (!this.#picture) throw new Error("There is no picture yet.");
    return job.holes.length ? this.#holed.run(job, this.#picture, talk) : this.#draw(job, this.#picture, talk);
  }

  /** @param {Job} job @param {{ texture: Texture, frame: Frame }} picture @param {import("../common/serve.js").Talk<Result>} talk */
  #draw(job, { texture, frame }, { progress }) {
    const solved = this.#solved.solve(job, job.tolerance, progress);
    const { map, corners, ms: solveMs } = solved;
    const { mesh, ms: meshMs } = this.#mesh(job, map);
    const begin = performance.now();
    const { source, target, triangles } = mesh;
    const way = onWay(job, map);
    const shown = meshOn(way, mesh);
    const pixels = shown.warp(texture, { texture: frame, view: job.view, direction: "push-forward", quality: "trilinear" });
    const warpMs = performance.now() - begin;
    const over = overOf(job, solved, way, shown);
    /** @type {Result} */
    const result = {
      version: job.version,
      pixels: /** @type {Pixels} */ (pixels),
      view: job.view,
      over,
      mesh: { source, target, triangles },
      walls: null,
      way: way && { target: shown.target, outline: way.outline, center: way.center, toward: way.toward },
      corners: job.corners,
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
    if (way) shown.free();
    return { result, transfer: [pixels, source, target, triangles, ...heatPixels(over)].map(({ buffer }) => buffer) };
  }

  /** An outline from text; points carried by a map that has no mesh. @param {{ what: "points", side: import("../common/probe.js").Side, points: Point[] } | import("../editor/read-outline.js").OutlineQuestion} question */
  answer(question) {
    return question.what === "points" ? this.#holed.carry(question.side, question.points) : readOutline(question.text, true);
  }

  /** A picture of any size and its lines, to be saved. @param {Job} job @param {(share: number) => void} onShare @returns {Promise<Plate>} */
  async plate(job, onShare) {
    if (!this.#picture) throw new Error("There is no picture yet.");
    if (job.holes.length) return this.#holed.plate(job, this.#picture, onShare);
    const { texture, frame } = this.#picture;
    const { view, show } = job;
    const solved = this.#solved.solve(job, job.tolerance, (_, share) => onShare(share / 2));
    const { map, corners } = solved;
    const { mesh: whole } = this.#mesh(job, map);
    const between = onWay(job, map);
    const mesh = meshOn(between, whole);
    const edges = show.mesh ? meshEdges(mesh.triangles) : null;
    const { source, target } = overOf({ ...job, fine: true, show: { ...show, heat: false } }, solved, between, mesh);
    const heat = show.heat ? heatOf(map, map.conformalRadius, corners, FINE_HEAT) : null;
    const colours = heat && new Texture(heat.pixels, ...heat.frame.pixels);
    const way = { view, ...PUSHED, quality: /** @type {const} */ ("best") };
    return {
      frame: view,
      band: BAND,
      draw: (rows) => mesh.warp(texture, { ...way, texture: frame, rows }),
      tint: colours && heat && ((rows) => mesh.warp(colours, { ...way, texture: heat.frame, rows })),
      panels: [
        { name: "region", frame: scaledTo(frame, view.pixels[0]), layers: [...drawnLayers(source, mesh.source, edges), { ink: "outline", lines: [corners], closed: true }, { ink: "vector", lines: arrowLines(job.toward, job.center, frame) }] },
        { name: "disk", frame: view, layers: [...drawnLayers(target, mesh.target, edges), { ink: "rim", lines: [between?.outline ?? UNIT_CIRCLE], closed: true }, { ink: "vector", lines: arrowLines(between?.toward ?? [1, 0], between?.center ?? [0, 0], view) }] },
      ],
      free: () => {
        colours?.free();
        if (between) mesh.free();
      },
    };
  }

  /** @param {Job} job @param {RiemannMap} map @returns {Meshed} */
  #mesh({ fine, boundary, path, center, toward, tolerance, maxErrorPixels, view }, map) {
    // A mesh for all of the disk: one looks closer at the same, only so far at a finer one.
    const frame = { ...diskFrame(view.pixels[0]), width: Math.max(view.width, MESH_WIDTH) };
    const shape = JSON.stringify([path || [...boundary], tolerance, maxErrorPixels, frame]);
    const key = JSON.stringify([center, toward, shape]);
    const known = [this.#meshed, this.#carried].find((meshed) => meshed?.key === key);
    if (known) return known;
    const begin = performance.now();
    const carried = fine || this.#meshed?.shape !== shape ? null : carriedMesh(this.#meshed, map);
    this.#carried?.mesh.free();
    this.#carried = null;
    const mesh = carried ?? JointTriangulation.regionToDisk(map, { maxErrorPixels, frame });
    const made = { shape, key, center, mesh, ms: performance.now() - begin };
    if (carried) return (this.#carried = made);
    this.#meshed?.mesh.free();
    return (this.#meshed = made);
  }
}

/** The mesh's nodes where another map of its region takes them, if that has its center nearby. @param {Meshed} meshed @param {RiemannMap} map */
function carriedMesh({ mesh, center }, map) {
  const [x, y] = map.toDisk(flatten([center]));
  if (!(Math.hypot(x, y) <= CARRIED)) return null;
  const { source, triangles } = mesh;
  const target = map.toDisk(source);
  if (!target.every(Number.isFinite)) return null;
  const carried = JointTriangulation.fromParts(source, target, triangles);
  if (carried.flipped === 0) return carried;
  carried.free();
  return null;
}

/** The way to the disk, unless it is at its end. @param {Job} job @param {RiemannMap} map */
const onWay = ({ morph, center }, map) => (morph < 1 ? wayBetween(map, center, morph) : null);

/** The mesh to what is shown: itself at the way's end. @param {Way | null} way @param {JointTriangulation} mesh to the disk */
const meshOn = (way, mesh) => (way ? JointTriangulation.fromParts(mesh.source, way.carry(mesh.target), mesh.triangles) : mesh);

/** What is shown over the pictures. @param {Job} job @param {import("../editor/solved-map.js").Solved} solved @param {Way | null} way @param {JointTriangulation} mesh to what is shown @returns {{ source: Over, target: Over }} */
function overOf({ show: { grid, heat, measure }, view, fine }, { map, corners, outline }, way, mesh) {
  const field = heat ? heatOf(map, map.conformalRadius, corners, fine ? FINE_HEAT : DRAFT_HEAT) : null;
  const source = { lines: grid ? regionLines(map, grid, fine) : [], fence: measure ? fenceOf(map, outline) : null, heat: field };
  const rings = grid ? diskLines(grid, fine) : [];
  const target = { lines: way ? rings.map((line) => way.carry(line)) : rings, fence: measure && !way ? CIRCLE_FENCE : null, heat: field && carriedHeat(mesh, field, view) };
  return { source, target };
}
