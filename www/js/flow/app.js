// The page of flows: bodies in the wind.

import { bodies as ready, bodyOf, placed } from "./bodies.js";
import { placeOf } from "./grid-field.js";
import { Particles } from "./particles.js";
import { restingPoints } from "./resting.js";
import { offerScene } from "./save-scene.js";
import { readState, writeState } from "./state.js";
import { moved, nearest, remaining, withOne } from "./vortices.js";
import { FlowView, levelsOf } from "./view.js";
import { Wind } from "./wind.js";
import { offerAlone } from "../common/alone.js";
import { goAlong } from "../common/along.js";
import { Courier } from "../common/courier.js";
import { scaleOf, toPlane } from "../common/frame.js";
import { ARROWS, onEscape } from "../common/keys.js";
import { isStill } from "../common/motion.js";
import { attempt, element, press, remark, showEvidence, statusOfPage, tell, watchErrors } from "../common/page.js";
import { isState, openState } from "../common/saved-state.js";
import { pixelOf } from "../common/svg.js";
import { power } from "../editor/evidence.js";
import { contains, crossingEdges, simplify } from "../editor/geometry.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./bodies.js").Bodies} Bodies */
/** @typedef {import("./answers.js").Basis} Basis */
/** @typedef {import("../common/frame.js").Frame} Frame */

watchErrors();
const courier = new Courier(new URL("worker.js", import.meta.url));
const canvas = /** @type {HTMLCanvasElement} */ (element("flow"));
const view = new FlowView(canvas);
const particles = new Particles();

/** An arrow key moves a vortex by this. */
const KEY_STEP = 0.05;
/** The part of the plane that is shown. @type {{ center: Point, width: number }} */
const PLANE = { center: [0, 0], width: 6 };
/** Grids for a first picture and for the best one. */
const COARSE = grid(60);
const FINE = grid(160);
/** Density of air in kg/m³, for the lift that is read. */
const AIR = 1.225;

const { state: first, wrong } = readState(location.hash);
let state = first;
if (wrong) remark(wrong);
/** @type {Wind | null} */
let wind = null;
/** @type {Basis | null} */
let basis = null;
/** @type {Point[]} */
let resting = [];
/** A visitor's body, which can be chosen again. */
let lastOwn = state.own;
/** Which body the solid points of a grid belong to. @type {Uint8Array} */
let owners = new Uint8Array();
/** @type {Point[] | null} */
let stroke = null;
/** The vortex that was touched last. @type {number | null} */
let chosen = null;

/** @param {number} columns @returns {Frame} */
function grid(columns) {
  return { ...PLANE, pixels: [columns, Math.round(columns * 0.6)] };
}

const shownBodies = () => state.own ?? /** @type {Bodies} */ (ready.get(state.body));

/** Computes the basic flows, first on a coarse grid. */
function solve() {
  const [bodies, { vortices }] = [shownBodies(), state];
  statusOfPage.onState(wind ? "working" : "loading");
  statusOfPage.onProgress("begun");
  /** @type {(on: Frame, last: boolean) => Promise<void>} */
  const ask = (on, last) =>
    courier.ask("basis", { what: "basis", bodies, vortices, grid: on }).then(
      (/** @type {Basis | null} */ found) => {
        if (!found || bodies !== shownBodies() || vortices !== state.vortices) return;
        basis = found;
        wind = new Wind(on, found);
        owners = ownersOf(wind, bodies.outlines);
        particles.scatter();
        turn();
        if (!last) return ask(FINE, true);
        statusOfPage.onState("ready", "");
        statusOfPage.onProgress(null);
        showFigures();
      },
      (error) => {
        statusOfPage.onProgress(null);
        statusOfPage.onState(wind ? "ready" : "invalid", error.message);
      },
    );
  ask(COARSE, false);
}

/** @param {Wind} of @param {Point[][]} outlines */
function ownersOf({ solid, grid }, outlines) {
  return Uint8Array.from(solid, (inside, k) => (inside ? Math.max(0, outlines.findIndex((outline) => contains(outline, placeOf(grid, k)))) : 0));
}

