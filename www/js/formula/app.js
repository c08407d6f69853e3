// The formula's page: connects the address, the formula, the two planes and the worker.

import { wrongWords } from "../common/address.js";
import { offerAlone } from "../common/alone.js";
import { goAlong } from "../common/along.js";
import { acceptFiles } from "../common/files.js";
import { onGrid } from "../common/frame.js";
import { addPicture } from "../common/images.js";
import { Lane } from "../common/lane.js";
import { element, PhotoOpener, remark, statusOfPage, watchErrors, wordsOf } from "../common/page.js";
import { PhotoChoice } from "../common/photo-choice.js";
import { PlaneView } from "../common/plane-view.js";
import { Probe, readingWords } from "../common/probe.js";
import { isStill } from "../common/motion.js";
import { menuOf } from "../common/menu.js";
import { probeRow } from "../common/probe-menu.js";
import { offerToSave } from "../common/save-menu.js";
import { playButton } from "../common/player.js";
import { Scheduler } from "../common/scheduler.js";
import { cutAt, formulaWithCut, isTurned, PRINCIPAL } from "./cut.js";
import { CutHandle } from "./cut-handle.js";
import { dilatationWords, placeWords } from "./dilatation.js";
import { showGallery } from "./gallery.js";
import { morphed } from "./morph.js";
import { showParams } from "./params.js";
import { PictureHandles } from "./picture-handles.js";
import { lattice, loadSquare } from "./square.js";
import { decode, encode, fromPreset, SHEETS } from "./state.js";

/** @typedef {import("./state.js").State} State */
/** @typedef {import("./pipeline.js").Job} Job */
/** @typedef {import("./pipeline.js").Result} Result */
/** @typedef {import("../common/images.js").Picture} Picture */
/** @typedef {import("./compile.js").Compiled} Compiled */
/** @typedef {import("../../pkg/formula/index.js").Preset} Preset */

const FIRST = "droste";
/** The texture's plane is seen this many pictures wide. */
const SURROUNDINGS = 2;
/** The view that 0 goes to. @type {import("../common/placement.js").Placement} */
const HOME = { center: [0, 0], width: 4 };
/** The controls that are choices, and sliders, by the parts of the state that they show. */
const SELECTS = /** @type {const} */ (["direction", "wrap", "colours", "lines"]);
const RANGES = /** @type {const} */ (["density", "morph"]);
/** What the planes are, in bold, and more of it. @type {Record<"picture" | State["direction"], [string, string][]>} */
const CAPTIONS = {
  picture: [["The picture", " in its plane"], ["Warped by f", ": drag to move, click and scroll to zoom"]],
  "pull-back": [["The plane of values", ": the key to the colours"], ["f(z) at each z", ": drag to move, click and scroll to zoom"]],
  "push-forward": [["f(z) at each z", ""], ["The plane of values", ": the key to the colours"]],
};

/** The way from z to f(z) takes so long, in seconds. */
const WAY = 3;
/** The address follows when nothing has changed for this long, in milliseconds. */
const REST = 160;

watchErrors();
const script = new URL("./worker.js", import.meta.url);
/** Reads formulas, also while the other worker draws. @type {Lane<Job, Result>} */
const reader = new Lane(script, 0, (reply) => {
  if ("broken" in reply) statusOfPage.onState("failed", `The page’s workers could not be started: ${reply.broken}. They are tried again, and again when you reload the page.`);
});
/** @type {Preset[]} */
const presets = await certain(() => reader.ask({ what: "presets" }));
const usual = fromPreset(/** @type {Preset} */ (presets.find(({ name }) => name === FIRST)), "astronaut");

/** What is drawn: its formula can be read. @type {State} */
let state = usual;
/** @type {Picture} */
let picture;
const photos = new PhotoOpener();
/** What was found out about the formula that is drawn. @type {Compiled} */
let compiled;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let resting;
/** Counts what was typed: words about an older text are late. */
let typings = 0;
/** Counts what was read under the pointer, and where that was, in the plane on which the formula is evaluated. */
let readings = 0;
/** @type {import("../common/frame.js").Point | null} */
let pointed = null;
/** Whether it is looked where the cuts are, and whether they have moved since. */
const seeking = { now: false, again: false, wanted: "" };

