// The page: connects the state, the two panels, the solver and the controls.

import { Controls } from "./controls.js";
import { DiskView } from "./disk-view.js";
import { Pen } from "../editor/pen.js";
import { Editor } from "../editor/edit.js";
import { failureWords, readingWords, rows } from "../editor/evidence.js";
import { acceptFiles } from "../common/files.js";
import { flatten } from "../common/frame.js";
import { addPicture, loadPicture } from "../common/images.js";
import { element, mark, say, sayBroken, saveCanvas, showEvidence, showProgress } from "../common/page.js";
import { photos } from "../common/photos.js";
import { Probe } from "../common/probe.js";
import { Scheduler } from "../common/scheduler.js";
import { outcomeOf } from "./outcome.js";
import { PhotoView } from "../editor/photo-view.js";
import { photoRegion, shapeRegion, shapes } from "../editor/presets.js";
import { towardPoint } from "../editor/region.js";
import { Store } from "../editor/store.js";
import { Traveller, upright } from "./travel.js";
import { decode, encode } from "../editor/url.js";

/** @typedef {import("../common/images.js").Picture} Picture */
/** @typedef {import("./outcome.js").Outcome} Outcome */

const FIRST_PHOTO = "astronaut";
/** How dark the photo is outside the region. */
const DIM = 0.42;

/** @type {Picture} */
let picture;
/** The last good picture of the disk. @type {Outcome | null} */
let outcome = null;

const photoView = new PhotoView(element("photo"), element("photo-marks"));
const diskView = new DiskView(element("disk"), element("disk-lines"), element("disk-marks"));
/** @type {Scheduler<import("./pipeline.js").Job, import("./pipeline.js").Result>} */
const scheduler = new Scheduler(new URL("./worker.js", import.meta.url), { onResult, onFailure, onProgress: showProgress, onBroken: sayBroken });

const address = decode(location.hash);
const store = new Store({ image: FIRST_PHOTO, region: photoRegion(FIRST_PHOTO) }, address.shown ?? { mesh: false, grid: false });
const editor = new Editor(store, photoView);
const pen = new Pen(store, photoView);
const locator = () => outcome?.locator ?? null;
new Traveller(store, diskView, locator);
const probe = new Probe(photoView, diskView, locator, (reading) => {
  element("reading").textContent = readingWords(reading);
});

const controls = new Controls(store, {
  draw: () => (store.mode === "draw" ? pen.cancel() : pen.begin()),
  remove: () => editor.removeSelected(),
  reset: () => store.commit({ region: defaultRegion(store.doc.image) }),
  photo: (id) => openPicture(loadPicture(id)),
  shape: (name) => store.commit({ region: shapeRegion(name, ...picture.frame.pixels) }),
  upright: () => {
    const region = outcome && upright(store.doc.region, outcome.locator);
    if (region) store.commit({ region });
  },
  save: () => saveCanvas(element("disk"), "disk.png"),
});

await start();

async function start() {
  store.begin(await documentAt(address));
  store.subscribe(onChange);
  acceptFiles(element("file"), element("photo-stage"), (file) => openPicture(addPicture(file)));
  window.addEventListener("hashchange", () => visit(decode(location.hash)));
  new ResizeObserver(() => onResize()).observe(element("panels"));
  onChange("commit");
}

/** Goes to another address. @param {import("../editor/url.js").Address} to */
async function visit(to) {
  const doc = await documentAt(to);
  if (to.shown) store.show(to.shown);
  store.commit(doc);
}

/** The document of an address; its picture is loaded. @param {import("../editor/url.js").Address} address */
async function documentAt({ image, shape, region }) {
  const id = image && (image in photos || image === store.doc.image) ? image : store.doc.image;
  picture = await loadPicture(id);
  const size = picture.frame.pixels;
  const wanted = region ?? (shape && shape in shapes ? shapeRegion(shape, ...size) : defaultRegion(id));
  return { image: id, region: wanted };
}

/** @param {string} id */
function defaultRegion(id) {
  return id in photos ? photoRegion(id) : shapeRegion("ellipse", ...picture.frame.pixels);
}

/** @param {Promise<Picture>} loading */
async function openPicture(loading) {
  try {
    picture = await loading;
    store.commit({ image: picture.id, region: defaultRegion(picture.id) });
  } catch (error) {
    say(error instanceof Error ? error.message : String(error), "invalid");
  }
}

/** @param {import("../editor/store.js").Change} change */
async function onChange(change) {
  if (picture.id !== store.doc.image) picture = await loadPicture(store.doc.image);
  const solving = change === "drag" || change === "commit";
  if (solving) probe.hide();
  layOut();
  draw();
  if (solving) {
    if (document.body.dataset.state !== "loading") mark("working");
    solve(change === "drag");
  }
  if (change !== "drag" && change !== "mode") remember();
}

/** @param {boolean} dragging */
function solve(dragging) {
  const { region } = store.doc;
  const fields = { boundary: flatten(region.boundary), center: region.center, toward: towardPoint(region) };
  scheduler.run(
    ({ tolerance, maxErrorPixels, sharpness }) => ({ ...fields, tolerance, maxErrorPixels, view: diskView.view(sharpness) }),
    picture,
    dragging,
  );
}

function layOut() {
  const [width, height] = picture.frame.pixels;
  element("panels").style.setProperty("--aspect", String(width / height));
  photoView.fit(picture);
  diskView.fit();
}

function draw() {
  const { mesh, grid } = store.shown;
  photoView.draw(picture, store, {
    dim: DIM,
    mesh: mesh && outcome ? { points: outcome.result.mesh.source, edges: outcome.edges } : undefined,
    lines: grid && outcome ? outcome.grid : undefined,
  });
  diskView.draw(store.shown, outcome, store.doc.region.boundary[store.selected ?? -1]);
  controls.update(picture.title);
}

/** @type {ReturnType<typeof setTimeout> | undefined} */
let resizing;

function onResize() {
  layOut();
  draw();
  clearTimeout(resizing);
  resizing = setTimeout(() => solve(false), 150);
}

function remember() {
  history.replaceState(null, "", `#${encode(store.doc, store.shown)}`);
}

/** @param {import("./pipeline.js").Result} result @param {boolean} done */
function onResult(result, done) {
  outcome = outcomeOf(result);
  diskView.paint(result);
  draw();
  say("", done ? "ready" : "draft");
  if (done) showEvidence(rows(result.evidence));
}

/** @param {import("../common/serve.js").Failure} failure */
function onFailure(failure) {
  say(failureWords(failure, outcome !== null), "invalid");
}
