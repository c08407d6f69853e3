// From a picture and a fixation point to what both hemispheres receive, the lines over it, and what of it can be recovered.

import { FoveatedTexture, Region, RetinoCorticalMap, Texture } from "../../pkg/index.js";
import { offscreen } from "../common/colours.js";
import { flatten, unflatten } from "../common/frame.js";
import { readOutline } from "../editor/read-outline.js";
import { GRID, onSide, SMALL_CIRCLES } from "./field.js";
import { hemisphereFrames, NO_HALF, panelFrame } from "./layout.js";
import { cortexOf, finite, HEMISPHERES } from "./maps.js";
import { POLIMENI } from "./models.js";
import { specOf } from "./specs.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../../pkg/index.js").CorticalImage} CorticalImage */
/** @typedef {import("../../pkg/index.js").PreparedWarp} PreparedWarp */
/** @typedef {import("../../pkg/index.js").Quality} Quality */
/** @typedef {import("./maps.js").Cortex} Cortex */
/** @typedef {import("./maps.js").Drawn} Drawn */
/** @typedef {import("./maps.js").FieldLine} FieldLine */
/** @typedef {import("./maps.js").Line} Line */
/** @typedef {import("./models.js").Landmark} Landmark */
/** @typedef {import("./models.js").Outline} Outline */
/** @typedef {Uint8ClampedArray<ArrayBuffer>} Pixels */
/**
 * @typedef {object} Job
 * @property {number} version which state of the page this is for
 * @property {string[]} models one a panel
 * @property {number} shear
 * @property {Outline | null} own
 * @property {Record<string, Landmark>} landmarks
 * @property {number} fieldOfView in degrees, across the picture
 * @property {Point} fixation in the picture's plane
 * @property {number} columns pixels of a panel
 * @property {(import("../common/placement.js").Placement | null)[]} places what each panel looks at; null for all
 * @property {boolean} fine
 * @property {boolean} lines rings and rays, where they are wanted
 * @property {boolean} circles
 * @property {{ dots: number, view: Frame } | null} recover the first panel's cortex keeps so many dots a millimetre
 * @property {Uint8ClampedArray | null} live the newest frame of a camera
 */
/** Whatever a panel shows, its landmark can be dragged. @typedef {{ landmark: (Landmark & { fromFormula?: number }) | null } & ({ drawn: Drawn, pixels: Pixels[] } | { refusal: string })} Panel */
/**
 * @typedef {object} Result
 * @property {number} version
 * @property {boolean} fine
 * @property {import("./layout.js").Half} half
 * @property {Point[][]} sizes pixels of the hemispheres’ pictures, by panel
 * @property {Panel[]} panels
 * @property {{ lines: Line[], circles: Line[] }} seen lines over the picture
 * @property {{ pixels: Pixels, size: Point } | null} recovered
 * @property {number} levels of the foveated texture
 * @property {number} warpMs
 */
/** @typedef {{ what: "picture", panel: number, points: Point[] } | { what: "place", panel: number, point: Point } | { what: "outline", text: string, scale: number }} Question */
/** @template {{ version: number }} J @template {{ version: number }} R @typedef {import("../common/serve.js").Pipeline<J, R>} Pipeline */

/** Pixels along each side of a level: about what a hemisphere has on the screen. */
const SIDE = 384;

/** @implements {Pipeline<Job, Result>} */
export class CortexPipeline {
  /** @type {{ pixels: Uint8ClampedArray, texture: Texture, frame: Frame } | null} */
  #picture = null;
  /** The picture as large as its file has it, where that is larger. @type {Promise<ImageBitmap> | null} */
  #large = null;
  /** @type {{ fixation: Point, texture: FoveatedTexture } | null} */
  #foveated = null;
  /** What the panels look at, by the last job. @type {({ cortex: Cortex, images: CorticalImage[] } | null)[]} */
  #eyes = [];
  /** Warps of a camera's frames, found out once. @type {{ key: string, warps: (PreparedWarp | null)[][] } | null} */
  #prepared = null;

  /** @param {Uint8ClampedArray} pixels @param {Frame} frame @param {Blob} [file] */
  setPicture(pixels, frame, file) {
    this.#picture?.texture.free();
    this.#foveated?.texture.free();
    this.#foveated = null;
    this.#large?.then((bitmap) => bitmap.close()).catch(() => {});
    this.#picture = { pixels, texture: new Texture(pixels, ...frame.pixels), frame };
    this.#large = file ? createImageBitmap(file, { imageOrientation: "from-image" }) : null;
  }

