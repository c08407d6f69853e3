// The page of electric fields: conductors, and the potentials that a visitor gives them.

import { conductors as ready } from "./conductors.js";
import { ElectricView } from "./view.js";
import { oneOf, readAddress, wrongWords } from "../common/address.js";
import { offerAlone } from "../common/alone.js";
import { goAlong } from "../common/along.js";
import { Courier } from "../common/courier.js";
import { onGrid, toPlane } from "../common/frame.js";
import { element, press, remark, showEvidence, statusOfPage, watchErrors } from "../common/page.js";
import { pixelOf } from "../common/svg.js";
import { power } from "../editor/evidence.js";
import { contains } from "../editor/geometry.js";
import { GridField, placeOf } from "../flow/grid-field.js";
import { offerScene } from "../flow/save-scene.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./answers.js").Answer} Answer */
/** @typedef {import("../common/frame.js").Frame} Frame */

watchErrors();
const courier = new Courier(new URL("worker.js", import.meta.url));
const canvas = /** @type {HTMLCanvasElement} */ (element("field"));
const view = new ElectricView(canvas);
/** @type {import("./view.js").Shown} */
let shown = { potential: true, levels: true, lines: true };

/** @type {Frame} */
const GRID = { center: [0, 0], width: 6, pixels: [180, 108] };
/** ε₀ in picofarads a metre. */
const EPSILON = 8.854187817;
/** Volts that a press on a conductor gives it in turn. */
const NEXT = new Map([[1, -1], [-1, 0], [0, 1]]);

const SCHEMA = {
  set: oneOf(ready.keys()),
  /** @param {string} text */
  volts: (text) => {
    const volts = text.split(",").map(Number);
    if (!volts.every((volt) => [-1, 0, 1].includes(volt))) throw new Error("must be made of −1, 0 and 1");
    return volts;
  },
};

let set = "pair";
/** @type {number[]} */
let potentials = [];
/** @type {{ field: GridField, answer: Answer } | null} */
let solved = null;

function chosen() {
  return /** @type {import("./conductors.js").Conductors} */ (ready.get(set));
}

/** The conductors as they are drawn; a shield comes first, as its potential does. @returns {import("./view.js").Drawn[]} */
function drawn() {
  const { shield, outlines } = chosen();
  return [...(shield ? [shield] : []), ...outlines].map((outline, k) => ({ outline, potential: potentials[k], around: shield !== undefined && k === 0 }));
}

/** Takes what the address says. */
function read() {
  const { values, wrong } = readAddress(location.hash, SCHEMA);
  set = values.set ?? "pair";
  potentials = values.volts?.length === chosen().potentials.length ? values.volts : chosen().potentials;
  remark(wrongWords(wrong));
}

function solve() {
  statusOfPage.onState(solved ? "working" : "loading");
  statusOfPage.onProgress("begun");
  courier.ask("field", { conductors: chosen(), potentials, grid: GRID }).then(
    (/** @type {Answer | null} */ answer) => {
      if (!answer) return;
      const field = new GridField(GRID, answer.potential);
      field.fill((k) => potentialAt(placeOf(GRID, k)));
      solved = { field, answer };
      view.prepare(field, answer, Math.max(...potentials.map(Math.abs)));
      draw();
      tell(answer);
      statusOfPage.onState("ready", "");
      statusOfPage.onProgress(null);
    },
    (error) => {
      statusOfPage.onProgress(null);
      statusOfPage.onState(solved ? "ready" : "invalid", error.message);
    },
  );
}

/** The potential of the conductor that a place lies in. @param {Point} place */
function potentialAt(place) {
  const within = drawn().find(({ outline, around }) => !around && contains(outline, place));
  return within?.potential ?? (chosen().shield ? potentials[0] : 0);
}

function draw() {
  if (solved) view.draw(solved.field, drawn(), shown);
}

/** @param {number} value */
const signed = (value) => value.toFixed(1).replace("-", "−");

/** What is read off the field. @param {Answer} answer */
function tell({ charges, capacitance, impedance, estimate, unknowns }) {
  const count = charges.length;
  const each = charges.map((charge, k) => `${k + 1}: ${signed(EPSILON * charge)}`).join(", ");
  element("reading").textContent = `Charges in picocoulombs a metre: ${each}. Press a conductor to change its potential.`;
  const own = EPSILON * capacitance[count + 1];
  showEvidence([
    ...(impedance === undefined
      ? /** @type {[string, string, string][]} */ ([["Capacitance", `${own.toFixed(2)} pF/m`, "of the second conductor against all others: an entry of Maxwell’s matrix"]])
      : /** @type {[string, string, string][]} */ ([
          ["Capacitance", `${own.toFixed(2)} pF/m`, "between both conductors, in vacuum"],
          ["As a line", `${impedance.toFixed(1)} Ω`, "the wave impedance of both conductors in vacuum"],
        ])),
    ["Error, at most", power(estimate), "of the potentials that unit charges give"],
    ["Unknowns", String(unknowns), "densities of charge on the walls"],
  ]);
}

function controls() {
  /** @type {HTMLSelectElement} */ (element("set")).value = set;
  for (const name of /** @type {const} */ (["potential", "levels", "lines"])) press(name, shown[name]);
}

const address = () => `set=${set}&volts=${potentials.join(",")}`;

function change() {
  history.replaceState(null, "", `#${address()}`);
  controls();
  solve();
}

const select = /** @type {HTMLSelectElement} */ (element("set"));
select.append(...[...ready].map(([name, { title }]) => new Option(title, name)));
select.addEventListener("change", () => {
  set = select.value;
  ({ potentials } = chosen());
  change();
});
for (const name of /** @type {const} */ (["potential", "levels", "lines"])) {
  element(name).addEventListener("click", () => {
    shown = { ...shown, [name]: !shown[name] };
    controls();
    draw();
  });
}
offerScene({ name: "field", drawing: "lines of force, equal potentials and conductors", canvas, view, address });
offerAlone(draw);
goAlong(() => ({}));
window.addEventListener("hashchange", () => {
  read();
  controls();
  solve();
});

/** Gives a conductor the next potential; not all of them the same. @param {number} k */
function charge(k) {
  const next = potentials.map((volt, j) => (j === k ? /** @type {number} */ (NEXT.get(volt)) : volt));
  if (new Set(next).size === 1) next[k] = /** @type {number} */ (NEXT.get(next[k]));
  potentials = next;
  change();
}

canvas.addEventListener("click", (event) => {
  const { width, height } = canvas.getBoundingClientRect();
  const at = toPlane(onGrid(GRID, [width, height]), pixelOf(canvas, event));
  const all = drawn();
  const hit = all.findIndex(({ outline, around }) => !around && contains(outline, at));
  const shield = all.findIndex(({ outline, around }) => around && !contains(outline, at));
  if (hit >= 0 || shield >= 0) charge(hit >= 0 ? hit : shield);
});
// By keys: the digit of a conductor.
window.addEventListener("keydown", (event) => {
  const k = Number(event.key) - 1;
  const typing = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement;
  if (!typing && !event.ctrlKey && !event.metaKey && !event.altKey && k >= 0 && k < potentials.length) charge(k);
});
new ResizeObserver(draw).observe(canvas);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", solve);
read();
controls();
solve();
