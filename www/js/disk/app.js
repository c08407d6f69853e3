// The page: connects the state, the two panels, the solver and the controls.

import { readAddress, wrongWords } from "../common/address.js";
import { offerAlone } from "../common/alone.js";
import { goAlong } from "../common/along.js";
import { acceptFiles } from "../common/files.js";
import { onGrid } from "../common/frame.js";
import { addPicture, loadPicture } from "../common/images.js";
import { element, PhotoOpener, pictureFor, remark, showEvidence, statusOfPage, wantedPicture, watchErrors } from "../common/page.js";
import { playButton } from "../common/player.js";
import { Probe } from "../common/probe.js";
import { probeRow } from "../common/probe-menu.js";
import { offerToSave } from "../common/save-menu.js";
import { careFor, Scheduler } from "../common/scheduler.js";
import { documentOf } from "../editor/document.js";
import { Drawing } from "../editor/drawing.js";
import { Editor } from "../editor/edit.js";
import { failureWords, probeWords, rows } from "../editor/evidence.js";
import { offerEdges } from "../editor/edge-menu.js";
import { letterDialog } from "../editor/letter-dialog.js";
import { looksLikeOutline } from "../editor/outline-text.js";
import { OutlineReader } from "../editor/outline-dialog.js";
import { wishesOf } from "../editor/overlays.js";
import { PhotoView } from "../editor/photo-view.js";
import { defaultRegion, LETTER, photoRegion, READ, shapeRegion } from "../editor/presets.js";
import { carried, makeRegion, pointsOf } from "../editor/region.js";
import { offerRepair } from "../editor/repair-button.js";
import { NOTHING_SHOWN, Store } from "../editor/store.js";
import { drawingFields, drawingSchema, encodeDrawing, encodeShown, ontoSchema, shownOf, shownSchema } from "../editor/url.js";
import { ontoOf } from "./onto.js";
import { Controls } from "./controls.js";
import { DiskView } from "./disk-view.js";
import { radiusAt } from "./homotopy.js";
import { Outcome } from "./outcome.js";
import { Traveller, upright } from "./travel.js";

/** @typedef {import("../common/images.js").Picture} Picture */
/** @typedef {import("../editor/store.js").Document} Document */

const FIRST_PHOTO = "astronaut";
/** The way from the region to the disk takes so long, in seconds. */
const WAY = 4;
/** What is shown that sliders change. */
const SLID = /** @type {const} */ (["density", "morph"]);
/** The address follows a slider when it has not moved for so long, in milliseconds. */
const REST = 160;
/** How dark the photo is outside the region. */
const DIM = 0.42;

watchErrors();
/** @type {Picture} */
let picture;
const photos = new PhotoOpener();
/** The last good picture of the disk. @type {Outcome | null} */
let outcome = null;
/** The picture that the panels have the shape of. @type {Picture | null} */
let laidOut = null;
/** What was shown last. @type {import("../editor/store.js").Shown} */
let last = NOTHING_SHOWN;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let resting;
/** Whether an address is being followed: what could not be read of it is left there. */
let visiting = false;

const photoView = new PhotoView(element("photo"), element("photo-marks"), () => {
  layOut();
  refresh(false, false);
});
const diskView = new DiskView(element("disk"), element("disk-lines"), element("disk-marks"), () => {
  layOut();
  refresh(true, true);
});
const script = new URL("./worker.js", import.meta.url);
/** @type {Scheduler<import("./pipeline.js").Job, import("./pipeline.js").Result>} */
const scheduler = new Scheduler(script, { ...statusOfPage, onResult, failureWords });

const store = new Store({ image: FIRST_PHOTO, region: photoRegion(FIRST_PHOTO) }, NOTHING_SHOWN);
const editor = new Editor(store, photoView);
const drawing = new Drawing(store, photoView, useOutline);
/** Where outlines go. */
const onPhoto = { photo: () => picture.frame, use: useOutline };
const outlines = new OutlineReader({ parse: (text) => scheduler.ask({ what: "outline", text }), ...onPhoto });
const askForLetter = letterDialog(onPhoto);
offerEdges(element("choose-edge"), [{ store, editor, view: photoView }]);
const locator = () => outcome?.locator ?? null;
// On the way to the disk there is nothing to travel on.
new Traveller(store, diskView, () => (store.shown.morph === 1 ? locator() : null));
const probe = new Probe(photoView, diskView, () => outcome?.carrier ?? null, (reading) => {
  element("reading").textContent = probeWords(reading);
});

