// Random walkers leave the centre: which wall do they meet? Counted, and by the map.

import { along, Board } from "../board.js";
import { closed, deepEnough, ROOM } from "../shapes.js";
import { isStill } from "../../common/motion.js";
import { mix, nearestOnBoundary, rightOf } from "../../editor/geometry.js";

/** @typedef {import("../../common/frame.js").Point} Point */

/** So near a wall a walker has met it. */
const ARRIVED = 1e-3;
/** Walkers that a press of the button sends off; those of one frame of the screen; those whose ways are drawn. */
const PARTY = 2000;
const AT_ONCE = 50;
const DRAWN = 6;

/** @param {import("../place.js").Place} place */
export function mount(place) {
  const room = new Board("A room that random walkers leave from the centre", [0, 0], 2.3);
  const bars = new Board("For each wall the share of walkers that met it, counted and by the map", [0, 0], 2.3);
  place.put(room, bars);
  room.curves("body", [closed(ROOM)]);
  /** @type {number[]} */
  let exact = [];
  let counts = ROOM.map(() => 0);
  /** @type {Point[][]} */
  let ways = [];
  let left = 0;

  const center = room.handle([-0.3, -0.25], {
    label: "Where the walkers start",
    kind: "gold",
    limit: (to) => deepEnough(ROOM, to),
    onMove: () => {
      counts = ROOM.map(() => 0);
      ways = [];
      left = 0;
      solve();
    },
  });

  function solve() {
    place.ask({ what: "disk", shape: { boundary: ROOM, center: center.at, toward: rightOf(ROOM, center.at).point }, lines: [] }, ({ angles }) => {
      exact = angles.map((/** @type {number} */ angle, /** @type {number} */ k) => {
        const next = angles[(k + 1) % angles.length];
        const arc = (next - angle) / (2 * Math.PI);
        return arc - Math.floor(arc);
      });
      draw();
    });
  }

  function draw() {
    const total = counts.reduce((sum, n) => sum + n, 0);
    const wide = 1.9 / ROOM.length;
    const tallest = Math.max(...exact, 0.2);
    /** @param {number} k @param {number} share @param {number} from @param {number} to @returns {Point[]} */
    const bar = (k, share, from, to) => {
      const [x0, x1] = [-0.95 + (k + from) * wide, -0.95 + (k + to) * wide];
      const top = -0.85 + (1.6 * share) / tallest;
      return [[x0, -0.85], [x1, -0.85], [x1, top], [x0, top]];
    };
    room.curves("way", ways);
    room.words(ROOM.map((from, k) => [String(k + 1), wordsBeside(from, ROOM[(k + 1) % ROOM.length])]));
    bars.curves("axes", [along([-1, -0.85], [1, -0.85])]);
    bars.curves("bar", exact.map((share, k) => bar(k, share, 0.12, 0.46)), true);
    bars.curves("counted", total ? counts.map((n, k) => bar(k, n / total, 0.5, 0.84)) : [], true);
    bars.words(exact.flatMap((share, k) => [
      [String(k + 1), [-0.95 + (k + 0.42) * wide, -1.02]],
      [`${(100 * share).toFixed(1)} %`, [-0.95 + (k + 0.08) * wide, -0.8 + (1.6 * Math.max(share, total ? counts[k] / total : 0)) / tallest]],
    ]));
    place.say(total ? `${total.toLocaleString("en")} walkers counted (red), beside the shares that the map gives (blue).` : "Blue: the share of walkers that each wall will meet, by the map.");
  }

  function send() {
    const many = Math.min(left, AT_ONCE);
    left -= many;
    for (let k = 0; k < many; k++) {
      const way = walk(center.at);
      counts[nearestOnBoundary(ROOM, way[way.length - 1]).edge]++;
      ways = [...ways, way].slice(-DRAWN);
    }
    if (!left || !isStill()) draw();
    if (left) requestAnimationFrame(send);
  }

  place.button(`Send ${PARTY.toLocaleString("en")} walkers`, () => {
    const idle = left === 0;
    left += PARTY;
    if (idle) requestAnimationFrame(send);
  });
  solve();
}

/**
 * A walker's way to the wall: from each point it leaves the largest circle around it anywhere with equal chance.
 * @param {Point} from @returns {Point[]}
 */
function walk(from) {
  const way = [from];
  for (;;) {
    const [x, y] = way[way.length - 1];
    const { distance } = nearestOnBoundary(ROOM, [x, y]);
    if (distance < ARRIVED) return way;
    const turn = 2 * Math.PI * Math.random();
    way.push([x + distance * Math.cos(turn), y + distance * Math.sin(turn)]);
  }
}

/** A place beside the middle of a wall, outside. @param {Point} from @param {Point} to @returns {Point} */
function wordsBeside(from, to) {
  const [x, y] = mix(from, to, 0.5);
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  return [x + (0.1 * (to[1] - from[1])) / length - 0.03, y - (0.1 * (to[0] - from[0])) / length - 0.03];
}
