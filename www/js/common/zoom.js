// Looking closer at a picture: the wheel with Ctrl, two fingers, a drag on empty ground, buttons and keys.

import { middleOf, shifted, steered, KEY_ZOOM, wheelRatio, zoomed } from "./placement.js";
import { pixelOf } from "./svg.js";

/** @typedef {import("./frame.js").Frame} Frame */
/** @typedef {import("./frame.js").Point} Point */
/** @typedef {import("./placement.js").Placement} Placement */

/** How close one may look. */
const CLOSEST = 64;

export class Zoom {
  /** What is looked at; null for all of the picture. @type {Placement | null} */
  place = null;
  #root;
  /** @type {() => { frame: Frame, home: Frame }} */ #frames;
  #onChange;
  #buttons;

  /**
   * @param {SVGSVGElement} root of the panel @param {() => { frame: Frame, home: Frame }} frames what is looked at, and the
   * whole, in CSS pixels @param {() => void} onChange @param {(event: PointerEvent) => boolean} isEmpty whether a press there takes hold of nothing
   */
  constructor(root, frames, onChange, isEmpty) {
    this.#root = root;
    this.#frames = frames;
    this.#onChange = onChange;
    this.#buttons = this.#makeButtons();
    this.#followWheel();
    this.#followFingers();
    this.#followDrag(isEmpty);
  }

  /** The frame to draw in. @param {Frame} home the whole picture's @returns {Frame} */
  within(home) {
    return this.place ? { ...home, ...this.place } : home;
  }

  /** All of the picture again, without telling. */
  reset() {
    this.#set(null);
  }

  /** @param {Placement | null} place */
  #set(place) {
    this.place = place;
    this.#root.classList.toggle("zoomed", place !== null);
    this.#buttons.classList.toggle("zoomed", place !== null);
  }

  /** Goes to a place, but never beyond the picture. @param {Placement} place */
  #go({ center, width }) {
    const { home } = this.#frames();
    if (width >= home.width * 0.999) this.#set(null);
    else {
      const narrow = Math.max(width, home.width / CLOSEST);
      const ratio = home.pixels[1] / home.pixels[0];
      const room = (home.width - narrow) / 2;
      /** @param {number} value @param {number} middle @param {number} most */
      const clamp = (value, middle, most) => Math.min(middle + most, Math.max(middle - most, value));
      this.#set({ center: [clamp(center[0], home.center[0], room), clamp(center[1], home.center[1], room * ratio)], width: narrow });
    }
    this.#onChange();
  }

  /** Without Ctrl the wheel scrolls the page. */
  #followWheel() {
    this.#root.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      this.#go(zoomed(this.#frames().frame, pixelOf(this.#root, event), wheelRatio(event)));
    }, { passive: false });
  }

  #followFingers() {
    /** @type {[Point, Point] | null} */
    let last = null;
    /** @param {TouchEvent} event @returns {[Point, Point] | null} */
    const pair = ({ touches }) => {
      const box = this.#root.getBoundingClientRect();
      const [a, b] = [...touches].map(({ clientX, clientY }) => /** @type {Point} */ ([clientX - box.left, clientY - box.top]));
      return touches.length === 2 ? [a, b] : null;
    };
    this.#root.addEventListener("touchstart", (event) => {
      last = pair(event);
      if (last) event.preventDefault();
    }, { passive: false });
    this.#root.addEventListener("touchmove", (event) => {
      const now = pair(event);
      if (!last || !now) return;
      event.preventDefault();
      const [from, to] = [last, now].map(([a, b]) => ({ middle: /** @type {Point} */ ([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]), apart: Math.hypot(a[0] - b[0], a[1] - b[1]) }));
      const moved = { ...this.#frames().frame, ...shifted(this.#frames().frame, from.middle, to.middle) };
      this.#go(zoomed(moved, to.middle, from.apart / (to.apart || 1)));
      last = now;
    }, { passive: false });
    for (const end of /** @type {const} */ (["touchend", "touchcancel"])) this.#root.addEventListener(end, () => (last = null));
  }

  /** @param {(event: PointerEvent) => boolean} isEmpty */
  #followDrag(isEmpty) {
    /** @type {{ pointer: number, at: Point } | null} */
    let hold = null;
    this.#root.addEventListener("pointerdown", (event) => {
      if (!this.place || event.pointerType === "touch" || event.button !== 0 || !isEmpty(event)) return;
      hold = { pointer: event.pointerId, at: pixelOf(this.#root, event) };
      this.#root.setPointerCapture(event.pointerId);
    });
    this.#root.addEventListener("pointermove", (event) => {
      if (hold?.pointer !== event.pointerId) return;
      const at = pixelOf(this.#root, event);
      this.#go(shifted(this.#frames().frame, hold.at, at));
      hold = { ...hold, at };
    });
    for (const end of /** @type {const} */ (["pointerup", "pointercancel"])) this.#root.addEventListener(end, () => (hold = null));
  }

  /** Closer, wider, all: for those who have no wheel. Arrow keys on them move. */
  #makeButtons() {
    const group = Object.assign(document.createElement("div"), { className: "zoom" });
    group.setAttribute("role", "group");
    group.setAttribute("aria-label", "Zoom; arrow keys move");
    /** @param {string} sign @param {string} name @param {() => void} onclick */
    const add = (sign, name, onclick) => {
      const button = Object.assign(document.createElement("button"), { type: "button", textContent: sign, title: name, onclick });
      button.setAttribute("aria-label", name);
      group.append(button);
    };
    /** @param {number} ratio */
    const by = (ratio) => this.#go(zoomed(this.#frames().frame, middleOf(this.#frames().frame), ratio));
    add("+", "Closer (+, or Ctrl and the wheel)", () => by(1 / KEY_ZOOM ** 2));
    add("−", "Wider (−)", () => by(KEY_ZOOM ** 2));
    add("Fit", "All of it (0)", () => this.#go(this.#frames().home));
    group.addEventListener("keydown", (event) => {
      const { frame, home } = this.#frames();
      const place = steered(frame, event, home);
      if (!place) return;
      event.preventDefault();
      this.#go(place);
    });
    this.#root.after(group);
    return group;
  }
}
