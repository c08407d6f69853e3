// Whole solves of regions, with accuracy, estimate, unknowns and time side by side.

import { readFileSync } from "node:fs";
import { Region, RiemannMap } from "conformal-warp";
import { fixture, largestAngle, regionOf, square } from "./lib/fixtures.mjs";
import { Table, Target, ms, scientific } from "./lib/table.mjs";
import { milliseconds } from "./lib/timing.mjs";

/**
 * @typedef {object} Row
 * @property {string} name
 * @property {import("./lib/fixtures.mjs").Fixture} given
 * @property {number} tolerance asked of the solve
 * @property {number} [error] largest acceptable at the vertices
 * @property {number} [time] milliseconds at most
 */

/** @type {Row[]} */
const rows = [
  { name: "square", given: square, tolerance: 1e-10, error: 1e-10, time: 5 },
  { name: "20 vertices, dragging", given: polygon20(), tolerance: 1e-3, error: 1e-3, time: 16 },
  { name: "blob100", given: fixture("blob100"), tolerance: 1e-7, error: 1e-7, time: 400 },
  { name: "blob300", given: fixture("blob300"), tolerance: 1e-6, error: 1e-6, time: 1500 },
  { name: "blob1000", given: fixture("blob1000"), tolerance: 1e-4, error: 1e-4, time: 2000 },
  { name: "blob10000", given: fixture("blob10000"), tolerance: 1e-3, error: 1e-3, time: 20_000 },
  ...["sc_4_101", "sc_6_102", "sc_9_103", "sc_15_104", "sc_24_105"].map((name) => ({
    name,
    given: fixture(name),
    tolerance: 1e-10,
    error: 1e-10,
  })),
  ...["neck", "slot", "spike", "rect10", "rect20"].map((name) => ({ name, given: fixture(name), tolerance: 1e-8 })),
];

/** Every fifth vertex of blob100: what somebody draws by hand. */
function polygon20() {
  const { vertices, ...rest } = fixture("blob100");
  return { ...rest, vertices: vertices.filter((_, k) => k % 5 === 0) };
}

export default async function bench() {
  const columns = { case: 21, vertices: 8, tolerance: 9, "error at vertices": 21, reference: 15, estimate: 8, unknowns: 8 };
  const table = new Table("Solve: region → Riemann map", { ...columns, time: 22 });
  for (const row of rows) table.row(...measure(row));
  newCenter();
  outlinesOfCurves();
}

/** Another center on a solved blob100. */
function newCenter() {
  const table = new Table("Another center on a solved region", { case: 21, tolerance: 9, estimate: 8, time: 22 });
  const given = fixture("blob100");
  const map = RiemannMap.solve(regionOf(given), { tolerance: 1e-7 });
  const moved = { center: /** @type {[number, number]} */ ([0.2, -0.1]), toward: given.toward };
  const { errorEstimate } = map.withCenter(moved);
  const time = milliseconds(() => map.withCenter(moved).free());
  table.row("blob100", scientific(1e-7), scientific(errorEstimate), new Target(time, 5, ms));
}

/** Icons as people have them: lines, arcs and Béziers that meet in corners. */
function outlinesOfCurves() {
  const columns = { case: 21, edges: 8, tolerance: 9, estimate: 8, unknowns: 8, time: 22, "another center": 14, "a million points": 16 };
  const table = new Table("Outlines of lines, arcs and Béziers: region → Riemann map", columns);
  /** @type {{ name: string, text: string }[]} */
  const icons = Object.values(JSON.parse(readFileSync(new URL("../tests/fixtures/icons.json", import.meta.url), "utf8"))).flat();
  /** @type {[string, [number, number]][]} */
  const chosen = [["abjad-arabic", [8, -14.5]], ["currency-uah", [11, -10]], ["git", [6, -12]]];
  for (const [name, center] of chosen) {
    const path = Region.parseShape(/** @type {{ text: string }} */ (icons.find((icon) => icon.name === name)).text).path;
    const tolerance = 1e-8;
    const region = new Region({ path, center, toward: [0, 0] });
    const map = RiemannMap.solve(region, { tolerance });
    const time = milliseconds(() => RiemannMap.solve(region, { tolerance }).free());
    const again = milliseconds(() => map.withCenter({ center: [center[0] + 0.01, center[1]], toward: [0, 0] }).free());
    const images = Float64Array.from({ length: 2e6 }, (_, k) => 0.7 * Math.sin(12.9898 * k));
    map.prepare();
    const points = milliseconds(() => map.fromDisk(images));
    const edges = (path.match(/[LAQC]/g) ?? []).length;
    table.row(name, edges, scientific(tolerance), scientific(map.errorEstimate), map.unknowns, new Target(time, 60, ms), ms(again), ms(points));
    map.free();
  }
}

/** @param {Row} row */
function measure({ name, given, tolerance, error, time }) {
  const region = regionOf(given);
  const start = [name, given.vertices.length, scientific(tolerance)];
  try {
    const map = RiemannMap.solve(region, { tolerance });
    const spent = milliseconds(() => RiemannMap.solve(region, { tolerance }).free());
    const exact = given.angles;
    const reference = exact ?? tighter(region, tolerance);
    const found = reference ? largestAngle(map.angles, reference) : undefined;
    const result = [
      found === undefined ? "–" : error === undefined ? scientific(found) : new Target(found, error, scientific),
      exact ? "exact" : reference ? "a tighter solve" : "none",
      scientific(map.errorEstimate),
      map.unknowns,
      time === undefined ? ms(spent) : new Target(spent, time, ms),
    ];
    map.free();
    return [...start, ...result];
  } catch (refusal) {
    return [...start, /** @type {Error} */ (refusal).message];
  }
}

/**
 * The angles of a solve to a tenth of the tolerance, if that was reached.
 *
 * @param {import("conformal-warp").Region} region
 * @param {number} tolerance
 */
function tighter(region, tolerance) {
  try {
    const map = RiemannMap.solve(region, { tolerance: tolerance / 10 });
    const { angles, errorEstimate } = map;
    map.free();
    return errorEstimate <= tolerance / 10 ? angles : undefined;
  } catch {
    return undefined;
  }
}
