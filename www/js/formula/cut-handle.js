// The cuts drawn in the plane of the formula, and the handle that turns them: by pointer and keys.

import { toPixels, toPlane } from "../common/frame.js";
import { ARROWS } from "../common/keys.js";
import { pixelOf, set, svg } from "../common/svg.js";
import { isTurned, wholeTurn } from "./cut.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./cut.js").Cut} Cut */
/** @typedef {import("./cut-lines.js").Piece} Piece */
/** What has cuts: its place among them, and their pieces. @typedef {{ which: number, pieces: Piece[] }} Line */
/**
 * What the handle needs of the page.
 * @typedef {object} Page
 * @property {() => Cut} cut
 * @property {(turn: number) => void} onTurn turned so far, over all sheets, in degrees
 * @property {(which: number, at: Point) => Promise<number | null>} angleAt of what has the cut
 */
/** @typedef {{ root: SVGSVGElement, frame: Frame }} View */

/** An arrow key's step in degrees; with Shift more. */
const STEP = 2;
const FASTER = 15;
/** The handle sits so far from the middle at first, in shares of the panel's width, and so far from its rim. */
const OUT = 0.3;
const RIM = 14;

export class CutHandle {
  #page;
  #halo = svg("path", { class: "cut-halo" });
  #line = svg("path", { class: "cut-line" });
  #handle = svg("g", { class: "cut-handle", "data-part": "cut", role: "slider", tabindex: 0, "aria-label": "The cut; arrow keys turn it", visibility: "hidden" }, [
    svg("circle", { class: "reach", r: 20 }),
    svg("circle", { class: "dot", r: 9 }),
    svg("path", { d: "M-3.5 -4A5.2 5.2 0 0 1 5 -1.5M-5 1.5A5.2 5.2 0 0 0 3.5 4M5.3 -4.6V-1.2H1.9M-5.3 4.6V1.2H-1.9" }),
  ]);
  /** @type {View | null} */ #view = null;
  /** @type {Line[]} */ #lines = [];
  /** Where it sits, and on the cut of what. @type {{ at: Point, which: number } | null} */ #seat = null;
  /** @type {{ pointer: number, grip: Point } | null} */ #hold = null;

  /** @param {Page} page */
  constructor(page) {
    this.#page = page;
    this.#follow();
  }

  /** Draws the cuts in a view; none, and there is no handle. @param {View} view @param {Line[]} lines */
  show(view, lines) {
    if (this.#view?.root !== view.root) {
      view.root.append(this.#halo, this.#line, this.#handle);
      this.#seat = null;
    }
    this.#view = view;
    this.#lines = lines;
    if (!this.#hold) this.#sit();
    this.draw();
  }

  /** As the view is now: it may have moved since the lines were found. */
  draw() {
    if (!this.#view) return;
    const { frame } = this.#view;
    const d = this.#lines.flatMap(({ pieces }) => pieces.map(([a, b]) => segment(toPixels(frame, a), toPixels(frame, b)))).join("");
    set(this.#line, { d });
    set(this.#halo, { d });
    for (const line of [this.#line, this.#halo]) line.classList.toggle("turned", isTurned(this.#page.cut()));
    const [x, y] = this.#seat ? toPixels(frame, this.#seat.at) : [0, 0];
    const turn = wholeTurn(this.#page.cut());
    set(this.#handle, {
      visibility: this.#seat ? "visible" : "hidden",
      transform: `translate(${x.toFixed(2)} ${y.toFixed(2)})`,
      "aria-valuenow": Math.round(turn),
      "aria-valuetext": `${Math.round(this.#page.cut().angle)} degrees, sheet ${this.#page.cut().sheet}`,
    });
  }

  /** Stays on the cut: where it is nearest to where it was, at first at some distance from the middle. */
  #sit() {
    if (!this.#view) return;
    const { frame } = this.#view;
    const [width, height] = frame.pixels;
    const was = this.#seat && toPixels(frame, this.#seat.at);
    let least = Infinity;
    this.#seat = null;
    for (const { which, pieces } of this.#lines) {
      for (const at of pieces.flat()) {
        const [x, y] = toPixels(frame, at);
        if (Math.min(x, y, width - x, height - y) < RIM) continue;
        const away = was ? Math.hypot(x - was[0], y - was[1]) : Math.abs(Math.hypot(x - width / 2, y - height / 2) - OUT * width);
        if (away < least) [least, this.#seat] = [away, { at, which }];
      }
    }
  }

  /** @param {Point} pixel */
  async #go(pixel) {
    if (!this.#view || !this.#seat) return;
    const { which } = this.#seat;
    const at = toPlane(this.#view.frame, pixel);
    const angle = await this.#page.angleAt(which, at);
    if (angle === null) return;
    this.#seat = { at, which };
    const turn = wholeTurn(this.#page.cut());
    this.#page.onTurn(angle + 360 * Math.round((turn - angle) / 360));
  }

  #follow() {
    const handle = this.#handle;
    handle.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || !this.#view || !this.#seat) return;
      event.stopPropagation();
      event.preventDefault();
      handle.setPointerCapture(event.pointerId);
      handle.focus();
      const [[x, y], [u, v]] = [pixelOf(this.#view.root, event), toPixels(this.#view.frame, this.#seat.at)];
      this.#hold = { pointer: event.pointerId, grip: [u - x, v - y] };
    });
    handle.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
    handle.addEventListener("pointermove", (event) => {
      if (this.#hold?.pointer !== event.pointerId || !this.#view) return;
      event.stopPropagation();
      const [x, y] = pixelOf(this.#view.root, event);
      this.#go([x + this.#hold.grip[0], y + this.#hold.grip[1]]);
    });
    for (const end of /** @type {const} */ (["pointerup", "pointercancel"])) {
      handle.addEventListener(end, () => (this.#hold = null));
    }
    handle.addEventListener("keydown", (event) => {
      const direction = ARROWS.get(event.key);
      if (!direction || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      event.stopPropagation();
      const step = event.shiftKey ? FASTER : STEP;
      this.#page.onTurn(Math.round(wholeTurn(this.#page.cut()) + step * (direction[0] + direction[1])));
    });
  }
}

/** @param {Point} from @param {Point} to */
const segment = ([x, y], [u, v]) => `M${x.toFixed(1)} ${y.toFixed(1)}L${u.toFixed(1)} ${v.toFixed(1)}`;
