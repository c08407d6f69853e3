// From a drawn region with holes to a picture of the ring, or of the disk with slits or round holes in it.

import { Texture } from "../../pkg/index.js";
import { flatten, known, scaledTo, unflatten } from "../common/frame.js";
import { arrowLines } from "../common/layers.js";
import { BAND } from "../common/plate.js";
import { pointByPoint } from "../common/point-by-point.js";
import { SolvedCanonical } from "../editor/canonical.js";
import { carriedHeat, diskLines, DRAFT_HEAT, FINE_HEAT, heatOf, radiusAt, UNIT_CIRCLE } from "../editor/field.js";
import { drawnLayers, heatPixels } from "../editor/overlays.js";
import { linesOf } from "../editor/path.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/layers.js").Layer} Layer */
/** @typedef {import("../editor/overlays.js").Over} Over */
/** @typedef {import("../editor/canonical.js").Canonical} Canonical */
/** @typedef {import("./pipeline.js").Job} Job */
/** @typedef {import("./pipeline.js").Result} Result */
/** @typedef {{ texture: Texture, frame: Frame }} Picture */

/** A line parts where its image jumps over a hole: by more than this share of the region's size, and this many times its last step. */
const LEAP = 0.02;
const STRIDE = 6;

export class HoledImage {
  #solved = new SolvedCanonical();

  /** @param {Job} job @param {Picture} picture @param {import("../common/serve.js").Talk<Result>} talk */
  async run(job, { texture, frame }, { progress, pause }) {
    const { version, view, corners: given } = job;
    const solved = this.#solved.solve(job, job.onto, job.tolerance, (stage, share) => progress(stage, 0.7 * share));
    const { map, walls, facts, ms } = solved;
    const begin = performance.now();
    const pixels = await pointByPoint(map, texture, frame, view, (share) => progress("picture", 0.7 + 0.3 * share), job.fine ? pause : null);
    const warpMs = performance.now() - begin;
    const over = overOf(job, solved);
    const images = unflatten(solved.to(given));
    const seen = images.flatMap(([u, v], k) => (Number.isFinite(u) ? [{ angle: Math.atan2(v, u), at: [given[2 * k], given[2 * k + 1]] }] : []));
    /** @type {Result} */
    const result = {
      version,
      pixels,
      view,
      over,
      mesh: null,
      way: null,
      walls: { onto: job.onto, lines: walls },
      corners: new Float64Array(seen.flatMap(({ at }) => at)),
      angles: new Float64Array(seen.map(({ angle }) => angle)),
      evidence: { errorEstimate: map.errorEstimate, unknowns: map.unknowns, facts, solveMs: ms, warpMs },
    };
    return { result, transfer: [pixels, ...heatPixels(over)].map(({ buffer }) => buffer) };
  }

  /** Points of the last picture, by the map itself. @param {import("../common/probe.js").Side} side @param {Point[]} points */
  carry(side, points) {
    const carried = this.#solved.last?.[side === "source" ? "to" : "from"](flatten(points));
    return carried ? known(carried) : null;
  }

  /** @param {Job} job @param {Picture} picture @param {(share: number) => void} onShare @returns {import("../common/plate.js").Plate} */
  plate(job, { texture, frame }, onShare) {
    const { view, show } = job;
    const solved = this.#solved.solve(job, job.onto, job.tolerance, (_, share) => onShare(share));
    const { map, walls, corners } = solved;
    const { source, target } = overOf({ ...job, fine: true, show: { ...show, heat: false } }, solved);
    const heat = show.heat ? heatOf(map, radiusAt(map, job.center), corners, FINE_HEAT) : null;
    const colours = heat && new Texture(heat.pixels, ...heat.frame.pixels);
    const way = { view, direction: /** @type {const} */ ("push-forward"), quality: /** @type {const} */ ("best") };
    return {
      frame: view,
      band: BAND,
      draw: (rows) => map.warp(texture, { ...way, texture: frame, rows }),
      tint: colours && heat && ((rows) => map.warp(colours, { ...way, texture: heat.frame, rows })),
      panels: [
        { name: "region", frame: scaledTo(frame, view.pixels[0]), layers: [...drawnLayers(source, undefined, null), { ink: "outline", lines: [corners, ...linesOf(job.holes)], closed: true }, { ink: "vector", lines: arrowLines(job.toward, job.center, frame) }] },
        { name: "disk", frame: view, layers: [...drawnLayers(target, undefined, null), { ink: "rim", lines: [UNIT_CIRCLE], closed: true }, { ink: "outline", lines: walls, closed: true }] },
      ],
      free: () => colours?.free(),
    };
  }
}

/** What is shown over the pictures. @param {Job} job @param {Canonical} solved @returns {{ source: Over, target: Over }} */
function overOf({ show: { grid, heat }, view, fine, center }, solved) {
  const { map, corners } = solved;
  const field = heat ? heatOf(map, radiusAt(map, center), corners, fine ? FINE_HEAT : DRAFT_HEAT) : null;
  const leap = LEAP * corners.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  const lines = grid ? diskLines(grid, fine).flatMap((line) => aroundHoles(line, solved.from(line), leap)) : [];
  return {
    source: { lines: lines.map(({ source }) => source), fence: null, heat: field },
    target: { lines: lines.map(({ target }) => target), fence: null, heat: field && carriedHeat(map, field, scaledTo(view, FINE_HEAT / 2)) },
  };
}

/** The parts of a line that have an image, and the images. @param {Float64Array} line @param {Float64Array} images NaN for what has none @param {number} leap that parts them @returns {{ source: Float64Array, target: Float64Array }[]} */
function aroundHoles(line, images, leap) {
  /** @type {{ source: Float64Array, target: Float64Array }[]} */
  const parts = [];
  let begin = 0;
  let step = Infinity;
  const end = (/** @type {number} */ to) => {
    if (to - begin > 2) parts.push({ source: images.slice(begin, to), target: line.slice(begin, to) });
    begin = to;
    step = Infinity;
  };
  for (let k = 0; k < line.length; k += 2) {
    if (!Number.isFinite(images[k])) {
      end(k);
      begin = k + 2;
    } else if (k > begin) {
      const next = Math.hypot(images[k] - images[k - 2], images[k + 1] - images[k - 1]);
      if (next > leap && next > STRIDE * step) end(k);
      step = next;
    }
  }
  end(line.length);
  return parts;
}
