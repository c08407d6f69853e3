// Two curves cross; so do their images. Does the angle stay?

import { along, Board } from "../board.js";

/** @typedef {import("../../common/frame.js").Point} Point */

/** @type {[formula: string, words: string][]} */
const MAPS = [
  ["z^2", "z²: conformal"],
  ["exp(z)", "exp z: conformal"],
  ["z + conj(z)/2", "z + ½ z̄: not"],
  ["conj(z)", "z̄: turns angles round"],
];
/** How close to the crossing the angle of the images is taken. */
const NEAR = 1e-5;

/** @param {import("../place.js").Place} place */
export function mount(place) {
  const left = new Board("The plane of z, with two lines that cross", [0.7, 0.4], 2.4);
  const right = new Board("The plane of f(z), with their images", [0.9, 0.7], 4.6);
  place.put(left, right);
  let [[formula]] = MAPS;

  const crossing = left.handle([0.8, 0.35], { label: "The crossing", onMove: () => carry(), kind: "crossing" });
  /** @type {Point[]} */
  let arms = [[0.5, 0.05], [0.15, 0.48]];
  const ends = arms.map((arm, k) =>
    left.handle(add(crossing.at, arm), {
      label: `The direction of line ${k + 1}`,
      limit: (to) => (Math.hypot(to[0] - crossing.at[0], to[1] - crossing.at[1]) > 0.08 ? to : null),
      onMove: () => {
        arms[k] = toward(crossing.at, ends[k].at);
        draw();
      },
    }),
  );

  // The lines go with their crossing.
  function carry() {
    ends.forEach((end, k) => end.put(add(crossing.at, arms[k])));
    draw();
  }

  function draw() {
    const z = crossing.at;
    const lines = arms.map((arm) => along(add(z, arm, -1.6), add(z, arm, 1.6)));
    left.curves("one", [lines[0]]);
    left.curves("two", [lines[1]]);
    left.curves("net", net(left));
    const tangents = arms.map((arm) => add(z, scaled(arm, NEAR / Math.hypot(...arm))));
    place.ask({ what: "images", formula, lines: [...net(left), ...lines], at: [z, ...tangents] }, (answer) => {
      right.curves("net", answer.lines.slice(0, -2));
      right.curves("one", answer.lines.slice(-2, -1));
      right.curves("two", answer.lines.slice(-1));
      right.dots("mark", [answer.at[0]], 5);
      const before = angle(arms[0], arms[1]);
      const after = angle(toward(answer.at[0], answer.at[1]), toward(answer.at[0], answer.at[2]));
      place.say(`Angle from blue to red: ${degrees(before)} before, ${degrees(after)} after.`);
    });
  }

  place.choice("Map", MAPS, (value) => {
    formula = value;
    draw();
  });
  draw();
}

/** The grid of a board, each line in small steps. @param {Board} board @returns {Point[][]} */
function net(board) {
  const { center, width } = board.view(1);
  const [left, right, low, high] = [center[0] - width / 2, center[0] + width / 2, center[1] - width / 2, center[1] + width / 2];
  const steps = Array.from({ length: 13 }, (_, k) => k / 12);
  return [
    ...steps.map((s) => along([left + s * width, low], [left + s * width, high], 40)),
    ...steps.map((s) => along([left, low + s * width], [right, low + s * width], 40)),
  ];
}

/** @param {Point} p @param {Point} q @param {number} [times] @returns {Point} */
const add = ([a, b], [c, d], times = 1) => [a + times * c, b + times * d];
/** @param {Point} p @param {number} times @returns {Point} */
const scaled = ([a, b], times) => [a * times, b * times];
/** @param {Point} from @param {Point} to @returns {Point} */
const toward = ([a, b], [c, d]) => [c - a, d - b];
/** From one direction to another, counter-clockwise. @param {Point} one @param {Point} two */
const angle = ([a, b], [c, d]) => Math.atan2(a * d - b * c, a * c + b * d);
/** @param {number} radians */
const degrees = (radians) => `${((radians * 180) / Math.PI).toFixed(1)}°`.replace("-", "−");