const source = new PlaneView(element("source"), element("source-marks"), (around) => change({ around }), () => surroundings());
const target = new PlaneView(element("target"), element("target-marks"), (view) => change({ view }), () => HOME);
/** @type {Scheduler<Job, Result>} */
const scheduler = new Scheduler(script, { ...statusOfPage, onResult, failureWords: ({ message }) => message }, 1);
const probe = new Probe(source, target, () => ({ carry }), read);
const cutHandle = new CutHandle({ cut: () => state.cut, onTurn: turnCut, angleAt: (which, at) => reader.ask({ what: "angle", ...typedIn(state), cut: state.cut, which, at }) });
const handles = new PictureHandles(source, () => state.texture, (texture) => change({ texture, around: state.around ?? surroundings() }));
const photoChoice = new PhotoChoice(element("choose-photo"), (image) => open(loadSquare(image)), [["lattice", "Lattice"]]);

connectControls();
await visit(usual);
showGallery(element("gallery"), presets, (kind) => squareFor(kind === "lattice" ? "lattice" : "astronaut"));

/** Goes to the address: what it says, and the rest as given. What cannot be read of it is said, and stays there. @param {State} rest */
async function visit(rest) {
  const { state: next, wrong } = decode(location.hash, presets, rest);
  remark(wrongWords(wrong));
  showFormula(next.formula);
  const found = await compiledBy(next.formula, next.params);
  const readable = "params" in found;
  complain(readable ? "" : found.message, readable ? null : (found.position ?? null));
  if (readable) adopt({ ...next, params: found.params }, found);
  else if (compiled) return;
  else adopt({ ...usual, image: next.image }, /** @type {Compiled} */ (await compiledBy(usual.formula, usual.params)));
  picture = await squareFor(state.image);
  show(readable && !wrong.length);
}

/** What an answer is waited for as long as it takes: a worker that fails is started again. @template T @param {() => Promise<T | null>} ask @returns {Promise<T>} */
async function certain(ask) {
  for (;;) {
    const answer = await ask();
    if (answer !== null) return answer;
    await new Promise((resolve) => setTimeout(resolve, REST));
  }
}

/** @param {string} text @param {State["params"]} params @returns {Promise<Compiled | import("./compile.js").Mistake>} */
function compiledBy(text, params) {
  return certain(() => reader.ask({ what: "compile", text, params }));
}

/** What is drawn, of what was typed: with its cuts where they were turned, and on the way there. */
function written() {
  const { formula, params, cut, morph } = state;
  return morphed(formulaWithCut(formula, Object.keys(params), cut), morph);
}

/** @param {State} state */
function typedIn({ formula, params }) {
  return { formula, params };
}

/** @param {State} next @param {Compiled} found */
function adopt(next, found) {
  state = next;
  compiled = found;
}

/** A picture, or what stands in for it. @param {string} id */
async function squareFor(id) {
  return loadSquare(id).catch((error) => {
    remark(wordsOf(error));
    return lattice(id);
  });
}

/** @param {Partial<State>} changes */
function change(changes) {
  state = { ...state, ...changes };
  show(true);
}

/** @param {boolean} remembering whether the address is to follow */
function show(remembering) {
  probe.hide();
  source.look(state.around ?? surroundings());
  source.outline(state.texture);
  handles.draw();
  target.look(state.view);
  showCuts();
  updateControls();
  scheduler.run(jobOf, picture, true);
  clearTimeout(resting);
  if (remembering) resting = setTimeout(() => history.replaceState(null, "", `#${encode(state)}`), REST);
}

/** The picture's plane as it is seen first. @returns {import("../common/placement.js").Placement} */
function surroundings() {
  return { center: state.texture.center, width: SURROUNDINGS * state.texture.width };
}

/** @param {import("../common/scheduler.js").Care} care @returns {Omit<Job, "version" | "fine">} */
function jobOf({ sharpness }) {
  const { params, direction, wrap, colours, lines, density, texture } = state;
  const placed = { ...texture, pixels: picture.frame.pixels };
  return { formula: written(), params, direction, wrap, colours, lines, density, texture: placed, source: source.view(sharpness), target: target.view(sharpness) };
}

/** How fast what is played moves. */
function speed() {
  return Number(/** @type {HTMLSelectElement} */ (element("speed")).value);
}

