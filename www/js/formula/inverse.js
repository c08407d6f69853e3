// Where a formula takes a given value: Newton's method from the best of many places, and from there along a figure.

import { flatten } from "../common/frame.js";
import { slopes, solved } from "./dilatation.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/placement.js").Placement} Placement */
/** @typedef {import("../../pkg/formula/index.js").FormulaMap} FormulaMap */

/** Places a side that are looked at, of which so many are followed. */
const SIDE = 56;
const SEEDS = 24;
const STEPS = 12;
/** A value is met within this share of the size of what is asked. */
const MET = 1e-9;

/**
 * Points p → z with f(z) = p; of the many that there may be, those about the one nearest to the middle of a view. Null where
 * there is none in the view, or where it was not found.
 * @param {FormulaMap} map @param {Point[]} points the first one first, the others near it @param {Placement} within @returns {(Point | null)[]}
 */
export function preimage(map, points, { center, width }) {
  const none = points.map(() => null);
  const [wanted, ...near] = points;
  const places = Array.from({ length: SIDE * SIDE }, (_, k) => /** @type {Point} */ ([
    center[0] + width * (((k % SIDE) + 0.5) / SIDE - 0.5),
    center[1] + width * ((Math.floor(k / SIDE) + 0.5) / SIDE - 0.5),
  ]));
  const flat = flatten(places);
  const [values, rises] = [map.eval(flat), slopes(map, flat)];
  // How far the root is by one step of Newton's: a small value of f' makes a small difference worth nothing.
  const steps = places.map((_, k) => Math.hypot(...solved(rises, k, values[2 * k] - wanted[0], values[2 * k + 1] - wanted[1])));
  const seeds = places.map((place, k) => ({ place, step: steps[k] })).filter(({ step }) => step < width).sort((a, b) => a.step - b.step).slice(0, SEEDS);
  const away = ([x, y] = /** @type {Point} */ ([0, 0])) => Math.max(Math.abs(x - center[0]), Math.abs(y - center[1]));
  const roots = newton(map, seeds.map(({ place }) => place), seeds.map(() => wanted)).filter((root) => root && away(root) <= width / 2);
  const [root] = roots.sort((a, b) => away(a ?? undefined) - away(b ?? undefined));
  if (!root) return none;
  const rise = slopes(map, flatten([root]));
  const starts = near.map(([x, y]) => {
    const [u, v] = solved(rise, 0, x - wanted[0], y - wanted[1]);
    return /** @type {Point} */ ([root[0] + u, root[1] + v]);
  });
  return [root, ...newton(map, starts, near)];
}

/** @param {FormulaMap} map @param {Point[]} from @param {Point[]} wanted @returns {(Point | null)[]} */
function newton(map, from, wanted) {
  if (!from.length) return [];
  const at = flatten(from);
  for (let step = 0; step < STEPS; step++) {
    const [values, rises] = [map.eval(at), slopes(map, at)];
    for (let k = 0; k < wanted.length; k++) {
      const [u, v] = solved(rises, k, values[2 * k] - wanted[k][0], values[2 * k + 1] - wanted[k][1]);
      at[2 * k] -= u;
      at[2 * k + 1] -= v;
    }
  }
  const values = map.eval(at);
  return wanted.map(([x, y], k) => {
    const off = Math.hypot(values[2 * k] - x, values[2 * k + 1] - y);
    return off <= MET * (1 + Math.hypot(x, y)) ? /** @type {Point} */ ([at[2 * k], at[2 * k + 1]]) : null;
  });
}
