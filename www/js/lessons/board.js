// A square piece of a plane to draw in: a picture beneath, curves, words, and points that a reader can move.

import { match, pathData, pixelOf, set, svg } from "../common/svg.js";
import { toPixels, toPlane } from "../common/frame.js";
import { paint } from "../common/canvas.js";
import { ARROWS } from "../common/keys.js";

/** @typedef {import("../common/frame.js").Point} Point */
/**
 * @typedef {object} Handle a point that can be moved
 * @property {string} label what it is, for those who do not see it
 * @property {string} [kind] its class: how it looks
 * @property {(to: Point, from: Point) => Point | null} [limit] where it may go; null: not there
 * @property {() => void} onMove
 */

/** Pixels of the drawing, which scales with its box. */
const SIDE = 400;
/** How far a key moves a point, in shares of the board's width; with Shift, five times that. */
const STEP = 0.01;

export class Board {
  /** In plane units across. @type {import("../common/frame.js").Frame} */ #frame;
  #canvas = document.createElement("canvas");
  #curves = svg("g", { "aria-hidden": "true" });
  #words = svg("g", { class: "words", "aria-hidden": "true" });
  #handles = svg("g", {});
  #svg;
  /** @type {Map<string, SVGPathElement>} */ #named = new Map();

  /** @param {string} label @param {Point} center @param {number} width in plane units */
  constructor(label, center, width) {
    this.#frame = { center, width, pixels: [SIDE, SIDE] };
    this.#svg = svg("svg", { viewBox: `0 0 ${SIDE} ${SIDE}`, role: "group", "aria-label": label }, [this.#curves, this.#words, this.#handles]);
    this.element = Object.assign(document.createElement("div"), { className: "board" });
    this.#canvas.setAttribute("aria-hidden", "true");
    this.element.append(this.#canvas, this.#svg);
    // Points and words keep their size on the screen.
    new ResizeObserver(() => this.element.style.setProperty("--unit", String(this.#unit))).observe(this.element);
  }

  /** Pixels of the drawing in one of the screen's. */
  get #unit() {
    return SIDE / (this.element.getBoundingClientRect().width || SIDE);
  }

  /** The part of the plane that is shown, `side` pixels a side. @param {number} side */
  view(side) {
    return { ...this.#frame, pixels: /** @type {Point} */ ([side, side]) };
  }

  get width() {
    return this.#frame.width;
  }

  /** Pixels a side that the screen has for it. */
  get sharpness() {
    const wide = this.element.getBoundingClientRect().width || SIDE;
    return Math.round(Math.min(900, wide * (window.devicePixelRatio || 1)));
  }

  /**
   * Draws lines under a name, which is their class too; lines break where a point is no number.
   * @param {string} name @param {Point[][]} lines @param {boolean} [closed]
   */
  curves(name, lines, closed = false) {
    let path = this.#named.get(name);
    if (!path) {
      path = svg("path", { class: name });
      this.#named.set(name, path);
      this.#curves.append(path);
    }
    const data = lines.flatMap((line) => pieces(line).map((piece) => pathData(piece.map((p) => toPixels(this.#frame, p)), closed && piece.length === line.length)));
    set(path, { d: data.join("") });
  }

  /** Round dots under a name. @param {string} name @param {Point[]} at @param {number} [radius] in pixels of 400 */
  dots(name, at, radius = 4) {
    const r = (radius * this.#frame.width) / SIDE;
    this.curves(name, at.filter(([x]) => Number.isFinite(x)).map((p) => around(p, r, 12)), true);
  }

  /** Words at points. @param {[text: string, at: Point][]} texts */
  words(texts) {
    match(this.#words, texts, () => svg("text"), (text, [words, at]) => {
      const [x, y] = toPixels(this.#frame, at);
      set(text, { x: x.toFixed(1), y: y.toFixed(1) });
      text.textContent = words;
    });
  }

  /** @param {Uint8ClampedArray<ArrayBuffer>} pixels @param {Point} size */
  paint(pixels, size) {
    paint(this.#canvas, pixels, size);
  }

  /** Shows a picture that lies in the plane so. @param {import("../common/images.js").Picture} picture */
  show({ canvas, frame }) {
    const side = 2 * SIDE;
    Object.assign(this.#canvas, { width: side, height: side });
    const [x0, y0] = toPixels(frame, toPlane(this.view(side), [0, 0]));
    const [x1, y1] = toPixels(frame, toPlane(this.view(side), [side, side]));
    const context = this.#canvas.getContext("2d");
    if (context) context.imageSmoothingQuality = "high";
    context?.drawImage(canvas, x0, y0, x1 - x0, y1 - y0, 0, 0, side, side);
  }

  /** A point that can be moved by pointer and keys. @param {Point} at @param {Handle} handle */
  handle(at, { label, kind = "", limit = (to) => to, onMove }) {
    const group = svg("g", { class: `grip ${kind}`, role: "button", tabindex: 0 }, [svg("circle", { class: "reach" }), svg("circle", { class: "dot" })]);
    const place = () => {
      const [x, y] = toPixels(this.#frame, point.at);
      set(group, { transform: `translate(${x.toFixed(2)} ${y.toFixed(2)})`, "aria-label": `${label}, at ${point.at.map((n) => n.toFixed(2)).join(", ")}: arrow keys move it` });
    };
    const point = {
      at,
      /** Moves it without asking. @param {Point} to */
      put(to) {
        point.at = to;
        place();
      },
    };
    /** @param {Point} to */
    const move = (to) => {
      const half = this.#frame.width / 2;
      const inside = /** @type {Point} */ (to.map((n, k) => Math.min(Math.max(n, this.#frame.center[k] - half), this.#frame.center[k] + half)));
      const allowed = limit(inside, point.at);
      if (!allowed) return;
      point.put(allowed);
      onMove();
    };
    this.#byPointer(group, move);
    byKeys(group, () => point.at, (to) => move(to), this.#frame.width * STEP);
    this.#handles.append(group);
    place();
    return point;
  }

  /** @param {SVGGElement} group @param {(to: Point) => void} move */
  #byPointer(group, move) {
    group.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      group.setPointerCapture(event.pointerId);
      group.focus();
      event.preventDefault();
    });
    group.addEventListener("pointermove", (event) => {
      if (!group.hasPointerCapture(event.pointerId)) return;
      const [x, y] = pixelOf(this.#svg, event);
      move(toPlane(this.#frame, [x * this.#unit, y * this.#unit]));
    });
  }
}

/** @typedef {ReturnType<Board["handle"]>} Movable */

/** @param {SVGGElement} group @param {() => Point} at @param {(to: Point) => void} move @param {number} step */
function byKeys(group, at, move, step) {
  group.addEventListener("keydown", (event) => {
    const arrow = ARROWS.get(event.key);
    if (!arrow || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const far = event.shiftKey ? 5 * step : step;
    const [x, y] = at();
    move([x + far * arrow[0], y + far * arrow[1]]);
  });
}

/** The runs of a line that are numbers. @param {Point[]} line */
function pieces(line) {
  /** @type {Point[][]} */
  const runs = [[]];
  for (const p of line) {
    if (Number.isFinite(p[0]) && Number.isFinite(p[1])) runs[runs.length - 1].push(p);
    else if (runs[runs.length - 1].length) runs.push([]);
  }
  return runs.filter((run) => run.length > 1);
}

/** A circle as a closed line. @param {Point} center @param {number} radius @param {number} [count] @returns {Point[]} */
export function around([x, y], radius, count = 96) {
  return Array.from({ length: count }, (_, k) => {
    const turn = (2 * Math.PI * k) / count;
    return [x + radius * Math.cos(turn), y + radius * Math.sin(turn)];
  });
}

/** A straight line in steps. @param {Point} from @param {Point} to @param {number} [count] @returns {Point[]} */
export function along([x0, y0], [x1, y1], count = 48) {
  return Array.from({ length: count + 1 }, (_, k) => [x0 + ((x1 - x0) * k) / count, y0 + ((y1 - y0) * k) / count]);
}
