// The way from the region to the disk: a conformal map of the region for every step of it.
//
// With f the Riemann map and r from 1 to 0, z → (f⁻¹(r f(z)) − z₀)/r is one to one and analytic: what f does to the part |f| < r of
// the region, at the size of all of it. It begins with z − z₀ and ends, as r → 0, with f(z)/f'(z₀). A similarity on the way turns
// and sizes that to f(z) itself; so none of the pictures folds, as the straight way (1 − s) z + s f(z) may.

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../../pkg/index.js").RiemannMap} RiemannMap */
/** Points of the disk → the plane in between; the region's outline and the two ends of its vector there. @typedef {{ carry(points: Float64Array): Float64Array, outline: Float64Array, center: Point, toward: Point }} Way */

/** Points of the outline between its corners. */
const STEPS = 720;
/** The series' first term says it all when r is smaller. */
const LEAST = 1e-4;

/** The radius r on the way: most happens while it is large. @param {number} s */
export const radiusAt = (s) => 1 - s * s;

/** @param {RiemannMap} map @param {Point} center @param {number} s 0: the region, 1: the disk @returns {Way} */
export function wayBetween(map, [x0, y0], s) {
  const r = Math.max(LEAST, radiusAt(s));
  const [a, b] = map.derivative(Float64Array.of(x0, y0));
  const size = Math.hypot(a, b) ** s / r;
  const turn = s * Math.atan2(b, a);
  const [cos, sin] = [size * Math.cos(turn), size * Math.sin(turn)];
  const [dx, dy] = [(1 - s) * x0, (1 - s) * y0];
  /** @param {Float64Array} points @param {number} scale */
  const carried = (points, scale) => {
    const images = map.fromDisk(points.map((value) => r * value));
    for (let k = 0; k < images.length; k += 2) {
      const [u, v] = [images[k] - x0, images[k + 1] - y0];
      images[k] = scale * (cos * u - sin * v + dx);
      images[k + 1] = scale * (sin * u + cos * v + dy);
    }
    return images;
  };
  const angles = [...map.angles, ...Array.from({ length: STEPS }, (_, k) => (2 * Math.PI * k) / STEPS)].sort((p, q) => p - q);
  const rim = new Float64Array(angles.flatMap((angle) => [Math.cos(angle), Math.sin(angle)]));
  const free = carried(rim, 1);
  // All of it is to be seen, where the disk is seen.
  const scale = Math.min(1, 1 / free.reduce((most, value) => Math.max(most, Math.abs(value)), 0));
  const [cx, cy, tx, ty] = carried(Float64Array.of(0, 0, 1, 0), scale);
  return { carry: (points) => carried(points, scale), outline: free.map((value) => scale * value), center: [cx, cy], toward: [tx, ty] };
}
