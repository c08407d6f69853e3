// Maps as bytes: the same answers from them, and no memory for what damaged ones promise.

import assert from "node:assert/strict";
import { before, test } from "node:test";
import init, { FormulaMap, Region, RegionMap, RiemannMap } from "conformal-warp";

/** @type {{ readonly buffer: ArrayBuffer }} */
let memory;
before(async () => {
  ({ memory } = await init());
});

const region = () => new Region({ boundary: new Float64Array([0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2]), center: [0.5, 0.5], toward: [2, 0.5] });
const points = Float64Array.from({ length: 2000 }, (_, k) => Math.abs(Math.sin(k)));

/** The bytes with the sum at their end made right. @param {Uint8Array} bytes */
function resummed(bytes) {
  const end = bytes.length - 8;
  let sum = 0xcbf29ce484222325n;
  for (const byte of bytes.subarray(0, end)) sum = BigInt.asUintN(64, (sum ^ BigInt(byte)) * 0x100000001b3n);
  new DataView(bytes.buffer).setBigUint64(end, sum, true);
  return bytes;
}

test("a map of its bytes answers with the same bits", () => {
  const map = RiemannMap.solve(region(), { tolerance: 1e-9 });
  const bytes = map.toBytes();
  const again = RiemannMap.fromBytes(structuredClone(bytes));
  const images = map.toDisk(points);
  assert.deepEqual(again.toDisk(points), images);
  assert.deepEqual(again.fromDisk(images), map.fromDisk(images));
  assert.equal(again.errorEstimate, map.errorEstimate);
  assert.deepEqual(again.toBytes(), bytes);
  const moved = again.withCenter({ center: [0.4, 0.6], toward: [2, 0.5] });
  assert.ok(moved.errorEstimate < 1e-8);
  assert.deepEqual(RegionMap.between(again, moved).forward(points), RegionMap.between(map, moved).forward(points));
  const formula = new FormulaMap("t z^2", { params: { t: [0.5, 2] } });
  assert.deepEqual(FormulaMap.fromBytes(formula.toBytes()).eval(points), formula.eval(points));
  for (const [bytes, code] of /** @type {const} */ ([[formula.toBytes(), "not-stored"], [map.toBytes().subarray(0, 99), "damaged"], [new Uint8Array(), "not-stored"]])) {
    assert.throws(() => RiemannMap.fromBytes(bytes), { code });
  }
});

test("no memory is taken for counts that are not borne out", () => {
  const bytes = RiemannMap.solve(region(), { tolerance: 1e-3 }).toBytes();
  RiemannMap.fromBytes(bytes).free();
  const before = memory.buffer.byteLength;
  for (let at = 20; at < bytes.length - 12; at++) {
    const forged = bytes.slice();
    new DataView(forged.buffer).setUint32(at, 0xffffffff, true);
    try {
      RiemannMap.fromBytes(resummed(forged)).free();
    } catch (/** @type {any} */ error) {
      assert.match(error.message, /\.$/);
      assert.notEqual(error.code, "crashed");
    }
  }
  assert.ok(memory.buffer.byteLength - before < 2 ** 26, `${memory.buffer.byteLength - before} bytes more`);
});
