// The left panel: the photo, dimmed outside the region, with the region's outline, points and inward vector over it.

import { Layer } from "../common/canvas.js";
import { onGrid, scaleOf, toPixels } from "../common/frame.js";
import { Zoom } from "../common/zoom.js";
import { drawLayers } from "../common/layers.js";
import { kindOf, pointOn } from "./curve.js";
import { pixelEdge, pixelPath } from "./path.js";
import { edgeAfter, faults, handlesOf, holeAt, outlinesOf, pointsOf, towardPoint } from "./region.js";
import { match, pathData, set, svg } from "../common/svg.js";
import { markVector, updateVector } from "./vector.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/images.js").Picture} Picture */
/** @typedef {import("./store.js").Store} Store */
/** A picture and where it lies. @typedef {{ picture: CanvasImageSource, frame: Frame }} Placed */
/**
 * What is drawn with the photo: pictures inside the region, cut off at its outline where they are colours; how much the outside is dimmed; lines.
 * @typedef {{ inside?: Placed, heat?: Placed | null, dim: number, over?: import("../common/layers.js").Layer[] }} Layers
 */

export class PhotoView {
  root;
  /** The photo's frame in CSS pixels of the panel. @type {Frame} */
  frame = { center: [0, 0], width: 2, pixels: [1, 1] };
  /** The whole photo's frame in CSS pixels of the panel. @type {Frame} */
  home = this.frame;
  #photo = "";
  /** What the region's drawing shows. @type {unknown[]} */ #drawn = [];
  #zoom;
  #layer;
  #body = svg("path", { class: "body", "data-part": "body" });
  #halo = svg("path", { class: "halo" });
  #outline = svg("path", { class: "outline" });
  #holes = svg("g", { class: "holes" });
  #edges = svg("g", { class: "edges" });
  /** What a finger takes hold of to add a point. */
  #middles = svg("g", { class: "middles" });
  #vertices = svg("g", { class: "vertices" });
  /** Lines to control points, and the points. */
  #arms = svg("g", { class: "arms" });
  #knobs = svg("g", { class: "knobs" });
  /** The handles of edges that can be taken hold of. @type {{ edge: number, handle: import("./region.js").Handle, at: Point }[]} */
  handles = [];
  #vector = markVector(true);

  /** @param {HTMLCanvasElement} canvas @param {SVGSVGElement} root @param {() => void} onZoom called when another part is looked at */
  constructor(canvas, root, onZoom) {
    this.root = root;
    this.#zoom = new Zoom(root, () => this, onZoom, (event) => !root.classList.contains("drawing") && !(event.target instanceof Element && event.target.closest("[data-part]")));
    this.#layer = new Layer(canvas);
    root.append(this.#body, this.#halo, this.#outline, this.#holes, this.#edges, this.#middles, this.#arms, this.#vertices, this.#knobs, this.#vector);
  }

  /** @param {Picture} picture */
  fit(picture) {
    const { width, height } = this.root.getBoundingClientRect();
    this.home = onGrid(picture.frame, [Math.max(1, width), Math.max(1, height)]);
    if (picture.id !== this.#photo) this.#zoom.reset();
    this.#photo = picture.id;
    this.frame = this.#zoom.within(this.home);
  }

  /** @param {Picture} picture @param {Store} store @param {Layers} layers */
  draw(picture, store, layers) {
    this.#drawPhoto(picture, store, layers);
    this.#drawRegion(store);
  }

  /** @param {Picture} picture @param {Store} store @param {Layers} layers */
  #drawPhoto({ canvas, frame: whole }, { doc, mode, dragging }, { inside, heat, dim, over = [] }) {
    const drawing = this.#layer.begin(this.frame);
    const { context, frame } = drawing;
    const [width, height] = frame.pixels;
    context.imageSmoothingQuality = "high";
    drawWithin(drawing, canvas, whole);
    if (mode === "draw") return;
    const data = regionData(doc.region, frame);
    if (inside) drawWithin(drawing, inside.picture, inside.frame);
    const outside = new Path2D(data);
    outside.rect(0, 0, width, height);
    context.fillStyle = `rgb(0 0 0 / ${dim})`;
    context.fill(outside, "evenodd");
    if (heat) {
      context.save();
      context.imageSmoothingQuality = "low";
      // Clean edges take time that a moving hand has not.
      if (!dragging) context.clip(new Path2D(data), "evenodd");
      drawWithin(drawing, heat.picture, heat.frame);
      context.restore();
    }
    drawLayers(drawing, over, dragging);
  }

  /** @param {Store} store */
  #drawRegion({ doc: { region }, selected, mode }) {
    const state = [region, selected, mode, this.frame];
    if (state.every((part, k) => part === this.#drawn[k])) return;
    this.#drawn = state;
    const points = pointsOf(region);
    const pixels = points.map((p) => toPixels(this.frame, p));
    const wrong = faults(region);
    this.root.classList.toggle("drawing", mode !== "edit");
    this.root.classList.toggle("in-region", mode === "hole");
    this.root.classList.toggle("dense", points.length > 48);
    const data = regionData(region, this.frame);
    for (const path of [this.#body, this.#halo, this.#outline]) set(path, { d: data });
    match(this.#holes, region.holes ?? [], (hole) => svg("path", { class: "hole", "data-part": "hole", "data-index": hole }), (element, hole) => set(element, { d: pixelPath(hole, this.frame) }));
    match(this.#edges, pixels, (edge) => svg("path", { "data-part": "edge", "data-index": edge }), (element, _, k) => {
      set(element, { d: pixelEdge(edgeAfter(region, k), this.frame), class: `edge${wrong.edges.has(k) ? " wrong" : ""}${k === selected ? " next" : ""}` });
    });
    match(this.#middles, pixels, newMiddle, (element, [x, y], k) => {
      const edge = edgeAfter(region, k);
      const [u, v] = toPixels(this.frame, edge[1]);
      // An arc's own handle is in its middle.
      const [mx, my] = toPixels(this.frame, pointOn(...edge, edge[2]?.kind === "arc" ? 0.25 : 0.5));
      set(element, { transform: `translate(${mx} ${my})`, visibility: Math.hypot(u - x, v - y) > LONG_EDGE ? "visible" : "hidden" });
    });
    this.#drawHandles(region, selected);
    match(this.#vertices, pixels, newVertex, (element, [x, y], k) => {
      const label = nameOf(region, k, pixels.length);
      const current = k === (selected ?? 0);
      set(element, { transform: `translate(${x} ${y})`, tabindex: current ? 0 : -1, "aria-label": label });
      element.classList.toggle("selected", k === selected);
    });
    updateVector(this.#vector, toPixels(this.frame, towardPoint(region)), toPixels(this.frame, region.center), wrong.center);
  }

  /** The handles of curved edges: of all of a few, or of those beside the selected point. @param {import("./region.js").Region} region @param {number | null} selected */
  #drawHandles(region, selected) {
    const points = pointsOf(region);
    const curved = points.flatMap((_, edge) => (edgeAfter(region, edge)[2] ? [edge] : []));
    const chosen = selected === null ? null : points[selected];
    const beside = (/** @type {number} */ edge) => edge === selected || edgeAfter(region, edge)[1] === chosen;
    this.handles = curved.flatMap((edge) => (curved.length <= FEW || beside(edge) ? handlesOf(region, edge).map((one) => ({ edge, ...one })) : []));
    const arms = this.handles.filter(({ handle }) => handle !== "bow");
    match(this.#arms, arms, () => svg("path"), (element, { edge, handle, at }) => {
      const [a, b] = edgeAfter(region, edge);
      set(element, { d: pathData([handle === "first" ? a : b, at].map((p) => toPixels(this.frame, p)), false) });
    });
    match(this.#knobs, this.handles, newKnob, (element, { edge, handle, at }) => {
      const [x, y] = toPixels(this.frame, at);
      set(element, { transform: `translate(${x} ${y})`, class: `knob ${handle}`, "data-index": edge, "data-handle": handle, "aria-label": `${HANDLES[handle]} ${edge + 1}` });
    });
  }