const controls = new Controls(store, {
  draw: () => drawing.toggle("draw"),
  hole: () => drawing.toggle("hole"),
  remove: () => editor.removeSelected(),
  reset: () => replaceRegion(defaultRegion(picture)),
  photo: (id) => openPicture(loadPicture(id)),
  shape: (name) => (name === READ ? outlines.ask() : name === LETTER ? askForLetter() : replaceRegion(shapeRegion(name, picture.frame.pixels))),
  upright: async () => {
    const { region } = store.doc;
    const turned = outcome && (await upright(region, outcome.carrier));
    if (turned && region === store.doc.region) store.commit({ region: turned });
  },
  stop: () => scheduler.stop(),
}, probeRow(probe, () => ({ side: "source", at: store.doc.region.center })));

/** What a region with holes becomes. */
const onto = /** @type {HTMLSelectElement} */ (element("onto"));
onto.onchange = () => store.show({ onto: /** @type {import("../editor/store.js").Onto} */ (onto.value) });

/** The slider from the region to the disk. */
const way = /** @type {HTMLInputElement} */ (element("morph"));
way.oninput = () => store.show({ morph: Number(way.value) });
way.after(playButton("the way from the region to the disk", (seconds) => {
  const { morph } = store.shown;
  const next = Math.min(1, (morph === 1 ? 0 : morph) + seconds / WAY);
  store.show({ morph: next });
  return next < 1;
}));

await start();

async function start() {
  const { doc, shown, wrong } = await read(location.hash);
  store.begin(doc);
  store.shown = last = shown;
  store.subscribe(onChange);
  offerRepair(store, element("photo-stage"));
  acceptFiles(element("file"), element("photo-stage"), (file) => openPicture(addPicture(file)), { take: (text, name) => outlines.take(text, name), looksLike: looksLikeOutline });
  offerToSave({
    name: "disk",
    script,
    picture: () => picture,
    shape: () => diskView.frame.pixels,
    job: (pixels, kind) => ({ ...carried(store.doc.region), ...careFor(pixels), view: onGrid(diskView.frame, pixels), show: wishesOf(store.shown, kind === "drawing"), ...wayOf(store.shown) }),
    drawing: "outline, triangles, vector and grid, on both sides",
    address,
  });
  offerAlone(() => {
    layOut();
    refresh(true, false);
  });
  goAlong(() => drawingFields(store.doc, { image: FIRST_PHOTO, region: photoRegion(FIRST_PHOTO) }));
  window.addEventListener("hashchange", visit);
  new ResizeObserver(onResize).observe(element("panels"));
  refresh(true, false);
  if (!wrong.length) remember();
}

/** Goes to another address: what it says, and the rest as it is. */
async function visit() {
  const { doc, shown, wrong } = await read(location.hash);
  drawing.cancel();
  visiting = true;
  store.show(shown);
  if (doc.image !== store.doc.image || doc.region !== store.doc.region) store.commit(doc);
  visiting = false;
  if (!wrong.length) remember();
}

/** The state that an address asks for; its picture is loaded, and what is wrong with it is said. @param {string} hash */
async function read(hash) {
  const { values, wrong } = readAddress(hash, { ...drawingSchema, ...shownSchema, ...ontoSchema });
  const { show, density, morph, onto: became, ...fields } = values;
  remark(wrongWords(wrong));
  picture = await pictureFor(fields.image ?? store.doc.image);
  const doc = documentOf(fields, store.doc, () => picture.frame);
  return { doc, shown: shownOf({ show: show ?? (fields.region || fields.path ? [] : undefined), density, morph, onto: became }, store.shown), wrong };
}

/** @param {Promise<Picture>} loading */
function openPicture(loading) {
  return photos.open(loading, (loaded) => {
    drawing.cancel();
    picture = loaded;
    store.commit({ image: picture.id, region: defaultRegion(picture) });
  });
}

/** @param {import("../editor/outline.js").Outline} outline @param {import("../editor/outline.js").Outline[]} [holes] */
function useOutline(outline, holes) {
  replaceRegion(makeRegion(outline, undefined, undefined, holes));
}

