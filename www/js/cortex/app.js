// The page of the visual cortex: a photo that is looked at, and what both hemispheres receive of it by two maps.

import { wrongWords } from "../common/address.js";
import { offerAlone } from "../common/alone.js";
import { goAlong } from "../common/along.js";
import { acceptFiles } from "../common/files.js";
import { toPlane } from "../common/frame.js";
import { History } from "../common/history.js";
import { addPicture, loadPicture } from "../common/images.js";
import { ARROWS, onEscape, onUndoKeys } from "../common/keys.js";
import { attempt, element, PhotoOpener, pictureFor, press, remark, statusOfPage, wantedPicture, watchErrors } from "../common/page.js";
import { PhotoChoice } from "../common/photo-choice.js";
import { Probe } from "../common/probe.js";
import { offerToSave } from "../common/save-menu.js";
import { Scheduler } from "../common/scheduler.js";
import { pixelOf } from "../common/svg.js";
import { Camera } from "./camera.js";
import { aspectOf, NO_HALF } from "./layout.js";
import { isOutline, MEASURED, models, ownOutline } from "./models.js";
import { Pace } from "./pace.js";
import { CortexPanel } from "./panel.js";
import { hortonHoyt, plotMagnification } from "./plot.js";
import { eccentricities } from "./plot-range.js";
import { outlineDialog } from "./read-outline.js";
import { decode, DOTS, encode, USUAL } from "./state.js";
import { SeenView } from "./views.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../common/images.js").Picture} Picture */
/** @typedef {import("./panel.js").Wishes} Wishes */
/** @typedef {import("./pipeline.js").Job} Job */
/** @typedef {import("./pipeline.js").Result} Result */
/** @typedef {import("./state.js").State} State */

/** An arrow key moves the gaze by this, in plane units. */
const KEY_STEP = 0.02;
/** A pause this long ends a series of arrow keys, in milliseconds. */
const KEY_PAUSE = 400;

watchErrors();
const first = decode(location.hash, USUAL);
remark(wrongWords(first.wrong));
/** @type {History<State>} */
const store = new History(first.state);
/** @type {Picture} */
let picture = await pictureFor(store.value.image);
const photos = new PhotoOpener();
/** What is seen at the moment, if that is the camera. @type {Camera | null} */
let camera = null;
/** The last result, and the newest state that could be drawn altogether. @type {Result | null} */
let result = null;
/** Whether the address says something that could not be read: it stays until something is changed. */
let unread = first.wrong.length > 0;
/** Whether such an address is being followed. */
let visiting = false;
/** Counts the places that were asked about: an answer to an older one is late. */
let places = 0;

const pace = new Pace();
const seen = new SeenView(element("seen"), element("seen-marks"), () => refresh(true));
const script = new URL("./worker.js", import.meta.url);
/** @type {Scheduler<Job, Result>} */
const scheduler = new Scheduler(script, { ...statusOfPage, onResult, failureWords: ({ message }) => message }, 1);
const askForOutline = outlineDialog((text, scale) => scheduler.ask({ what: "outline", text, scale }), useOutline);
const panels = ["Map of V1", "Map beside it"].map((label, k) => new CortexPanel(makeFigure(k), label, wishesOf(k)));
const probes = panels.map(({ view }, panel) => {
  /** @type {import("../common/probe.js").Carrier} */
  const carrier = { carry: (side, points) => (side === "target" ? scheduler.ask({ what: "picture", panel, points }) : []) };
  return new Probe(seen, view, () => carrier, () => {});
});
const photoChoice = new PhotoChoice(element("choose-photo"), (image) => open(loadPicture(image)));

connect();
read(null, 0);
refresh(false);

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
    choose: (name) => store.commit({ models: /** @type {[string, string]} */ (store.value.models.with(k, name)) }),
    shear: (shear) => store.dragTo({ shear }),
    place: (name, landmark) => store.dragTo({ landmarks: { ...store.value.landmarks, [name]: landmark } }),
    placed: (kept) => (kept ? store.drop() : store.giveUp()),
    draw: useOutline,
    read: askForOutline,
    look: () => refresh(true),
    point: (event) => read(event, k),
  };
}

/** @param {Point[]} outline */
function useOutline(outline) {
  const { own: _, ...landmarks } = store.value.landmarks;
  store.commit({ own: ownOutline(outline), landmarks });
}

/** Says what a point of the cortex looks at. @param {PointerEvent | null} event @param {number} panel */
async function read(event, panel) {
  const place = ++places;
  const { root, frame } = panels[panel].view;
  const at = event && (await scheduler.ask({ what: "place", panel, point: toPlane(frame, pixelOf(root, event)) }));
  if (place !== places) return;
  element("reading").textContent = at
    ? `This place looks ${at.eccentricity.toFixed(1)}° away from the fixation point, and gives ${at.magnification.toPrecision(2)} mm to each degree.`
    : "Click or drag on the photo to look somewhere else; point at the cortex to see what a place there looks at.";
}

