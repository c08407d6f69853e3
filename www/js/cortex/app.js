// The page of the visual cortex: a photo that is looked at, and what both hemispheres receive of it by two maps.

import init from "../../pkg/index.js";
import { acceptFiles } from "../common/files.js";
import { toPlane } from "../common/frame.js";
import { addPicture, loadPicture } from "../common/images.js";
import { Lane } from "../common/lane.js";
import { element, mark, say, sayBroken, saveCanvas } from "../common/page.js";
import { photos } from "../common/photos.js";
import { Probe } from "../common/probe.js";
import { pixelOf } from "../common/svg.js";
import { Camera, CAMERA } from "./camera.js";
import { Eye } from "./eye.js";
import { isOutline, MEASURED, models, ownOutline, specOf } from "./models.js";
import { CortexPanel } from "./panel.js";
import { eccentricities, hortonHoyt, plotMagnification } from "./plot.js";
import { outlineDialog } from "./read-outline.js";
import { decode, DOTS, encode, USUAL } from "./state.js";
import { CortexView, SeenView } from "./views.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/images.js").Picture} Picture */
/** @typedef {import("./panel.js").Wishes} Wishes */
/** @typedef {import("./pipeline.js").Job} Job */
/** @typedef {import("./pipeline.js").Result} Result */
/** @typedef {import("./state.js").State} State */

/** A hand that has not moved for this long rests, in milliseconds; a warp that takes longer than this is given up for a newer one. */
const REST = 160;
const PATIENCE = 6000;
/** Pixels of a draft, a screen's pixel. */
const DRAFT = 0.5;
/** An arrow key moves the gaze by this, in plane units. */
const KEY_STEP = 0.02;

await init().catch((error) => {
  sayBroken(error.message);
  throw error;
});

let state = decode(location.hash.slice(1));
/** @type {Picture} */
let picture = await loadPicture(state.image).catch(() => loadPicture(USUAL.image));
/** One a panel. @type {Eye[]} */
let eyes = [];
let version = 0;
/** What is seen at the moment, if that is the camera. @type {Camera | null} */
let camera = null;
/** The hemispheres' frames for the camera's pictures. @type {import("../common/frame.js").Frame[]} */
let liveViews = [];
/** @type {ReturnType<typeof setTimeout> | undefined} */
let resting;

const seen = new SeenView(element("seen"), element("seen-marks"));
const askForOutline = outlineDialog((outline) => change({ own: ownOutline(outline), landmarks: without("own") }));
const panels = ["Map of V1", "Map beside it"].map((label, k) => new CortexPanel(makeFigure(k), label, wishesOf(k)));
/** @type {Lane<Job, Result>} */
const lane = new Lane(new URL("./worker.js", import.meta.url), PATIENCE, receive);
const probes = panels.map(({ view }, k) => {
  const carrier = { carry: (/** @type {string} */ side, /** @type {Point} */ point) => (side === "target" ? (eyes[k]?.toPicture(point) ?? null) : null) };
  return new Probe(seen, view, () => carrier, () => {});
});

connect();
read(null, 0);
show();

/** A panel from the page's template. @param {number} k */
function makeFigure(k) {
  const template = /** @type {HTMLTemplateElement} */ (document.getElementById("cortex-panel"));
  const figure = /** @type {HTMLElement} */ (template.content.cloneNode(true).childNodes[1]);
  const names = k === 0 ? ["cortex", "cortex-marks", "model"] : ["beside", "beside-marks", "beside-model"];
  ["canvas", "svg", "select"].forEach((part, n) => figure.querySelector(part)?.setAttribute("id", names[n]));
  element("targets").append(figure);
  return figure;
}

/** @param {number} k @returns {Wishes} */
function wishesOf(k) {
  return {
    choose: (name) => {
      const chosen = /** @type {[string, string]} */ ([...state.models]);
      chosen[k] = name;
      change({ models: chosen });
    },
    shear: (shear) => change({ shear }),
    place: (name, landmark) => change({ landmarks: { ...state.landmarks, [name]: landmark } }),
    draw: (outline) => change({ own: ownOutline(outline), landmarks: without("own") }),
    read: askForOutline,
    point: (event) => read(event, k),
  };
}

/** The landmarks that were moved, but for one. @param {string} name */
const without = (name) => Object.fromEntries(Object.entries(state.landmarks).filter(([key]) => key !== name));

