// Both hemispheres of one eye that looks at a picture, on the page's own thread: for lines and for the pointer.

import { unflatten } from "../common/frame.js";
import { cortexOf, HEMISPHERES } from "./maps.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./models.js").Spec} Spec */
/** @typedef {import("../../pkg/index.js").Texture} Texture */
/** A line of the visual field, on the picture and on the cortex. @typedef {{ name: string, picture: Point[], cortex: Point[] }} Line */

/** The edge of the field, just inside where the maps end. */
const EDGE = 89.99;
/** Eccentricities of the rings, in degrees, and directions of the rays, in radians from the horizontal. */
const RINGS = [1, 2, 4, 8, 16, 32, 64, EDGE];
const RAYS = [-Math.PI / 2, -Math.PI / 4, 0, Math.PI / 4, Math.PI / 2];
/** Eccentricities and directions of the middles of small circles, and their radii as shares of the eccentricity. */
const CIRCLES = { at: [1, 2.2, 4.8, 10.5, 23, 50], along: [-1.15, -0.58, 0, 0.58, 1.15], radius: 0.16 };
/** Points of a line. */
const STEPS = 90;
/** The vertical meridian itself belongs to neither half. */
const MERIDIAN = Math.PI / 2 - 1e-6;

/** A point of the visual field E·e^{iθ} → two numbers. @param {number} eccentricity in degrees @param {number} azimuth in radians @returns {Point} */
const fieldPoint = (eccentricity, azimuth) => [eccentricity * Math.cos(azimuth), eccentricity * Math.sin(azimuth)];

/** @typedef {(share: number) => Point} Curve of the right half of the field, over [0, 1] */

/** @type {{ name: string, at: Curve }[]} */
const GRID = [
  ...RINGS.map((ring) => ({ name: ring === EDGE ? "" : `${ring}°`, at: (/** @type {number} */ s) => fieldPoint(ring, MERIDIAN * (2 * s - 1)) })),
  ...RAYS.map((ray) => ({ name: "", at: (/** @type {number} */ s) => fieldPoint(EDGE * s ** 3, Math.max(-MERIDIAN, Math.min(MERIDIAN, ray))) })),
];

/** @type {Curve[]} */
const SMALL_CIRCLES = CIRCLES.at.flatMap((e) => CIRCLES.along.map((azimuth) => (/** @type {number} */ s) => smallCircle(e, azimuth, 2 * Math.PI * s)));

/** A point of a circle on the sphere of directions, which conformal maps take to near-circles. @param {number} e in degrees @param {number} azimuth @param {number} turn @returns {Point} */
function smallCircle(e, azimuth, turn) {
  const degree = Math.PI / 180;
  const [polar, radius] = [e * degree, CIRCLES.radius * e * degree];
  // The circle around the pole, tilted by the eccentricity of its middle.
  const [x, y, z] = [Math.sin(radius) * Math.cos(turn), Math.sin(radius) * Math.sin(turn), Math.cos(radius)];
  const [across, ahead] = [x * Math.cos(polar) + z * Math.sin(polar), z * Math.cos(polar) - x * Math.sin(polar)];
  return fieldPoint(Math.atan2(Math.hypot(across, y), ahead) / degree, azimuth + Math.atan2(y, across));
}

export class Eye {
  #halves;

  /** @param {Spec} spec @param {Frame} picture @param {number} fieldOfView @param {Point} fixation */
  constructor(spec, picture, fieldOfView, fixation) {
    this.#halves = HEMISPHERES.map((hemisphere) => {
      const cortex = cortexOf(spec, hemisphere);
      return { side: hemisphere === "left" ? 1 : -1, cortex, image: cortex.seeing({ picture, fieldOfView, fixation }) };
    });
    const [{ cortex }] = this.#halves;
    /** In mm², of one hemisphere. */
    this.area = cortex.area;
    /** How far an outline's map misses its landmark: in mm, in radians. @type {[number, number] | undefined} */
    this.landmarkError = cortex.landmarkError;
    const outline = unflatten(cortex.boundary);
    /** Half of the size of both hemispheres, laid out with 0 between them. In mm. */
    this.half = { width: Math.max(...outline.map(([x]) => Math.abs(x))), height: Math.max(...outline.map(([, y]) => Math.abs(y))) };
    /** The outlines of both. */
    this.outlines = [outline, outline.map(([x, y]) => /** @type {Point} */ ([-x, y]))];
  }

  free() {
    for (const { cortex, image } of this.#halves) {
      image.free();
      cortex.free();
    }
  }

  /** The warps of a picture that changes, one a hemisphere. @param {Texture} texture @param {Frame} frame @param {Frame[]} views */
  prepare(texture, frame, views) {
    return this.#halves.map(({ image }, k) => image.prepareWarp(texture, { texture: frame, view: views[k] }));
  }

  /** @param {Point} point of the cortex */
  #halfAt(point) {
    return this.#halves.find(({ side }) => side * point[0] >= 0);
  }

  /** Cortex → picture; null outside V1. @param {Point} point @returns {Point | null} */
  toPicture(point) {
    const half = this.#halfAt(point);
    const [x, y] = half ? half.image.toPicture(new Float64Array(point)) : [NaN, NaN];
    return Number.isFinite(x) ? [x, y] : null;
  }

  /**
   * What a point of the cortex looks at: how far from the fixation point, and how magnified; null outside V1.
   * @param {Point} point @returns {{ eccentricity: number, magnification: number } | null} degrees, mm a degree
   */
  at(point) {
    const half = this.#halfAt(point);
    const field = half?.cortex.toField(new Float64Array(point));
    if (!half || !field || !Number.isFinite(field[0])) return null;
    return { eccentricity: Math.hypot(field[0], field[1]), magnification: half.cortex.magnification(field)[0] };
  }

  /** Rings and rays of the visual field. @returns {Line[]} */
  lines() {
    return this.#drawn(GRID);
  }

  /** Small circles of the visual field, all over it. @returns {Line[]} */
  circles() {
    return this.#drawn(SMALL_CIRCLES.map((at) => ({ name: "", at })));
  }

  /** @param {{ name: string, at: Curve }[]} curves @returns {Line[]} */
  #drawn(curves) {
    return this.#halves.flatMap(({ side, cortex, image }) =>
      curves.map(({ name, at }) => {
        const field = Array.from({ length: STEPS + 1 }, (_, k) => at(k / STEPS)).flatMap(([x, y]) => [side * x, y]);
        const onCortex = cortex.toCortex(new Float64Array(field));
        return { name, cortex: finite(onCortex), picture: finite(image.toPicture(onCortex)) };
      }),
    );
  }

  /** Millimetres a degree along the horizontal meridian. @param {number[]} eccentricities in degrees @returns {Float64Array} */
  magnification(eccentricities) {
    const left = this.#halves.find(({ side }) => side === 1);
    return left ? left.cortex.magnification(new Float64Array(eccentricities.flatMap((e) => [e, 0]))) : new Float64Array();
  }
}

/** @param {Float64Array} flat @returns {Point[]} */
const finite = (flat) => unflatten(flat).filter(([x]) => Number.isFinite(x));
