// Plane geometry that the editor needs at once, before the worker has answered.

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {{ edge: number, t: number, point: Point, distance: number }} EdgePoint edge k runs from vertex k to k + 1 */

/** @param {Point} a @param {Point} b */
export const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** The point at share t of the way from a to b. @param {Point} a @param {Point} b @param {number} t @returns {Point} */
export const mix = (a, b, t) => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];

/** Twice the signed area of the triangle a b c. @param {Point} a @param {Point} b @param {Point} c */
const turn = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

/** Signed area; positive when counter-clockwise. @param {Point[]} polygon */
export function area(polygon) {
  let twice = 0;
  polygon.forEach(([x, y], k) => {
    const [u, v] = polygon[(k + 1) % polygon.length];
    twice += x * v - u * y;
  });
  return twice / 2;
}

/** The boundary point nearest to p. @param {Point[]} polygon @param {Point} p @returns {EdgePoint} */
export function nearestOnBoundary(polygon, p) {
  /** @type {EdgePoint} */
  let best = { edge: 0, t: 0, point: polygon[0], distance: Infinity };
  polygon.forEach((a, edge) => {
    const b = polygon[(edge + 1) % polygon.length];
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    const length2 = dx * dx + dy * dy;
    const t = length2 ? Math.min(1, Math.max(0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2)) : 0;
    const point = mix(a, b, t);
    const d = distance(point, p);
    if (d < best.distance) best = { edge, t, point, distance: d };
  });
  return best;
}

/** Whether p lies inside, by crossings of a ray. @param {Point[]} polygon @param {Point} p */
export function contains(polygon, [x, y]) {
  let inside = false;
  polygon.forEach(([x0, y0], k) => {
    const [x1, y1] = polygon[(k + 1) % polygon.length];
    if (y0 > y !== y1 > y && x < x0 + ((y - y0) / (y1 - y0)) * (x1 - x0)) inside = !inside;
  });
  return inside;
}

/** @param {Point} a @param {Point} b @param {Point} c @param {Point} d whether the segments ab and cd meet */
function meet(a, b, c, d) {
  const [p, q, r, s] = [turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)];
  return p > 0 !== q > 0 && r > 0 !== s > 0;
}

/** The edges that cross another one that is not their neighbour. @param {Point[]} polygon @returns {Set<number>} */
export function crossingEdges(polygon) {
  const n = polygon.length;
  /** @type {Set<number>} */
  const bad = new Set();
  for (let i = 0; i < n; i++) {
    for (let j = i + 2; j < n; j++) {
      if (i === 0 && j === n - 1) continue;
      if (meet(polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % n])) bad.add(i).add(j);
    }
  }
  return bad;
}

/** How much nearness to the corners counts beside depth: it decides between points of a band, all equally deep. */
const MIDDLE = 0.1;

/**
 * A point well inside: on a grid, one far from the boundary and in the middle of it.
 * @param {Point[]} polygon @returns {Point}
 */
export function deepPoint(polygon) {
  const xs = polygon.map((p) => p[0]);
  const ys = polygon.map((p) => p[1]);
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const steps = 40;
  let best = { point: polygon[0], score: -Infinity };
  for (let i = 1; i < steps; i++) {
    for (let j = 1; j < steps; j++) {
      /** @type {Point} */
      const point = [left + ((right - left) * i) / steps, low + ((high - low) * j) / steps];
      if (!contains(polygon, point)) continue;
      const away = polygon.reduce((sum, corner) => sum + distance(corner, point), 0) / polygon.length;
      const score = nearestOnBoundary(polygon, point).distance - MIDDLE * away;
      if (score > best.score) best = { point, score };
    }
  }
  return best.point;
}

/** Where the ray from p to the right first meets the boundary. @param {Point[]} polygon @param {Point} p @returns {EdgePoint} */
export function rightOf(polygon, p) {
  /** @type {EdgePoint | undefined} */
  let best;
  polygon.forEach((a, edge) => {
    const b = polygon[(edge + 1) % polygon.length];
    if (a[1] > p[1] === b[1] > p[1]) return;
    const t = (p[1] - a[1]) / (b[1] - a[1]);
    const x = a[0] + t * (b[0] - a[0]);
    if (x > p[0] && (!best || x < best.point[0])) best = { edge, t, point: [x, p[1]], distance: x - p[0] };
  });
  return best ?? nearestOnBoundary(polygon, p);
}

/**
 * A polyline with the points dropped that lie within `tolerance` of the line through those kept (Douglas and Peucker).
 * @param {Point[]} line @param {number} tolerance @returns {Point[]}
 */
export function simplify(line, tolerance) {
  if (line.length < 3) return line;
  const [first, last] = [line[0], line[line.length - 1]];
  let far = 0;
  let worst = 0;
  for (let k = 1; k < line.length - 1; k++) {
    const d = nearestOnBoundary([first, last], line[k]).distance;
    if (d > worst) [worst, far] = [d, k];
  }
  if (worst <= tolerance) return [first, last];
  return [...simplify(line.slice(0, far + 1), tolerance).slice(0, -1), ...simplify(line.slice(far), tolerance)];
}
