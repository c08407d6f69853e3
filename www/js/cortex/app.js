// The page of the visual cortex: a photo that is looked at, and what both hemispheres receive of it.

import init from "../../pkg/index.js";
import { acceptFiles } from "../common/files.js";
import { toPlane } from "../common/frame.js";
import { addPicture, loadPicture } from "../common/images.js";
import { Lane } from "../common/lane.js";
import { element, mark, say, sayBroken, saveCanvas } from "../common/page.js";
import { photos } from "../common/photos.js";
import { Probe } from "../common/probe.js";
import { pixelOf } from "../common/svg.js";
import { Eye } from "./eye.js";
import { halfSize, models } from "./models.js";
import { eccentricities, plotMagnification } from "./plot.js";
import { CortexView, SeenView } from "./views.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/images.js").Picture} Picture */
/** @typedef {import("./pipeline.js").Job} Job */
/** @typedef {import("./pipeline.js").Result} Result */
/** @typedef {{ image: string, model: string, fieldOfView: number, fixation: Point, lines: boolean }} State */

/** @type {State} */
const USUAL = { image: "astronaut", model: "schira", fieldOfView: 40, fixation: [-0.13, 0.55], lines: true };
/** A hand that has not moved for this long rests, in milliseconds; a warp that takes longer than this is given up for a newer one. */
const REST = 160;
const PATIENCE = 3000;
const DRAFT = { quality: /** @type {const} */ ("trilinear"), sharpness: 0.5 };
const FINE = { quality: /** @type {const} */ ("best"), sharpness: 1 };
/** An arrow key moves the gaze by this, in plane units. */
const KEY_STEP = 0.02;

await init().catch((error) => {
  sayBroken(error.message);
  throw error;
});

let state = decode();
/** @type {Picture} */
let picture = await loadPicture(state.image).catch(() => loadPicture(USUAL.image));
/** @type {Eye | null} */
let eye = null;
let version = 0;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let resting;

const seen = new SeenView(element("seen"), element("seen-marks"));
const cortex = new CortexView(element("cortex"), element("cortex-marks"));
/** @type {Lane<Job, Result>} */
const lane = new Lane(new URL("./worker.js", import.meta.url), PATIENCE, receive);
const carrier = { carry: (/** @type {string} */ side, /** @type {Point} */ point) => (side === "target" ? (eye?.toPicture(point) ?? null) : null) };
const probe = new Probe(seen, cortex, () => carrier, () => {});

connect();
read(null);
show();

/** Says what a point of the cortex looks at. @param {PointerEvent | null} event */
function read(event) {
  const at = event && eye?.at(toPlane(cortex.frame, pixelOf(cortex.root, event)));
  element("reading").textContent = at
    ? `This place looks ${at.eccentricity.toFixed(1)}° away from the fixation point, and gives ${at.magnification.toPrecision(2)} mm to each degree.`
    : "Click or drag on the photo to look somewhere else; point at the cortex to see what a place there looks at.";
}

/** @param {Partial<State>} changes */
function change(changes) {
  state = { ...state, ...changes };
  show();
}

function show() {
  probe.hide();
  const half = halfSize(state.model);
  const [width, height] = picture.frame.pixels;
  element("panels").style.setProperty("--aspect", String(width / height));
  element("panels").style.setProperty("--other-aspect", String(CortexView.aspect(half)));
  cortex.fit(half);
  eye?.free();
  eye = new Eye(state.model, picture.frame, state.fieldOfView, state.fixation);
  const lines = state.lines ? eye.lines() : [];
  seen.show(picture, state.fixation, lines);
  cortex.showLines(lines);
  plotMagnification(element("plot"), eye.magnification(eccentricities));
  updateControls();
  mark("working");
  request(DRAFT);
  clearTimeout(resting);
  resting = setTimeout(() => {
    request(FINE);
    history.replaceState(null, "", `#${encode()}`);
  }, REST);
}

/** @param {typeof DRAFT | typeof FINE} care */
function request({ quality, sharpness }) {
  const { model, fieldOfView, fixation } = state;
  lane.setPicture(picture);
  lane.request({ version: ++version, model, fieldOfView, fixation, views: cortex.views(sharpness), quality });
}

/** @param {import("../common/serve.js").Reply<Result>} reply */
function receive(reply) {
  if ("broken" in reply) return sayBroken(reply.broken);
  if ("progress" in reply) return;
  if ("failure" in reply) return reply.failure.version === version ? say(reply.failure.message, "invalid") : undefined;
  const { result } = reply;
  cortex.paint(result.pixels, result.views);
  if (result.version !== version || result.quality !== FINE.quality) return;
  element("evidence").textContent = `Both hemispheres drawn in ${Math.max(1, Math.round(result.warpMs))} ms, four samples a pixel.`;
  say("", "ready");
}

