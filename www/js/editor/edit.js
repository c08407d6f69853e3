// Editing the region with pointer and keyboard: points, edges, the ends of the vector, the whole.

import { toPixels, toPlane } from "../common/frame.js";
import { onEscape } from "../common/keys.js";
import { pixelOf } from "../common/svg.js";
import { distance } from "./geometry.js";
import { insertVertex, moveCenter, moveToward, moveVertex, removeVertex, towardPoint, translate } from "./region.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./region.js").Region} Region */
/** @typedef {import("./store.js").Store} Store */
/** @typedef {import("./photo-view.js").PhotoView} PhotoView */
/**
 * A drag of one part: where it was taken hold of, and the region for a new place of the pointer.
 * @typedef {{ pointer: number, grip: Point, move: (to: Point) => Region, moved: boolean }} Drag
 */

/** Arrow keys, in pixels of the panel. @type {Record<string, Point>} */
const STEPS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** A finger takes hold of what is so near, in pixels of the panel. */
const FINGER = 22;

/** A pause this long ends a series of arrow keys, in milliseconds. */
const KEY_PAUSE = 400;

export class Editor {
  #store;
  #view;
  /** @type {Drag | null} */
  #drag = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #keys;

  /** @param {Store} store @param {PhotoView} view */
  constructor(store, view) {
    this.#store = store;
    this.#view = view;
    const { root } = view;
    root.addEventListener("pointerdown", (event) => this.#press(event));
    root.addEventListener("touchstart", (event) => this.#touch(event), { passive: false });
    root.addEventListener("pointermove", (event) => this.#move(event));
    root.addEventListener("pointerup", (event) => this.#release(event));
    root.addEventListener("pointercancel", (event) => this.#release(event));
    root.addEventListener("dblclick", (event) => this.#doubleClick(event));
    root.addEventListener("keydown", (event) => this.#key(event));
    root.addEventListener("focusin", (event) => {
      const { part, index } = partOf(event.target);
      if (part === "vertex") this.#store.select(index);
    });
    onEscape(() => this.#cancel());
  }

  /** Gives a drag up: the region is as before. */
  #cancel() {
    if (!this.#drag) return false;
    this.#drag = null;
    this.#store.giveUp();
    return true;
  }

  /** Removes the selected point. */
  removeSelected() {
    const { selected, doc } = this.#store;
    if (selected === null || doc.region.boundary.length <= 3) return;
    this.#store.commit({ region: removeVertex(doc.region, selected) });
    const last = this.#store.doc.region.boundary.length - 1;
    this.#store.select(Math.min(selected, last));
  }

  /** @param {PointerEvent} event */
  #press(event) {
    if (this.#store.mode !== "edit" || event.button !== 0 || this.#drag) return;
    const at = pixelOf(this.#view.root, event);
    const { part, index } = (event.pointerType === "touch" && this.#nearest(at)) || partOf(event.target);
    const taken = this.#take(part, index, at, event.pointerType);
    if (!taken) return this.#store.select(null);
    event.preventDefault();
    this.#view.root.setPointerCapture(event.pointerId);
    /** @type {Point} */
    const grip = [taken.anchor[0] - at[0], taken.anchor[1] - at[1]];
    this.#drag = { pointer: event.pointerId, grip, move: taken.move, moved: false };
    if (part === "edge") this.#store.drag(taken.move(this.#plane(at)));
    if (part !== "body") this.#focus(part, index);
  }

  /** A finger that takes hold of something does not scroll the page; what is drawn in an SVG cannot say so in its style. @param {TouchEvent} event */
  #touch(event) {
    if (this.#store.mode !== "edit" || event.touches.length > 1) return;
    const [{ clientX, clientY }] = event.touches;
    const box = this.#view.root.getBoundingClientRect();
    if (partOf(event.target).part === "edge" || this.#nearest([clientX - box.left, clientY - box.top])) event.preventDefault();
  }

  /** The handle nearest to a finger, if one is near: those of neighbours overlap. @param {Point} at */
  #nearest(at) {
    const { region } = this.#store.doc;
    /** @type {[part: string, index: number, point: Point][]} */
    const handles = [["center", -1, region.center], ["toward", -1, towardPoint(region)], ...region.boundary.map((p, k) => /** @type {[string, number, Point]} */ (["vertex", k, p]))];
    let best = { part: "", index: -1, away: FINGER };
    for (const [part, index, point] of handles) {
      const away = distance(toPixels(this.#view.frame, point), at);
      if (away < best.away) best = { part, index, away };
    }
    return best.part ? best : null;
  }

  /**
   * What a press takes hold of: the anchor, in pixels, that will follow the pointer, and the region it makes.
   * @param {string | undefined} part @param {number} index @param {Point} at @param {string} pointerType
   * @returns {{ anchor: Point, move: (to: Point) => Region } | null}
   */
  #take(part, index, at, pointerType) {
    const { region } = this.#store.doc;
    const { frame } = this.#view;
    switch (part) {
      case "vertex":
        return { anchor: toPixels(frame, region.boundary[index]), move: (to) => moveVertex(region, index, to) };
      case "edge":
        return { anchor: at, move: (to) => insertVertex(region, index, to) };
      case "center":
        return { anchor: toPixels(frame, region.center), move: (to) => moveCenter(region, to) };
      case "toward":
        return { anchor: toPixels(frame, towardPoint(region)), move: (to) => moveToward(region, to) };
      case "body": {
        // A finger on the photo scrolls the page; only its handles are dragged.
        if (pointerType === "touch") return null;
        const from = toPlane(frame, at);
        return { anchor: at, move: (to) => translate(region, this.#within(region, [to[0] - from[0], to[1] - from[1]])) };
      }
      default:
        return null;
    }
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const drag = this.#drag;
    if (!drag || event.pointerId !== drag.pointer) return;
    const [x, y] = pixelOf(this.#view.root, event);
    drag.moved = true;
    this.#store.drag(drag.move(this.#plane([x + drag.grip[0], y + drag.grip[1]])));
  }

  /** @param {PointerEvent} event */
  #release(event) {
    if (event.pointerId !== this.#drag?.pointer) return;
    this.#drag = null;
    this.#store.drop();
  }

  /** @param {MouseEvent} event */
  #doubleClick(event) {
    // The press captured the pointer, so the event itself names only the whole drawing.
    const { part, index } = partOf(document.elementFromPoint(event.clientX, event.clientY));
    if (this.#store.mode !== "edit" || part !== "vertex") return;
    this.#store.select(index);
    this.removeSelected();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const { part, index } = partOf(event.target);
    if (this.#store.mode !== "edit" || !part || event.ctrlKey || event.metaKey || event.altKey) return;
    const { region } = this.#store.doc;
    const count = region.boundary.length;
    if (event.key in STEPS) this.#nudge(part, index, STEPS[event.key], event.shiftKey ? 10 : 1);
    else if (part !== "vertex") return;
    else if (event.key === "Delete" || event.key === "Backspace") {
      this.removeSelected();
      this.#focus("vertex", this.#store.selected ?? 0);
    } else if (event.key === "PageDown") this.#focus("vertex", (index + 1) % count);
    else if (event.key === "PageUp") this.#focus("vertex", (index + count - 1) % count);
    else if (event.key === "Insert" || event.key === "+") {
      const [[ax, ay], [bx, by]] = [region.boundary[index], region.boundary[(index + 1) % count]];
      this.#store.commit({ region: insertVertex(region, index, [(ax + bx) / 2, (ay + by) / 2]) });
      this.#focus("vertex", index + 1);
    } else return;
    event.preventDefault();
  }

  /** @param {string} part @param {number} index @param {Point} step @param {number} times */
  #nudge(part, index, [dx, dy], times) {
    const taken = this.#take(part, index, [0, 0], "keyboard");
    if (!taken) return;
    const [x, y] = taken.anchor;
    this.#store.drag(taken.move(this.#plane([x + times * dx, y + times * dy])));
    clearTimeout(this.#keys);
    this.#keys = setTimeout(() => this.#store.drop(), KEY_PAUSE);
  }

  /** @param {string | undefined} part @param {number} index */
  #focus(part, index) {
    if (part === "edge" || part === "vertex") {
      const vertex = part === "edge" ? index + 1 : index;
      this.#store.select(vertex);
      this.#view.focusVertex(vertex);
    } else {
      this.#store.select(null);
      /** @type {SVGElement | null} */ (this.#view.root.querySelector(`[data-part="${part}"]`))?.focus();
    }
  }

  /** A pixel, kept on the photo, in the plane. @param {Point} pixel @returns {Point} */
  #plane([x, y]) {
    const { frame } = this.#view;
    return toPlane(frame, [Math.min(frame.pixels[0], Math.max(0, x)), Math.min(frame.pixels[1], Math.max(0, y))]);
  }

  /** The part of a shift that keeps the region on the photo. @param {Region} region @param {Point} shift @returns {Point} */
  #within({ boundary }, [dx, dy]) {
    const { width, pixels } = this.#view.home;
    /** @param {0 | 1} axis @param {number} half @param {number} d */
    const clamp = (axis, half, d) => {
      const values = boundary.map((p) => p[axis]);
      return Math.min(half - Math.max(...values), Math.max(-half - Math.min(...values), d));
    };
    return [clamp(0, width / 2, dx), clamp(1, (width * pixels[1]) / pixels[0] / 2, dy)];
  }
}

/** Which part of the region an element is. @param {EventTarget | null} target */
export function partOf(target) {
  const element = target instanceof Element ? /** @type {SVGElement | null} */ (target.closest("[data-part]")) : null;
  const part = element?.dataset.part;
  // The handle in the middle of an edge is taken for the edge.
  return { part: part === "middle" ? "edge" : part, index: Number(element?.dataset.index ?? -1) };
}
