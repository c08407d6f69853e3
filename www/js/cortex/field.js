// Lines of the visual field, in degrees: rings and rays, and small circles all over it.

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {(share: number) => Point} Curve of the right half of the field, over [0, 1] */
/** A line of the right half of the field, as x, y, x, y, … @typedef {{ name: string, field: Float64Array }} FieldLine */

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

/** A point of a circle on the sphere of directions, which conformal maps take to near-circles. @param {number} e in degrees @param {number} azimuth @param {number} turn @returns {Point} */
function smallCircle(e, azimuth, turn) {
  const degree = Math.PI / 180;
  const [polar, radius] = [e * degree, CIRCLES.radius * e * degree];
  // The circle around the pole, tilted by the eccentricity of its middle.
  const [x, y, z] = [Math.sin(radius) * Math.cos(turn), Math.sin(radius) * Math.sin(turn), Math.cos(radius)];
  const [across, ahead] = [x * Math.cos(polar) + z * Math.sin(polar), z * Math.cos(polar) - x * Math.sin(polar)];
  return fieldPoint(Math.atan2(Math.hypot(across, y), ahead) / degree, azimuth + Math.atan2(y, across));
}

/** @param {string} name @param {Curve} at @returns {FieldLine} */
function sampled(name, at) {
  return { name, field: new Float64Array(Array.from({ length: STEPS + 1 }, (_, k) => at(k / STEPS)).flat()) };
}

/** Rings and rays. */
export const GRID = [
  ...RINGS.map((ring) => sampled(ring === EDGE ? "" : `${ring}°`, (s) => fieldPoint(ring, MERIDIAN * (2 * s - 1)))),
  ...RAYS.map((ray) => sampled("", (s) => fieldPoint(EDGE * s ** 3, Math.max(-MERIDIAN, Math.min(MERIDIAN, ray))))),
];

/** Small circles. */
export const SMALL_CIRCLES = CIRCLES.at.flatMap((e) => CIRCLES.along.map((azimuth) => sampled("", (s) => smallCircle(e, azimuth, 2 * Math.PI * s))));

/** The same line in the half of the field on that side. @param {Float64Array} field @param {number} side 1 for the right half, −1 for the left */
export const onSide = (field, side) => (side === 1 ? field : field.map((value, k) => (k % 2 ? value : -value)));
