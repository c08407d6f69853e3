// An outline that meets itself → the nearest one that does not, and what was done to it.

import { area, meetings, sizeOf, spikeWidth } from "./geometry.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./geometry.js").Meeting} Meeting */
/** What was done: points and spikes taken out, parts cut off (with their share of the area), crossings joined the other way round. @typedef {{ repeated: number, spikes: number, loops: number[], pinches: number[], rejoined: number }} Changes */

/** A spike is taken out that is narrower than this share of the outline's size. */
const THIN = 1e-4;
/** Points nearer than this share are one. */
const SAME = 1e-9;
/** Of an eight, a half so large, as a share of the other, is not cut off: both are joined. */
const WORTH_KEEPING = 0.1;

/**
 * Takes out spikes, cuts off loops and what hangs on by a point, the smaller part each time; where an outline is like an 8 its
 * halves are joined. Null where too little is left. Each step makes the outline shorter, so that it ends.
 * @param {Point[]} outline @returns {{ outline: Point[], changes: Changes } | null}
 */
export function repairOutline(outline) {
  /** @type {Changes} */
  const changes = { repeated: 0, spikes: 0, loops: [], pinches: [], rejoined: 0 };
  const size = sizeOf(outline);
  const whole = grossArea(outline);
  let points = withoutSpikes(outline, size, changes);
  for (let step = 0; step < 2 * outline.length; step++) {
    const parts = meetings(points).map((met) => ({ met, ...partsAt(points, met) }));
    if (!parts.length) return points.length > 2 && Math.abs(area(points)) > SAME * size * size ? { outline: points, changes } : null;
    const { met, inner, outer } = parts.reduce((least, other) => (smaller(other) < smaller(least) ? other : least));
    const [a, b] = [area(inner), area(outer)];
    const [less, more] = [Math.min(Math.abs(a), Math.abs(b)), Math.max(Math.abs(a), Math.abs(b))];
    if (met.crossing && a > 0 !== b > 0 && less > WORTH_KEEPING * more) {
      points = rejoined(points, met);
      changes.rejoined++;
    } else {
      points = Math.abs(a) < Math.abs(b) ? outer : inner;
      (met.crossing ? changes.loops : changes.pinches).push(less / whole);
    }
    points = withoutSpikes(points, size, changes);
  }
  return null;
}

/** The two closed parts of an outline that meets itself. @param {Point[]} points @param {Meeting} met @returns {{ inner: Point[], outer: Point[] }} */
function partsAt(points, { first, second, at }) {
  return { inner: [at, ...points.slice(first + 1, second + 1)], outer: [at, ...points.slice(second + 1), ...points.slice(0, first + 1)] };
}

/** @param {{ inner: Point[], outer: Point[] }} parts */
const smaller = ({ inner, outer }) => Math.min(Math.abs(area(inner)), Math.abs(area(outer)));

/** The part between two crossing edges the other way round, so that they do not cross. @param {Point[]} points @param {Meeting} met */
const rejoined = (points, { first, second }) => [...points.slice(0, first + 1), ...points.slice(first + 1, second + 1).reverse(), ...points.slice(second + 1)];

/** What shares are shares of: for an outline that crosses itself its own area may be nothing. @param {Point[]} points */
function grossArea(points) {
  const parts = meetings(points).map((met) => partsAt(points, met));
  return Math.max(Math.abs(area(points)), ...parts.map(({ inner, outer }) => Math.abs(area(inner)) + Math.abs(area(outer))));
}

/** Points without repeated ones and without tips of spikes. @param {Point[]} outline @param {number} size @param {Changes} changes */
function withoutSpikes(outline, size, changes) {
  const points = [...outline];
  for (let k = 0; k < points.length && points.length > 2; ) {
    const [before, tip, after] = [-1, 0, 1].map((step) => points[(k + step + points.length) % points.length]);
    const repeated = Math.hypot(tip[0] - after[0], tip[1] - after[1]) <= SAME * size;
    const spike = !repeated && spikeWidth(before, tip, after) <= THIN * size;
    if (!repeated && !spike) {
      k++;
      continue;
    }
    changes[repeated ? "repeated" : "spikes"]++;
    points.splice(k, 1);
    // What is left of the spike may be one again.
    k = Math.max(0, k - 2);
  }
  return points;
}

/** @param {number} n @param {string} one @param {string} many */
const counted = (n, one, many) => (n === 1 ? one : `${n} ${many}`);

/** @param {number[]} shares */
function shareWords(shares) {
  const percent = 100 * shares.reduce((sum, share) => sum + share, 0);
  return `${percent < 0.1 ? "less than 0.1" : percent < 10 ? percent.toFixed(1).replace(/\.0$/, "") : Math.round(percent)} % of the area`;
}

/** What was done, for the visitor. @param {Changes} changes */
export function changeWords({ repeated, spikes, loops, pinches, rejoined: joined }) {
  const said = [
    loops.length && `cut off ${counted(loops.length, "a loop", "loops")} (${shareWords(loops)})`,
    pinches.length && `cut off ${counted(pinches.length, "a part that hung on by a point or a line", "parts that hung on by a point or a line")} (${shareWords(pinches)})`,
    joined && `joined the points the other way round at ${counted(joined, "a crossing", "crossings")}`,
    spikes && `took out ${counted(spikes, "a spike", "spikes")} without width`,
    repeated && `took out ${counted(repeated, "a repeated point", "repeated points")}`,
  ].filter(Boolean);
  return `Repaired: ${said.join("; ")}. Undo takes it back.`;
}
