// The same triangles on both sides: the paper's joint triangulation.

import { around, Board } from "../board.js";
import { closed, deepEnough, ROOM } from "../shapes.js";
import { meshEdges } from "../../common/layers.js";
import { rightOf } from "../../editor/geometry.js";

/** @typedef {import("../../common/frame.js").Point} Point */

/** @param {import("../place.js").Place} place */
export function mount(place) {
  const left = new Board("The region in triangles", [0, 0], 2.3);
  const right = new Board("The same triangles in the disk", [0, 0], 2.3);
  place.put(left, right);
  let spacing = 2 ** -2.3;
  const center = left.handle([-0.3, -0.25], { label: "The centre", kind: "gold", limit: (to) => deepEnough(ROOM, to), onMove: () => draw() });

  function draw() {
    left.curves("body", [closed(ROOM)]);
    right.curves("body", [closed(around([0, 0], 1))]);
    const shape = { boundary: ROOM, center: center.at, toward: rightOf(ROOM, center.at).point };
    place.ask({ what: "mesh", shape, spacing }, ({ source, target, triangles, evidence }) => {
      const edges = meshEdges(triangles);
      /** @param {Point[]} nodes */
      const lines = (nodes) => Array.from({ length: edges.length / 2 }, (_, k) => [nodes[edges[2 * k]], nodes[edges[2 * k + 1]]]);
      left.curves("net", lines(source));
      right.curves("net", lines(target));
      const flips = evidence.flippedAtFirst ? `${evidence.flippedAtFirst} turned over at first and were mended` : "none turned over";
      place.say(`${triangles.length / 3} triangles, ${flips}. Off the map by at most ${evidence.largestError.toPrecision(2)} of the disk’s radius.`);
    });
  }

  place.slider("Coarse to fine", { min: 1, max: 4, step: 0.1, value: 2.3 }, (value) => {
    spacing = 2 ** -value;
    draw();
  });
  draw();
}
