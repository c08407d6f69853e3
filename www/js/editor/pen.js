// Drawing a new region: corner by corner, or in one stroke with the button held.

import { toPixels, toPlane } from "../common/frame.js";
import { distance, simplify } from "./geometry.js";
import { makeRegion } from "./region.js";
import { pathData, pixelOf, set, svg } from "../common/svg.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./store.js").Store} Store */
/** @typedef {import("./photo-view.js").PhotoView} PhotoView */

/** In pixels of the panel: how near to the first point closes, how far a press moves to become a stroke, … */
const CLOSE = 12;
const STROKE = 6;
/** … the spacing of a stroke's points, and how far the outline may leave the stroke. */
const SPACING = 2;
const SLACK = 1.2;

export class Pen {
  #store;
  #view;
  /** In the plane. @type {Point[]} */
  #points = [];
  /** The pointer, in pixels. @type {Point | null} */
  #hover = null;
  /** The press that may become a stroke. @type {{ pointer: number, from: Point, stroke: boolean } | null} */
  #press = null;
  #line = svg("path", { class: "pen-line" });
  #halo = svg("path", { class: "pen-halo" });
  #start = svg("circle", { class: "pen-start", r: 7 });

  /** @param {Store} store @param {PhotoView} view */
  constructor(store, view) {
    this.#store = store;
    this.#view = view;
    const { root } = view;
    root.append(svg("g", { class: "pen" }, [this.#halo, this.#line, this.#start]));
    root.addEventListener("pointerdown", (event) => this.#down(event));
    root.addEventListener("pointermove", (event) => this.#move(event));
    root.addEventListener("pointerup", (event) => this.#up(event));
    root.addEventListener("pointercancel", (event) => this.#up(event));
    window.addEventListener("keydown", (event) => this.#key(event));
  }

  begin() {
    this.#points = [];
    this.#hover = null;
    this.#press = null;
    this.#draw();
    this.#store.setMode("draw");
  }

  cancel() {
    this.#points = [];
    this.#draw();
    this.#store.setMode("edit");
  }

  get #active() {
    return this.#store.mode === "draw";
  }

  /** @param {PointerEvent} event */
  #down(event) {
    if (!this.#active || event.button !== 0 || this.#press) return;
    event.preventDefault();
    const { root, frame } = this.#view;
    const at = pixelOf(root, event);
    root.setPointerCapture(event.pointerId);
    const [first] = this.#points;
    const last = this.#points.at(-1);
    if (this.#points.length > 2 && first && distance(toPixels(frame, first), at) < CLOSE) return this.#finish();
    // As the second press of a double click does.
    if (this.#points.length > 2 && last && distance(toPixels(frame, last), at) < STROKE) return this.#finish();
    this.#press = { pointer: event.pointerId, from: at, stroke: false };
    this.#points.push(this.#plane(at));
    this.#hover = at;
    this.#draw();
  }

  /** @param {PointerEvent} event */
  #move(event) {
    if (!this.#active) return;
    const { frame, root } = this.#view;
    const at = pixelOf(root, event);
    this.#hover = at;
    const press = this.#press;
    if (press?.pointer === event.pointerId) {
      press.stroke ||= distance(press.from, at) > STROKE;
      const last = this.#points.at(-1);
      if (press.stroke && last && distance(toPixels(frame, last), at) >= SPACING) this.#points.push(this.#plane(at));
    }
    this.#draw();
  }

  /** @param {PointerEvent} event */
  #up(event) {
    const press = this.#press;
    if (press?.pointer !== event.pointerId) return;
    this.#press = null;
    if (press.stroke) this.#finish();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (!this.#active) return;
    if (event.key === "Escape") this.cancel();
    else if (event.key === "Enter" && this.#points.length > 2) this.#finish();
    else if (event.key === "Backspace" || event.key === "Delete") {
      this.#points.pop();
      this.#draw();
    } else return;
    event.preventDefault();
  }

  #finish() {
    const { frame } = this.#view;
    const slack = (SLACK * frame.width) / frame.pixels[0];
    const outline = outlineOf(this.#points, slack);
    if (outline.length < 3) return this.cancel();
    this.#points = [];
    this.#draw();
    this.#store.setMode("edit");
    this.#store.commit({ region: makeRegion(outline) });
  }

  #draw() {
    const { frame } = this.#view;
    const pixels = this.#points.map((p) => toPixels(frame, p));
    const [first] = pixels;
    const line = this.#hover && pixels.length && !this.#press?.stroke ? [...pixels, this.#hover] : pixels;
    const closing = pixels.length > 2 && this.#hover !== null && distance(first, this.#hover) < CLOSE;
    for (const path of [this.#line, this.#halo]) set(path, { d: pathData(line, false) });
    set(this.#start, { cx: first?.[0] ?? -99, cy: first?.[1] ?? -99, class: closing ? "pen-start closing" : "pen-start" });
  }

  /** @param {Point} pixel @returns {Point} */
  #plane([x, y]) {
    const { frame } = this.#view;
    return toPlane(frame, [Math.min(frame.pixels[0], Math.max(0, x)), Math.min(frame.pixels[1], Math.max(0, y))]);
  }
}

/** A drawn line as a closed outline, without the points that add nothing. @param {Point[]} line @param {number} slack */
function outlineOf(line, slack) {
  if (line.length < 3) return line;
  const [start] = line;
  // Cut at the point farthest from the start: the line's own ends meet, and would be the same point.
  const far = line.reduce((best, p, k) => (distance(p, start) > distance(line[best], start) ? k : best), 0);
  const outline = [...simplify(line.slice(0, far + 1), slack), ...simplify([...line.slice(far), start], slack).slice(1)];
  outline.pop();
  while (outline.length > 3 && distance(outline[outline.length - 1], start) < 2 * slack) outline.pop();
  return outline;
}