/** The wind, or the turning of the fluid, has changed. */
function turn() {
  if (!wind) return;
  const { outlines } = shownBodies();
  const circulation = state.kutta && wind.canLeave ? "kutta" : outlines.map(() => state.circulation);
  wind.turn((state.angle * Math.PI) / 180, circulation, (k) => owners[k]);
  resting = restingPoints(wind, outlines);
  view.prepare(wind, state);
  canvas.dataset.lines = "rough";
  draw();
  read();
  trace(wind);
}

/** The streamlines and points of rest as the map has them, when the wind keeps still long enough. @param {Wind} of */
function trace(of) {
  const { angle, bodies, frame } = { angle: state.angle, bodies: shownBodies(), frame: COARSE };
  const question = { what: "lines", angle: (angle * Math.PI) / 180, circulation: of.circulation, levels: levelsOf(of), frame };
  courier.ask("lines", question).then(
    (/** @type {import("./answers.js").Traced | null} */ found) => {
      if (!found || of !== wind || bodies !== shownBodies() || angle !== state.angle || question.circulation !== of.circulation) return;
      view.take(found.lines);
      resting = found.resting;
      draw();
      canvas.dataset.lines = "traced";
    },
    // The lines of the grid stay.
    () => {},
  );
}

function draw() {
  if (!wind) return;
  const outlines = stroke ? [] : shownBodies().outlines;
  const vortices = stroke ? [] : state.vortices.map(({ at, circulation }, k) => ({ at, turns: /** @type {1 | -1} */ (circulation < 0 ? -1 : 1), chosen: k === chosen }));
  view.draw(wind, outlines, state, particles.specks.map(({ trail }) => trail), stroke ? [] : resting, vortices, stroke ?? undefined);
}

/** What is read off the flow. */
function read() {
  if (!wind) return;
  const total = wind.circulation.reduce((sum, each) => sum + each, 0);
  const lift = -total;
  const way = Math.abs(lift) < 0.005 ? "no lift" : `lift ${signed(lift * AIR)} N a metre of span`;
  // Beside a vortex the lift is not the circulation alone.
  const says = state.vortices.length ? " around what is in the wind" : `: ${way}, in air at 1 m/s`;
  element("reading").textContent = `Circulation ${signed(total)} m²/s${says}. The fluid rests at the yellow points.`;
  const slider = /** @type {HTMLInputElement} */ (element("circulation"));
  if (state.kutta && wind.canLeave) slider.value = String(total / wind.circulation.length);
  /** @type {HTMLButtonElement} */ (element("kutta")).disabled = !wind.canLeave;
  slider.disabled = state.kutta && wind.canLeave;
  element("angle-value").textContent = `${signed(state.angle, 1)}°`;
  element("circulation-value").textContent = signed(Number(slider.value));
}

/** @param {number} value @param {number} [digits] */
const signed = (value, digits = 2) => value.toFixed(digits).replace("-", "−");

function showFigures() {
  if (!basis) return;
  const { estimate, unknowns, ms } = basis;
  showEvidence([
    ["Error, at most", power(estimate), "of the potential, in units of the wind times the body’s size"],
    ["Unknowns", String(unknowns), "densities on the walls, for every wind at once"],
    ["Computed in", `${ms.toFixed(0)} ms`, "all flows past these bodies; each turn of the wind adds them up anew"],
    ["Points", FINE.pixels.join(" × "), "where the stream function was computed; velocities are its differences"],
  ]);
}

function remember() {
  history.replaceState(null, "", `#${writeState(state)}`);
}

/** @param {Partial<typeof state>} change @param {boolean} [anew] whether the bodies are others */
function change(change, anew = false) {
  state = { ...state, ...change };
  if (change.own || change.body) state.vortices = remaining(state.vortices, shownBodies().outlines);
  if (chosen !== null && chosen >= state.vortices.length) chosen = null;
  remember();
  controls();
  if (anew) solve();
  else turn();
}

