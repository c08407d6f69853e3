// Drawing a new region: corner by corner, or in one stroke with the button held.

import { toPixels, toPlane } from "../common/frame.js";
import { undoOrRedo } from "../common/keys.js";
import { pathData, pixelOf, set, svg } from "../common/svg.js";
import { fitted } from "./fit.js";
import { crossingEdges, distance, simplifyClosed } from "./geometry.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/**
 * @typedef {object} Paper
 * @property {{ root: SVGSVGElement, frame: Frame }} view where the pen draws
 * @property {() => boolean} isActive
 * @property {(drawing: boolean) => void} onMode asks for drawing to begin, or to end
 * @property {(outline: Point[]) => void} onOutline
 * @property {(outline: import("./outline.js").Outline) => void} [onStroke] takes a stroke as curves; left out, it is one of straight edges
 */

/** In pixels of the panel: how near to the first point closes, how far a press moves to become a stroke, … */
const CLOSE = 12;
const STROKE = 6;
/** … the spacing of a stroke's points, how far the outline may leave the stroke, how long a hook at its ends may be, and how far around a point its direction is looked for. */
const SPACING = 2;
const SLACK = 1.2;
const HOOK = 40;
const REACH = 10;

export class Pen {
  #paper;
  /** In the plane. @type {Point[]} */
  #points = [];
  /** Corners that were taken back. @type {Point[]} */
  #undone = [];
  /** The pointer, in pixels. @type {Point | null} */
  #hover = null;
  /** The press that may become a stroke. @type {{ pointer: number, from: Point, stroke: boolean } | null} */
  #press = null;
  #line = svg("path", { class: "pen-line" });
  #halo = svg("path", { class: "pen-halo" });
  #start = svg("circle", { class: "pen-start", r: 7 });

  /** @param {Paper} paper */
  constructor(paper) {
    this.#paper = paper;
    const { root } = paper.view;
    root.append(svg("g", { class: "pen" }, [this.#halo, this.#line, this.#start]));
    root.addEventListener("pointerdown", (event) => this.#down(event));
    root.addEventListener("pointermove", (event) => this.#move(event));
    root.addEventListener("pointerup", (event) => this.#up(event));
    root.addEventListener("pointercancel", (event) => this.#up(event));
    // Before all others: Ctrl Z means the last corner while there is a drawing.
    window.addEventListener("keydown", (event) => this.#key(event), { capture: true });
  }

  begin() {
    this.#clear();
    this.#paper.onMode(true);
  }

  cancel() {
    this.#clear();
    this.#paper.onMode(false);
  }

  #clear() {
    this.#points = [];
    this.#undone = [];
    this.#hover = null;
    this.#press = null;
    this.#draw();
  }

  /** @param {PointerEvent} event */
  #down(event) {
    if (!this.#paper.isActive() || event.button !== 0 || this.#press) return;
    event.preventDefault();
    const { root, frame } = this.#paper.view;
    const at = pixelOf(root, event);
    root.setPointerCapture(event.pointerId);
    const [first] = this.#points;
    const last = this.#points.at(-1);
    if (this.#points.length > 2 && first && distance(toPixels(frame, first), at) < CLOSE) return this.#finish();
    // As the second press of a double click does.
    if (this.#points.length > 2 && last && distance(toPixels(frame, last), at) < STROKE) return this.#finish();
    this.#press = { pointer: event.pointerId, from: at, stroke: false };
    this.#points.push(this.#plane(at));
    this.#undone = [];
    this.#hover = at;
    this.#draw();
  }

  /** @param {PointerEvent} event */
  #move(event) {
    if (!this.#paper.isActive()) return;
    const { frame, root } = this.#paper.view;
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
    if (press.stroke) this.#finish(true);
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (!this.#paper.isActive()) return;
    const meaning = undoOrRedo(event);
    if (event.key === "Escape") this.cancel();
    else if (event.key === "Enter" && this.#points.length > 2) this.#finish();
    else if (meaning === "undo" || event.key === "Backspace" || event.key === "Delete") this.#shift(this.#points, this.#undone);
    else if (meaning === "redo") this.#shift(this.#undone, this.#points);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** @param {Point[]} from @param {Point[]} to */
  #shift(from, to) {
    const corner = from.pop();
    if (corner) to.push(corner);
    this.#draw();
  }

  /** @param {boolean} [stroke] whether it was drawn in one stroke */
  #finish(stroke = false) {
    const { view, onOutline, onStroke } = this.#paper;
    const pixel = view.frame.width / view.frame.pixels[0];
    const line = withoutHooks(closed(this.#points, SPACING * pixel), HOOK * pixel);
    const outline = cornersOf(line, SLACK * pixel);
    this.cancel();
    if (outline.length < 3) return;
    if (stroke && onStroke) onStroke(fitted(line, SLACK * pixel, REACH * pixel));
    else onOutline(outline);
  }

  #draw() {
    const { frame } = this.#paper.view;
    const pixels = this.#points.map((p) => toPixels(frame, p));
    const [first] = pixels;
    const line = this.#hover && pixels.length && !this.#press?.stroke ? [...pixels, this.#hover] : pixels;
    const closing = pixels.length > 2 && this.#hover !== null && distance(first, this.#hover) < CLOSE;
    for (const path of [this.#line, this.#halo]) set(path, { d: pathData(line, false) });
    set(this.#start, { cx: first?.[0] ?? -99, cy: first?.[1] ?? -99, class: closing ? "pen-start closing" : "pen-start" });
  }

  /** @param {Point} pixel @returns {Point} */
  #plane([x, y]) {
    const { frame } = this.#paper.view;
    return toPlane(frame, [Math.min(frame.pixels[0], Math.max(0, x)), Math.min(frame.pixels[1], Math.max(0, y))]);
  }
}

/**
 * A line without the hooks that a hand leaves where it begins and ends: short pieces beyond the place where the closed line
 * meets itself. @param {Point[]} line @param {number} longest that may be cut away @returns {Point[]}
 */
function withoutHooks(line, longest) {
  let kept = line;
  while (kept.length > 4) {
    const crossing = crossingEdges(kept);
    if (!crossing.size) return kept;
    const [first, last] = [Math.min(...crossing), Math.max(...crossing)];
    const parts = [
      { rest: kept.slice(first + 1, last + 1), cut: lengthOf(kept.slice(0, first + 2)) + lengthOf(kept.slice(last)) },
      { rest: kept.slice(0, first + 1), cut: lengthOf(kept.slice(first)) },
      { rest: kept.slice(last + 1), cut: lengthOf(kept.slice(0, last + 2)) },
    ];
    const best = parts.reduce((a, b) => (b.cut < a.cut ? b : a));
    if (best.cut > longest) return kept;
    kept = best.rest;
  }
  return kept;
}

/** A line without the points at its end that come close to its start. @param {Point[]} line @param {number} close @returns {Point[]} */
function closed(line, close) {
  let end = line.length;
  while (end > 4 && distance(line[end - 1], line[0]) < close) end--;
  return line.slice(0, end);
}

/** @param {Point[]} line */
const lengthOf = (line) => line.reduce((sum, p, k) => (k ? sum + distance(p, line[k - 1]) : 0), 0);

/** A drawn line as a closed outline, without the points that add nothing. @param {Point[]} line @param {number} slack */
function cornersOf(line, slack) {
  if (line.length < 3) return line;
  const corners = simplifyClosed(line, slack);
  while (corners.length > 3 && distance(corners[corners.length - 1], corners[0]) < 2 * slack) corners.pop();
  return corners;
}
