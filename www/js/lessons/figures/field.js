// Rings and spokes of the visual field, and the cortex's chart of them.

import { Board } from "../board.js";
import { POLIMENI } from "../../cortex/models.js";

/** @typedef {import("../../common/frame.js").Point} Point */

const RINGS = [1, 2.5, 5, 10, 20, 40, 80];
/** Turns of the spokes, from down to up. */
const SPOKES = Array.from({ length: 9 }, (_, k) => -Math.PI / 2 + (Math.PI * k) / 8);

/** @param {import("../place.js").Place} place */
export function mount(place) {
  const left = new Board("The right half of the visual field", [22, 0], 50);
  const right = new Board("The left hemisphere’s chart of it, in millimetres", [32, 0], 96);
  place.put(left, right);
  let a = POLIMENI.a;
  const dot = left.handle([8, 5], { label: "A point of the field", kind: "gold", limit: ([x, y]) => [Math.max(0.01, x), y], onMove: () => draw() });

  function draw() {
    const rings = RINGS.map((r) => Array.from({ length: 61 }, (_, k) => polar(r, -Math.PI / 2 + (Math.PI * k) / 60)));
    const spokes = SPOKES.map((turn) => Array.from({ length: 121 }, (_, k) => polar(0.001 + 80 * (k / 120) ** 3, turn)));
    left.curves("one", rings);
    left.curves("two", spokes);
    const ring = Array.from({ length: 49 }, (_, k) => {
      const turn = (2 * Math.PI * k) / 48;
      return /** @type {Point} */ ([Math.max(0.001, dot.at[0] + 2 * Math.cos(turn)), dot.at[1] + 2 * Math.sin(turn)]);
    });
    left.curves("probe", [ring]);
    place.ask({ what: "cortex", model: { k: POLIMENI.k, a }, lines: [ring, ...rings, ...spokes], at: dot.at }, ({ lines: [probe, ...lines], at, magnification }) => {
      right.curves("one", lines.slice(0, RINGS.length));
      right.curves("two", lines.slice(RINGS.length));
      right.curves("probe", [probe]);
      right.dots("mark", [at], 5);
      place.say(`${Math.hypot(...dot.at).toFixed(1)}° from where one looks, a degree takes ${magnification.toFixed(2)} mm of cortex; at the centre, ${(POLIMENI.k / a).toFixed(1)} mm.`);
    });
  }

  place.slider("a, in degrees", { min: 0.2, max: 5, step: 0.01, value: a }, (value) => {
    a = value;
    draw();
  });
  draw();
}

/** @param {number} r @param {number} turn @returns {Point} */
const polar = (r, turn) => [r * Math.cos(turn), r * Math.sin(turn)];
