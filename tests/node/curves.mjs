// Regions drawn by curves: paths, edges and SVG files, and the maps of them.

import assert from "node:assert/strict";
import { before, test } from "node:test";
import init, { AnnulusMap, JointTriangulation, Region, RiemannMap } from "conformal-warp";

before(() => init());

/** @type {{ center: [number, number], toward: [number, number] }} */
const above = { center: [0, 0.5], toward: [1, 0] };
const halfDisk = "M-1 0H1A1 1 0 0 1-1 0Z";

/**
 * Half disk → disk: w = ((1 + z)/(1 − z))² takes it to the upper half plane, (w − w₀)/(w − w̄₀) that to the disk, 1 to 1.
 *
 * @param {number[]} z
 */
function exactMap(z) {
  const over = (/** @type {number[]} */ [a, b], /** @type {number[]} */ [c, d]) => [(a * c + b * d) / (c * c + d * d), (b * c - a * d) / (c * c + d * d)];
  const w = (/** @type {number[]} */ [x, y]) => {
    const [u, v] = over([1 + x, y], [1 - x, -y]);
    return [u * u - v * v, 2 * u * v];
  };
  const [[a, b], [c, d]] = [w(z), w(above.center)];
  return over([a - c, b - d], [a - c, b + d]);
}

test("a half disk, as a path and as edges, has conformal radius 0.6 at i/2", () => {
  /** @type {import("conformal-warp").EdgeOptions[]} */
  const edges = [{ line: [[-1, 0], [1, 0]] }, { arc: { center: [0, 0], radii: [1, 1], start: 0, sweep: Math.PI } }];
  for (const region of [new Region({ path: halfDisk, ...above }), new Region({ edges, ...above })]) {
    const map = RiemannMap.solve(region, { tolerance: 1e-12 });
    assert.ok(Math.abs(map.conformalRadius - 0.6) < 1e-13, `${map.conformalRadius}`);
    const points = new Float64Array([0, 0.999, 0.3, 1e-6, -0.7, 0.7, 0.2, 0.4]);
    const images = map.toDisk(points);
    for (let k = 0; k < points.length; k += 2) {
      const exact = exactMap([points[k], points[k + 1]]);
      const error = Math.hypot(images[k] - exact[0], images[k + 1] - exact[1]);
      assert.ok(error < 1e-12 && error < 1e-14 + map.errorEstimate, `${points[k]}, ${points[k + 1]}: ${error}, estimated ${map.errorEstimate}`);
    }
    const again = RiemannMap.fromBytes(map.toBytes());
    assert.deepEqual(again.toDisk(new Float64Array([0.3, 0.2])), map.toDisk(new Float64Array([0.3, 0.2])));
  }
});

test("what is inside is decided on the curve, and its polygon looks like it", () => {
  const region = new Region({ path: halfDisk, ...above });
  for (const angle of [0.1, 1, 2.5]) {
    const at = (/** @type {number} */ r) => [r * Math.cos(angle), r * Math.sin(angle)];
    assert.deepEqual([...region.contains(new Float64Array([...at(1 - 1e-13), ...at(1 + 1e-13)]))], [1, 0]);
  }
  const { boundary } = region;
  assert.ok(boundary.length > 200);
  for (let k = 0; k < boundary.length; k += 2) {
    const onArc = Math.abs(Math.hypot(boundary[k], boundary[k + 1]) - 1);
    assert.ok(Math.min(onArc, Math.abs(boundary[k + 1])) < 1e-15);
  }
  assert.match(/** @type {string} */ (region.path), /^M-1 0L1 0A1 1 0 0 1 .*Z$/);
  assert.deepEqual(new Region({ path: region.path, ...above }).boundary.length, boundary.length);
  assert.equal(new Region({ boundary: new Float64Array([0, 0, 1, 0, 0, 1]), center: [0.2, 0.2], toward: [0, 0] }).path, undefined);
  // Clockwise is turned around.
  assert.deepEqual(new Region({ path: "M-1 0A1 1 0 0 0 1 0Z", ...above }).toward, [1, 0]);
  const [first, second] = ["0 3 1 -3 2 0", "0 3 1 3 2 0"];
  assert.throws(() => new Region({ path: `M0 0C${first}Z`, center: [0.5, 0.5], toward: [0, 0] }), { code: "self-intersecting" });
  assert.ok(new Region({ path: `M0 0C${second}Z`, center: [1, 1], toward: [0, 0] }));
});

