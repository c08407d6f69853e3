// A frame's two directions: pixels → plane, and back.

import assert from "node:assert/strict";
import { before, test } from "node:test";
import init, { frameToPixels, frameToPlane } from "conformal-warp";

/** @type {import("conformal-warp").Frame} */
const frame = { center: [1, 2], width: 4, pixels: [400, 200] };

before(() => init());

test("corners and middle lie where the frame says", () => {
  assert.deepEqual([...frameToPlane(frame, new Float64Array([0, 0, 200, 100, 400, 200]))], [-1, 3, 1, 2, 3, 1]);
  assert.deepEqual([...frameToPixels(frame, new Float64Array([-1, 3, 1, 2, 3, 1]))], [0, 0, 200, 100, 400, 200]);
});

test("there and back is where one was", () => {
  const pixels = Float64Array.from({ length: 2000 }, (_, k) => 1000 * Math.sin(k));
  const back = frameToPixels(frame, frameToPlane(frame, pixels));
  assert.equal(back.length, pixels.length);
  back.forEach((x, k) => assert.ok(Math.abs(x - pixels[k]) < 1e-10, `${pixels[k]} came back as ${x}`));
});

test("frames and points that cannot be are refused in words", () => {
  const code = (/** @type {() => unknown} */ call) => {
    try {
      call();
    } catch (error) {
      return /** @type {import("conformal-warp").ConformalWarpError} */ (error).code;
    }
  };
  assert.equal(code(() => frameToPlane({ ...frame, width: 0 }, new Float64Array(2))), "invalid-frame");
  assert.equal(code(() => frameToPlane(frame, new Float64Array(3))), "wrong-length");
  // @ts-expect-error: a misspelled option
  assert.equal(code(() => frameToPixels({ ...frame, wdth: 1 }, new Float64Array(2))), "invalid-option");
});
