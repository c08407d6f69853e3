// From a formula to two pictures: the texture's own plane, and what the formula makes of it. Slow ones come coarse to fine.

import { FormulaMap, presets, Texture } from "../../pkg/formula/index.js";
import { SPACE } from "../common/colours.js";
import { flatten, onGrid, scaledTo, unflatten } from "../common/frame.js";
import { compile } from "./compile.js";
import { turned } from "./cut.js";
import { angleAt, cutLines } from "./cut-lines.js";
import { dilatationOver, drawEllipses, slopes } from "./dilatation.js";
import { gridLines, spokesOf, unbroken } from "./grid.js";
import { preimage } from "./inverse.js";
import { drawLevels, portray, valuesOver } from "./portrait.js";
import { StillPlanes } from "./still.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../../pkg/formula/index.js").Direction} Direction */
/** @typedef {import("../../pkg/formula/index.js").Quality} Quality */
/** @typedef {import("../../pkg/formula/index.js").Wrap} Wrap */
/** @typedef {import("./portrait.js").Part} Part */
/** @typedef {"picture" | import("./portrait.js").Scheme} Colours what the planes show */
/** @typedef {"none" | "cartesian" | "polar" | Part | "stretch" | "argument" | "ellipses"} Lines what is drawn over that */
/** @typedef {{ formula: string, params: Record<string, Point> }} Typed */
/**
 * @typedef {Typed & {
 *   version: number, fine: boolean, direction: Direction, wrap: Wrap, colours: Colours, lines: Lines, density: number,
 *   texture: Frame, source: Frame, target: Frame
 * }} Job
 * `version`: which state of the page this is for; `texture`: where the picture lies; `source`, `target`: the views of the
 * texture's plane and of the warped one
 */
/** @typedef {Uint8ClampedArray<ArrayBuffer>} Pixels */
/** @typedef {{ version: number, source: Frame, target: Frame, sourcePixels: Pixels, targetPixels: Pixels, warpMs: number, dilatation: import("./dilatation.js").Dilatation | null, space: PredefinedColorSpace }} Result `dilatation` of what is not analytic, over the plane on which it is evaluated */
/** @typedef {import("../common/placement.js").Placement} Placement */
/**
 * @typedef {{ what: "presets" } | { what: "compile", text: string, params: Record<string, Point> } | ({ what: "points" } & Typed & { points: Point[] })
 *   | ({ what: "back" } & Typed & { points: Point[], within: Placement }) | ({ what: "slopes" } & Typed & { at: Point })
 *   | ({ what: "cuts" } & Typed & { cut: import("./cut.js").Cut, within: Placement })
 *   | ({ what: "angle" } & Typed & { cut: import("./cut.js").Cut, which: number, at: Point })} Question
 */
/** @typedef {import("../common/serve.js").Talk<Result>} Talk */
/** @template {{ version: number }} J @template {{ version: number }} R @typedef {import("../common/serve.js").Pipeline<J, R>} Pipeline */

/** Heat and argument leave this much of the picture to be seen. */
const OPACITY = 0.55;
/** Lines over a photo are light, over colours that are light themselves dark. @type {Record<"photo" | "colours", import("./portrait.js").Ink>} */
const INKS = { photo: [255, 255, 255, 200], colours: [16, 18, 26, 190] };
/** Lines of one kind alone are so much thicker than those of a grid. */
const LINE = 2;
/** Pixels a side of the first picture, which tells how slow the formula is. */
const FIRST = 24;
/** A draft may take about this long, a fine picture without coarser ones before it; in milliseconds. */
const DRAFT_TIME = 150;
const FINE_TIME = 400;
/** Rows are drawn for about this long before the page is listened to, in milliseconds. */
const BAND_TIME = 60;
/** Rows of a saved picture that are pushed forward at once: each band costs as much as all. */
const WHOLE = 2048;
/** Each picture on the way has so many times the pixels a side of the last one. */
const FINER = 2;