test("Béziers among edges are those of paths", () => {
  const drawn = new Region({ path: "M0 0Q1 -1 2 0C3 1 1 2 0 2Z", center: [1, 1], toward: [2, 0] });
  const edges = new Region({
    edges: [{ bezier: [[0, 0], [1, -1], [2, 0]] }, { bezier: [[2, 0], [3, 1], [1, 2], [0, 2]] }, { line: [[0, 2], [0, 0]] }],
    center: [1, 1],
    toward: [2, 0],
  });
  assert.equal(edges.path, drawn.path);
  // A tilted ellipse by its own numbers, whole.
  const arc = { center: /** @type {[number, number]} */ ([1, 2]), radii: /** @type {[number, number]} */ ([3, 1]), rotation: 0.5, start: 0, sweep: 2 * Math.PI };
  const ellipse = new Region({ edges: [{ arc }], center: [1, 2], toward: [9, 2] });
  const tip = (/** @type {number} */ r) => [1 + r * Math.cos(0.5), 2 + r * Math.sin(0.5)];
  assert.deepEqual([...ellipse.contains(new Float64Array([...tip(3 - 1e-13), ...tip(3 + 1e-13)]))], [1, 0]);
});

test("SVG files become paths with holes, in plane coordinates", () => {
  const file = "<svg viewBox='0 0 9 9'><g transform='translate(1 1)'><circle cx='1' cy='1' r='1'/><circle cx='1' cy='1' r='.25'/></g></svg>";
  const { path, holes } = Region.parseShape(file, { scale: 2 });
  const disk = new Region({ path, center: [4, -4], toward: [6, -4] });
  assert.ok(Math.abs(RiemannMap.solve(disk).conformalRadius - 2) < 1e-13);
  assert.equal(holes.length, 1);
  const hole = new Region({ path: holes[0], center: [4, -4], toward: [5, -4] });
  assert.deepEqual([...hole.contains(new Float64Array([4.499, -4, 4.501, -4]))], [1, 0]);
  assert.throws(() => Region.parseShape("M0 0h1v1zM5 5h1v1z"), { code: "invalid-outline", message: /2 curves/ });
  assert.throws(() => Region.parseShape("M0 0h1v1x"), { code: "invalid-outline", message: /“x” \(character 9\)/ });
});

test("curves are triangulated, and so are maps between them and polygons", () => {
  const half = RiemannMap.solve(new Region({ path: halfDisk, ...above }));
  const square = RiemannMap.solve(new Region({ boundary: new Float64Array([-1, -1, 1, -1, 1, 1, -1, 1]), center: [0, 0], toward: [1, 0] }));
  /** @type {import("conformal-warp").Frame} */
  const frame = { center: [0, 0], width: 2, pixels: [300, 300] };
  for (const mesh of [JointTriangulation.regionToDisk(half, { maxErrorPixels: 0.25, frame }), JointTriangulation.regionToRegion(square, half, { maxErrorPixels: 0.25, frame })]) {
    mesh.validate();
    assert.equal(mesh.flipped, 0);
    assert.ok((mesh.evidence.largestErrorPixels ?? NaN) <= 0.25);
  }
});

test("a curve goes through points, with the corners that are marked", () => {
  const count = 60;
  const through = new Float64Array(2 * count);
  for (let k = 0; k < count; k++) through.set([Math.cos((Math.PI * k) / (count - 1)), Math.sin((Math.PI * k) / (count - 1))], 2 * k);
  const { conformalRadius, errorEstimate } = RiemannMap.solve(new Region({ through, corners: [0, count - 1], ...above }), { tolerance: 1e-8 });
  // What the spline leaves out of the half circle is no error of the map.
  assert.ok(errorEstimate < 1e-8 && Math.abs(conformalRadius - 0.6) < 3e-7, String(conformalRadius - 0.6));
  const circle = RiemannMap.solve(new Region({ through: through.map((value, k) => (k % 2 ? Math.sin : Math.cos)((2 * Math.PI * (k >> 1)) / count)), center: [0, 0], toward: [1, 0] }));
  assert.ok(Math.abs(circle.conformalRadius - 1) < 1e-6);
});

test("letters with counters are regions", () => {
  const { path, holes } = Region.parseShape("M0 0 H2 V-2 H0 Z M0.5 -0.5 H1 A0.5 0.5 0 0 0 1 -1.5 H0.5 Z");
  const letter = new Region({ path, holes });
  const { innerRadius, errorEstimate } = AnnulusMap.solve(letter, { tolerance: 1e-8 });
  assert.ok(innerRadius > 0.3 && innerRadius < 0.8 && errorEstimate <= 1e-8);
  const same = AnnulusMap.solve(new Region({ path: letter.path ?? "" }), { tolerance: 1e-8 });
  assert.ok(Math.abs(same.innerRadius - innerRadius) < 2e-8);
});

