// Dragging the disk: its picture follows the pointer by a Möbius map of the disk, that is, by another inward vector.

import { toPlane } from "../common/frame.js";
import { onEscape } from "../common/keys.js";
import { pixelOf } from "../common/svg.js";
import { moveCenter, moveToward } from "../editor/region.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../editor/region.js").Region} Region */
/** @typedef {import("../editor/locate.js").Locator} Locator */
/** @typedef {import("../editor/store.js").Store} Store */
/** @typedef {import("./disk-view.js").DiskView} DiskView */

/** How far from 0 the new center may be looked for, and how near to the rim the new boundary point. */
const FARTHEST = 0.97;
const RIMS = [0.9995, 0.998, 0.99, 0.97];
/** The step of the difference quotient at 0. */
const STEP = 1e-3;

export class Traveller {
  #view;
  /** The state in which the disk was taken hold of. @type {{ pointer: number, from: Point, region: Region, locator: Locator } | null} */
  #hold = null;

  /** @param {Store} store @param {DiskView} view @param {() => Locator | null} locator of what is shown */
  constructor(store, view, locator) {
    this.#view = view;
    const { root } = view;
    root.addEventListener("pointerdown", (event) => {
      const from = this.#point(event);
      const held = locator();
      if (event.button !== 0 || event.shiftKey || this.#hold || !held || Math.hypot(...from) > FARTHEST) return;
      event.preventDefault();
      root.setPointerCapture(event.pointerId);
      this.#hold = { pointer: event.pointerId, from, region: store.doc.region, locator: held };
      root.classList.add("held");
    });
    root.addEventListener("pointermove", (event) => {
      if (this.#hold?.pointer !== event.pointerId) return;
      const region = travelled(this.#hold, this.#point(event));
      if (region) store.drag(region);
    });
    for (const end of /** @type {const} */ (["pointerup", "pointercancel"])) {
      root.addEventListener(end, (event) => {
        if (this.#hold?.pointer === event.pointerId) this.#end(() => store.drop());
      });
    }
    onEscape(() => {
      if (!this.#hold) return false;
      this.#end(() => store.giveUp());
      return true;
    });
  }

  /** @param {() => void} settle what becomes of the drag */
  #end(settle) {
    this.#hold = null;
    this.#view.root.classList.remove("held");
    settle();
  }

  /** @param {PointerEvent} event */
  #point(event) {
    return toPlane(this.#view.frame, pixelOf(this.#view.root, event));
  }
}

/**
 * The region whose map shows at `to` what was at `from`.
 *
 * T(w) = (w + a)/(1 + āw) moves the disk along itself; T(from) = to gives a − c·ā = d with c = to·from, d = to − from.
 * The new center is where T∘f is 0: f = −a; the new boundary point where it is 1: f = (1 − a)/(1 − ā).
 * @param {{ from: Point, region: Region, locator: Locator }} hold @param {Point} to @returns {Region | null}
 */
export function travelled({ from, region, locator }, to) {
  const length = Math.hypot(...to);
  const [u, v] = length > FARTHEST ? [(to[0] * FARTHEST) / length, (to[1] * FARTHEST) / length] : to;
  const [cx, cy] = [u * from[0] - v * from[1], u * from[1] + v * from[0]];
  const [dx, dy] = [u - from[0], v - from[1]];
  const scale = 1 / (1 - cx * cx - cy * cy);
  const a = [(dx + cx * dx + cy * dy) * scale, (dy + cy * dx - cx * dy) * scale];
  const center = locator.at("target", [-a[0], -a[1]]);
  const toward = rimPoint(locator, 2 * Math.atan2(-a[1], 1 - a[0]));
  return center && toward && moveToward(moveCenter(region, center), toward);
}

/** The region's boundary, nearly, at an angle of the circle. @param {Locator} locator @param {number} angle @returns {Point | null} */
export function rimPoint(locator, angle) {
  for (const radius of RIMS) {
    const found = locator.at("target", [radius * Math.cos(angle), radius * Math.sin(angle)]);
    if (found) return found;
  }
  return null;
}

/**
 * The region whose map does not turn the picture at its center: f'(center) > 0.
 * @param {Region} region @param {import("../common/probe.js").Carrier} carrier of its map @returns {Promise<Region | null>}
 */
export async function upright(region, carrier) {
  const [a, b] = (await carrier.carry("target", [[-STEP, 0], [STEP, 0]])) ?? [];
  if (!a || !b) return null;
  // What the disk shows from left to right lies in this direction on the photo: turn it back.
  const angle = Math.atan2(b[1] - a[1], b[0] - a[0]);
  const places = await carrier.carry("target", RIMS.map((radius) => [radius * Math.cos(angle), -radius * Math.sin(angle)]));
  const place = places?.find(Boolean);
  return place ? moveToward(region, place) : null;
}