  /** The element of a handle. @param {number} edge @param {string} handle */
  handle(edge, handle) {
    return [...this.#knobs.children].find((knob) => knob instanceof SVGElement && knob.dataset.index === String(edge) && knob.dataset.handle === handle) ?? null;
  }

  /** Gives the keyboard to a vertex. @param {number} index */
  focusVertex(index) {
    /** @type {SVGElement | undefined} */ (this.#vertices.children[index])?.focus();
  }
}

/** All outlines of a region, to be drawn. @param {import("./region.js").Region} region @param {Frame} frame */
const regionData = (region, frame) => outlinesOf(region).map((outline) => pixelPath(outline, frame)).join("");

/** What a point is called. @param {import("./region.js").Region} region @param {number} index @param {number} count of all points */
function nameOf(region, index, count) {
  const hole = holeAt(region, index);
  const bent = outlinesOf(region)[hole === null ? 0 : hole + 1].curves ? `; ${EDGES[kindOf(edgeAfter(region, index)[2])]} to the next` : "";
  return `Point ${index + 1} of ${count}${hole === null ? "" : `, on hole ${hole + 1}`}${bent}`;
}

/** A picture where its frame lies. @param {{ context: CanvasRenderingContext2D, frame: Frame }} drawing @param {CanvasImageSource} picture @param {Frame} whole */
export function drawWithin({ context, frame }, picture, { center, width, pixels }) {
  const height = (width * pixels[1]) / pixels[0];
  const [left, top] = toPixels(frame, [center[0] - width / 2, center[1] + height / 2]);
  context.drawImage(picture, left, top, width * scaleOf(frame), height * scaleOf(frame));
}

/** Of so many curved edges all handles are shown. */
const FEW = 8;
/** Names for those who do not see them. */
const HANDLES = { first: "First control point of edge", second: "Second control point of edge", bow: "Middle of the arc that is edge" };
const EDGES = { line: "a line", arc: "an arc", curve: "a curve" };

/** Shorter edges show no handle in their middle, in pixels. */
const LONG_EDGE = 52;

/** @param {number} edge */
function newMiddle(edge) {
  return svg("g", { class: "middle", "data-part": "middle", "data-index": edge, "aria-hidden": "true" }, [svg("circle", { class: "reach" }), svg("path", { d: "M-3.5 0h7M0 -3.5v7" })]);
}

function newKnob() {
  return svg("g", { "data-part": "handle", role: "button", tabindex: 0 }, [svg("circle", { class: "reach" }), svg("rect", { class: "dot", x: -4, y: -4, width: 8, height: 8 })]);
}

/** @param {number} index */
function newVertex(index) {
  return svg("g", { class: "vertex", "data-part": "vertex", "data-index": index, role: "button" }, [
    svg("circle", { class: "reach" }),
    svg("circle", { class: "dot" }),
  ]);
}
