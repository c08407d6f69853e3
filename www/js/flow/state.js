// What the page of flows shows, and its place in the address.

import { bodies as ready, bodyOf } from "./bodies.js";
import { readVortices, remaining, writeVortices } from "./vortices.js";
import { between, oneOf, readAddress, someOf, wrongWords } from "../common/address.js";

/** @typedef {import("../common/frame.js").Point} Point */
/**
 * @typedef {object} State
 * @property {string} body a ready-made one
 * @property {import("./bodies.js").Bodies | null} own a visitor's, in its place
 * @property {number} angle of the wind, in degrees
 * @property {boolean} kutta whether the fluid leaves at the trailing corners
 * @property {number} circulation around each body, if it does not
 * @property {import("./vortices.js").Vortex[]} vortices
 * @property {boolean} pressure
 * @property {boolean} lines
 * @property {boolean} specks
 */

/** @type {State} */
const FIRST = { body: "wing", own: null, angle: 6, kutta: true, circulation: 0, vortices: [], pressure: true, lines: true, specks: true };

/** What is drawn beside the bodies. */
const LAYERS = /** @type {const} */ (["pressure", "lines", "specks"]);

const SCHEMA = {
  body: oneOf(ready.keys()),
  angle: between(-30, 30),
  circulation: between(-8, 8),
  show: someOf(LAYERS),
  vortices: readVortices,
  /** @param {string} text @returns {Point[]} */
  outline: (text) => {
    const points = text.split(";").map((pair) => pair.split(",").map(Number));
    if (points.length < 3 || points.length > 400 || points.some((p) => p.length !== 2 || !p.every((x) => Math.abs(x) < 10))) throw new Error("must be 3 to 400 points x,y;x,y;…");
    return /** @type {Point[]} */ (points);
  },
};

/** @param {string} hash @returns {{ state: State, wrong: string }} */
export function readState(hash) {
  const { values, wrong } = readAddress(hash, SCHEMA);
  const body = values.body ?? FIRST.body;
  const own = values.outline ? bodyOf("Your own", values.outline) : null;
  const edge = own !== null || ready.get(body)?.trailing !== null;
  const shown = values.show ?? LAYERS;
  const state = {
    body,
    own,
    angle: values.angle ?? FIRST.angle,
    kutta: edge && values.circulation === undefined,
    circulation: values.circulation ?? 0,
    vortices: remaining(values.vortices ?? [], (own ?? /** @type {import("./bodies.js").Bodies} */ (ready.get(body))).outlines),
    pressure: shown.includes("pressure"),
    lines: shown.includes("lines"),
    specks: shown.includes("specks"),
  };
  return { state, wrong: wrongWords(wrong) };
}

/** @param {State} state */
export function writeState({ body, own, angle, kutta, circulation, vortices, ...shown }) {
  const parts = [own ? `outline=${own.outlines[0].map(([x, y]) => `${x.toFixed(3)},${y.toFixed(3)}`).join(";")}` : `body=${body}`, `angle=${angle}`];
  if (!kutta) parts.push(`circulation=${circulation}`);
  if (vortices.length) parts.push(`vortices=${writeVortices(vortices)}`);
  const names = LAYERS.filter((name) => shown[name]);
  if (names.length < LAYERS.length) parts.push(`show=${names.join(",")}`);
  return parts.join("&");
}
