// Handles on the picture in its own plane: its middle moves it, its corner makes it larger or smaller; by pointer and keys.

import { scaleOf, toPixels, toPlane } from "../common/frame.js";
import { ARROWS } from "../common/keys.js";
import { pixelOf, set, svg } from "../common/svg.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/placement.js").Placement} Placement */

/** An arrow key's step in pixels; with Shift more. */
const STEP = 4;
const FASTER = 5;
/** The narrowest picture, in pixels of the panel. */
const LEAST = 12;

export class PictureHandles {
  /** @type {{ root: SVGSVGElement, frame: Frame }} */ #view;
  #place;
  #onPlace;
  #move = handle("move", "The picture; arrow keys move it", "M-7 0H7M0 -7V7M-7 0l2.5 -2.5M-7 0l2.5 2.5M7 0l-2.5 -2.5M7 0l-2.5 2.5M0 -7l-2.5 2.5M0 -7l2.5 2.5M0 7l-2.5 -2.5M0 7l2.5 -2.5");
  #size = handle("size", "The size of the picture; arrow keys change it", "M-5 -5L5 5M5 5h-4M5 5v-4M-5 -5h4M-5 -5v4");

  /** @param {{ root: SVGSVGElement, frame: Frame }} view @param {() => Placement} place of the picture @param {(place: Placement) => void} onPlace */
  constructor(view, place, onPlace) {
    this.#view = view;
    this.#place = place;
    this.#onPlace = onPlace;
    view.root.append(this.#move, this.#size);
    this.#follow(this.#move, ({ center }) => center, ({ width }, to) => ({ center: to, width }));
    this.#follow(this.#size, corner, ({ center }, to) => {
      const least = LEAST / scaleOf(view.frame);
      return { center, width: Math.max(least, 2 * Math.max(to[0] - center[0], center[1] - to[1])) };
    });
  }

  draw() {
    const place = this.#place();
    for (const [group, at] of /** @type {[SVGGElement, Point][]} */ ([[this.#move, place.center], [this.#size, corner(place)]])) {
      const [x, y] = toPixels(this.#view.frame, at);
      set(group, { transform: `translate(${x.toFixed(2)} ${y.toFixed(2)})` });
    }
  }

  /** @param {SVGGElement} group @param {(place: Placement) => Point} anchor @param {(place: Placement, to: Point) => Placement} moved */
  #follow(group, anchor, moved) {
    /** @type {{ pointer: number, grip: Point } | null} */
    let hold = null;
    const here = () => toPixels(this.#view.frame, anchor(this.#place()));
    /** @param {Point} pixel */
    const go = (pixel) => this.#onPlace(moved(this.#place(), toPlane(this.#view.frame, pixel)));
    group.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      // The plane under it stays where it is.
      event.stopPropagation();
      event.preventDefault();
      group.setPointerCapture(event.pointerId);
      group.focus();
      const [[x, y], [u, v]] = [pixelOf(this.#view.root, event), here()];
      hold = { pointer: event.pointerId, grip: [u - x, v - y] };
    });
    group.addEventListener("pointermove", (event) => {
      if (hold?.pointer !== event.pointerId) return;
      event.stopPropagation();
      const [x, y] = pixelOf(this.#view.root, event);
      go([x + hold.grip[0], y + hold.grip[1]]);
    });
    for (const end of /** @type {const} */ (["pointerup", "pointercancel"])) group.addEventListener(end, () => (hold = null));
    group.addEventListener("keydown", (event) => {
      const direction = ARROWS.get(event.key);
      if (!direction || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      event.stopPropagation();
      const step = STEP * (event.shiftKey ? FASTER : 1);
      const [x, y] = here();
      go([x + step * direction[0], y - step * direction[1]]);
    });
  }
}

/** The lower right one. @param {Placement} place @returns {Point} */
const corner = ({ center: [x, y], width }) => [x + width / 2, y - width / 2];

/** @param {string} part @param {string} label @param {string} d */
function handle(part, label, d) {
  return svg("g", { class: `picture-handle ${part}`, "data-part": part, role: "button", tabindex: 0, "aria-label": label }, [
    svg("circle", { class: "reach", r: 20 }),
    svg("circle", { class: "dot", r: 10 }),
    svg("path", { d }),
  ]);
}