function connect() {
  const image = /** @type {HTMLSelectElement} */ (element("choose-photo"));
  image.append(...Object.entries(photos).map(([id, { title }]) => new Option(title, id)));
  image.onchange = () => open(loadPicture(image.value));
  const model = /** @type {HTMLSelectElement} */ (element("model"));
  model.append(...Object.entries(models).map(([name, { title }]) => new Option(title, name)));
  model.onchange = () => change({ model: model.value });
  const angle = /** @type {HTMLInputElement} */ (element("field-of-view"));
  angle.oninput = () => change({ fieldOfView: Number(angle.value) });
  element("lines").onclick = () => change({ lines: !state.lines });
  element("save").onclick = () => saveCanvas(element("cortex"), "cortex.png");
  const file = /** @type {HTMLInputElement} */ (element("file"));
  element("open").onclick = () => file.click();
  acceptFiles(file, element("seen-stage"), (chosen) => open(addPicture(chosen)));
  cortex.root.addEventListener("pointermove", read);
  cortex.root.addEventListener("pointerleave", () => read(null));
  seen.root.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    seen.root.setPointerCapture(event.pointerId);
    look(pixelOf(seen.root, event));
  });
  seen.root.addEventListener("pointermove", (event) => {
    if (seen.root.hasPointerCapture(event.pointerId)) look(pixelOf(seen.root, event));
  });
  seen.root.addEventListener("keydown", (event) => {
    /** @type {Record<string, Point>} */
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const step = steps[event.key];
    if (!step) return;
    event.preventDefault();
    change({ fixation: [state.fixation[0] + KEY_STEP * step[0], state.fixation[1] + KEY_STEP * step[1]] });
  });
  window.addEventListener("hashchange", async () => {
    state = decode();
    picture = await loadPicture(state.image).catch(() => picture);
    show();
  });
  new ResizeObserver(() => show()).observe(element("panels"));
}

/** @param {Point} pixel of the photo's panel */
function look([x, y]) {
  const [width, height] = seen.frame.pixels;
  change({ fixation: toPlane(seen.frame, [Math.min(width, Math.max(0, x)), Math.min(height, Math.max(0, y))]) });
}

/** @param {Promise<Picture>} loading */
async function open(loading) {
  try {
    picture = await loading;
    change({ image: picture.id, fixation: picture.id === USUAL.image ? USUAL.fixation : [0, 0] });
  } catch (error) {
    say(error instanceof Error ? error.message : String(error), "invalid");
  }
}

function updateControls() {
  const image = /** @type {HTMLSelectElement} */ (element("choose-photo"));
  if (![...image.options].some(({ value }) => value === picture.id)) image.append(new Option(picture.title, picture.id));
  image.value = picture.id;
  /** @type {HTMLSelectElement} */ (element("model")).value = state.model;
  /** @type {HTMLInputElement} */ (element("field-of-view")).value = String(state.fieldOfView);
  element("angle").textContent = `${state.fieldOfView}°`;
  element("lines").setAttribute("aria-pressed", String(state.lines));
  element("source").textContent = `The model: ${models[state.model].source}.`;
}

function encode() {
  const { image, model, fieldOfView, fixation, lines } = state;
  const at = fixation.map((x) => x.toFixed(4)).join(",");
  return `image=${image}&model=${model}&angle=${fieldOfView}&fixation=${at}&lines=${lines ? 1 : 0}`;
}

/** @returns {State} */
function decode() {
  const fields = new URLSearchParams(location.hash.slice(1));
  const image = fields.get("image") ?? USUAL.image;
  const model = fields.get("model") ?? USUAL.model;
  const angle = Number(fields.get("angle") ?? USUAL.fieldOfView);
  const at = (fields.get("fixation") ?? "").split(",").map(Number);
  const usual = image === USUAL.image ? USUAL.fixation : /** @type {Point} */ ([0, 0]);
  return {
    image: image in photos ? image : USUAL.image,
    model: model in models ? model : USUAL.model,
    fieldOfView: angle >= 5 && angle <= 150 ? angle : USUAL.fieldOfView,
    fixation: at.length === 2 && at.every(Number.isFinite) ? [at[0], at[1]] : usual,
    lines: fields.get("lines") !== "0",
  };
}
