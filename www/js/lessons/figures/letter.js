// A letter F and its image: small ones keep their form, large ones bend.

import { along, Board } from "../board.js";

/** @typedef {import("../../common/frame.js").Point} Point */

/** The outline of an F, one unit high, around the point that it is held at. @type {Point[]} */
const F = [[-0.3, -0.5], [-0.1, -0.5], [-0.1, -0.08], [0.2, -0.08], [0.2, 0.1], [-0.1, 0.1], [-0.1, 0.32], [0.35, 0.32], [0.35, 0.5], [-0.3, 0.5]];

/** @type {[formula: string, words: string][]} */
const MAPS = [["exp(z)", "exp z"], ["z^2", "z²"], ["sin(z)", "sin z"]];

/** @param {import("../place.js").Place} place */
export function mount(place) {
  const left = new Board("The plane of z, with a letter F", [0.3, 0.4], 2.8);
  const right = new Board("The plane of f(z), with the letter’s image", [1.2, 1], 6);
  place.put(left, right);
  let size = 0.8;
  let [[formula]] = MAPS;
  const held = left.handle([0.5, 0.6], { label: "The letter F", onMove: () => draw(), kind: "crossing" });

  function draw() {
    const [x, y] = held.at;
    const outline = sides(F.map(([a, b]) => /** @type {Point} */ ([x + size * a, y + size * b])));
    left.curves("letter", [outline], true);
    left.curves("axes", axes(left));
    place.ask({ what: "images", formula, lines: [outline, ...axes(left)], at: [held.at] }, ({ lines: [image, ...carried], at: [w], derivative: [slope] }) => {
      const straight = outline.map(([a, b]) => add(w, times(slope, [a - x, b - y])));
      right.curves("axes", carried);
      right.curves("plain", [straight], true);
      right.curves("letter", [image], true);
      right.dots("mark", [w], 4);
      const bent = Math.max(...straight.map((p, k) => Math.hypot(p[0] - image[k][0], p[1] - image[k][1]))) / (size * Math.hypot(...slope));
      const turn = (Math.atan2(slope[1], slope[0]) * 180) / Math.PI;
      place.say(`Enlarged ${Math.hypot(...slope).toFixed(2)} times, turned by ${turn.toFixed(0).replace("-", "−")}°, out of form by ${(100 * bent).toFixed(1)} % of its height.`);
    });
  }

  place.choice("Map", MAPS, (value) => {
    formula = value;
    draw();
  });
  place.slider("Size", { min: 0.05, max: 1, step: 0.01, value: size }, (value) => {
    size = value;
    draw();
  });
  draw();
}

/** A closed outline in small steps, so that its image bends. @param {Point[]} corners */
const sides = (corners) => corners.flatMap((corner, k) => along(corner, corners[(k + 1) % corners.length], 12).slice(0, -1));

/** @param {Board} board @returns {Point[][]} */
function axes(board) {
  const { center, width } = board.view(1);
  return [along([center[0] - width / 2, 0], [center[0] + width / 2, 0]), along([0, center[1] - width / 2], [0, center[1] + width / 2])];
}

/** @param {Point} p @param {Point} q @returns {Point} */
const add = ([a, b], [c, d]) => [a + c, b + d];
/** The product of two complex numbers. @param {Point} p @param {Point} q @returns {Point} */
const times = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];
