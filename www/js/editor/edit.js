// Editing the region with pointer and keyboard: points, edges, the ends of the vector, the whole.

import { toPixels, toPlane } from "../common/frame.js";
import { onEscape } from "../common/keys.js";
import { pixelOf } from "../common/svg.js";
import { distance } from "./geometry.js";
import { polygonOf } from "./outline.js";
import { pointOn } from "./curve.js";
import { canRemove, convertEdge, edgeAfter, handlesOf, holeAt, moveCenter, moveHandle, moveToward, moveVertex, pointsOf, removeHole, removeVertex, splitEdge, towardPoint, translate, translateHole } from "./region.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./region.js").Region} Region */
/** @typedef {import("./store.js").Store} Store */
/** @typedef {import("./photo-view.js").PhotoView} PhotoView */
/**
 * A drag of one part: where it was taken hold of, and the region for a new place of the pointer.
 * @typedef {{ pointer: number, grip: Point, move: Move, moved: boolean }} Drag
 */
/** Where a part is taken to; `breaks`: a smooth joint may become a corner. @typedef {(to: Point, breaks: boolean) => Region} Move */
/** What an element, or a place, is of the region. @typedef {{ part: string | undefined, index: number, handle?: import("./region.js").Handle }} Part */

/** Keys that say what the edge after a point is to be. @type {Record<string, import("./curve.js").Kind>} */
const KINDS = { l: "line", a: "arc", c: "curve" };

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
    if (selected === null || !canRemove(doc.region, selected)) return;
    this.#store.commit({ region: removeVertex(doc.region, selected) });
    const last = pointsOf(this.#store.doc.region).length - 1;
    this.#store.select(Math.min(selected, last));
  }

  /** The edge after the selected point is made a line, an arc or a curve. @param {import("./curve.js").Kind} kind */
  convertSelected(kind) {
    const { selected, doc } = this.#store;
    if (selected !== null) this.#store.commit({ region: convertEdge(doc.region, selected, kind) });
  }

  /** @param {PointerEvent} event */
  #press(event) {
    if (this.#store.mode !== "edit" || event.button !== 0 || this.#drag) return;
    const at = pixelOf(this.#view.root, event);
    const found = (event.pointerType === "touch" && this.#nearest(at)) || partOf(event.target);
    const { part, index } = found;
    const taken = this.#take(found, at, event.pointerType);
    if (!taken) return this.#store.select(null);
    event.preventDefault();
    this.#view.root.setPointerCapture(event.pointerId);
    /** @type {Point} */
    const grip = [taken.anchor[0] - at[0], taken.anchor[1] - at[1]];
    this.#drag = { pointer: event.pointerId, grip, move: taken.move, moved: false };
    if (part === "edge") this.#store.drag(taken.move(this.#plane(at), false));
    if (found.handle) /** @type {SVGElement | null} */ (this.#view.handle(index, found.handle))?.focus();
    else if (part !== "body" && part !== "hole") this.#focus(part, index);
  }

  /** A finger that takes hold of something does not scroll the page; what is drawn in an SVG cannot say so in its style. @param {TouchEvent} event */
  #touch(event) {
    if (this.#store.mode !== "edit" || event.touches.length > 1) return;
    const [{ clientX, clientY }] = event.touches;
    const box = this.#view.root.getBoundingClientRect();
    if (partOf(event.target).part === "edge" || this.#nearest([clientX - box.left, clientY - box.top])) event.preventDefault();
  }

  /** What is to be taken hold of nearest to a finger, if it is near: those of neighbours overlap. @param {Point} at @returns {Part | null} */
  #nearest(at) {
    const { region } = this.#store.doc;
    /** @type {[Part, Point][]} */
    const all = [
      [{ part: "center", index: -1 }, region.center],
      [{ part: "toward", index: -1 }, towardPoint(region)],
      ...pointsOf(region).map((p, k) => /** @type {[Part, Point]} */ ([{ part: "vertex", index: k }, p])),
      ...this.#view.handles.map(({ edge, handle, at: place }) => /** @type {[Part, Point]} */ ([{ part: "handle", index: edge, handle }, place])),
    ];
    /** @type {Part | null} */
    let best = null;
    let least = FINGER;
    for (const [part, point] of all) {
      const away = distance(toPixels(this.#view.frame, point), at);
      if (away < least) [best, least] = [part, away];
    }
    return best;
  }

  /**
   * What a press takes hold of: the anchor, in pixels, that will follow the pointer, and the region it makes.
   * @param {Part} found @param {Point} at @param {string} pointerType
   * @returns {{ anchor: Point, move: Move } | null}
   */
  #take({ part, index, handle }, at, pointerType) {
    const { region } = this.#store.doc;
    const { frame } = this.#view;
    switch (part) {
      case "vertex":
        return { anchor: toPixels(frame, pointsOf(region)[index]), move: (to) => moveVertex(region, index, to) };
      case "edge": {
        const split = splitEdge(region, index, toPlane(frame, at));
        return { anchor: at, move: (to) => moveVertex(split, index + 1, to) };
      }
      case "handle": {
        const place = handlesOf(region, index).find((one) => one.handle === handle);
        return place ? { anchor: toPixels(frame, place.at), move: (to, breaks) => moveHandle(region, index, place.handle, to, breaks) } : null;
      }
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
      case "hole": {
        if (pointerType === "touch") return null;
        const from = toPlane(frame, at);
        return { anchor: at, move: (to) => translateHole(region, index, [to[0] - from[0], to[1] - from[1]]) };
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
    this.#store.drag(drag.move(this.#plane([x + drag.grip[0], y + drag.grip[1]]), event.altKey));
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
    const found = partOf(event.target);
    const { part, index } = found;
    if (this.#store.mode !== "edit" || !part || event.ctrlKey || event.metaKey) return;
    if (event.altKey && part !== "handle") return;
    const { region } = this.#store.doc;
    const count = pointsOf(region).length;
    if (event.key in STEPS) this.#nudge(found, STEPS[event.key], event.shiftKey ? 10 : 1, event.altKey);
    else if (part !== "vertex") return;
    else if (event.key === "Delete" || event.key === "Backspace") {
      const hole = event.shiftKey ? holeAt(region, index) : null;
      if (hole === null) this.removeSelected();
      else this.#store.commit({ region: removeHole(region, hole) });
      this.#focus("vertex", this.#store.selected ?? 0);
    } else if (event.key === "PageDown") this.#focus("vertex", (index + 1) % count);
    else if (event.key === "PageUp") this.#focus("vertex", (index + count - 1) % count);
    else if (event.key === "Insert" || event.key === "+") {
      this.#store.commit({ region: splitEdge(region, index, pointOn(...edgeAfter(region, index), 0.5)) });
      this.#focus("vertex", index + 1);
    } else if (event.key.toLowerCase() in KINDS) this.#store.commit({ region: convertEdge(region, index, KINDS[event.key.toLowerCase()]) });
    else return;
    event.preventDefault();
  }

  /** @param {Part} found @param {Point} step @param {number} times @param {boolean} breaks */
  #nudge(found, [dx, dy], times, breaks) {
    const taken = this.#take(found, [0, 0], "keyboard");
    if (!taken) return;
    const [x, y] = taken.anchor;
    this.#store.drag(taken.move(this.#plane([x + times * dx, y + times * dy]), breaks));
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
  #within(region, [dx, dy]) {
    const { width, pixels } = this.#view.home;
    /** @param {0 | 1} axis @param {number} half @param {number} d */
    const clamp = (axis, half, d) => {
      const values = polygonOf(region).map((p) => p[axis]);
      return Math.min(half - Math.max(...values), Math.max(-half - Math.min(...values), d));
    };
    return [clamp(0, width / 2, dx), clamp(1, (width * pixels[1]) / pixels[0] / 2, dy)];
  }
}

/** Which part of the region an element is. @param {EventTarget | null} target @returns {Part} */
export function partOf(target) {
  const element = target instanceof Element ? /** @type {SVGElement | null} */ (target.closest("[data-part]")) : null;
  const part = element?.dataset.part;
  // The handle in the middle of an edge is taken for the edge.
  const handle = /** @type {import("./region.js").Handle | undefined} */ (element?.dataset.handle);
  return { part: part === "middle" ? "edge" : part, index: Number(element?.dataset.index ?? -1), handle };
}
