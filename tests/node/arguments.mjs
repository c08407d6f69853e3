// Wrong calls: whatever is given for whatever is asked, the answer is an Error with a code and a sentence, and the module
// works on.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { before, test } from "node:test";
import * as warp from "conformal-warp";
import { calls, types } from "../../pkg/signatures.js";

/** @typedef {import("../../js/check.js").Type} Type */
/** @typedef {import("../../js/check.js").Parameter} Parameter */

const { default: init, AnnulusMap, ChannelFlow, CircleMap, Electrostatics, ExteriorMap, FormulaMap, FoveatedTexture, HalfPlaneMap, JointTriangulation, PotentialFlow, RectangleMap, Region, RegionMap, RetinoCorticalMap, RiemannMap, SlitMap, StripMap, Texture } = warp;

const declared = readFileSync(new URL("../../pkg/index.d.ts", import.meta.url), "utf8");
const codes = new Set([.../** @type {RegExpExecArray} */ (/type ErrorCode = (.*);/.exec(declared))[1].matchAll(/"([a-z-]+)"/g)].map(([, code]) => code));
/** Words of the machinery that no user should have to know. */
const MACHINERY = /wasm|rust|unreachable|__wbg|null pointer|\bf64\b|\busize\b|\bu8\b|\bu32\b|struct |expected instance|recursive use|ownership|undefined is not|not a function|Cannot read|\[object/i;

/** @type {any} */
let fine;

before(async () => {
  await init();
  const region = new Region({ boundary: new Float64Array([-1, -1, 1, -1, 1, 1, -1, 1]), center: [0, 0], toward: [1, 0] });
  const map = RiemannMap.solve(region);
  const square = (/** @type {number} */ half) => new Float64Array([-half, -half, half, -half, half, half, -half, half]);
  const ring = new Region({ boundary: square(1), holes: [square(0.5)] });
  const annulus = AnnulusMap.solve(ring);
  const holed = {
    AnnulusMap: annulus,
    LevelLines: annulus.levelLines("circles", new Float64Array([0.8])),
    ChannelFlow: ChannelFlow.solve(region, { ends: [[-1, 0], [1, 0]] }),
    RectangleMap: RectangleMap.solve(region, { corners: [[-1, -1], [1, -1], [1, 1], [-1, 1]] }),
    StripMap: StripMap.solve(region, { ends: [[-1, 0], [1, 0]] }),
    HalfPlaneMap: HalfPlaneMap.solve(region, { pole: [1, 1] }),
    CircleMap: CircleMap.solve(new Region({ boundary: square(1), holes: [square(0.5)], center: [0.75, 0] }), { tolerance: 1e-3 }),
    SlitMap: SlitMap.solve(ring, { kind: "annulus" }),
    Electrostatics: Electrostatics.solve(ring, { potentials: [0, 1] }),
    ExteriorMap: ExteriorMap.solve({ boundary: square(1) }),
    PotentialFlow: PotentialFlow.past(Region.exterior({ holes: [square(1)] })),
  };
  const texture = new Texture(new Uint8Array(4 * 64), 8, 8);
  const frame = { center: [0, 0], width: 2, pixels: [8, 8] };
  const formula = new FormulaMap("z + t", { params: { t: [0, 0] } });
  const cortex = RetinoCorticalMap.model({ k: 15, a: 0.7 });
  const stack = FoveatedTexture.of(texture, /** @type {any} */ (frame));
  const mesh = JointTriangulation.regionToDisk(map, { spacing: 0.5 });
  const options = { texture: frame, view: frame };
  const image = cortex.seeing(/** @type {any} */ ({ picture: frame, fieldOfView: 40, fixation: [0, 0] }));
  const prepared = formula.prepareWarp(texture, /** @type {any} */ (options));
  const context = { putImageData() {} };
  fine = {
    texture,
    frame,
    context,
    ring,
    outside: Region.exterior({ holes: [square(1)] }),
    objects: { Region: region, RiemannMap: map, Texture: texture, FormulaMap: formula, RetinoCorticalMap: cortex, FoveatedTexture: stack,
      JointTriangulation: mesh, CorticalImage: image, PreparedWarp: prepared, RegionMap: RegionMap.between(map, map), ...holed },
  };
});

/**
 * Whether a wrong call is answered properly.
 *
 * @param {string} name
 * @param {() => unknown} call
 * @returns {string | undefined} what is improper about it
 */
function improper(name, call) {
  let answer;
  try {
    answer = call();
  } catch (/** @type {any} */ error) {
    if (!(error instanceof Error)) return `${name} threw ${error}`;
    const { code } = /** @type {any} */ (error);
    if (!codes.has(code) || code === "crashed" || code === "internal") return `${name} threw the code ${code}: ${error.message}`;
    if (!/^[A-Z“a-z].*[.]$/s.test(error.message) || MACHINERY.test(error.message)) return `${name} said: ${error.message}`;
    return undefined;
  }
  return `${name} answered ${String(answer).slice(0, 60)}`;
}

/** Values that are wrong for a type, whichever it is, or only for this one. @param {Type} type @returns {[string, unknown][]} */
function wrongFor(type) {
  const resolved = typeof type === "string" && type in types ? types[type] : type;
  const common = /** @type {[string, unknown][]} */ ([["a symbol", Symbol("x")], ["true", true], ["a function", resolved === "function" ? 7 : () => 1], ["a bigint", 10n], ["a date", new Date(0)], ["null object", Object.create(null)]]);
  const number = /** @type {[string, unknown]} */ (["a number", 5]);
  const string = /** @type {[string, unknown]} */ (["a string", "abcd"]);
  const object = /** @type {[string, unknown]} */ (["{}", {}]);
  const length = /** @type {[string, unknown]} */ (["{ length: 1e9 }", { length: 1e9 }]);
  if (resolved === "number") return [...common, string, object, ["[1]", [1]], ["NaN", NaN], ["−∞", -Infinity]];
  if (resolved === "Count") return [...common, string, object, ["1.5", 1.5], ["-1", -1], ["NaN", NaN], ["2³² + 1", 2 ** 32 + 1], ["\"1\"", "1"]];
  if (resolved === "boolean") return [...common.filter(([what]) => what !== "true"), number, string, object];
  if (resolved === "string") return [...common, number, object, ["[\"z\"]", ["z"]]];
  if (resolved === "function") return common.filter(([what]) => what !== "null object").concat([number, string, object]);
  if (typeof resolved === "string") return [...common, number, string, object, length, ["[\"1\"]", ["1"]], ["a Map", new Map()], ["a BigInt64Array", new BigInt64Array(2)]];
  if ("oneOf" in resolved) return [...common, number, string, object];
  if ("tuple" in resolved) return [...common, number, string, object, length, ["too few", [1]], ["too many", [1, 2, 3, 4, 5]], ["strings", resolved.tuple.map(() => "1")], ["holes", new Array(resolved.tuple.length)]];
  if ("fields" in resolved) return [...common.filter(([what]) => what !== "null object" || needsMore(resolved)), number, string, ["an array", [1, 2]], ...unknownKey(resolved)];
  return [...common.filter(([what]) => what !== "null object"), number, string];
}

/** Objects of the platform's may have more keys. @param {any} type @returns {[string, unknown][]} */
const unknownKey = (type) => (type.open ? [] : [["an unknown key", { oops: 1, ...sample(type) }]]);

/** @param {any} type */
const needsMore = (type) => Object.values(type.fields).some(([, optional]) => !optional);

/** @param {Type} type @returns {any} a value that fits */
function sample(type) {
  if (typeof type === "string" && type in types) return sample(types[type]);
  if (type === "number") return 1;
  if (type === "Count") return 8;
  if (type === "string") return "z";
  if (type === "function") return () => true;
  if (type === "Float64Array") return new Float64Array([0.1, 0.2]);
  if (type === "Uint32Array") return new Uint32Array([0, 1, 2]);
  if (type === "Uint8ClampedArray" || type === "Uint8Array") return new Uint8ClampedArray(4 * 64);
  if (typeof type === "string") return fine.objects[type];
  if ("oneOf" in type) return type.oneOf[0];
  if ("any" in type) return sample(type.any[0]);
  if ("tuple" in type) return type.tuple.map(sample);
  if ("record" in type) return {};
  if ("list" in type) return [];
  if ("methods" in type) return fine.context;
  return Object.fromEntries(Object.entries(type.fields).filter(([, [, optional]]) => !optional).map(([key, [field]]) => [key, sample(field)]));
}

/**
 * Every argument of a call wrong in every way, the others right, and every key of options too.
 *
 * @param {string} name
 * @param {Parameter[]} parameters
 * @param {(args: unknown[]) => unknown} call
 */
function* wrongCalls(name, parameters, call) {
  const right = parameters.map(([, type]) => sample(type));
  const instead = (/** @type {number} */ k, /** @type {unknown} */ value) => right.map((other, at) => (at === k ? value : other));
  for (const [k, [argument, type, optional]] of parameters.entries()) {
    for (const [what, value] of wrongFor(type)) yield /** @type {const} */ ([`${name}: ${what} for ${argument}`, () => call(instead(k, value))]);
    if (!optional) for (const value of [undefined, null]) yield /** @type {const} */ ([`${name}: ${value} for ${argument}`, () => call(instead(k, value))]);
    const resolved = typeof type === "string" && type in types ? types[type] : type;
    const inner = typeof resolved === "string" && resolved in types ? types[resolved] : resolved;
    if (typeof inner === "string" || !("fields" in inner)) continue;
    for (const [key, [field]] of Object.entries(inner.fields)) {
      for (const [what, value] of wrongFor(field)) {
        yield /** @type {const} */ ([`${name}: ${what} for ${argument}.${key}`, () => call(instead(k, { ...right[k], [key]: value }))]);
      }
    }
  }
}

test("wrong kinds of arguments, of every call that there is", () => {
  /** @type {string[]} */
  const failures = [];
  let count = 0;
  const check = (/** @type {Iterable<readonly [string, () => unknown]>} */ cases) => {
    for (const [name, call] of cases) {
      count++;
      const found = improper(name, call);
      if (found) failures.push(found);
    }
  };
  for (const [name, signature] of Object.entries(calls)) {
    const exported = /** @type {any} */ (warp)[name];
    if (Array.isArray(signature)) {
      check(wrongCalls(name, signature, (args) => exported(...args)));
      continue;
    }
    check([[`${name}() without new`, () => exported()]]);
    if (signature.new) check(wrongCalls(`new ${name}`, signature.new, (args) => new exported(...args)));
    else check([[`new ${name}()`, () => new exported()]]);
    for (const [key, parameters] of Object.entries(signature.static)) {
      check(wrongCalls(`${name}.${key}`, /** @type {any} */ (parameters), (args) => exported[key](...args)));
    }
    for (const [key, parameters] of Object.entries(signature.methods)) {
      const self = fine.objects[name];
      check(wrongCalls(`${name}.${key}`, /** @type {any} */ (parameters), (args) => self[key](...args)));
      check([undefined, null, {}, 3, exported.prototype, { __wbg_ptr: 1 }].map((other) => /** @type {const} */ ([`${name}.${key} apart`, () => exported.prototype[key].call(other)])));
    }
  }
  assert.deepEqual(failures, []);
  assert.ok(count >= 365, `${count} calls`);
  assert.equal(fine.objects.RiemannMap.toDisk(new Float64Array(2)).length, 2, "the module works on");
});

test("what fits the types but cannot be", () => {
  const { frame, texture } = fine;
  const { FormulaMap: formula, RiemannMap: map } = fine.objects;
  const huge = (/** @type {[number, number]} */ ...pixels) => ({ ...frame, pixels });
  const options = { texture: frame, view: frame };
  /** @type {Record<string, () => unknown>} */
  const cases = {
    "overlay whose bytes overflow": () => formula.overlay({ kind: "polar", view: huge(65536, 16385) }),
    "warp of 30000²": () => formula.warp(texture, { ...options, view: huge(30000, 30000) }),
    "overlay of 30000²": () => formula.overlay({ kind: "polar", view: huge(30000, 30000) }),
    "prepareWarp of 30000²": () => formula.prepareWarp(texture, { ...options, view: huge(30000, 30000) }),
    "warp of 2³² − 1 squared": () => formula.warp(texture, { ...options, view: huge(2 ** 32 - 1, 2 ** 32 - 1) }),
    "prepareWarp of a region": () => map.prepareWarp(texture, { ...options, view: huge(30000, 30000) }),
    "no pixels": () => formula.warp(texture, { ...options, view: huge(0, 8) }),
    "a negative width": () => formula.warp(texture, { ...options, view: { ...frame, width: -1 } }),
    "an infinite center": () => formula.warp(texture, { ...options, view: { ...frame, center: [Infinity, 0] } }),
    "rows beyond": () => formula.warp(texture, { ...options, rows: [4, 9] }),
    "rows backwards": () => formula.warp(texture, { ...options, rows: [4, 3] }),
    "out too short": () => formula.warp(texture, { ...options, out: new Uint8ClampedArray(3) }),
    "a key unknown inside": () => formula.warp(texture, { ...options, view: { ...frame, heigth: 3 } }),
    "a color out of range": () => formula.overlay({ kind: "polar", view: frame, color: [0, 0, 0, 256] }),
    "a color with fractions": () => formula.overlay({ kind: "polar", view: frame, color: [0, 0, 0, 0.5] }),
    "spokes with fractions": () => formula.overlay({ kind: "polar", view: frame, spokes: 1.5 }),
    "many vertices": () => RetinoCorticalMap.modelOutline({ k: 15, a: 0.7 }, 2 ** 32 - 1),
    "many points": () => formula.eval(new Float64Array(2 ** 28)),
    "an odd count": () => formula.eval(new Float64Array(3)),
    "a string of points": () => formula.eval(/** @type {any} */ ("0.5")),
    "two numbers for points": () => map.toDisk(/** @type {any} */ (0.5), 0.5),
    "float16 pixels": () => Texture.fromImageData(/** @type {any} */ ({ data: new Float32Array(4), width: 1, height: 1 })),
    "too few bytes": () => new Texture(new Uint8Array(3), 1, 1),
    "bytes that are none": () => new Texture(/** @type {any} */ ([256, 0, 0, 0]), 1, 1),
    "no formula": () => new FormulaMap(""),
    "half a formula": () => new FormulaMap("z +"),
    "a parameter that is no name": () => new FormulaMap("z", { params: { "1": [0, 0] } }),
    "a parameter that is no point": () => new FormulaMap("z + t", { params: { t: /** @type {any} */ ("00") } }),
    "an unknown parameter": () => formula.setParam("u", [0, 0]),
    "a center outside": () => new Region({ boundary: new Float64Array([0, 0, 1, 0, 0, 1]), center: [2, 2], toward: [1, 0] }),
    "a boundary of two": () => new Region({ boundary: new Float64Array([0, 0, 1, 0]), center: [0, 0], toward: [1, 0] }),
    "a husk": () => new /** @type {any} */ (RiemannMap)(),
    "a negative tolerance": () => RiemannMap.solve(fine.objects.Region, { tolerance: -1 }),
    "neither spacing nor frame": () => JointTriangulation.regionToDisk(map, /** @type {any} */ ({})),
    "a spacing of 0": () => JointTriangulation.regionToDisk(map, { spacing: 0 }),
    "a Uint8Array to fill": () => formula.warp(texture, { ...options, out: new Uint8Array(4 * 64) }),
    "a Uint8Array to fill, prepared": () => fine.objects.PreparedWarp.warp(texture, new Uint8Array(4 * 64)),
    "potentials that are no numbers": () => Electrostatics.solve(fine.ring, { potentials: [NaN, 1] }),
    "a billion lines of force": () => fine.objects.Electrostatics.forceLines(1e9, frame),
    "a mesh of a billion nodes": () => JointTriangulation.regionToDisk(map, { spacing: 1e-8 }),
    "a mesh of millions of nodes": () => JointTriangulation.regionToDisk(map, { spacing: 1e-6 }),
    "an endless circulation": () => fine.objects.PotentialFlow.again({ circulation: [Infinity] }),
    "an object of the package for options": () => RiemannMap.solve(fine.objects.Region, fine.objects.Region),
    "an array whose memory is gone": () => formula.eval(detached()),
    "free of another class": () => Texture.prototype.free.call(new FormulaMap("z")),
    "an argument that frees the object": () => {
      const gone = new FormulaMap("z");
      gone.eval(/** @type {any} */ (new Proxy([1, 2], { get: (numbers, key) => (key === "0" && gone.free(), Reflect.get(numbers, key)) })));
    },
    "an overlay of no opacity it uses": () => formula.overlay({ kind: "polar", view: frame, opacity: Infinity }),
    "an angle that is not used": () => SlitMap.solve(fine.ring, { kind: "annulus", angle: Infinity }),
    "an infinite density": () => fine.objects.PotentialFlow.lift(Infinity),
    "a negative density": () => fine.objects.PotentialFlow.force(-1),
    "an onProgress that cannot cancel": () => RiemannMap.solve(fine.objects.Region, { onProgress: /** @type {any} */ (async () => false) }),
    "a canvas where there is none": () => formula.paint(fine.context, texture, options),
    "a canvas where there is none, prepared": () => fine.objects.PreparedWarp.paint(fine.context, texture),
    "circles of negative radius": () => fine.objects.AnnulusMap.levelLines("circles", new Float64Array([0.8, -1])),
    "a ray at no angle": () => fine.objects.AnnulusMap.levelLines("rays", new Float64Array([NaN])),
    "endless potentials": () => fine.objects.Electrostatics.levelLines(new Float64Array([Infinity]), frame),
    "endless streamlines": () => fine.objects.PotentialFlow.levelLines("streamlines", new Float64Array([NaN]), frame),
    "a landmark that is none": () => RetinoCorticalMap.modelLandmark({ k: 15, a: 0.7 }, [NaN, 0]),
    "a landmark in the other half": () => RetinoCorticalMap.modelLandmark({ k: 15, a: 0.7 }, [-5, 0]),
    "an outline of three vertices": () => RetinoCorticalMap.modelOutline({ k: 15, a: 0.7 }, 3),
    "a cortex of endless area": () => RetinoCorticalMap.model({ k: 1e200, a: 0.7 }),
    "a cortex of no area": () => RetinoCorticalMap.model({ k: 1e-200, a: 0.7 }),
    "a cortex without a middle": () => RetinoCorticalMap.model({ k: 15, a: 1e300 }),
    "no points in a text": () => Region.parseOutline("[]"),
    "one point in a text": () => Region.parseOutline("[[1, 2]]"),
    "a shape of one point": () => Region.parseShape("[[1, 2]]"),
    "two points of a path": () => Region.parseOutline("M0 0L1 1Z"),
    "pixels too small for numbers": () => JointTriangulation.regionToDisk(map, { frame: { ...frame, width: 5e-324 } }),
    "pixels too far for numbers": () => formula.warp(texture, { ...options, view: { ...frame, width: 1.7e308, center: [1e308, 0] } }),
    "an inherited key": () => RiemannMap.solve(fine.objects.Region, Object.create({ tolerence: 1e-3 })),
    "revoked options": () => RiemannMap.solve(fine.objects.Region, revoked({})),
    "revoked points": () => map.toDisk(revoked([])),
    "a revoked region": () => RiemannMap.solve(revoked(fine.objects.Region)),
    "free of what is frozen": () => Object.freeze(new FormulaMap("z")).free(),
    "a class that is told": () => RiemannMap.solve(fine.objects.Region, { onProgress: /** @type {any} */ (class {}) }),
    "a pole of another kind of slits": () => SlitMap.solve(fine.ring, { kind: "annulus", pole: [0.7, 0] }),
    "a hole of another kind of slits": () => SlitMap.solve(fine.ring, { kind: "parallel", hole: 0 }),
    "a pole at the center": () => SlitMap.solve(ringAround([0.75, 0]), { kind: "radial", pole: [0.75, 0] }),
    "a pole that is none": () => SlitMap.solve(ringAround([0.75, 0]), { kind: "radial", pole: [NaN, 0] }),
    "no center to solve from": () => RiemannMap.solve(fine.objects.Region, { maxCharts: 0 }),
    "an arc of negative radius": () => new Region({ edges: [{ arc: { center: [0, 0], radii: [-1, 1], start: 0, sweep: 2 * Math.PI } }], center: [0, 0], toward: [1, 0] }),
    "a magnification that is none": () => JointTriangulation.fromParts(corners, corners, new Uint32Array([0, 1, 2, 0, 2, 3]), new Float64Array([NaN, 1, 1, 1])),
    "a body given twice": () => ExteriorMap.solve({ boundary: corners, path: "M0 0H1V1Z" }),
    "a body without boundary": () => ExteriorMap.solve({}),
    "a stack with a bad frame": () => FoveatedTexture.of(texture, { ...frame, width: 0 }),
  };
  const failures = Object.entries(cases).flatMap(([name, call]) => improper(name, call) ?? []);
  assert.deepEqual(failures, []);
  assert.deepEqual(texture.size, [8, 8], "a texture that was refused is still there");
  assert.equal(formula.warp(texture, options).length, 4 * 64, "the module works on");
});

/** @template T @param {T} value @returns {T} */
function revoked(value) {
  const { proxy, revoke } = Proxy.revocable(/** @type {any} */ (value), {});
  revoke();
  return proxy;
}

const corners = new Float64Array([-1, -1, 1, -1, 1, 1, -1, 1]);

/** @param {[number, number]} center */
const ringAround = (center) => new Region({ boundary: corners, holes: [corners.map((x) => x / 2)], center });

function detached() {
  const points = new Float64Array(2);
  structuredClone(points.buffer, { transfer: [points.buffer] });
  return points;
}

test("what is wrong is said so that it can be mended", () => {
  const { Texture: texture, Region: region, AnnulusMap: annulus } = fine.objects;
  /** @type {[RegExp, () => unknown][]} */
  const cases = [
    [/rgba\[0\].*from 0 to 255, found 300/, () => new Texture(/** @type {any} */ (Array(256).fill(300)), 8, 8)],
    [/an array of 4 points, found an array of 3/, () => RectangleMap.solve(region, { corners: /** @type {any} */ ([0, 1, 2]) })],
    [/either four corners or two ends/, () => ChannelFlow.solve(region, {})],
    [/counter-clockwise/, () => ChannelFlow.solve(region, { corners: [[-1, -1], [-1, 1], [1, 1], [1, -1]] })],
    [/flux.*positive number/, () => ChannelFlow.solve(region, { ends: [[-1, 0], [1, 0]], flux: 0 })],
    [/Vortex 0 \(counted from 0\), at \(0, 0\), must lie inside the region/, () => PotentialFlow.past(fine.outside, { vortices: [{ at: [0, 0], circulation: 1 }] })],
    [/strengths add up to 0/, () => PotentialFlow.past(region, { sources: [{ at: [0.5, 0], strength: 1 }] })],
    [/not where/, () => fine.objects.PotentialFlow.again({ sources: [{ at: [3, 0], strength: 1 }] })],
    [/circulation/, () => PotentialFlow.past(fine.outside, { vortices: [/** @type {any} */ ({ at: [3, 0] })] })],
    [/an AnnulusMap/, () => annulus.toAnnulus.call(texture, new Float64Array(2))],
    [/found "4"/, () => new Texture(new Uint8Array(4), /** @type {any} */ ("4"), 1)],
    [/it is 1\.000e-300\.$/, () => RiemannMap.solve(region, { tolerance: 1e-300 })],
  ];
  for (const [message, call] of cases) assert.throws(call, { message });
});

test("a source that is none is refused, whether the module is there or not", async () => {
  for (const source of [42, {}, true]) await assert.rejects(init(/** @type {any} */ (source)), { code: "invalid-argument" });
  await init(new Uint8Array(8));
  await init(Promise.resolve("nowhere"));
  assert.throws(() => warp.initSync(/** @type {any} */ (42)), { code: "invalid-argument" });
});

test("absent keys may be undefined or null, and arrays of numbers may be plain", () => {
  const { frame, texture } = fine;
  const options = { texture: frame, view: frame };
  const plain = fine.objects.FormulaMap.warp(texture, options);
  const absent = { direction: undefined, quality: null, out: undefined, rows: null };
  assert.deepEqual(fine.objects.FormulaMap.warp(texture, { ...options, ...absent }), plain);
  assert.deepEqual([...fine.objects.FormulaMap.eval([1, 2])], [1, 2]);
  const out = new Uint8ClampedArray(4 * 64);
  assert.equal(fine.objects.FormulaMap.warp(texture, { ...options, out }), out, "the array given is filled and given back");
});

test("what was made before a reset is stale afterwards, and may be freed", async () => {
  const map = new FormulaMap("z");
  const texture = new Texture(new Uint8Array(4), 1, 1);
  await init.reset();
  assert.throws(() => map.eval(new Float64Array(2)), { code: "stale" });
  const { frame } = fine;
  assert.throws(() => new FormulaMap("z").warp(texture, { texture: frame, view: frame }), { code: "stale" });
  map.free();
  texture.free();
  assert.deepEqual([...new FormulaMap("2z").eval(new Float64Array([1, 2]))], [2, 4]);
});