/** Says what a point of the cortex looks at. @param {PointerEvent | null} event @param {number} k the panel */
function read(event, k) {
  const { root, frame } = panels[k].view;
  const at = event && eyes[k]?.at(toPlane(frame, pixelOf(root, event)));
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
  for (const probe of probes) probe.hide();
  const specs = state.models.map((name) => specOf(name, state));
  if (!look(specs)) return;
  const half = { width: Math.max(...eyes.map((eye) => eye.half.width)), height: Math.max(...eyes.map((eye) => eye.half.height)) };
  const [width, height] = picture.frame.pixels;
  element("panels").style.setProperty("--aspect", String(width / height));
  element("panels").style.setProperty("--other-aspect", String(CortexView.aspect(half)));
  updateControls();
  eyes.forEach((eye, k) => {
    const [name, spec] = [state.models[k], specs[k]];
    const landmark = spec.kind === "outline" ? spec : null;
    panels[k].update(name, state, landmark);
    panels[k].refuse("");
    panels[k].explain(eye, spec.kind === "outline" && !state.landmarks[name] ? spec.fromFormula : undefined);
    panels[k].view.fit(half);
    panels[k].view.show(eye.outlines, state.lines ? eye.lines() : [], state.circles ? eye.circles() : [], landmark);
  });
  const [eye] = eyes;
  seen.show(picture, state.fixation, state.lines ? eye.lines() : [], state.circles ? eye.circles() : [], state.dots === 0);
  showMagnification();
  mark("working");
  request(false);
  clearTimeout(resting);
  resting = setTimeout(() => {
    request(true);
    history.replaceState(null, "", `#${encode(state)}`);
  }, REST);
}

/** Makes the maps anew; whether they can be made. @param {import("./models.js").Spec[]} specs */
function look(specs) {
  /** @type {Eye[]} */
  const made = [];
  for (const [k, spec] of specs.entries()) {
    try {
      made.push(new Eye(spec, picture.frame, state.fieldOfView, state.fixation));
    } catch (error) {
      for (const eye of made) eye.free();
      panels[k].update(state.models[k], state, spec.kind === "outline" ? spec : null);
      const words = error instanceof Error ? error.message : String(error);
      panels[k].refuse(words);
      mark("invalid");
      return false;
    }
  }
  for (const eye of eyes) eye.free();
  eyes = made;
  return true;
}

function showMagnification() {
  const [first, second] = state.models;
  const { k, a } = models[first].options ?? {};
  const published = k && a && !isOutline(first) && first !== "macaque" ? [{ kind: "published", name: `${k}/(E + ${a}), its curve near the fovea`, magnification: eccentricities.map((e) => k / (e + a)) }] : [];
  const beside = second === first ? [] : [{ kind: "second", name: models[second].title, magnification: eyes[1].magnification(eccentricities) }];
  plotMagnification(element("plot"), [
    { kind: "first", name: models[first].title, magnification: eyes[0].magnification(eccentricities) },
    ...beside,
    ...published,
    { kind: "measured", name: "17.3/(E + 0.75), Horton and Hoyt (1991)", magnification: hortonHoyt },
  ]);
}

/** @param {boolean} fine */
function request(fine) {
  const { models, fieldOfView, fixation, dots } = state;
  const sharpness = fine ? 1 : DRAFT;
  const [{ view }] = panels;
  if (camera) {
    liveViews = view.views(sharpness);
    camera.prepare(eyes, liveViews);
    return;
  }
  lane.setPicture(picture);
  lane.request({
    version: ++version,
    specs: models.map((name) => specOf(name, state)),
    fieldOfView,
    fixation,
    views: view.views(sharpness),
    fine,
    recover: dots ? { dots, view: seen.view(sharpness) } : null,
  });
}

/** @param {import("../common/serve.js").Reply<Result>} reply */
function receive(reply) {
  if ("broken" in reply) return sayBroken(reply.broken);
  if ("progress" in reply) return;
  if ("failure" in reply) return reply.failure.version === version ? say(reply.failure.message, "invalid") : undefined;
  const { result } = reply;
  result.panels.forEach((pixels, k) => panels[k].view.paint(pixels, result.views));
  if (result.recovered && state.dots) seen.paint(result.recovered, seen.view(result.fine ? 1 : DRAFT).pixels);
  if (result.version !== version || !result.fine) return;
  const stack = `from a foveated picture of ${result.levels} ${result.levels === 1 ? "level" : "levels"}`;
  element("evidence").textContent = `${MEASURED} Drawn in ${Math.max(1, Math.round(result.warpMs))} ms ${stack}.`;
  say("", "ready");
}