function controls() {
  lastOwn = state.own ?? lastOwn;
  ownOption.hidden = !lastOwn;
  press("kutta", state.kutta);
  for (const name of /** @type {const} */ (["pressure", "lines", "specks"])) press(name, state[name]);
  /** @type {HTMLSelectElement} */ (element("body")).value = state.own ? "own" : state.body;
  /** @type {HTMLInputElement} */ (element("angle")).value = String(state.angle);
  if (!state.kutta) /** @type {HTMLInputElement} */ (element("circulation")).value = String(state.circulation);
  document.body.dataset.mode = stroke ? "draw" : "edit";
  press("draw", stroke !== null);
}

// Controls

const select = /** @type {HTMLSelectElement} */ (element("body"));
select.append(...[...ready].map(([name, { title }]) => new Option(title, name)));
const ownOption = Object.assign(new Option("Your own", "own"), { hidden: true });
select.append(ownOption);
select.addEventListener("change", () => {
  stroke = null;
  if (select.value === "own") return change({ own: lastOwn, kutta: true }, true);
  change({ body: select.value, own: null, kutta: ready.get(select.value)?.trailing !== null }, true);
});
element("angle").addEventListener("input", (event) => change({ angle: /** @type {HTMLInputElement} */ (event.target).valueAsNumber }));
element("circulation").addEventListener("input", (event) => change({ circulation: /** @type {HTMLInputElement} */ (event.target).valueAsNumber }));
element("kutta").addEventListener("click", () => change({ kutta: !state.kutta, circulation: /** @type {HTMLInputElement} */ (element("circulation")).valueAsNumber }));
for (const name of /** @type {const} */ (["pressure", "lines", "specks"])) element(name).addEventListener("click", () => change({ [name]: !state[name] }));
element("vortex").addEventListener("click", () => {
  const vortices = withOne(state.vortices, shownBodies().outlines);
  if (!vortices) return remark("There is no room for another vortex: drag one away, or remove one with Delete.");
  chosen = vortices.length - 1;
  change({ vortices }, true);
});
window.addEventListener("keydown", (event) => {
  const { vortices } = state;
  const isTaken = event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey;
  if (isTaken || !vortices.length || (event.target instanceof Element && event.target.matches("input, select, textarea, [role=menu] *"))) return;
  const step = ARROWS.get(event.key);
  if (event.key.toLowerCase() === "v") {
    chosen = chosen === null ? 0 : (chosen + 1) % vortices.length;
    draw();
  } else if (chosen === null) return;
  else if (["Delete", "Backspace"].includes(event.key)) remove(chosen);
  else if (event.key === "-") turnOver(chosen);
  else if (step) move(chosen, [0, 1].map((k) => vortices[/** @type {number} */ (chosen)].at[k] + KEY_STEP * step[k]));
  else return;
  event.preventDefault();
});
/** @param {number} vortex @param {number[]} to */
function move(vortex, to) {
  const vortices = moved(state.vortices, vortex, /** @type {Point} */ (to), shownBodies().outlines);
  if (vortices) change({ vortices }, true);
}
/** @param {number} vortex */
function turnOver(vortex) {
  change({ vortices: state.vortices.map((each, k) => (k === vortex ? { ...each, circulation: -each.circulation } : each)) }, true);
}
/** @param {number} vortex */
function remove(vortex) {
  chosen = null;
  change({ vortices: state.vortices.filter((_, k) => k !== vortex) }, true);
}
canvas.addEventListener("dblclick", (event) => {
  const touched = nearest(state.vortices, pointAt(event), grasp());
  if (touched !== null && !stroke) turnOver(touched);
});
offerScene({ name: "flow", drawing: "streamlines and bodies", canvas, view, address: () => writeState(state) });
offerAlone(draw);
goAlong(() => ({}));
window.addEventListener("hashchange", () => {
  const { state: next, wrong: words } = readState(location.hash);
  remark(words);
  stroke = null;
  state = next;
  controls();
  solve();
});
element("open").addEventListener("click", () => /** @type {HTMLElement} */ (element("file")).click());
element("file").addEventListener("change", async () => {
  const input = /** @type {HTMLInputElement} */ (element("file"));
  const [file] = input.files ?? [];
  input.value = "";
  if (file) take(await file.text(), file.name);
});
window.addEventListener("dragover", (event) => event.preventDefault());
window.addEventListener("drop", async (event) => {
  event.preventDefault();
  const [file] = event.dataTransfer?.files ?? [];
  if (file) take(await file.text(), file.name);
});
window.addEventListener("paste", (event) => {
  const text = event.clipboardData?.getData("text/plain");
  if (text?.trim()) take(text, "What you pasted");
});

