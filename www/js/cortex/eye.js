// Both hemispheres of one eye that looks at a picture, on the page's own thread: for lines and for the pointer.

import { cortexOf, fieldPoint, HEMISPHERES } from "./models.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {{ name: string, picture: Point[], cortex: Point[] }} Line the same line of the visual field, twice */

/** The edge of the field, just inside where the models end. */
const EDGE = 89.99;
/** Eccentricities of the rings, in degrees, and directions of the rays, in radians from the horizontal. */
const RINGS = [1, 2, 4, 8, 16, 32, 64, EDGE];
const RAYS = [-Math.PI / 2, -Math.PI / 4, 0, Math.PI / 4, Math.PI / 2];
/** Points of a line. */
const STEPS = 90;
/** The vertical meridian itself belongs to neither half. */
const MERIDIAN = Math.PI / 2 - 1e-6;

export class Eye {
  #halves;

  /** @param {string} model @param {Frame} picture @param {number} fieldOfView @param {Point} fixation */
  constructor(model, picture, fieldOfView, fixation) {
    this.#halves = HEMISPHERES.map((hemisphere) => {
      const cortex = cortexOf(model, hemisphere);
      return { side: hemisphere === "left" ? 1 : -1, cortex, image: cortex.seeing({ picture, fieldOfView, fixation }) };
    });
  }

  free() {
    for (const { cortex, image } of this.#halves) {
      image.free();
      cortex.free();
    }
  }

  /** Cortex → picture; null outside V1. @param {Point} point @returns {Point | null} */
  toPicture(point) {
    const half = this.#halves.find(({ side }) => side * point[0] >= 0);
    const [x, y] = half ? half.image.toPicture(new Float64Array(point)) : [NaN, NaN];
    return Number.isFinite(x) ? [x, y] : null;
  }

  /**
   * What a point of the cortex looks at: how far from the fixation point, and how magnified; null outside V1.
   * @param {Point} point @returns {{ eccentricity: number, magnification: number } | null} degrees, mm a degree
   */
  at(point) {
    const half = this.#halves.find(({ side }) => side * point[0] >= 0);
    const field = half?.cortex.toField(new Float64Array(point));
    if (!half || !field || !Number.isFinite(field[0])) return null;
    return { eccentricity: Math.hypot(field[0], field[1]), magnification: half.cortex.magnification(field)[0] };
  }

  /** Rings and rays of the visual field. @returns {Line[]} */
  lines() {
    return this.#halves.flatMap(({ side, cortex, image }) => {
      const rings = RINGS.map((ring) => ({ name: ring === EDGE ? "" : `${ring}°`, at: (/** @type {number} */ s) => fieldPoint(ring, MERIDIAN * (2 * s - 1)) }));
      const rays = RAYS.map((ray) => ({ name: "", at: (/** @type {number} */ s) => fieldPoint(EDGE * s ** 3, Math.max(-MERIDIAN, Math.min(MERIDIAN, ray))) }));
      return [...rings, ...rays].map(({ name, at }) => {
        const field = Array.from({ length: STEPS + 1 }, (_, k) => at(k / STEPS)).flatMap(([x, y]) => [side * x, y]);
        const onCortex = cortex.toCortex(new Float64Array(field));
        return { name, cortex: finite(onCortex), picture: finite(image.toPicture(onCortex)) };
      });
    });
  }

  /** Millimetres a degree along the horizontal meridian. @param {number[]} eccentricities in degrees @returns {Float64Array} */
  magnification(eccentricities) {
    const left = this.#halves.find(({ side }) => side === 1);
    return left ? left.cortex.magnification(new Float64Array(eccentricities.flatMap((e) => [e, 0]))) : new Float64Array();
  }
}

/** @param {Float64Array} flat @returns {Point[]} */
function finite(flat) {
  /** @type {Point[]} */
  const points = [];
  for (let k = 0; k < flat.length; k += 2) if (Number.isFinite(flat[k])) points.push([flat[k], flat[k + 1]]);
  return points;
}
