// The formula's page: connects the address, the formula, the two planes and the worker.

import init, { presets as allPresets } from "../../pkg/index.js";
import { acceptFiles } from "../common/files.js";
import { addPicture } from "../common/images.js";
import { Lane } from "../common/lane.js";
import { element, mark, saveCanvas } from "../common/page.js";
import { photos } from "../common/photos.js";
import { PlaneView } from "../common/plane-view.js";
import { Probe } from "../common/probe.js";
import { carrierOf, compile } from "./compile.js";
import { showGallery } from "./gallery.js";
import { showParams } from "./params.js";
import { cropped, loadSquare } from "./square.js";
import { decode, encode, fromPreset } from "./state.js";

/** @typedef {import("./state.js").State} State */
/** @typedef {import("./pipeline.js").Job} Job */
/** @typedef {import("./pipeline.js").Result} Result */
/** @typedef {import("../common/images.js").Picture} Picture */

const FIRST = "droste";
/** The texture's plane is seen this many pictures wide. */
const SURROUNDINGS = 2;
/** A hand that has not moved for this long rests, in milliseconds; a warp that takes longer than this is given up for a newer one. */
const REST = 160;
const PATIENCE = 3000;
const DRAFT = { quality: /** @type {const} */ ("bilinear"), sharpness: 0.5 };
const FINE = { quality: /** @type {const} */ ("best"), sharpness: 1 };

await init().catch((error) => {
  say(`The page’s WebAssembly module could not be started: ${error.message}`, null);
  mark("failed");
  throw error;
});
const presets = allPresets();
const usual = fromPreset(/** @type {import("../../pkg/index.js").Preset} */ (presets.find(({ name }) => name === FIRST)), "astronaut");

/** @type {State} */
let state = decode(location.hash, presets, usual);
/** @type {Picture} */
let picture;
/** The last formula that could be read. @type {import("./compile.js").Compiled} */
let compiled;
/** The visitor's own picture, if there is one. @type {Map<string, Picture>} */
const own = new Map();
let version = 0;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let resting;

const source = new PlaneView(element("source"), element("source-marks"), null);
const target = new PlaneView(element("target"), element("target-marks"), (view) => change({ view }));
/** @type {Lane<Job, Result>} */
const lane = new Lane(new URL("./worker.js", import.meta.url), PATIENCE, receive);
const probe = new Probe(source, target, () => carrierOf(compiled.map, state.direction), (reading) => {
  const { direction } = state;
  const hint = direction === "pull-back" ? "Point at the right picture: a mark shows where its colours come from." : "Point at the left picture: a mark shows where it goes.";
  element("reading").textContent = reading ? readingWords(reading) : hint;
});

connectControls();
await go(state);
showGallery(element("gallery"), presets, (kind) => loadSquare(kind === "lattice" ? "lattice" : "astronaut"));

/** Goes to a state altogether. @param {State} next */
async function go(next) {
  const result = compile(next.formula, next.params);
  if (!("map" in result)) {
    /** @type {HTMLInputElement} */ (element("formula")).value = next.formula;
    say(result.message, result.position ?? null);
    if (compiled) return;
    return go({ ...usual, image: next.image });
  }
  picture = own.get(next.image) ?? (await loadSquare(next.image).catch(() => loadSquare("astronaut")));
  if (compiled) compiled.map.free();
  compiled = result;
  state = { ...next, image: picture.id, params: result.params };
  /** @type {HTMLInputElement} */ (element("formula")).value = state.formula;
  say("", null);
  show();
}

/** @param {Partial<State>} changes */
function change(changes) {
  state = { ...state, ...changes };
  for (const [name, value] of Object.entries(changes.params ?? {})) compiled.map.setParam(name, value);
  show();
}

function show() {
  probe.hide();
  source.look({ center: state.texture.center, width: SURROUNDINGS * state.texture.width });
  source.outline(state.texture);
  target.look(state.view);
  updateControls();
  mark("working");
  request(DRAFT);
  clearTimeout(resting);
  resting = setTimeout(() => {
    request(FINE);
    history.replaceState(null, "", `#${encode(state)}`);
  }, REST);
}