/** A body from a text. @param {string} text @param {string} name */
function take(text, name) {
  if (isState(text)) return attempt(openState(text, name), () => {});
  attempt(courier.ask("outline", { what: "outline", text }), (found) => {
    if (!found) return;
    own(name, placed(found.outline));
    tell(found.said);
  });
}

/** @param {string} title @param {Point[]} outline */
function own(title, outline) {
  stroke = null;
  change({ own: bodyOf(title, outline), kutta: true }, true);
}

// Drawing a body, turning the wind

element("draw").addEventListener("click", () => {
  stroke = stroke ? null : [];
  controls();
  draw();
});

/** How near a vortex the pointer grasps it, in the plane. */
const grasp = () => 16 / scaleOf({ ...PLANE, pixels: [canvas.clientWidth, canvas.clientHeight] });

/** @param {MouseEvent} event */
function pointAt(event) {
  const { width, height } = canvas.getBoundingClientRect();
  return toPlane({ ...PLANE, pixels: [width, height] }, pixelOf(canvas, event));
}

/** The wind's angle when a drag began, and where that was: up and to the right it rises. @type {{ angle: number, at: number } | null} */
let turning = null;
/** The vortex that follows the pointer. @type {number | null} */
let dragged = null;

canvas.addEventListener("pointerdown", (event) => {
  if (event.button !== 0) return;
  canvas.setPointerCapture(event.pointerId);
  if (stroke) {
    stroke = [pointAt(event)];
    return;
  }
  const before = chosen;
  chosen = nearest(state.vortices, pointAt(event), grasp());
  dragged = chosen;
  if (chosen !== before) draw();
  if (chosen === null) turning = { angle: state.angle, at: event.clientX - event.clientY };
});
canvas.addEventListener("pointermove", (event) => {
  if (!canvas.hasPointerCapture(event.pointerId)) return;
  if (stroke) {
    stroke.push(pointAt(event));
    draw();
  } else if (dragged !== null) {
    move(dragged, pointAt(event));
  } else if (turning) {
    const angle = Math.max(-30, Math.min(30, turning.angle + (event.clientX - event.clientY - turning.at) * 0.1));
    change({ angle: Math.round(angle * 10) / 10 });
  }
});
canvas.addEventListener("pointerup", (event) => {
  turning = null;
  if (dragged !== null && document.elementFromPoint(event.clientX, event.clientY) !== canvas) remove(dragged);
  dragged = null;
  if (!stroke || stroke.length < 3) return;
  const outline = simplify(stroke, 0.015).slice(0, 200);
  stroke = [];
  if (outline.length < 3 || crossingEdges(outline).size) {
    remark("The outline crosses itself: draw it again in one stroke that ends where it began.");
    return draw();
  }
  own("Your own", outline);
});
onEscape(() => {
  if (!stroke) return false;
  stroke = null;
  controls();
  draw();
  return true;
});

// Time

/** Where nothing is to move by itself, specks have gone this far, in seconds, once and for all. */
const [STILL_STEPS, STILL_STEP] = [14, 1 / 40];
let last = 0;
/** @param {number} now */
function frame(now) {
  requestAnimationFrame(frame);
  if (!wind || !state.specks || stroke || document.hidden) return;
  const count = Math.round(Math.min(260, Math.max(60, canvas.clientWidth / 4)));
  if (isStill()) {
    if (particles.specks.length === count) return;
    for (let step = 0; step < STILL_STEPS; step++) particles.step(wind, STILL_STEP, count);
  } else particles.step(wind, Math.min(0.05, (now - last) / 1000), count);
  last = now;
  draw();
}
requestAnimationFrame(frame);
new ResizeObserver(draw).observe(canvas);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", turn);
controls();
solve();