/** @implements {Pipeline<Job, Result>} */
export class FormulaPipeline {
  /** @type {{ pixels: Uint8ClampedArray, size: Point } | null} */
  #picture = null;
  #still = new StillPlanes();
  /** The picture, made ready for one way of going on beyond its edges. @type {{ wrap: Wrap, texture: Texture } | null} */
  #ready = null;
  /** Cuts that were found last: most of what a hand moves leaves them where they are. @type {Map<string, import("./cut-lines.js").Piece[]>} */
  #traced = new Map();
  /** The map that the page asked about last. @type {{ key: string, map: FormulaMap } | null} */
  #asked = null;

  /** @param {Uint8ClampedArray} pixels @param {Frame} frame */
  setPicture(pixels, frame) {
    this.#picture = { pixels, size: frame.pixels };
    this.#ready?.texture.free();
    this.#ready = null;
    this.#still.forget();
  }

  /** @param {Job} job @param {Talk} talk */
  async run(job, talk) {
    const texture = this.#texture(job.wrap);
    const map = new FormulaMap(job.formula, { params: job.params });
    const identity = new FormulaMap("z");
    const begin = performance.now();
    const dilatation = dilatationOver(map, job.direction === "pull-back" ? job.target : job.source);
    /** @param {number} side @param {Quality} quality @param {(share: number) => void} [onShare] */
    const draw = (side, quality, onShare) => drawBoth({ map, identity, texture, still: this.#still, job, begin, dilatation }, side, quality, talk, onShare);
    try {
      const full = job.target.pixels[0];
      const first = await draw(Math.min(FIRST, full), "bilinear");
      const pixelMs = first.result.warpMs / Math.min(FIRST, full) ** 2;
      const time = (/** @type {number} */ side) => pixelMs * side * side;
      if (!job.fine) {
        if (time(full) <= DRAFT_TIME) return await draw(full, "bilinear");
        talk.show(first);
        return await draw(Math.max(FIRST, Math.floor(Math.sqrt(DRAFT_TIME / pixelMs))), "bilinear");
      }
      const sides = [full];
      while (time(sides[0]) > FINE_TIME && sides[0] > FINER * FIRST) sides.unshift(Math.ceil(sides[0] / FINER));
      const all = sides.reduce((sum, side) => sum + side * side, 0);
      let done = 0;
      for (const side of sides) {
        const share = (/** @type {number} */ part) => talk.progress("picture", (done + part * side * side) / all);
        const drawn = await draw(side, side === full ? "best" : "bilinear", share);
        if (side === full) return drawn;
        talk.show(drawn);
        done += side * side;
      }
      return first;
    } finally {
      map.free();
      identity.free();
    }
  }

  /** A picture of any size, to be saved; for a drawing, the grid's lines carried by the formula. @param {Job & { drawing: boolean }} job @returns {Promise<import("../common/plate.js").Plate>} */
  async plate(job) {
    const texture = this.#texture(job.wrap);
    const map = new FormulaMap(job.formula, { params: job.params });
    const { target: view, direction, lines, colours, texture: frame } = job;
    const pulling = direction === "pull-back";
    const straight = job.drawing ? gridLines(pulling ? view : job.source, lines, job) : [];
    const bent = straight.flatMap((line) => unbroken(map.eval(line)));
    const panels = [
      { name: "picture", frame: scaledTo(job.source, view.pixels[0]), layers: inked(pulling ? bent : straight) },
      { name: "warped", frame: view, layers: inked(pulling ? straight : bent) },
    ];
    return {
      frame: view,
      band: pulling || colours !== "picture" ? 128 : Math.min(view.pixels[1], WHOLE),
      draw: (rows) => (colours === "picture" ? map.warp(texture, { texture: frame, view, direction, quality: "best", rows }) : coloured(pulling ? map : null, job, { view, rows })),
      space: spaceOf(colours),
      tint: lines === "none" ? null : (rows) => overlaid(map, job, view, rows),
      panels: job.drawing ? panels : [],
      free: () => map.free(),
    };
  }

  /** @param {Question} question */
  answer(question) {
    if (question.what === "presets") return presets();
    if (question.what === "compile") return compile(question.text, question.params);
    if (question.what === "slopes") return slopes(this.#map(question), flatten([question.at]));
    if (question.what === "cuts") return this.#cuts(question);
    if (question.what === "angle") return angleAt(this.#map({ ...question, formula: cutIn(question)[question.which] ?? "0" }), question.at);
    if (question.what === "back") return preimage(this.#map(question), question.points, question.within);
    return unflatten(this.#map(question).eval(flatten(question.points))).map((p) => (p.every(Number.isFinite) ? p : null));
  }

  /** Where the cuts lie. @param {Question & { what: "cuts" }} question @returns {import("./cut-handle.js").Line[]} */
  #cuts({ cut, within, params, ...rest }) {
    /** @type {Map<string, import("./cut-lines.js").Piece[]>} */
    const traced = new Map();
    const lines = cutIn({ cut, params, ...rest }).map((formula, which) => {
      const named = FormulaMap.parameters(formula).map((name) => params[name]);
      const key = JSON.stringify([formula, named, cut.angle, within]);
      const pieces = this.#traced.get(key) ?? cutLines(this.#map({ formula, params }), cut.angle, within);
      traced.set(key, pieces);
      return { which, pieces };
    });
    this.#traced = traced;
    return lines;
  }

  /** A formula's map; the last one is kept. @param {Typed} typed */
  #map({ formula, params }) {
    const key = JSON.stringify([formula, params]);
    if (this.#asked?.key !== key) {
      this.#asked?.map.free();
      this.#asked = null;
      this.#asked = { key, map: new FormulaMap(formula, { params }) };
    }
    return this.#asked.map;
  }

  /** @param {Wrap} wrap */
  #texture(wrap) {
    if (this.#ready?.wrap === wrap) return this.#ready.texture;
    if (!this.#picture) throw new Error("There is no picture yet.");
    const { pixels, size } = this.#picture;
    this.#ready?.texture.free();
    this.#ready = { wrap, texture: new Texture(pixels, ...size, { wrap }) };
    return this.#ready.texture;
  }
}

/** What in a formula has cuts. @param {Typed & { cut: import("./cut.js").Cut }} typed */
const cutIn = ({ formula, params, cut }) => turned(formula, Object.keys(params), cut)?.arguments ?? [];

/**
 * Both pictures, with so many pixels a side.
 * @param {{ map: FormulaMap, identity: FormulaMap, texture: Texture, still: StillPlanes, job: Job, begin: number, dilatation: Result["dilatation"] }} what @param {number} side
 * @param {Quality} quality @param {Talk} talk @param {(share: number) => void} [onShare] of the rows
 */
async function drawBoth({ map, identity, texture, still, job, begin, dilatation }, side, quality, talk, onShare = () => {}) {
  const { texture: frame, direction, colours, lines, density, wrap, fine, version } = job;
  const [source, target] = [job.source, job.target].map((view) => onGrid(view, [side, side]));
  const started = performance.now();
  const photo = colours === "picture";
  // The map's lines lie in the plane that it is evaluated on; the straight ones are what they go to.
  const pulling = direction === "pull-back";
  const key = JSON.stringify([source, frame, wrap, quality, pulling, colours, lines, density, fine]);
  const known = still.copy(key);
  const sourcePixels = known ?? new Uint8ClampedArray(4 * side * side);
  const targetPixels = new Uint8ClampedArray(4 * side * side);
  /** In the plane that the map is evaluated on: its values as colours, and its lines. @param {Place} place */
  const drawValues = (place) => {
    coloured(map, job, place);
    drawLines(map, job, place);
  };
  /** In the plane of its values: their own colours, and straight lines. @param {Place} place */
  const drawPlain = (place) => {
    coloured(null, job, place);
    if (isGrid(lines)) drawLines(identity, job, place);
  };
  /** What of the texture's plane does not depend on the formula. @param {Place} place */
  const drawStill = (place) => {
    if (photo) identity.warp(texture, { texture: frame, ...place, quality });
    if (pulling) drawPlain(place);
  };
  /** The plane of the image. @param {Place} place */
  const drawImage = (place) => {
    if (photo) map.warp(texture, { texture: frame, ...place, direction, quality });
    if (pulling) drawValues(place);
    else drawPlain(place);
  };
  if (!known) {
    await inBands(side, true, talk, () => {}, (rows) => drawStill({ view: source, out: rowsOf(sourcePixels, rows, side), rows }));
    still.keep(key, sourcePixels);
  }
  await inBands(side, pulling || !photo, talk, onShare, (rows) => {
    if (!pulling) drawValues({ view: source, out: rowsOf(sourcePixels, rows, side), rows });
    drawImage({ view: target, out: rowsOf(targetPixels, rows, side), rows });
  });
  const warpMs = performance.now() - (side === job.target.pixels[0] ? begin : started);
  /** @type {Result} */
  const result = { version, source, target, sourcePixels, targetPixels, warpMs, dilatation, space: spaceOf(colours) };
  return { result, transfer: [sourcePixels.buffer, targetPixels.buffer] };
}

/** @param {Pixels} pixels of a square picture @param {[number, number]} rows @param {number} side */
const rowsOf = (pixels, [first, end], side) => pixels.subarray(4 * side * first, 4 * side * end);

/**
 * Draws rows band by band, each for about as long as the page may wait; at once where a band costs as much as the whole.
 * @param {number} count of rows @param {boolean} parted @param {Talk} talk @param {(share: number) => void} onShare
 * @param {(rows: [number, number]) => void} draw
 */
async function inBands(count, parted, talk, onShare, draw) {
  let height = parted ? Math.max(8, Math.ceil(count / 16)) : count;
  for (let row = 0; row < count; ) {
    const begin = performance.now();
    const end = Math.min(count, row + height);
    draw([row, end]);
    const took = performance.now() - begin;
    height = Math.max(1, Math.min(count, Math.round(height * Math.min(4, Math.max(0.25, BAND_TIME / (took || 1))))));
    row = end;
    onShare(row / count);
    if (row < count && took > BAND_TIME / 4) await talk.pause();
  }
}

/** The lines over the warped plane, alone. @param {FormulaMap} map @param {Job} job @param {Frame} view @param {[number, number]} rows */
function overlaid(map, job, view, rows) {
  const out = new Uint8ClampedArray(4 * view.pixels[0] * (rows[1] - rows[0]));
  const straight = job.direction !== "pull-back";
  if (straight && !isGrid(job.lines)) return out;
  const identity = straight ? new FormulaMap("z") : null;
  drawLines(identity ?? map, { ...job, fine: true }, { view, out, rows }, view.pixels[0] / 600);
  identity?.free();
  return out;
}

/** Schemes of colours are sRGB's. @param {Colours} colours @returns {PredefinedColorSpace} */
const spaceOf = (colours) => (colours === "picture" ? SPACE : "srgb");

/** @param {Float64Array[]} lines @returns {import("../common/layers.js").Layer[]} */
const inked = (lines) => [{ ink: "lines", lines }];

/** Lines that the other plane has too, straight ones. @param {Lines} lines */
const isGrid = (lines) => lines !== "stretch" && lines !== "argument" && lines !== "ellipses";

/** @typedef {{ view: Frame, out: Uint8ClampedArray, rows: [number, number] }} Place rows of a view */

/** The values of a map as colours; null for the plane of the values itself. @param {FormulaMap | null} map @param {Job} job @param {{ view: Frame, rows: [number, number], out?: Uint8ClampedArray }} place */
function coloured(map, { colours, density }, { view, rows, out = new Uint8ClampedArray(4 * view.pixels[0] * (rows[1] - rows[0])) }) {
  if (colours !== "picture") portray(valuesOver(map, view, rows), colours, spokesOf(density), out);
  return out;
}

/** @param {FormulaMap} map @param {Job} job @param {Place} place @param {number} [bold] so many times as thick */
function drawLines(map, { lines, colours, density, texture, fine }, place, bold = 1) {
  if (lines === "none") return;
  const [spacing, spokes, thick] = [texture.width / density, spokesOf(density), (fine ? 2 : 1) * Math.max(1, bold)];
  const ink = INKS[colours === "picture" ? "photo" : "colours"];
  if (lines === "ellipses") drawEllipses(map, place, { spacing, width: (LINE / 2) * thick, ink });
  else if (lines === "cartesian" || lines === "polar" || lines === "stretch" || lines === "argument") map.overlay({ ...place, kind: lines, opacity: OPACITY, width: thick, spacing, spokes, color: ink });
  else drawLevels(valuesOver(map, place.view, place.rows), lines, { spacing, spokes, width: (LINE / 2) * thick, ink }, place.out);
}
