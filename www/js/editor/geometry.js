// Plane geometry that the editor needs at once, before the worker has answered.

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {{ edge: number, t: number, point: Point, distance: number }} EdgePoint edge k runs from vertex k to k + 1 */

/** @param {Point} a @param {Point} b */
export const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** The point at share t of the way from a to b. @param {Point} a @param {Point} b @param {number} t @returns {Point} */
export const mix = (a, b, t) => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];

/** p, and so many times q more. @param {Point} p @param {Point} q @param {number} [times] @returns {Point} */
export const plus = (p, q, times = 1) => [p[0] + times * q[0], p[1] + times * q[1]];

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
export function nearestOnBoundary(polygon, [x, y]) {
  let [edge, share, least] = [0, 0, Infinity];
  for (let k = 0; k < polygon.length; k++) {
    const a = polygon[k];
    const b = polygon[(k + 1) % polygon.length];
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    const length2 = dx * dx + dy * dy;
    const t = length2 ? Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / length2)) : 0;
    const d = Math.hypot(a[0] + dx * t - x, a[1] + dy * t - y);
    if (d < least) [edge, share, least] = [k, t, d];
  }
  return { edge, t: share, point: mix(polygon[edge], polygon[(edge + 1) % polygon.length], share), distance: least };
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

/** Points count as one that are this near, as a share of the polygon's size. */
const SAME = 1e-12;

/**
 * Where two edges that are no neighbours meet, or an edge folds back on the one before it.
 * @typedef {{ first: number, second: number, at: Point, crossing: boolean }} Meeting `crossing`: they go through each other instead of touching
 */

/** Where the segments ab and cd meet, if they do; `near` counts as touching. @param {Point} a @param {Point} b @param {Point} c @param {Point} d @param {number} near @returns {{ at: Point, crossing: boolean } | null} */
function meeting(a, b, c, d, near) {
  const [p, q, r, s] = [turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)];
  const apart = p > 0 === q > 0 || r > 0 === s > 0;
  if (!apart && p && q && r && s) return { at: mix(c, d, p / (p - q)), crossing: true };
  // Boxes that are apart need no closer look.
  if (Math.max(a[0], b[0]) + near < Math.min(c[0], d[0]) || Math.max(c[0], d[0]) + near < Math.min(a[0], b[0])) return null;
  if (Math.max(a[1], b[1]) + near < Math.min(c[1], d[1]) || Math.max(c[1], d[1]) + near < Math.min(a[1], b[1])) return null;
  /** @type {[Point, Point, Point][]} */
  const ends = [[a, c, d], [b, c, d], [c, a, b], [d, a, b]];
  const touching = ends.find(([end, from, to]) => offSegment(end, from, to) <= near);
  return touching ? { at: touching[0], crossing: false } : null;
}

/** How far p lies from the segment ab. @param {Point} p @param {Point} a @param {Point} b */
export function offSegment(p, a, b) {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const length2 = dx * dx + dy * dy;
  const t = length2 ? Math.min(1, Math.max(0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2)) : 0;
  return Math.hypot(a[0] + dx * t - p[0], a[1] + dy * t - p[1]);
}

/** Every place where the polygon meets itself. @param {Point[]} polygon @returns {Meeting[]} */
export function meetings(polygon) {
  const n = polygon.length;
  const near = SAME * sizeOf(polygon);
  /** @type {Map<number, Meeting>} */
  const found = new Map();
  for (const edges of cellsOf(polygon)) {
    for (let a = 0; a < edges.length; a++) {
      for (let b = a + 1; b < edges.length; b++) {
        const [first, second] = [edges[a], edges[b]];
        if (second - first < 2 || (first === 0 && second === n - 1) || found.has(first * n + second)) continue;
        const met = meeting(polygon[first], polygon[first + 1], polygon[second], polygon[(second + 1) % n], near);
        if (met) found.set(first * n + second, { first, second, ...met });
      }
    }
  }
  polygon.forEach((tip, k) => {
    const before = (k + n - 1) % n;
    if (spikeWidth(polygon[before], tip, polygon[(k + 1) % n]) <= near) found.set(before * n + k, { first: before, second: k, at: tip, crossing: false });
  });
  return [...found.values()];
}

/** The edges of two polygons that meet each other. @param {Point[]} one @param {Point[]} other @returns {[Set<number>, Set<number>]} */
export function crossings(one, other) {
  const [here, there] = [new Set(), new Set()];
  const [a, b] = [boxOf(one), boxOf(other)];
  if (a.left > b.right || b.left > a.right || a.low > b.high || b.low > a.high) return [here, there];
  const near = SAME * sizeOf(one);
  one.forEach((from, k) => {
    other.forEach((start, n) => {
      if (!meeting(from, one[(k + 1) % one.length], start, other[(n + 1) % other.length], near)) return;
      here.add(k);
      there.add(n);
    });
  });
  return [here, there];
}

/** How wide a spike is at the end of its shorter side; infinite where the outline does not turn back at its tip. @param {Point} before @param {Point} tip @param {Point} after */
export function spikeWidth(before, tip, after) {
  const [u, v, x, y] = [before[0] - tip[0], before[1] - tip[1], after[0] - tip[0], after[1] - tip[1]];
  if (u * x + v * y <= 0) return Infinity;
  return Math.abs(u * y - v * x) / Math.max(Math.hypot(u, v), Math.hypot(x, y));
}

/** The edges that meet another one where they should not. @param {Point[]} polygon @returns {Set<number>} */
export const crossingEdges = (polygon) => new Set(meetings(polygon).flatMap(({ first, second }) => [first, second]));