/** @param {boolean} dragging */
function refresh(dragging) {
  const state = store.value;
  for (const probe of probes) probe.hide();
  layOut();
  seen.show(picture, state.fixation, state.dots === 0 || camera !== null);
  panels.forEach((panel, k) => panel.update(state.models[k], state));
  updateControls();
  if (camera) scheduler.follow(jobOf, picture);
  else scheduler.run(jobOf, picture, dragging);
}

function layOut() {
  const [width, height] = picture.frame.pixels;
  const { style } = element("panels");
  style.setProperty("--aspect", String(width / height));
  const half = result?.half ?? NO_HALF;
  style.setProperty("--other-aspect", String(aspectOf(half)));
  for (const { view } of panels) view.fit(half);
}

/** @param {import("../common/scheduler.js").Care} care @returns {Omit<Job, "version" | "fine">} */
function jobOf({ sharpness: wanted }) {
  const sharpness = wanted < 1 ? wanted * pace.share : wanted;
  const { models: chosen, shear, own, landmarks, fieldOfView, fixation, dots, lines, circles } = store.value;
  const live = camera?.frame() ?? null;
  const [columns] = panels[0].view.grid(live ? 1 : sharpness);
  const recover = dots && !live ? { dots, view: seen.view(sharpness) } : null;
  return { models: chosen, shear, own, landmarks, fieldOfView, fixation, columns, places: panels.map(({ view }) => view.place), lines, circles, recover, live };
}

/** @param {Result} newest @param {boolean} done */
function onResult(newest, done) {
  result = newest;
  if (!newest.fine && !camera) pace.took(newest.warpMs);
  const state = store.value;
  layOut();
  newest.panels.forEach((panel, k) => panels[k].show(panel, newest.sizes[k], newest.half, state));
  if (camera) seen.drawPhoto(camera.picture);
  else if (newest.recovered && state.dots) seen.paint(newest.recovered.pixels, newest.recovered.size);
  seen.overlay(state.fixation, state.lines ? newest.seen.lines : [], state.circles ? newest.seen.circles : []);
  const time = Math.max(1, Math.round(newest.warpMs));
  if (camera) element("evidence").textContent = `${MEASURED} A frame of the camera is drawn in ${time} ms.`;
  if (!done || camera) return;
  element("evidence").textContent = `${MEASURED} Drawn in ${time} ms from a foveated picture of ${newest.levels} ${newest.levels === 1 ? "level" : "levels"}.`;
  showMagnification(newest);
  // What cannot be drawn is not worth a link.
  if (!unread && !newest.panels.some((panel) => "refusal" in panel)) history.replaceState(null, "", `#${encode(state)}`);
}

/** @param {Result} newest */
function showMagnification({ panels: shown }) {
  const [one, other] = store.value.models;
  /** @param {number} k @param {string} kind @param {string} name */
  const curve = (k, kind, name) => {
    const panel = shown[k];
    return "drawn" in panel ? [{ kind, name: models.get(name)?.title ?? "", magnification: panel.drawn.magnification }] : [];
  };
  const { k, a } = models.get(one)?.options ?? {};
  const published = k && a && !isOutline(one) && one !== "macaque" ? [{ kind: "published", name: `${k}/(E + ${a}), its curve near the fovea`, magnification: eccentricities.map((e) => k / (e + a)) }] : [];
  plotMagnification(element("plot"), [
    ...curve(0, "first", one),
    ...(other === one ? [] : curve(1, "second", other)),
    ...published,
    { kind: "measured", name: "17.3/(E + 0.75), Horton and Hoyt (1991)", magnification: hortonHoyt },
  ]);
}

async function switchCamera() {
  if (camera) return open(loadPicture(store.value.image));
  await attempt(Camera.open(() => scheduler.follow(jobOf, picture)), (opened) => {
    camera = opened;
    picture = opened.picture;
    store.commit({ fixation: [0, 0], dots: 0 });
  });
}

function closeCamera() {
  camera?.close();
  camera = null;
}

