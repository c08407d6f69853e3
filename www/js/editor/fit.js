// A closed line that a hand drew → few curves near it: Schneider's algorithm (Graphics Gems, 1990) between the corners that were drawn.

import { pointOn } from "./curve.js";
import { distance, plus } from "./geometry.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./curve.js").Bezier} Bezier */
/** @typedef {[a: Point, first: Point, second: Point, b: Point]} Cubic */

/** A corner turns by more than this within twice the reach, as a cosine; hands do not draw sharper bends without meaning one. */
const CORNER = Math.cos((50 * Math.PI) / 180);
/** Times that parameters are moved to where the curve is nearest. */
const ROUNDS = 6;

/** @param {Point} p @param {Point} q */
const dot = (p, q) => p[0] * q[0] + p[1] * q[1];
/** @param {Point} from @param {Point} to @returns {Point} the direction */
const towards = (from, to) => {
  const length = distance(from, to) || 1;
  return [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
};

/**
 * @param {Point[]} line closed: its last point is followed by its first one @param {number} slack how far a curve may be off it
 * @param {number} reach how far around a point its direction is looked for @returns {import("./outline.js").Outline}
 */
export function fitted(line, slack, reach) {
  const corners = cornersOf(line, reach);
  const starts = corners.length ? corners : [0];
  const cubics = starts.flatMap((start, k) => {
    const part = along(line, start, starts[(k + 1) % starts.length]);
    // Without corners the ends of the only part go on into each other.
    const [from, to] = corners.length ? [direction(part, reach), direction([...part].reverse(), reach)] : smoothEnds(line, reach);
    return fitPart(part, from, to, slack, reach);
  });
  return { boundary: cubics.map(([a]) => a), curves: cubics.map(asCurve) };
}

/** A cubic as an edge: a line, where it is as good as one. @param {Cubic} cubic */
function asCurve([a, first, second, b]) {
  const way = towards(a, b);
  const off = [first, second].map((p) => Math.abs((p[0] - a[0]) * way[1] - (p[1] - a[1]) * way[0]));
  return Math.max(...off) < 1e-3 * distance(a, b) ? null : /** @type {Bezier} */ ({ kind: "curve", first, second });
}

/** The points from one index to another, around the end of the line. @param {Point[]} line @param {number} from @param {number} to */
function along(line, from, to) {
  return to > from ? line.slice(from, to + 1) : [...line.slice(from), ...line.slice(0, to + 1)];
}

/** The index so far along the line, in steps of `side` 1 or −1. @param {Point[]} line @param {number} index @param {number} reach @param {number} side */
function away(line, index, reach, side) {
  let [at, gone] = [index, 0];
  for (let k = 0; k < line.length && gone < reach; k++) {
    const next = (at + side + line.length) % line.length;
    gone += distance(line[at], line[next]);
    at = next;
  }
  return at;
}

/** Where the line has corners: the sharpest places, apart from each other. @param {Point[]} line @param {number} reach @returns {number[]} in rising order */
function cornersOf(line, reach) {
  const turns = line.map((p, k) => dot(towards(line[away(line, k, reach, -1)], p), towards(p, line[away(line, k, reach, 1)])));
  const sharp = turns.flatMap((turn, k) => (turn < CORNER ? [k] : [])).sort((a, b) => turns[a] - turns[b]);
  /** @type {number[]} */
  const kept = [];
  for (const k of sharp) {
    if (kept.every((other) => distance(line[k], line[other]) > 1.5 * reach)) kept.push(k);
  }
  return kept.sort((a, b) => a - b);
}

/** The direction in which a part begins. @param {Point[]} part @param {number} reach @returns {Point} */
function direction(part, reach) {
  const far = part.find((p) => distance(p, part[0]) >= reach) ?? part[part.length - 1];
  return towards(part[0], far);
}

/** The directions into a closed line from its first point, forth and back. @param {Point[]} line @param {number} reach @returns {[Point, Point]} */
function smoothEnds(line, reach) {
  const way = towards(line[away(line, 0, reach, -1)], line[away(line, 0, reach, 1)]);
  return [way, [-way[0], -way[1]]];
}

/** @param {Point[]} part @param {Point} from @param {Point} to directions at both ends, inwards @param {number} slack @param {number} reach @returns {Cubic[]} */
function fitPart(part, from, to, slack, reach) {
  const [a, b] = [part[0], part[part.length - 1]];
  if (part.length < 4) {
    const third = distance(a, b) / 3;
    return [[a, plus(a, from, third), plus(b, to, third), b]];
  }
  let times = chordTimes(part);
  let best = bestCubic(part, times, from, to);
  for (let round = 0; round < ROUNDS; round++) {
    const { worst, at } = farthest(part, times, best);
    if (worst <= slack) return [best];
    if (worst > 16 * slack || round === ROUNDS - 1) {
      const before = along(part, 0, at);
      const split = part.slice(at);
      const way = towards(part[Math.max(0, at - stepsOf(part, at, reach, -1))], part[Math.min(part.length - 1, at + stepsOf(part, at, reach, 1))]);
      return [...fitPart(before, from, [-way[0], -way[1]], slack, reach), ...fitPart(split, way, to, slack, reach)];
    }
    times = nearer(part, times, best);
    best = bestCubic(part, times, from, to);
  }
  return [best];
}

/** Steps from a point of an open line that go about so far, and stay on it. @param {Point[]} part @param {number} at @param {number} reach @param {1 | -1} side */
function stepsOf(part, at, reach, side) {
  let steps = 1;
  while (part[at + side * (steps + 1)] && distance(part[at], part[at + side * steps]) < reach) steps++;
  return steps;
}

/** Parameters by lengths along the line. @param {Point[]} part */
function chordTimes(part) {
  const lengths = [0];
  for (let k = 1; k < part.length; k++) lengths.push(lengths[k - 1] + distance(part[k], part[k - 1]));
  return lengths.map((length) => length / (lengths[lengths.length - 1] || 1));
}

/** The cubic with these directions at its ends that is nearest by least squares. @param {Point[]} part @param {number[]} times @param {Point} from @param {Point} to @returns {Cubic} */
function bestCubic(part, times, from, to) {
  const [a, b] = [part[0], part[part.length - 1]];
  let [c00, c01, c11, x0, x1] = [0, 0, 0, 0, 0];
  part.forEach((p, k) => {
    const t = times[k];
    const s = 1 - t;
    const [b0, b1, b2, b3] = [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
    /** @type {Point} */
    const rest = [p[0] - a[0] * (b0 + b1) - b[0] * (b2 + b3), p[1] - a[1] * (b0 + b1) - b[1] * (b2 + b3)];
    c00 += b1 * b1;
    c01 += b1 * b2 * dot(from, to);
    c11 += b2 * b2;
    x0 += b1 * dot(from, rest);
    x1 += b2 * dot(to, rest);
  });
  const size = distance(a, b);
  const det = c00 * c11 - c01 * c01;
  let [u, v] = [(x0 * c11 - x1 * c01) / det, (c00 * x1 - c01 * x0) / det];
  // Where least squares turn an end around, a third of the way will do.
  const least = 1e-3 * size;
  if (!(u > least) || !(v > least) || u > 3 * size || v > 3 * size) u = v = size / 3;
  return [a, plus(a, from, u), plus(b, to, v), b];
}

/** @param {Cubic} cubic @param {number} t @returns {Point} */
const at = ([a, first, second, b], t) => pointOn(a, b, { kind: "curve", first, second }, t);

/** The inner point of the line that is farthest from the curve. @param {Point[]} part @param {number[]} times @param {Cubic} cubic */
function farthest(part, times, cubic) {
  let [worst, index] = [0, Math.floor(part.length / 2)];
  for (let k = 1; k + 1 < part.length; k++) {
    const off = distance(part[k], at(cubic, times[k]));
    if (off > worst) [worst, index] = [off, k];
  }
  return { worst, at: index };
}

/** Parameters moved by a step of Newton's method to where the curve is nearest. @param {Point[]} part @param {number[]} times @param {Cubic} cubic */
function nearer(part, times, [a, p, q, b]) {
  const moved = part.map((point, k) => {
    const t = times[k];
    const s = 1 - t;
    const off = plus(at([a, p, q, b], t), point, -1);
    const [u, v, w] = [plus(p, a, -1), plus(q, p, -1), plus(b, q, -1)];
    const slope = plus(plus([3 * s * s * u[0], 3 * s * s * u[1]], v, 6 * s * t), w, 3 * t * t);
    const [y, z] = [plus(v, u, -1), plus(w, v, -1)];
    const bend = plus([6 * s * y[0], 6 * s * y[1]], z, 6 * t);
    const fall = dot(slope, slope) + dot(off, bend);
    return Math.min(1, Math.max(0, fall > 0 ? t - dot(off, slope) / fall : t));
  });
  // They must go on rising.
  for (let k = 1; k < moved.length; k++) moved[k] = Math.max(moved[k], moved[k - 1]);
  return moved;
}