/** Points as the map takes them from the plane on which it is evaluated to the other; back, to one of the points that it takes there. @param {import("../common/probe.js").Side} side @param {import("../common/frame.js").Point[]} points */
function carry(side, points) {
  const typed = { formula: written(), params: state.params };
  const home = domain();
  if (side === (home === target ? "target" : "source")) {
    pointed = points[0];
    return scheduler.ask({ what: "points", ...typed, points });
  }
  const { center, width } = home.frame;
  return scheduler.ask({ what: "back", ...typed, points, within: { center, width } }).then((found) => {
    pointed = found?.[0] ?? null;
    return found;
  });
}

/** The panel with the plane on which the formula is evaluated. */
function domain() {
  return state.direction === "pull-back" ? target : source;
}

/** What the map does under the pointer; where it bends angles, both its dilatations. @param {import("../common/probe.js").Reading | null} reading */
async function read(reading) {
  const at = ++readings;
  const words = reading ? readingWords(reading, "picture") : "Point at either picture: marks show what belongs together.";
  if (!reading || !pointed || compiled.analytic) return void (element("reading").textContent = words);
  const found = await scheduler.ask({ what: "slopes", formula: written(), params: state.params, at: pointed });
  if (at === readings) element("reading").textContent = found ? placeWords(found) || words : words;
}

/** The cuts, once they are known; the newest view waits while an older one is looked at. */
async function showCuts() {
  cutHandle.draw();
  const { formula, params, direction, cut } = state;
  const wanted = JSON.stringify([compiled.branching, formula, params, direction, cut, domain().frame]);
  if (wanted === seeking.wanted) return;
  seeking.wanted = wanted;
  seeking.again = seeking.now;
  if (seeking.now) return;
  seeking.now = true;
  const view = domain();
  const { center, width } = view.frame;
  const lines = compiled.branching ? await reader.ask({ what: "cuts", ...typedIn(state), cut: state.cut, within: { center, width } }) : [];
  seeking.now = false;
  if (lines && view === domain()) cutHandle.show(view, compiled.branching ? lines : []);
  // A worker that gave no answer is asked again with the next change.
  if (!lines || seeking.again) seeking.wanted = "";
  if (seeking.again) showCuts();
}

/** Turns the cut: over a whole turn it comes to the next sheet. @param {number} turn in degrees */
function turnCut(turn) {
  const cut = cutAt(Math.round(10 * turn) / 10);
  if (Math.abs(cut.sheet) <= SHEETS) change({ cut });
}

/** @param {Result} result @param {boolean} done */
function onResult(result, done) {
  source.paint(result.sourcePixels, result.source, result.space);
  target.paint(result.targetPixels, result.target, result.space);
  probe.refresh();
  const kind = result.dilatation ? dilatationWords(result.dilatation) : "Analytic: angles are kept.";
  const cut = compiled.branching && isTurned(state.cut) ? ` Logarithms, roots and powers have their cut at ${Math.round(state.cut.angle)}°, on sheet ${state.cut.sheet}.`.replaceAll("-", "−") : "";
  const time = result.warpMs < 1000 ? `${Math.max(1, Math.round(result.warpMs))} ms` : `${(result.warpMs / 1000).toFixed(1)} s`;
  const way = state.morph === 1 ? "" : ` On the way: h(z) = (1 − s) z + s f(z), with s = ${state.morph.toFixed(2)}.`;
  element("evidence").textContent = `${kind}${cut}${way} ${done ? `Drawn in ${time}${state.colours === "picture" ? ", four samples a pixel" : ""}.` : "This is a coarse picture."}`;
}