function connect() {
  const angle = /** @type {HTMLInputElement} */ (element("field-of-view"));
  angle.oninput = () => store.dragTo({ fieldOfView: Number(angle.value) });
  angle.onchange = () => store.drop();
  const dots = /** @type {HTMLSelectElement} */ (element("dots"));
  dots.append(...DOTS.map((n) => new Option(`as ${n} ${n === 1 ? "dot" : "dots"} a mm of V1 recover it`, String(n))));
  dots.onchange = () => store.commit({ dots: Number(dots.value) });
  element("lines").onclick = () => store.commit({ lines: !store.value.lines });
  element("circles").onclick = () => store.commit({ circles: !store.value.circles });
  element("undo").onclick = () => store.undo();
  element("redo").onclick = () => store.redo();
  element("reset").onclick = () => store.commit({ ...USUAL, image: store.value.image, fixation: firstGaze(store.value.image) });
  element("camera").onclick = switchCamera;
  element("stop").onclick = () => scheduler.stop();
  offerToSave({
    name: "cortex",
    script,
    picture: () => picture,
    shape: () => panels[0].view.frame.pixels,
    job: ([columns], kind) => ({ ...jobOf({ tolerance: 0, maxErrorPixels: 0, sharpness: 1 }), columns, live: null, lines: store.value.lines || kind === "drawing", circles: store.value.circles }),
    drawing: "the upper cortex: outlines and rings",
    address: () => encode(store.value),
  });
  offerAlone(() => refresh(false));
  const file = /** @type {HTMLInputElement} */ (element("file"));
  element("open").onclick = () => file.click();
  acceptFiles(file, element("seen-stage"), (chosen) => open(addPicture(chosen)));
  connectGaze();
  onUndoKeys(
    () => store.undo(),
    () => store.redo(),
  );
  store.subscribe(onChange);
  goAlong(() => (store.value.image === USUAL.image ? /** @type {Record<string, string>} */ ({}) : { image: store.value.image }));
  window.addEventListener("hashchange", visit);
  new ResizeObserver(() => refresh(false)).observe(element("panels"));
}

/** @param {import("../common/history.js").Change} change */
async function onChange(change) {
  unread = visiting;
  if (!camera && picture.id !== store.value.image) {
    const found = await wantedPicture(() => store.value.image);
    if (camera || !found) return;
    picture = found;
  }
  refresh(change === "drag");
}

/** Goes to another address: what it says, and the rest as it is. */
async function visit() {
  const { state, wrong } = decode(location.hash, store.value);
  remark(wrongWords(wrong));
  closeCamera();
  visiting = wrong.length > 0;
  store.commit(state);
  visiting = false;
}

function connectGaze() {
  const { root } = seen;
  /** @type {number | null} */
  let held = null;
  root.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || held !== null || (event.shiftKey && seen.place)) return;
    held = event.pointerId;
    root.setPointerCapture(event.pointerId);
    fixate(pixelOf(root, event));
  });
  // Two fingers look closer, and leave the gaze where it was.
  root.addEventListener("touchstart", ({ touches }) => {
    if (touches.length < 2 || held === null) return;
    held = null;
    store.giveUp();
  });
  root.addEventListener("pointermove", (event) => {
    if (event.pointerId === held) fixate(pixelOf(root, event));
  });
  for (const end of /** @type {const} */ (["pointerup", "pointercancel"])) {
    root.addEventListener(end, (event) => {
      if (event.pointerId !== held) return;
      held = null;
      store.drop();
    });
  }
  onEscape(() => {
    const dragged = held !== null;
    held = null;
    if (dragged) store.giveUp();
    return dragged;
  });
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let keys;
  root.addEventListener("keydown", (event) => {
    const step = ARROWS.get(event.key);
    if (!step) return;
    event.preventDefault();
    const [x, y] = store.value.fixation;
    store.dragTo({ fixation: [x + KEY_STEP * step[0], y + KEY_STEP * step[1]] });
    clearTimeout(keys);
    keys = setTimeout(() => store.drop(), KEY_PAUSE);
  });
}

/** @param {Point} pixel of the photo's panel */
function fixate([x, y]) {
  const [width, height] = seen.frame.pixels;
  store.dragTo({ fixation: toPlane(seen.frame, [Math.min(width, Math.max(0, x)), Math.min(height, Math.max(0, y))]) });
}

/** @param {string} image @returns {Point} */
const firstGaze = (image) => (image === USUAL.image ? USUAL.fixation : [0, 0]);

/** @param {Promise<Picture>} loading */
function open(loading) {
  return photos.open(loading, (opened) => {
    closeCamera();
    picture = opened;
    store.commit({ image: picture.id, fixation: firstGaze(picture.id) });
  });
}

function updateControls() {
  const { fieldOfView, dots: chosen, lines, circles } = store.value;
  photoChoice.show(picture);
  /** @type {HTMLInputElement} */ (element("field-of-view")).value = String(fieldOfView);
  element("angle").textContent = `${fieldOfView}°`;
  const dots = /** @type {HTMLSelectElement} */ (element("dots"));
  dots.value = String(chosen);
  dots.disabled = camera !== null;
  press("camera", camera !== null);
  press("lines", lines);
  press("circles", circles);
  /** @type {HTMLButtonElement} */ (element("undo")).disabled = !store.canUndo;
  /** @type {HTMLButtonElement} */ (element("redo")).disabled = !store.canRedo;
}