/** The camera's newest frame, everywhere. */
function drawLive() {
  if (!camera || !liveViews.length) return;
  const begin = performance.now();
  camera.draw().forEach((pixels, k) => panels[k].view.paint(pixels, liveViews));
  seen.drawPhoto(camera.picture);
  element("evidence").textContent = `${MEASURED} A frame of the camera is drawn in ${Math.max(1, Math.round(performance.now() - begin))} ms.`;
  say("", "ready");
}

async function switchCamera() {
  if (camera) return open(loadPicture(USUAL.image));
  try {
    camera = await Camera.open(drawLive);
    picture = camera.picture;
    change({ image: CAMERA, fixation: [0, 0], dots: 0 });
  } catch (error) {
    say(error instanceof Error ? error.message : String(error), "invalid");
  }
}

function connect() {
  const image = /** @type {HTMLSelectElement} */ (element("choose-photo"));
  image.append(...Object.entries(photos).map(([id, { title }]) => new Option(title, id)));
  image.onchange = () => open(loadPicture(image.value));
  const angle = /** @type {HTMLInputElement} */ (element("field-of-view"));
  angle.oninput = () => change({ fieldOfView: Number(angle.value) });
  const dots = /** @type {HTMLSelectElement} */ (element("dots"));
  dots.append(...DOTS.map((n) => new Option(`as ${n} ${n === 1 ? "dot" : "dots"} a mm of V1 recover it`, String(n))));
  dots.onchange = () => change({ dots: Number(dots.value) });
  element("lines").onclick = () => change({ lines: !state.lines });
  element("circles").onclick = () => change({ circles: !state.circles });
  element("camera").onclick = switchCamera;
  element("save").onclick = () => saveCanvas(panels[0].view.canvas, "cortex.png");
  const file = /** @type {HTMLInputElement} */ (element("file"));
  element("open").onclick = () => file.click();
  acceptFiles(file, element("seen-stage"), (chosen) => open(addPicture(chosen)));
  connectGaze();
  window.addEventListener("hashchange", async () => {
    state = decode(location.hash.slice(1));
    picture = await loadPicture(state.image).catch(() => picture);
    show();
  });
  new ResizeObserver(() => show()).observe(element("panels"));
}

function connectGaze() {
  const { root } = seen;
  root.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    root.setPointerCapture(event.pointerId);
    fixate(pixelOf(root, event));
  });
  root.addEventListener("pointermove", (event) => {
    if (root.hasPointerCapture(event.pointerId)) fixate(pixelOf(root, event));
  });
  root.addEventListener("keydown", (event) => {
    /** @type {Record<string, Point>} */
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const step = steps[event.key];
    if (!step) return;
    event.preventDefault();
    change({ fixation: [state.fixation[0] + KEY_STEP * step[0], state.fixation[1] + KEY_STEP * step[1]] });
  });
}

/** @param {Point} pixel of the photo's panel */
function fixate([x, y]) {
  const [width, height] = seen.frame.pixels;
  change({ fixation: toPlane(seen.frame, [Math.min(width, Math.max(0, x)), Math.min(height, Math.max(0, y))]) });
}

/** @param {Promise<Picture>} loading */
async function open(loading) {
  try {
    picture = await loading;
    camera?.close();
    camera = null;
    change({ image: picture.id, fixation: picture.id === USUAL.image ? USUAL.fixation : [0, 0] });
  } catch (error) {
    say(error instanceof Error ? error.message : String(error), "invalid");
  }
}

function updateControls() {
  const image = /** @type {HTMLSelectElement} */ (element("choose-photo"));
  if (!camera) [...image.options].find(({ value }) => value === CAMERA)?.remove();
  if (![...image.options].some(({ value }) => value === picture.id)) image.append(new Option(picture.title, picture.id));
  image.value = picture.id;
  /** @type {HTMLInputElement} */ (element("field-of-view")).value = String(state.fieldOfView);
  element("angle").textContent = `${state.fieldOfView}°`;
  const dots = /** @type {HTMLSelectElement} */ (element("dots"));
  dots.value = String(state.dots);
  dots.disabled = camera !== null;
  element("camera").setAttribute("aria-pressed", String(camera !== null));
  element("lines").setAttribute("aria-pressed", String(state.lines));
  element("circles").setAttribute("aria-pressed", String(state.circles));
}
