// The disk's picture by triangles, and exactly: a curtain between the two can be drawn.

import { around, Board } from "../board.js";
import { closed } from "../shapes.js";
import { loadPicture } from "../../common/images.js";
import { defaultRegion } from "../../editor/presets.js";
import { towardPoint } from "../../editor/region.js";

/** @typedef {import("../../common/frame.js").Point} Point */

/** @param {import("../place.js").Place} place */
export async function mount(place) {
  const picture = await loadPicture("astronaut");
  place.know(picture);
  const region = defaultRegion(picture);
  const { boundary, center } = region;
  const left = new Board("A photo with a region in triangles", [-0.2, 0.35], 1.3);
  const right = new Board("The disk: by triangles to the left of the curtain, exactly to its right", [0, 0], 2.12);
  place.put(left, right);
  left.show(picture);
  left.curves("body", [closed(boundary)]);
  right.curves("body", [closed(around([0, 0], 1))]);
  let spacing = 2 ** -2.1;
  /** @type {{ byTriangles: Uint8ClampedArray<ArrayBuffer>, exact: Uint8ClampedArray<ArrayBuffer>, side: number } | null} */
  let pictures = null;
  const curtain = right.handle([0, -1], { label: "The curtain", kind: "crossing", limit: ([x]) => [x, -1], onMove: () => show() });

  function show() {
    if (!pictures) return;
    const { byTriangles, exact, side } = pictures;
    const column = Math.round(((curtain.at[0] + right.width / 2) / right.width) * side);
    const shown = new Uint8ClampedArray(exact);
    for (let row = 0; row < side; row++) {
      const begin = 4 * row * side;
      shown.set(byTriangles.subarray(begin, begin + 4 * column), begin);
    }
    right.paint(shown, [side, side]);
    right.curves("curtain", [[[curtain.at[0], -1.06], [curtain.at[0], 1.06]]]);
  }

  function draw() {
    const side = right.sharpness;
    const shape = { boundary, center, toward: towardPoint(region) };
    place.ask({ what: "mesh", shape, spacing, picture: picture.id, view: right.view(side) }, ({ source, triangles, evidence, byTriangles, exact }) => {
      left.curves("net", Array.from({ length: triangles.length / 3 }, (_, k) => [0, 1, 2, 0].map((j) => source[triangles[3 * k + j]])));
      pictures = { byTriangles, exact, side };
      show();
      const pixels = (evidence.largestError * side) / right.width;
      place.say(`${triangles.length / 3} triangles are off the exact map by at most ${pixels.toPrecision(2)} pixels; angles by ${((evidence.meanAngleError * 180) / Math.PI).toPrecision(2)}° on average.`);
    });
  }

  place.slider("Coarse to fine", { min: 1.5, max: 5, step: 0.1, value: 2.1 }, (value) => {
    spacing = 2 ** -value;
    draw();
  });
  draw();
}
