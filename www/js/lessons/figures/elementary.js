// A square of graph paper under the elementary maps.

import { along, Board } from "../board.js";

/** @typedef {import("../../common/frame.js").Point} Point */

/** What each shows, and the part of the plane that it fills. @type {Map<string, { words: string, center: Point, width: number, at: Point, shows: string }>} */
const MAPS = new Map([
  ["z^2", { words: "z²", center: [0, 0], width: 6, at: [0.75, 0.55], shows: "Lines become parabolas. At 0 every angle is doubled: drag the square over it." }],
  ["exp(z)", { words: "exp z", center: [0, 0], width: 8, at: [0.3, 0.4], shows: "Level lines become rays, upright ones circles: products of what were sums." }],
  ["1/z", { words: "1/z", center: [0, 0], width: 5, at: [0.8, 0.5], shows: "Every line becomes a circle through 0." }],
  ["(z - i)/(z + i)", { words: "(z − i)/(z + i)", center: [0, 0], width: 2.8, at: [0.1, 0.65], shows: "The upper half plane becomes the disk, and its edge, the real axis, the circle." }],
  ["log(z)", { words: "log z", center: [0, 0], width: 6, at: [0.9, 0.6], shows: "The inverse of exp. Where the square crosses the negative axis, its image jumps to the other branch." }],
  ["sin(z)", { words: "sin z", center: [0, 0], width: 6, at: [0.4, 0.55], shows: "Ellipses and hyperbolas with foci at 1 and −1." }],
]);
const LINES = 9;

/** @param {import("../place.js").Place} place */
export function mount(place) {
  const left = new Board("The plane of z, with a square of graph paper", [0, 0], 4);
  const rights = new Map([...MAPS].map(([formula, { words, center, width }]) => [formula, new Board(`The plane of ${words}, with the square’s image`, center, width)]));
  let formula = "z^2";
  place.put(left, ...rights.values());
  let size = 1.1;
  const held = left.handle([0.75, 0.55], { label: "The square", onMove: () => draw(), kind: "crossing" });

  function draw() {
    const { shows } = /** @type {{ shows: string }} */ (MAPS.get(formula));
    const right = /** @type {Board} */ (rights.get(formula));
    for (const [name, board] of rights) board.element.hidden = name !== formula;
    const level = lines(held.at, size, ([x, y]) => [x, y]);
    const upright = lines(held.at, size, ([x, y]) => [y, x]);
    const axes = [along([-2, 0], [2, 0]), along([0, -2], [0, 2])];
    left.curves("axes", axes);
    left.curves("one", level);
    left.curves("two", upright);
    place.ask({ what: "images", formula, lines: [...level, ...upright] }, (answer) => {
      const { center, width } = right.view(1);
      right.curves("axes", [along([center[0] - width / 2, center[1]], [center[0] + width / 2, center[1]]), along([center[0], center[1] - width / 2], [center[0], center[1] + width / 2])]);
      right.curves("one", answer.lines.slice(0, LINES).map(unbroken(right)));
      right.curves("two", answer.lines.slice(LINES).map(unbroken(right)));
      place.say(shows);
    });
  }

  place.choice("Map", [...MAPS].map(([formula, { words }]) => [formula, words]), (value) => {
    formula = value;
    held.put(/** @type {{ at: Point }} */ (MAPS.get(value)).at);
    draw();
  });
  place.slider("Size", { min: 0.2, max: 2.4, step: 0.02, value: size }, (value) => {
    size = value;
    draw();
  });
  draw();
}

/** Lines of graph paper around a point; `turn` chooses which way they run. @param {Point} center @param {number} size @param {(p: Point) => Point} turn */
function lines(center, size, turn) {
  return Array.from({ length: LINES }, (_, k) => {
    const offset = (k / (LINES - 1) - 0.5) * size;
    const at = (/** @type {number} */ end) => {
      const [x, y] = turn([end * 0.5 * size, offset]);
      return /** @type {Point} */ ([center[0] + x, center[1] + y]);
    };
    return along(at(-1), at(1), 64);
  });
}

/** A branch's jump, and what flies off to infinity, are no part of a line. @param {Board} board */
const unbroken = (board) => (/** @type {Point[]} */ line) =>
  line.map((p, k) => {
    const last = line[k - 1] ?? p;
    return Math.hypot(p[0] - last[0], p[1] - last[1]) > board.width * 0.6 ? /** @type {Point} */ ([NaN, NaN]) : p;
  });