function connectControls() {
  const formula = /** @type {HTMLInputElement} */ (element("formula"));
  formula.addEventListener("input", () => typed(formula.value));
  element("formula-form").addEventListener("submit", (event) => event.preventDefault());
  const file = /** @type {HTMLInputElement} */ (element("file"));
  element("open").onclick = () => file.click();
  acceptFiles(file, element("source-stage"), (chosen) => open(addPicture(chosen).then(({ id }) => loadSquare(id))));
  for (const name of SELECTS) {
    const select = /** @type {HTMLSelectElement} */ (element(name));
    select.onchange = () => change({ [name]: select.value });
  }
  for (const name of RANGES) {
    const slider = /** @type {HTMLInputElement} */ (element(name));
    slider.oninput = () => change({ [name]: Number(slider.value) });
  }
  const angle = /** @type {HTMLInputElement} */ (element("cut-angle"));
  angle.oninput = () => change({ cut: { ...state.cut, angle: Number(angle.value) } });
  const sheet = /** @type {HTMLInputElement} */ (element("sheet"));
  sheet.oninput = () => {
    const number = Math.round(Number(sheet.value));
    if (sheet.value !== "" && Math.abs(number) <= SHEETS) change({ cut: { ...state.cut, sheet: number } });
  };
  element("morph").after(playButton("the way from z to f(z)", (seconds) => {
    const morph = Math.min(1, (state.morph === 1 ? 0 : state.morph) + (speed() * seconds) / WAY);
    change({ morph });
    return morph < 1;
  }));
  // What an example shows is to be seen.
  document.querySelector("main")?.addEventListener("click", ({ target }) => {
    if (target instanceof Element && target.closest('a[href^="#"]')) element("panels").scrollIntoView({ block: "center", behavior: isStill() ? "auto" : "smooth" });
  });
  element("home").onclick = () => change({ view: HOME, around: null });
  offerToSave({
    name: "formula",
    script,
    picture: () => picture,
    shape: () => target.frame.pixels,
    job: (pixels, kind) => ({ ...jobOf({ tolerance: 0, maxErrorPixels: 0, sharpness: 1 }), target: onGrid(target.frame, pixels), drawing: kind === "drawing" }),
    drawing: "the grid, and where f takes it",
    address: () => encode(state),
  });
  menuOf(/** @type {HTMLButtonElement} */ (element("probe")), "The probe", [
    probeRow(probe, () => (state.direction === "pull-back" ? { side: "target", at: target.frame.center } : { side: "source", at: source.frame.center })),
  ]);
  element("stop").onclick = () => scheduler.stop();
  offerAlone(() => show(false));
  goAlong(() => (state.image === usual.image || state.image === "lattice" ? /** @type {Record<string, string>} */ ({}) : { image: state.image }));
  window.addEventListener("hashchange", () => visit(state));
  new ResizeObserver(() => picture && show(false)).observe(element("panels"));
}

function updateControls() {
  photoChoice.show(picture);
  for (const name of SELECTS) /** @type {HTMLSelectElement} */ (element(name)).value = state[name];
  for (const name of RANGES) /** @type {HTMLInputElement} */ (element(name)).value = String(state[name]);
  showCutControls();
  const photo = state.colours === "picture";
  element("panels").dataset.colours = photo ? "picture" : "values";
  CAPTIONS[photo ? "picture" : state.direction].forEach(([strong, rest], k) => {
    const [bold, words] = element(k ? "target-words" : "source-words").children;
    [bold.textContent, words.textContent] = [strong, rest];
  });
  showParams(element("params"), state.params, (name, value) => change({ params: { ...state.params, [name]: value } }), speed);
  const preset = presets.find(({ formula, direction, view }) => formula === state.formula && direction === state.direction && view.width === state.view.width);
  element("shows").textContent = preset?.shows ?? "";
}

/** Only formulas that have cuts have controls for them. */
function showCutControls() {
  const { angle, sheet } = state.cut;
  /** @type {HTMLElement} */ (element("cut")).hidden = !compiled.branching;
  /** @type {HTMLInputElement} */ (element("cut-angle")).value = String(angle);
  element("cut-value").textContent = `${String(Math.round(angle)).replace("-", "−")}°`;
  const number = /** @type {HTMLInputElement} */ (element("sheet"));
  if (number.value === "" ? document.activeElement !== number : Number(number.value) !== sheet) number.value = String(sheet);
}

/** @param {string} text */
async function typed(text) {
  const typing = ++typings;
  if (scheduler.state === "ready") statusOfPage.onState("working");
  const found = await compiledBy(text, state.params);
  if (typing !== typings) return;
  if (!("params" in found)) {
    complain(found.message, found.position ?? null);
    return statusOfPage.onState(scheduler.state);
  }
  complain("", null);
  adopt({ ...state, formula: text, params: found.params, cut: found.branching ? state.cut : PRINCIPAL }, found);
  show(true);
}

/** @param {Promise<Picture>} loading */
function open(loading) {
  return photos.open(loading, (opened) => {
    picture = opened;
    change({ image: opened.id });
  });
}

/** @param {string} text */
function showFormula(text) {
  const formula = /** @type {HTMLInputElement} */ (element("formula"));
  if (formula.value !== text) formula.value = text;
}

/** @param {string} words @param {number | null} position of a mistake in the formula */
function complain(words, position) {
  element("mistake").textContent = words;
  element("formula").setAttribute("aria-invalid", String(words !== ""));
  element("caret").textContent = position === null ? "" : `${" ".repeat(position)}▲`;
}