test("smooth holes lie in polygons and paths, each joined in its own way", () => {
  const round = new Float64Array(64).map((_, k) => 0.6 * (k % 2 ? Math.sin : Math.cos)((2 * Math.PI * (k >> 1)) / 32));
  const [boundary, path] = [new Float64Array([-1, -1, 1, -1, 1, 1, -1, 1]), "M-1 -1H1V1H-1Z"];
  const exact = AnnulusMap.solve(new Region({ path, holes: ["M0.6 0A0.6 0.6 0 0 1 -0.6 0A0.6 0.6 0 0 1 0.6 0Z"] }), { tolerance: 1e-10 }).innerRadius;
  /** @type {Partial<import("../../pkg/index.js").RegionOptions>[]} */
  const outlines = [{ boundary }, { boundary, curve: "polygon" }, { path }];
  for (const outline of outlines) {
    const { innerRadius, errorEstimate } = AnnulusMap.solve(new Region({ ...outline, holes: [{ boundary: round, curve: "smooth" }] }), { tolerance: 1e-10 });
    assert.ok(errorEstimate <= 1e-10 && Math.abs(innerRadius - exact) < 1e-10, String(innerRadius - exact));
  }
  const bodies = Region.exterior({ holes: [{ boundary: round, curve: "smooth" }, boundary.map((x, k) => (k % 2 ? x : x + 3))] });
  assert.ok(bodies.contains(new Float64Array([0, 0.61]))[0] && !bodies.contains(new Float64Array([0, 0.59]))[0]);
  const wrong = /** @type {any} */ ([{ boundary: round }, { boundary: round, curve: "round" }, { boundary: 3, curve: "smooth" }, { round }]);
  for (const hole of wrong) assert.throws(() => new Region({ boundary, holes: [hole] }), { code: "invalid-option", message: /hole|boundary|curve/ });
});

test("what curves cannot be is refused in words", () => {
  const region = new Region({ path: halfDisk, ...above });
  const hole = new Float64Array([-0.1, 0.4, 0.1, 0.4, 0, 0.6]);
  /** @type {[code: string, words: RegExp, call: () => unknown][]} */
  const refused = [
    ["invalid-option", /"curve" goes with "boundary" alone/, () => new Region({ path: halfDisk, holes: [hole], curve: "polygon", ...above })],
    ["invalid-option", /"curve" goes with "boundary" alone/, () => new Region({ path: halfDisk, curve: "smooth", ...above })],
    ["invalid-option", /one of the options "boundary", "path", "edges" and "through"/, () => new Region(above)],
    ["invalid-option", /"corners" goes with "through" alone/, () => new Region({ path: halfDisk, corners: [0], ...above })],
    ["invalid-option", /indices of points/, () => new Region({ through: hole, corners: [3], ...above })],
    ["invalid-option", /one of the options "boundary", "path", "edges" and "through"/, () => new Region({ path: halfDisk, edges: [], ...above })],
    ["invalid-option", /edges\[0\].*one of line, arc and bezier/, () => new Region({ edges: [{}], ...above })],
    ["invalid-option", /edges\[0\].*3 or 4 control points/, () => new Region({ edges: [{ bezier: [[0, 0], [1, 1]] }], ...above })],
    ["invalid-option", /edges\[0\]\.line.*an array of 2 points/, () => new Region({ edges: [/** @type {any} */ ({ line: [[0, 0]] })], ...above })],
    ["invalid-option", /edges\[0\]\.arc\.sweep" is missing/, () => new Region({ edges: [/** @type {any} */ ({ arc: { center: [0, 0], radii: [1, 1], start: 0 } })], ...above })],
    ["invalid-outline", /edge 0 does not end where the next one starts/, () => new Region({ edges: [{ line: [[0, 0], [1, 0]] }, { line: [[1, 1], [0, 0]] }], ...above })],
    ["invalid-outline", /2 curves/, () => new Region({ path: "M0 0h1v1zm3 0h1v1z", ...above })],
    ["cusp", /near \(0, 0\)/, () => new Region({ path: "M0 0A1 1 0 0 1 -1 1L-2 1L-2 -1L2 -1L2 1L1 1A1 1 0 0 1 0 0Z", ...above })],
    ["self-intersecting", /edge 0 meets edge 2/, () => new Region({ path: "M0 0Q1 2 2 0L2 1L0 0.5Z", ...above })],
    ["center-outside", /must lie inside/, () => new Region({ path: halfDisk, center: [0, 1.0000001], toward: [1, 0] })],
    ["wrong-region", /./, () => AnnulusMap.solve(region)],
  ];
  for (const [code, message, call] of refused) assert.throws(call, { code, message });
});
