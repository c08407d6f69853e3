// The polar grid of the disk, pulled back to the region through the joint triangulation.

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../editor/locate.js").Locator} Locator */

export const RINGS = [0.2, 0.4, 0.6, 0.8];
/** Rays, in parts of a full turn. */
export const RAYS = Array.from({ length: 12 }, (_, k) => k / 12);

/** Points along a ring, and along a ray: close enough for lines that look smooth where the map magnifies most. */
const RING_STEPS = 240;
const RAY_STEPS = 120;

/**
 * Lines in the region on which |f| is one of the rings or arg f one of the rays.
 * @param {Locator} locator @returns {Point[][]}
 */
export function pulledBackGrid(locator) {
  const rings = RINGS.map((radius) => line(locator, RING_STEPS, (s) => [radius, s]));
  const rays = RAYS.map((turns) => line(locator, RAY_STEPS, (s) => [s, turns]));
  return [...rings, ...rays];
}

/** @param {Locator} locator @param {number} steps @param {(s: number) => [radius: number, turns: number]} at */
function line(locator, steps, at) {
  /** @type {Point[]} */
  const points = [];
  for (let k = 0; k <= steps; k++) {
    const [radius, turns] = at(k / steps);
    const [cos, sin] = [Math.cos(2 * Math.PI * turns), Math.sin(2 * Math.PI * turns)];
    const point = locator.at("target", [radius * cos, radius * sin]);
    if (point) points.push(point);
  }
  return points;
}
