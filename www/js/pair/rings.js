// From two drawn regions with a hole each to the picture of one in the other: through their rings, stretched where these differ.

import { RegionMap } from "../../pkg/index.js";
import { flatten, known, scaledTo } from "../common/frame.js";
import { pointByPoint } from "../common/point-by-point.js";
import { SolvedCanonical } from "../editor/canonical.js";
import { carriedHeat, DRAFT_HEAT, FINE_HEAT, heatOf, radiusAt } from "../editor/field.js";
import { heatPixels } from "../editor/overlays.js";
import { plateOf } from "./plate.js";
import { ringLines } from "./ring-lines.js";

/** @typedef {import("../../pkg/index.js").AnnulusMap} AnnulusMap */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/probe.js").Side} Side */
/** @typedef {import("../editor/canonical.js").Canonical & { ms: number }} Solved */
/** @typedef {import("./pipeline.js").Job} Job */
/** @typedef {import("./pipeline.js").Over} Over */
/** @typedef {import("./pipeline.js").Result} Result */
/** @typedef {{ texture: import("../../pkg/index.js").Texture, frame: import("../common/frame.js").Frame }} Picture */
/** Both maps onto rings, what they make together, and the power of |w| that takes the first ring to the second. @typedef {{ from: Solved, to: Solved, between: RegionMap, power: number }} Joined */

/** A picture takes so much of the time. */
const DRAWING = 0.3;

export class RingImage {
  #from = new SolvedCanonical();
  #to = new SolvedCanonical();
  /** The map between both regions of the last picture. @type {RegionMap | null} */
  #between = null;

  /** @param {Job} job @param {Picture} picture @param {import("../common/serve.js").Talk<Result>} talk */
  async run(job, { texture, frame }, { progress, pause }) {
    this.forget();
    const joined = this.#join(job, (share) => progress("solve", (1 - DRAWING) * share));
    const { from, to, between } = joined;
    this.#between = between;
    const begin = performance.now();
    const pixels = await pointByPoint(between, texture, frame, job.view, (share) => progress("picture", 1 - DRAWING * (1 - share)), job.fine ? pause : null);
    const warpMs = performance.now() - begin;
    const over = overOf(job, joined);
    /** @type {Result} */
    const result = {
      version: job.version,
      pixels,
      view: job.view,
      mesh: null,
      over,
      dilatation: dilatationOf(joined),
      evidence: {
        errorEstimate: Math.max(from.map.errorEstimate, to.map.errorEstimate),
        unknowns: (from.map.unknowns ?? 0) + (to.map.unknowns ?? 0),
        facts: factsOf(joined),
        solveMs: from.ms + to.ms,
        warpMs,
      },
    };
    return { result, transfer: [pixels, ...heatPixels(over)].map(({ buffer }) => buffer) };
  }

  /** Points of the last picture. @param {Side} side @param {Point[]} points */
  carry(side, points) {
    const flat = flatten(points);
    const images = side === "source" ? this.#between?.forward(flat) : this.#between?.inverse(flat);
    return images ? known(images) : null;
  }

  /** @param {import("./pipeline.js").SavedJob} job @param {Picture} picture @param {(share: number) => void} onShare */
  plate(job, picture, onShare) {
    const joined = this.#join(job, onShare);
    const { from, between } = joined;
    return plateOf(job, picture, {
      map: between,
      heat: job.show.heat ? heatOf(between, radiusAt(between, job.from.center), from.corners, FINE_HEAT) : null,
      over: overOf({ ...job, fine: true, show: { ...job.show, heat: false } }, joined),
      free: () => between.free(),
    });
  }

  forget() {
    this.#between?.free();
    this.#between = null;
  }

  /** @param {Job} job @param {(share: number) => void} onShare @returns {Joined} */
  #join({ from: first, to: second, tolerance }, onShare) {
    const from = this.#from.solve(first, "ring", tolerance, (_, share) => onShare(share / 2));
    const to = this.#to.solve(second, "ring", tolerance, (_, share) => onShare((1 + share) / 2));
    const [a, b] = [from, to].map(({ map }) => /** @type {AnnulusMap} */ (map));
    return { from, to, between: RegionMap.between(a, b, { stretch: true }), power: Math.log(b.modulus) / Math.log(a.modulus) };
  }
}

/** How much longer than wide the map makes a small circle, wherever it is: 1 where it is conformal. @param {Joined} joined */
const dilatationOf = ({ between, power }) => (between.isAnalytic ? 1 : Math.max(power, 1 / power));

/** Digits after the point, and at most. */
const [DIGITS, MOST_DIGITS] = [4, 10];

/** What the two rings allow, in words. @param {Joined} joined @returns {[string, string, string][]} */
function factsOf(joined) {
  const [first, second] = [joined.from, joined.to].map(({ map }) => /** @type {AnnulusMap} */ (map).modulus);
  const dilatation = dilatationOf(joined);
  if (dilatation === 1) {
    const both = [first, second].map((modulus) => modulus.toFixed(6)).join(" and ");
    return [["Moduli", both, "of the two rings, outer radius to inner: they agree up to the error, so the map is conformal and keeps angles"]];
  }
  // As many as tell what is different from what would be alike.
  const digitsFor = (/** @type {number} */ difference) => Math.min(MOST_DIGITS, Math.max(DIGITS, 2 - Math.floor(Math.log10(difference))));
  const digits = digitsFor(Math.abs(first - second));
  const factor = dilatation.toFixed(digitsFor(dilatation - 1));
  return [
    ["Moduli", `${first.toFixed(digits)} and ${second.toFixed(digits)}`, "of the two rings, outer radius to inner: no conformal map changes it, so there is none here until a hole is made to fit"],
    ["Dilatation K", factor, `of the stretch from ring to ring, ratio of log moduli: angles are not kept, small circles become ellipses ${factor} times as long as wide`],
  ];
}

/** What is shown over the pictures: circles and rays of the first ring, and where they go; how much the first region is enlarged. @param {Job} job @param {Joined} joined @returns {Over} */
function overOf({ from: { center }, show: { grid, heat }, fine, view }, { from, to, between, power }) {
  const stretch = heat ? heatOf(between, radiusAt(between, center), from.corners, fine ? FINE_HEAT : DRAFT_HEAT) : null;
  const lines = grid ? ringLines(grid, 1 / /** @type {AnnulusMap} */ (from.map).modulus, fine) : [];
  const [source, target] = [lines.map((line) => from.from(line)), lines.map((line) => to.from(stretched(line, power)))].map((all) => all.map((line) => line.filter(Number.isFinite)));
  return {
    source: { lines: source, fence: null, heat: stretch },
    target: { lines: target, fence: null, heat: stretch && carriedHeat(between, stretch, scaledTo(view, FINE_HEAT / 2)) },
  };
}

/** w → w |w|^(power − 1). @param {Float64Array} line @param {number} power */
const stretched = (line, power) => line.map((value, k) => value * Math.hypot(line[k - (k % 2)], line[k - (k % 2) + 1]) ** (power - 1));