/** @param {typeof DRAFT | typeof FINE} care */
function request({ quality, sharpness }) {
  const { formula, direction, wrap, lines, texture } = state;
  lane.setPicture(picture);
  lane.request({
    version: ++version,
    formula,
    params: compiled.params && Object.fromEntries(Object.keys(compiled.params).map((name) => [name, state.params[name]])),
    direction,
    wrap,
    lines,
    texture: { ...texture, pixels: picture.frame.pixels },
    source: source.view(sharpness),
    target: target.view(sharpness),
    quality,
  });
}

/** @param {import("../common/serve.js").Reply<Result>} reply */
function receive(reply) {
  if ("broken" in reply) return mark("failed");
  if ("progress" in reply) return;
  if ("failure" in reply) {
    if (reply.failure.version !== version) return;
    say(reply.failure.message, reply.failure.position ?? null);
    return mark("invalid");
  }
  const { result } = reply;
  source.paint(result.sourcePixels, result.source);
  target.paint(result.targetPixels, result.target);
  if (result.version !== version || result.quality !== FINE.quality) return;
  const kind = compiled.map.isAnalytic ? "Analytic: angles are kept." : "Not analytic: angles are bent.";
  element("evidence").textContent = `${kind} Drawn in ${Math.max(1, Math.round(result.warpMs))} ms, four samples a pixel.`;
  mark("ready");
}

function connectControls() {
  const formula = /** @type {HTMLInputElement} */ (element("formula"));
  formula.addEventListener("input", () => typed(formula.value));
  element("formula-form").addEventListener("submit", (event) => event.preventDefault());
  const image = /** @type {HTMLSelectElement} */ (element("choose-photo"));
  image.append(new Option("Lattice", "lattice"), ...Object.entries(photos).map(([id, { title }]) => new Option(title, id)));
  image.onchange = () => go({ ...state, image: image.value });
  const file = /** @type {HTMLInputElement} */ (element("file"));
  element("open").onclick = () => file.click();
  acceptFiles(file, element("source-stage"), open);
  for (const name of /** @type {const} */ (["direction", "wrap", "lines"])) {
    const select = /** @type {HTMLSelectElement} */ (element(name));
    select.onchange = () => change({ [name]: select.value });
  }
  element("home").onclick = () => change({ view: { center: [0, 0], width: 4 } });
  element("save").onclick = () => saveCanvas(element("target"), "formula.png");
  window.addEventListener("hashchange", () => go(decode(location.hash, presets, { ...usual, image: state.image })));
  new ResizeObserver(() => compiled && show()).observe(element("panels"));
}

function updateControls() {
  const image = /** @type {HTMLSelectElement} */ (element("choose-photo"));
  if (![...image.options].some(({ value }) => value === picture.id)) image.append(new Option(picture.title, picture.id));
  image.value = picture.id;
  for (const name of /** @type {const} */ (["direction", "wrap", "lines"])) /** @type {HTMLSelectElement} */ (element(name)).value = state[name];
  showParams(element("params"), state.params, (name, value) => change({ params: { ...state.params, [name]: value } }));
  const preset = presets.find(({ formula, direction, view }) => formula === state.formula && direction === state.direction && view.width === state.view.width);
  element("shows").textContent = preset?.shows ?? "";
}

/** @param {string} text */
function typed(text) {
  const result = compile(text, state.params);
  if (!("map" in result)) return say(result.message, result.position ?? null);
  compiled.map.free();
  compiled = result;
  say("", null);
  change({ formula: text, params: result.params });
}

/** @param {File} file */
async function open(file) {
  try {
    const opened = cropped(await addPicture(file));
    own.set(opened.id, opened);
    await go({ ...state, image: opened.id });
  } catch (error) {
    say(error instanceof Error ? error.message : String(error), null);
  }
}

/** @param {import("../common/probe.js").Reading} reading */
function readingWords({ stretch, turn }) {
  const size = stretch >= 1 ? `enlarged ${stretch.toFixed(1)} times` : `shrunk ${(1 / stretch).toFixed(1)} times`;
  return `Here the picture is ${size} and turned by ${Math.round(turn)}°.`;
}

/** @param {string} words @param {number | null} position of a mistake in the formula */
function say(words, position) {
  element("mistake").textContent = words;
  const formula = /** @type {HTMLInputElement} */ (element("formula"));
  formula.setAttribute("aria-invalid", String(words !== ""));
  element("caret").textContent = position === null ? "" : `${" ".repeat(position)}▲`;
}