  /** @param {Job} job */
  async run(job) {
    if (!this.#picture) throw new Error("There is no picture yet.");
    const { texture, frame } = this.#picture;
    const { version, fixation, fieldOfView, fine, recover } = job;
    const gaze = { picture: frame, fieldOfView, fixation };
    const stack = fine ? await this.#around(fixation) : null;
    const begin = performance.now();
    const looked = this.#look(job, gaze);
    const half = largest(looked.flatMap((panel) => ("drawn" in panel ? [panel.drawn.half] : [])));
    const views = job.places.map((place) => hemisphereFrames(half, job.columns, place));
    const warps = job.live ? this.#followed(job, views) : null;
    if (job.live) texture.replace(job.live);
    const panels = looked.map((panel, k) => {
      const eye = this.#eyes[k];
      if (!eye || !("drawn" in panel)) return panel;
      const pixels = eye.images.map((image, side) => {
        if (!views[k][side].pixels[0]) return new Uint8ClampedArray();
        if (warps) return /** @type {Pixels} */ (warps[k][side]?.warp(texture));
        const options = { texture: frame, view: views[k][side], quality: /** @type {Quality} */ (fine ? "best" : "trilinear") };
        return /** @type {Pixels} */ (stack ? image.warpFoveated(stack, options) : image.warp(texture, options));
      });
      return { ...panel, pixels };
    });
    const recovered = recover && this.#recover(texture, frame, recover);
    const warpMs = performance.now() - begin;
    /** @type {Result} */
    const result = { version, fine, half, sizes: views.map((both) => both.map(({ pixels }) => pixels)), panels, seen: linesOver(gaze, job), recovered, levels: stack?.levels ?? 0, warpMs };
    const pictures = panels.flatMap((panel) => ("pixels" in panel ? panel.pixels : []));
    return { result, transfer: [...pictures, ...(recovered ? [recovered.pixels] : [])].map(({ buffer }) => buffer) };
  }

  /** Makes the maps of the panels and what they see; one that cannot be made refuses, the others go on. @param {Job} job @param {{ picture: Frame, fieldOfView: number, fixation: Point }} gaze @returns {Panel[]} */
  #look({ models, ...changes }, gaze) {
    for (const image of this.#eyes.flatMap((eye) => eye?.images ?? [])) image.free();
    this.#eyes = [];
    return models.map((name) => {
      const spec = specOf(name, changes);
      const landmark = spec.kind === "outline" ? { center: spec.center, direction: spec.direction, fromFormula: Object.hasOwn(changes.landmarks, name) ? undefined : spec.fromFormula } : null;
      try {
        const cortex = cortexOf(spec, changes.fine);
        this.#eyes.push({ cortex, images: cortex.halves.map(({ map }) => map.seeing(gaze)) });
        return { landmark, drawn: cortex.drawnWith(changes.circles), pixels: [] };
      } catch (error) {
        // A trap is no refusal: the worker is of no use any more.
        if (error instanceof WebAssembly.RuntimeError) throw error;
        this.#eyes.push(null);
        return { landmark, refusal: refusalOf(error) };
      }
    });
  }

  /** The warps of a camera's frames; they hold as long as nothing but the frame changes. @param {Job} job @param {Frame[][]} views by panel */
  #followed({ models, shear, own, landmarks, fieldOfView, fixation }, views) {
    const key = JSON.stringify([models, shear, own, landmarks, fieldOfView, fixation, views]);
    if (this.#prepared?.key === key) return this.#prepared.warps;
    for (const warp of this.#prepared?.warps.flat() ?? []) warp?.free();
    this.#prepared = null;
    const { texture, frame } = /** @type {{ texture: Texture, frame: Frame }} */ (this.#picture);
    const warps = this.#eyes.map((eye, k) => (eye?.images ?? []).map((image, side) => (views[k][side].pixels[0] ? image.prepareWarp(texture, { texture: frame, view: views[k][side] }) : null)));
    this.#prepared = { key, warps };
    return warps;
  }

  /** The upper cortex at any size, and its lines, to be saved. @param {Job} job @returns {Promise<import("../common/plate.js").Plate>} */
  async plate(job) {
    if (!this.#picture) throw new Error("There is no picture yet.");
    const { frame } = this.#picture;
    const [panel] = this.#look({ ...job, fine: true, models: [job.models[0]] }, { picture: frame, fieldOfView: job.fieldOfView, fixation: job.fixation });
    const [eye] = this.#eyes;
    if (!eye || !("drawn" in panel)) throw new Error("refusal" in panel ? panel.refusal : "There is no map.");
    const stack = await this.#around(job.fixation, job.columns / 4);
    if (!stack) throw new Error("There is no picture yet.");
    const { drawn } = panel;
    const [place] = job.places;
    const views = hemisphereFrames(drawn.half, job.columns, place);
    const view = { ...(place ?? panelFrame(drawn.half, [1, 1])), pixels: /** @type {Point} */ ([job.columns, views[0].pixels[1]]) };
    const mirrored = drawn.outline.map((value, k) => (k % 2 ? value : -value));
    /** @param {Line[]} lines */
    const carried = (lines) => lines.map(({ at }) => at);
    return {
      frame: view,
      band: 128,
      draw: (band) => beside(eye.images.map((image, k) => (views[k].pixels[0] ? image.warpFoveated(stack, { texture: frame, view: views[k], quality: "best", rows: band }) : new Uint8ClampedArray())), band[1] - band[0]),
      panels: [{
        name: "cortex",
        frame: view,
        layers: [
          ...(job.circles ? [/** @type {import("../common/layers.js").Layer} */ ({ ink: "circles", lines: carried(drawn.circles) })] : []),
          ...(job.lines ? [/** @type {import("../common/layers.js").Layer} */ ({ ink: "lines", lines: carried(drawn.lines) })] : []),
          { ink: "rim", lines: [drawn.outline, mirrored], closed: true },
        ],
      }],
      free: () => {},
    };
  }

  /** What the first panel's cortex keeps of the picture. @param {Texture} texture @param {Frame} frame @param {{ dots: number, view: Frame }} recover */
  #recover(texture, frame, { dots, view }) {
    const [eye] = this.#eyes;
    if (!eye) return null;
    /** @type {Pixels | undefined} */
    let pixels;
    eye.images.forEach((image, k) => {
      const options = { texture: frame, cortex: eye.cortex.halves[k].map.frame(dots), view, ...(pixels && { out: pixels }) };
      pixels = /** @type {Pixels} */ (image.recover(texture, options));
    });
    return pixels ? { pixels, size: view.pixels } : null;
  }

  /** @param {Question} question */
  answer(question) {
    if (question.what === "outline") return parseOutline(question.text, question.scale);
    const eye = this.#eyes[question.panel];
    if (!eye) return null;
    if (question.what === "picture") return question.points.map((point) => pointOf(eye.images[eye.cortex.indexAt(point)].toPicture(flatten([point]))));
    const { map } = eye.cortex.halves[eye.cortex.indexAt(question.point)];
    const field = map.toField(flatten([question.point]));
    return Number.isFinite(field[0]) ? { eccentricity: Math.hypot(field[0], field[1]), magnification: map.magnification(field)[0] } : null;
  }

  /** The picture with full detail around the fixation point. @param {Point} fixation @param {number} [least] pixels along each side of a level */
  async #around(fixation, least = 0) {
    const picture = this.#picture;
    if (!picture) return null;
    const known = this.#foveated;
    if (known && known.fixation[0] === fixation[0] && known.fixation[1] === fixation[1]) return known.texture;
    const bitmap = await this.#large?.catch(() => null);
    const side = Math.max(SIDE, Math.round(least));
    const texture = bitmap
      ? cutFrom(bitmap, picture.frame, fixation, side)
      : new FoveatedTexture(picture.pixels, { picture: picture.frame, fixation, side });
    known?.texture.free();
    this.#foveated = { fixation, texture };
    return texture;
  }
}

/** Two pictures of a height as one. @param {Uint8ClampedArray[]} pictures @param {number} rows */
function beside([left, right], rows) {
  const both = new Uint8ClampedArray(left.length + right.length);
  const [first, second] = [left.length / rows, right.length / rows];
  for (let row = 0; row < rows; row++) {
    both.set(left.subarray(row * first, (row + 1) * first), row * (first + second));
    both.set(right.subarray(row * second, (row + 1) * second), row * (first + second) + first);
  }
  return both;
}

/** @param {import("./layout.js").Half[]} halves */
function largest(halves) {
  if (!halves.length) return NO_HALF;
  return { width: Math.max(...halves.map(({ width }) => width)), height: Math.max(...halves.map(({ height }) => height)) };
}

/** @param {Float64Array} flat @returns {Point | null} */
const pointOf = ([x, y]) => (Number.isFinite(x) ? [x, y] : null);

/** Words for what keeps a panel from being drawn. @param {unknown} error */
function refusalOf(error) {
  const { code, message } = /** @type {{ code?: string, message: string }} */ (error);
  if (code === "center-outside") return "The blind spot must lie inside the outline: drag it back, or undo. The picture stays as it was.";
  if (code === "self-intersecting") return "This outline crosses or touches itself: draw or read another one, or undo. The picture stays as it was.";
  return `${message} The picture stays as it was.`;
}

/** Any map of the field lays its lines over a picture alike: this one is a formula. @type {{ lines: Float64Array[], circles: Float64Array[], map: RetinoCorticalMap }[] | null} */
let rulers = null;

/** Lines of the field over the picture that is looked at. @param {{ picture: Frame, fieldOfView: number, fixation: Point }} gaze @param {{ lines: boolean, circles: boolean }} wanted */
function linesOver(gaze, wanted) {
  rulers ??= HEMISPHERES.map(({ hemisphere, side }) => {
    const map = RetinoCorticalMap.model({ k: POLIMENI.k, a: POLIMENI.a, hemisphere });
    /** @param {FieldLine[]} lines */
    const carried = (lines) => lines.map(({ field }) => map.toCortex(onSide(field, side)));
    return { lines: carried(GRID), circles: carried(SMALL_CIRCLES), map };
  });
  const halves = rulers.map(({ lines, circles, map }) => {
    const image = map.seeing(gaze);
    /** @param {boolean} shown @param {Float64Array[]} carried @param {FieldLine[]} named @returns {Line[]} */
    const seen = (shown, carried, named) => (shown ? carried.map((line, k) => ({ name: named[k].name, at: finite(image.toPicture(line)) })) : []);
    const found = { lines: seen(wanted.lines, lines, GRID), circles: seen(wanted.circles, circles, SMALL_CIRCLES) };
    image.free();
    return found;
  });
  return { lines: halves.flatMap(({ lines }) => lines), circles: halves.flatMap(({ circles }) => circles) };
}

/** An outline from text. Whether it can be one at all is known before it is shown. @param {string} text @param {number} scale @returns {{ outline: Point[] } | { refusal: string }} */
function parseOutline(text, scale) {
  try {
    const found = readOutline(text);
    if ("refusal" in found) return found;
    const points = found.outline.map(([x, y]) => /** @type {Point} */ ([scale * x, scale * y]));
    const outline = flatten(points);
    const middle = /** @type {Point} */ ([0, 1].map((k) => points.reduce((sum, p) => sum + p[k], 0) / points.length));
    try {
      new Region({ boundary: outline, center: middle, toward: points[0] ?? middle }).free();
    } catch (error) {
      // The middle of a bent outline may lie outside: the page looks for a better one.
      if (/** @type {{ code?: string }} */ (error).code !== "center-outside") throw error;
    }
    return { outline: points };
  } catch (error) {
    return { refusal: error instanceof Error ? error.message : String(error) };
  }
}

/** The crops of a picture that is too large to be held as pixels: the browser scales each. @param {ImageBitmap} bitmap @param {Frame} frame @param {Point} fixation @param {number} size pixels along each side of a level */
function cutFrom(bitmap, frame, fixation, size) {
  const { width, height } = bitmap;
  const picture = { ...frame, pixels: /** @type {Point} */ ([width, height]) };
  const context = offscreen(size, size);
  context.imageSmoothingQuality = "high";
  /** @type {FoveatedTexture | undefined} */
  let stack;
  for (const crop of FoveatedTexture.crops({ picture, fixation, side: size })) {
    const scale = width / frame.width;
    const side = crop.width * scale;
    const left = (crop.center[0] - frame.center[0]) * scale + width / 2 - side / 2;
    const top = height / 2 - (crop.center[1] - frame.center[1]) * scale - side / 2;
    context.clearRect(0, 0, size, size);
    context.drawImage(bitmap, left, top, side, side, 0, 0, size, size);
    const texture = Texture.fromImageData(context.getImageData(0, 0, size, size));
    if (stack) stack.add(texture, crop);
    else stack = FoveatedTexture.of(texture, crop);
    texture.free();
  }
  if (!stack) throw new Error("The picture has no crops.");
  return stack;
}
