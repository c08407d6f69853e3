// Maps of a region with holes, and what its holes become: slits in the disk, the inner circle of a ring, or round holes.

import { AnnulusMap, CircleMap, Region, SlitMap } from "../../pkg/index.js";
import { circleLine } from "./field.js";

/** @typedef {import("../common/serve.js").Progress} Progress */
/** @typedef {import("./region.js").Carried} Carried */
/** What a region with holes becomes. @typedef {import("./store.js").Onto} Onto */
/** @typedef {{ errorEstimate: number, unknowns?: number, warp: AnnulusMap["warp"], derivative: AnnulusMap["derivative"], free(): void }} AnyMap */
/**
 * @typedef {object} Canonical
 * @property {AnyMap} map
 * @property {(points: Float64Array) => Float64Array} to
 * @property {(points: Float64Array) => Float64Array} from
 * @property {Float64Array[]} walls what becomes of the holes, as lines
 * @property {Float64Array} corners of the outer boundary
 * @property {[name: string, value: string, words: string][]} facts
 */

/** Places along an edge of a hole: close to each other at its ends, which may go to the ends of its slit. */
const PLACES = Array.from({ length: 24 }, (_, k) => (1 - Math.cos((Math.PI * k) / 24)) / 2);

/** @type {Record<Onto, (region: Region, tolerance: number, onProgress: Progress) => Omit<Canonical, "corners">>} */
const MAKERS = {
  ring(region, tolerance, onProgress) {
    const map = AnnulusMap.solve(region, { tolerance, onProgress });
    const { innerRadius, modulus } = map;
    return {
      map,
      to: (points) => map.toAnnulus(points),
      from: (points) => map.fromAnnulus(points),
      walls: [circleLine(innerRadius)],
      facts: [["Inner radius", innerRadius.toFixed(6), `of the ring; its radii are as ${modulus.toFixed(4)} to 1, whatever the map: no other ring will do`]],
    };
  },
  slits(region, tolerance, onProgress) {
    const map = SlitMap.solve(region, { kind: "disk" }, { tolerance, onProgress });
    const to = (/** @type {Float64Array} */ points) => map.toSlits(points);
    return { map, to, from: (points) => map.fromSlits(points), walls: region.holes.map((hole) => to(along(hole)).filter(Number.isFinite)), facts: [["Slits", list(radiiOf(map.slits)), "how far each lies from 0: parts of circles, seen from both sides"]] };
  },
  circles(region, tolerance, onProgress) {
    const map = CircleMap.solve(region, { tolerance, onProgress });
    const { centers, radii } = map;
    const walls = [...radii].map((radius, k) => circleLine(radius).map((value, n) => value + centers[2 * k + (n % 2)]));
    return { map, to: (points) => map.toCircles(points), from: (points) => map.fromCircles(points), walls, facts: [["Round holes", list([...radii]), "their radii, beside the disk’s, which is 1"]] };
  },
};

/** The map of a region that is being edited: made anew where what it depends on has changed. */
export class SolvedCanonical {
  /** @type {(Canonical & { key: string, ms: number }) | null} */
  #last = null;

  /** The last one. */
  get last() {
    return this.#last;
  }

  /** The region's map; it is valid until the next call. @param {Carried} region @param {Onto} onto @param {number} tolerance @param {Progress} onProgress */
  solve(region, onto, tolerance, onProgress) {
    const { boundary, path, holes, center, toward } = region;
    const key = JSON.stringify([path || [...boundary], holes, onto === "ring" ? null : center, toward, onto, tolerance]);
    if (this.#last?.key === key) return this.#last;
    const begin = performance.now();
    const solved = solveCanonical(region, onto, tolerance, onProgress);
    this.#last?.map.free();
    this.#last = { ...solved, key, ms: performance.now() - begin };
    return this.#last;
  }
}

/** @param {Carried} region @param {Onto} onto @param {number} tolerance @param {Progress} onProgress @returns {Canonical} */
function solveCanonical({ boundary, path, holes, center, toward }, onto, tolerance, onProgress) {
  const region = new Region({ ...(path ? { path } : { boundary }), holes, center, toward });
  try {
    return { ...MAKERS[onto](region, tolerance, onProgress), corners: path ? boundary : region.boundary };
  } finally {
    region.free();
  }
}

/** Points all along a closed polygon. @param {Float64Array} polygon */
function along(polygon) {
  const count = polygon.length / 2;
  const points = new Float64Array(2 * count * PLACES.length);
  for (let k = 0, n = 0; k < count; k++) {
    const [a, b] = [2 * k, 2 * ((k + 1) % count)];
    for (const t of PLACES) {
      points[n++] = polygon[a] + t * (polygon[b] - polygon[a]);
      points[n++] = polygon[a + 1] + t * (polygon[b + 1] - polygon[a + 1]);
    }
  }
  return points;
}

/** How far slits lie from 0. @param {Float64Array} ends */
const radiiOf = (ends) => Array.from({ length: ends.length / 4 }, (_, k) => Math.hypot(ends[4 * k], ends[4 * k + 1]));

/** @param {number[]} values */
const list = (values) => values.map((value) => value.toFixed(4)).join(", ");