/** A drawing that is under way ends there. @param {import("../editor/region.js").Region} region */
function replaceRegion(region) {
  drawing.cancel();
  store.commit({ region });
}

/** @param {import("../common/history.js").Change} change */
async function onChange(change) {
  if (picture.id !== store.doc.image) {
    const found = await wantedPicture(() => store.doc.image);
    if (!found) return;
    picture = found;
  }
  // A slider is moved, or plays: more is to come.
  const sliding = change === "view" && SLID.some((name) => store.shown[name] !== last[name]);
  last = store.shown;
  refresh(change === "drag" || change === "commit" || change === "view", change === "drag" || sliding);
  if (change === "drag" || change === "mode" || visiting) return;
  clearTimeout(resting);
  if (sliding) resting = setTimeout(remember, REST);
  else remember();
}

/** Draws the page, and computes it anew if asked to. @param {boolean} solving @param {boolean} dragging */
function refresh(solving, dragging) {
  if (solving) probe.hide();
  if (laidOut !== picture) layOut();
  draw();
  probe.refresh();
  if (solving) solve(dragging);
}

/** @param {boolean} dragging */
function solve(dragging) {
  const [fields, show, way] = [carried(store.doc.region), wishesOf(store.shown, false), wayOf(store.shown)];
  scheduler.run(
    ({ tolerance, maxErrorPixels, sharpness }) => ({ ...fields, tolerance, maxErrorPixels, view: diskView.view(sharpness), show, ...way }),
    picture,
    dragging,
  );
}

/** How far the region has gone, and what becomes of its holes: with holes there are no steps on the way. @param {import("../editor/store.js").Shown} shown */
function wayOf({ morph, onto: chosen }) {
  const { holes = [] } = store.doc.region;
  return { morph: holes.length ? 1 : morph, onto: ontoOf(chosen, holes.length) };
}

function layOut() {
  laidOut = picture;
  const [width, height] = picture.frame.pixels;
  element("panels").style.setProperty("--aspect", String(width / height));
  photoView.fit(picture);
  diskView.fit();
}

function draw() {
  const { shown } = store;
  photoView.draw(picture, store, { dim: DIM, heat: outcome?.heat("source", shown), over: outcome?.layers("source", shown) });
  diskView.draw(store.shown, outcome, pointsOf(store.doc.region)[store.selected ?? -1], store.dragging);
  controls.update(picture);
  const { morph, onto: becomes } = wayOf(store.shown);
  way.value = String(morph);
  showOnto(becomes, store.doc.region.holes?.length ?? 0);
  element("disk-words").replaceChildren(...captionOf(morph, Boolean(store.doc.region.holes)));
}

/** The choice of what a region with holes becomes, where it has some. @param {import("../editor/store.js").Onto} becomes @param {number} holes */
function showOnto(becomes, holes) {
  onto.hidden = !holes;
  for (const part of document.querySelectorAll(".way")) /** @type {HTMLElement} */ (part).hidden = holes > 0;
  for (const option of onto.options) option.hidden = option.disabled = option.value === "ring" && holes !== 1;
  onto.value = becomes;
}

/** What the right picture is. @param {number} morph @param {boolean} holed @returns {(Node | string)[]} */
function captionOf(morph, holed) {
  const strong = (/** @type {string} */ textContent) => Object.assign(document.createElement("b"), { textContent });
  if (holed) return [strong("Its conformal image"), " on "];
  if (morph === 1) return [strong("Its conformal image"), " on the unit disk"];
  return [strong("On the way"), `: f⁻¹(r f)/r, r = ${radiusAt(morph).toFixed(2)}`];
}

/** @type {ReturnType<typeof setTimeout> | undefined} */
let resizing;

function onResize() {
  layOut();
  draw();
  clearTimeout(resizing);
  resizing = setTimeout(() => solve(false), 150);
}

/** The state, in the address. */
function remember() {
  history.replaceState(null, "", `#${address()}`);
}

/** The state, as the address has it. */
function address() {
  return encodeDrawing(store.doc) + encodeShown(store.shown);
}

/** @param {import("./pipeline.js").Result} result @param {boolean} done */
function onResult(result, done) {
  outcome = new Outcome(result, { carry: (side, points) => scheduler.ask({ what: "points", side, points }) });
  diskView.paint(result);
  draw();
  probe.refresh();
  if (done) showEvidence(rows(result.evidence));
}
