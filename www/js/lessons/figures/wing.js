// Joukowski's map bends a circle through 1 to the section of a wing.

import { along, around, Board } from "../board.js";
import { closed } from "../shapes.js";

/** @typedef {import("../../common/frame.js").Point} Point */

/** @param {import("../place.js").Place} place */
export function mount(place) {
  const left = new Board("The plane of z, with a circle through 1", [0, 0], 4.4);
  const right = new Board("The plane of z + 1/z, with the wing", [0, 0], 6);
  place.put(left, right);
  const middle = left.handle([-0.12, 0.16], {
    label: "The circle’s centre",
    kind: "crossing",
    // A circle that leaves −1 outside would have the wing cross itself.
    limit: ([x, y]) => (Math.hypot(x - 1, y) >= Math.hypot(x + 1, y) && x > -0.5 && Math.abs(y) < 0.8 ? [x, y] : null),
    onMove: () => draw(),
  });

  function draw() {
    const [x, y] = middle.at;
    const radius = Math.hypot(1 - x, y);
    const trailing = Math.atan2(-y, 1 - x);
    const circle = closed(around(middle.at, radius, 400));
    const circles = [1.15, 1.35, 1.6, 1.9].map((r) => closed(around(middle.at, r * radius, 160)));
    const rays = Array.from({ length: 24 }, (_, k) => {
      const turn = trailing + (2 * Math.PI * k) / 24;
      /** @param {number} r @returns {Point} */
      const at = (r) => [x + r * radius * Math.cos(turn), y + r * radius * Math.sin(turn)];
      return along(at(1), at(1.9), 40);
    });
    left.curves("axes", axes(4.4));
    left.curves("net", [...circles, ...rays]);
    left.curves("body", [circle]);
    left.dots("mark", [[1, 0], [-1, 0]], 4);
    place.ask({ what: "images", formula: "z + 1/z", lines: [circle, ...circles, ...rays] }, ({ lines: [wing, ...net] }) => {
      right.curves("axes", axes(6));
      right.curves("net", net);
      right.curves("body", [wing]);
      right.dots("mark", [[2, 0]], 4);
      const chord = Math.max(...wing.map((/** @type {Point} */ p) => p[0])) - Math.min(...wing.map((/** @type {Point} */ p) => p[0]));
      const thick = thickness(wing);
      place.say(`Thickness ${((100 * thick) / chord).toFixed(0)} % of the chord. To the left the wing grows thicker, upward it is bent.`);
    });
  }
  draw();
}

/** The largest height of a wing, upper side over lower side. @param {Point[]} wing */
function thickness(wing) {
  const half = wing.length - 1;
  // The circle's points mirrored in its level diameter lie nearly above each other.
  return Math.max(...Array.from({ length: Math.floor(half / 2) }, (_, k) => Math.abs(wing[k][1] - wing[half - k][1])));
}

/** @param {number} width @returns {Point[][]} */
const axes = (width) => [along([-width / 2, 0], [width / 2, 0]), along([0, -width / 2], [0, width / 2])];
