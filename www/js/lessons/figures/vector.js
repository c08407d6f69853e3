// One region, one photo; the inward vector chooses among its maps.

import { around, Board } from "../board.js";
import { closed, deepEnough, onCircle } from "../shapes.js";
import { loadPicture } from "../../common/images.js";
import { nearestOnBoundary } from "../../editor/geometry.js";
import { defaultRegion } from "../../editor/presets.js";
import { towardPoint } from "../../editor/region.js";

/** @param {import("../place.js").Place} place */
export async function mount(place) {
  const picture = await loadPicture("chelsea");
  place.know(picture);
  const region = defaultRegion(picture);
  const { boundary } = region;
  const left = new Board("A photo with a region and its inward vector", [-0.12, 0], 2);
  const right = new Board("The region on the unit disk", [0, 0], 2.12);
  place.put(left, right);
  left.show(picture);
  left.curves("body", [closed(boundary)]);
  right.curves("body", [closed(around([0, 0], 1))]);
  const center = left.handle(region.center, { label: "The point that goes to 0", kind: "gold", limit: (to) => deepEnough(boundary, to), onMove: () => draw() });
  const toward = left.handle(towardPoint(region), { label: "The wall’s point that goes to 1", kind: "gold toward", limit: (to) => nearestOnBoundary(boundary, to).point, onMove: () => draw() });

  function draw() {
    left.curves("vector", [[toward.at, center.at]]);
    const side = right.sharpness;
    const view = right.view(side);
    place.ask({ what: "disk", shape: { boundary, center: center.at, toward: toward.at }, lines: [], picture: picture.id, view }, ({ pixels, angles }) => {
      right.paint(pixels, [side, side]);
      right.curves("vector", [[[1, 0], [0, 0]]]);
      right.dots("corners", onCircle(angles), 3);
      place.say("The yellow vector goes to the vector from 1 to 0. Nothing else is left to choose.");
    });
  }
  draw();
}