/** The longer side of the box around the points. @param {Point[]} points */
export function sizeOf(points) {
  const { left, low, right, high } = boxOf(points);
  return Math.max(right - left, high - low);
}

/** A grid over the polygon, about as many cells as edges: for each cell the edges that may pass it, in order. @param {Point[]} polygon @returns {Iterable<number[]>} */
function cellsOf(polygon) {
  const n = polygon.length;
  const { left, low, right, high } = boxOf(polygon);
  const side = Math.max(1, Math.ceil(Math.sqrt(n)));
  /** @param {number} value @param {number} from @param {number} to */
  const index = (value, from, to) => Math.min(side - 1, Math.max(0, Math.floor(((value - from) / (to - from || 1)) * side)));
  /** @type {Map<number, number[]>} */
  const cells = new Map();
  polygon.forEach((a, k) => {
    const b = polygon[(k + 1) % n];
    const [first, last] = a[0] <= b[0] ? [a, b] : [b, a];
    const end = index(last[0], left, right);
    for (let column = index(first[0], left, right); column <= end; column++) {
      // The edge's own heights within the column, and a little more for rounding.
      const [x0, x1] = [0, 1].map((step) => left + ((column + step) / side) * (right - left));
      const [y0, y1] = [heightAt(first, last, x0), heightAt(first, last, x1)];
      const slack = 1e-9 * (high - low);
      const top = index(Math.max(y0, y1) + slack, low, high);
      for (let row = index(Math.min(y0, y1) - slack, low, high); row <= top; row++) {
        const cell = column + side * row;
        const known = cells.get(cell);
        if (known) known.push(k);
        else cells.set(cell, [k]);
      }
    }
  });
  return cells.values();
}

/** The height of a segment at x, or of its end nearest to it. @param {Point} a @param {Point} b to the right of a @param {number} x */
function heightAt(a, b, x) {
  if (x <= a[0]) return a[1];
  return x >= b[0] ? b[1] : a[1] + ((x - a[0]) / (b[0] - a[0])) * (b[1] - a[1]);
}

/** @param {Point[]} points */
function boxOf(points) {
  let [left, low, right, high] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of points) {
    [left, right] = [Math.min(left, x), Math.max(right, x)];
    [low, high] = [Math.min(low, y), Math.max(high, y)];
  }
  return { left, low, right, high };
}

/** How much nearness to the corners counts beside depth: it decides between points of a band, all equally deep. */
const MIDDLE = 0.1;
/** Lines of the grid that is looked at; corners that say where the middle is; points times edges that are looked at. */
const STEPS = 40;
const CORNERS = 100;
const EFFORT = 2e6;
/** Of points that differ by rounding the first is taken, on every photo the same one. */
const EVEN = 1e-9;

/**
 * A point well inside: on a grid, one far from the boundary and in the middle of it; not in one of the holes.
 * @param {Point[]} polygon @param {Point[][]} [holes] @returns {Point}
 */
export function deepPoint(polygon, holes = []) {
  const { left, low, right, high } = boxOf(polygon);
  const steps = Math.max(8, Math.min(STEPS, Math.floor(Math.sqrt(EFFORT / polygon.length))));
  const every = Math.ceil(polygon.length / CORNERS);
  const corners = polygon.filter((_, k) => k % every === 0);
  let best = { point: between(polygon), score: -Infinity };
  for (let i = 1; i < steps; i++) {
    for (let j = 1; j < steps; j++) {
      /** @type {Point} */
      const point = [left + ((right - left) * i) / steps, low + ((high - low) * j) / steps];
      if (!contains(polygon, point) || holes.some((hole) => contains(hole, point))) continue;
      const away = corners.reduce((sum, corner) => sum + distance(corner, point), 0) / corners.length;
      const depth = Math.min(...[polygon, ...holes].map((outline) => nearestOnBoundary(outline, point).distance));
      const score = depth - MIDDLE * away;
      if (score > best.score + EVEN * (right - left)) best = { point, score };
    }
  }
  return best.point;
}

/** A point inside where no grid finds one: half way along a level line, between two edges. @param {Point[]} polygon @returns {Point} */
function between(polygon) {
  const { low, high } = boxOf(polygon);
  let best = { point: polygon[0], width: 0 };
  for (let k = 1; k < STEPS; k++) {
    const y = low + ((high - low) * (k + 0.5 / STEPS)) / STEPS;
    const xs = polygon.flatMap((a, e) => {
      const b = polygon[(e + 1) % polygon.length];
      return a[1] > y === b[1] > y ? [] : [a[0] + ((y - a[1]) / (b[1] - a[1])) * (b[0] - a[0])];
    }).sort((p, q) => p - q);
    for (let e = 0; e + 1 < xs.length; e += 2) {
      if (xs[e + 1] - xs[e] > best.width) best = { point: [(xs[e] + xs[e + 1]) / 2, y], width: xs[e + 1] - xs[e] };
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

/**
 * The same of a closed line, whose first point stays: cut at the point farthest from it, since its own ends meet and would be one point.
 * @param {Point[]} line @param {number} tolerance @returns {Point[]}
 */
export function simplifyClosed(line, tolerance) {
  const [start] = line;
  const far = line.reduce((best, p, k) => (distance(p, start) > distance(line[best], start) ? k : best), 0);
  return [line.slice(0, far + 1), [...line.slice(far), start]].flatMap((half) => simplify(half, tolerance).slice(0, -1));
}
