// Any region is a disk in disguise: its corners can be dragged.

import { around, Board } from "../board.js";
import { closed, deepEnough, onCircle, POLAR, ROOM } from "../shapes.js";
import { crossingEdges, rightOf } from "../../editor/geometry.js";

/** @typedef {import("../../common/frame.js").Point} Point */

/** @param {import("../place.js").Place} place */
export function mount(place) {
  const left = new Board("A region whose corners can be dragged", [0, 0], 2.3);
  const right = new Board("The unit disk", [0, 0], 2.3);
  place.put(left, right);
  /** @type {import("../board.js").Movable[]} */
  const corners = ROOM.map((at, k) => left.handle(at, { label: `Corner ${k + 1}`, limit: (to) => (allowed(k, to) ? to : null), onMove: () => draw() }));
  const center = left.handle([-0.3, -0.25], { label: "The centre", kind: "gold", limit: (to) => deepEnough(outline(), to), onMove: () => draw() });

  const outline = () => corners.map(({ at }) => at);

  /** A corner may go where the walls do not cross and the centre stays inside. @param {number} k @param {Point} to */
  function allowed(k, to) {
    const moved = outline();
    moved[k] = to;
    return deepEnough(moved, center.at) !== null && crossingEdges(moved).size === 0;
  }

  function draw() {
    const boundary = outline();
    left.curves("body", [closed(boundary)]);
    right.curves("body", [closed(around([0, 0], 1))]);
    right.curves("net", POLAR.rays);
    right.curves("circles", POLAR.circles);
    const shape = { boundary, center: center.at, toward: rightOf(boundary, center.at).point };
    place.ask({ what: "disk", shape, lines: [...POLAR.circles, ...POLAR.rays] }, ({ lines, angles, radius }) => {
      left.curves("circles", lines.slice(0, POLAR.circles.length));
      left.curves("net", lines.slice(POLAR.circles.length));
      const images = onCircle(angles);
      right.dots("corners", images, 6);
      right.words(images.map(([x, y], k) => [String(k + 1), [1.08 * x - 0.02, 1.08 * y - 0.03]]));
      left.words(boundary.map(([x, y], k) => [String(k + 1), [x + 0.05, y + 0.05]]));
      place.say(`Near its centre the region is a disk of radius ${radius.toFixed(3)}: its conformal radius.`);
    });
  }
  draw();
}
