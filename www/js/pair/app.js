// The page that maps one region to another: two sides, one scheduler, the picture of the first in the second.

import { readAddress, wrongWords } from "../common/address.js";
import { offerAlone } from "../common/alone.js";
import { goAlong } from "../common/along.js";
import { acceptFiles } from "../common/files.js";
import { onGrid } from "../common/frame.js";
import { newStep, redoNext, undoLast } from "../common/history.js";
import { onUndoKeys } from "../common/keys.js";
import { element, press, remark, showEvidence, statusOfPage, watchErrors } from "../common/page.js";
import { Probe } from "../common/probe.js";
import { menuOf } from "../common/menu.js";
import { probeRow } from "../common/probe-menu.js";
import { offerToSave } from "../common/save-menu.js";
import { careFor, Scheduler } from "../common/scheduler.js";
import { documentOf } from "../editor/document.js";
import { offerEdges } from "../editor/edge-menu.js";
import { failureWords, pairRows, probeWords } from "../editor/evidence.js";
import { OutlineReader } from "../editor/outline-dialog.js";
import { looksLikeOutline } from "../editor/outline-text.js";
import { letterDialog } from "../editor/letter-dialog.js";
import { frameOf, LETTER } from "../editor/presets.js";
import { wishesOf } from "../editor/overlays.js";
import { showMenu } from "../editor/show-menu.js";
import { drawingFields, drawingSchema, encodeDrawing, encodeShown, shownOf, shownSchema } from "../editor/url.js";
import { firstFrom, firstTo } from "./first.js";
import { Outcome } from "./outcome.js";
import { Side } from "./side.js";

/** @typedef {import("./pipeline.js").Job} Job */
/** @typedef {import("./pipeline.js").Result} Result */

/** How dark the first photo is outside its region; the second one is not, so that the two make one picture. */
const DIM = 0.42;

/** The fields of the address: those of a drawing for each side. */
const schema = {
  .../** @type {{ [K in keyof typeof drawingSchema as `a.${K}`]: typeof drawingSchema[K] }} */ (prefixed("a.")),
  .../** @type {{ [K in keyof typeof drawingSchema as `b.${K}`]: typeof drawingSchema[K] }} */ (prefixed("b.")),
  ...shownSchema,
};

watchErrors();
/** What is drawn from the last good result. @type {Outcome | null} */
let outcome = null;
/** The side that was edited last: a file goes there. @type {Side} */
let active;
/** The pictures that the panels have the shapes of. @type {import("../common/images.js").Picture[]} */
let pictures = [];
/** Whether an address is being followed: what could not be read of it is left there. */
let visiting = false;

const first = read(firstFrom, firstTo);
const [from, to] = await Promise.all([Side.open("from", first.from, wishOutline), Side.open("to", first.to, wishOutline)]);
/** Where outlines go. */
const onPhoto = { photo: () => active.picture.frame, use: (/** @type {Parameters<Side["useOutline"]>} */ ...drawn) => active.useOutline(...drawn) };
const outlines = new OutlineReader({ parse: (text) => scheduler.ask({ what: "outline", text }), ...onPhoto });
const askForLetter = letterDialog(onPhoto);
const stores = [from.store, to.store];
/** What is shown over both pictures is kept with the first. */
const keeper = from.store;
keeper.shown = shownOf(first.fields, keeper.shown);
active = from;

const script = new URL("./worker.js", import.meta.url);
/** @type {Scheduler<Job, Result>} */
const scheduler = new Scheduler(script, { ...statusOfPage, onResult, failureWords });
const probe = new Probe(from.view, to.view, () => outcome?.carrier ?? null, (reading) => {
  element("reading").textContent = probeWords(reading, outcome?.dilatation);
});

offerEdges(element("choose-edge"), [from, to]);
const showShown = showMenu(keeper, element("show"));
for (const side of [from, to]) side.store.subscribe((change) => onChange(side, change));
connectControls();
new ResizeObserver(() => refresh(true)).observe(element("panels"));
refresh(true);
if (!first.wrong.length) remember();

/** An outline, or a letter, is asked for, for that side. @param {Side} side @param {string} kind */
function wishOutline(side, kind) {
  active = side;
  if (kind === LETTER) askForLetter();
  else outlines.ask();
}

/** @param {string} prefix */
function prefixed(prefix) {
  return Object.fromEntries(Object.entries(drawingSchema).map(([name, reader]) => [prefix + name, reader]));
}

/** The documents that the address asks for; what it leaves out is as given. @param {import("../editor/store.js").Document} a @param {import("../editor/store.js").Document} b */
function read(a, b) {
  const { values, wrong } = readAddress(location.hash, schema);
  remark(wrongWords(wrong));
  const [left, right] = [values, values].map((all, k) => {
    const prefix = k ? "b." : "a.";
    return Object.fromEntries(Object.entries(all).flatMap(([name, value]) => (name.startsWith(prefix) ? [[name.slice(2), value]] : [])));
  });
  return { from: documentOf(left, a, frameOf), to: documentOf(right, b, frameOf), fields: values, wrong };
}

/** Goes to another address: what it says, and the rest as it is. */
async function visit() {
  const next = read(from.store.doc, to.store.doc);
  const step = newStep();
  visiting = true;
  keeper.show(shownOf(next.fields, keeper.shown));
  if (next.from.region !== from.store.doc.region) await from.visit(next.from, step);
  if (next.to.region !== to.store.doc.region) await to.visit(next.to, step);
  visiting = false;
  refresh(false);
  if (!next.wrong.length) remember();
}

/** @param {Side} side @param {import("../common/history.js").Change} change */
async function onChange(side, change) {
  active = side;
  await side.follow();
  const looking = change === "look" && side === to;
  refresh(change === "drag" || change === "commit" || change === "view" || looking, change === "drag" || looking, change === "drag");
  if (change !== "drag" && change !== "look" && !visiting) remember();
}

/** Draws the page, and computes it anew if asked to. @param {boolean} solving @param {boolean} [dragging] @param {boolean} [still] whether nothing but a region has changed */
function refresh(solving, dragging = false, still = false) {
  // While a hand moves a region the page stays as it is.
  if (!still || pictures.some((picture, k) => picture !== [from, to][k].picture)) layOut();
  draw();
  probe.refresh();
  if (solving) solve(dragging);
}

function remember() {
  history.replaceState(null, "", `#${address()}`);
}

/** The state, as the address has it. */
function address() {
  const sides = [encodeDrawing(from.store.doc, "a."), encodeDrawing(to.store.doc, "b.")];
  return sides.join("&") + encodeShown(keeper.shown);
}

/** @param {boolean} dragging */
function solve(dragging) {
  probe.hide();
  const [a, b, show] = [from.outline, to.outline, wishesOf(keeper.shown, false)];
  scheduler.run(
    ({ tolerance, maxErrorPixels, sharpness }) => ({ from: a, to: b, tolerance, maxErrorPixels, view: to.frame(sharpness), show }),
    from.picture,
    dragging,
  );
}

function layOut() {
  pictures = [from.picture, to.picture];
  for (const [side, name] of /** @type {[Side, string][]} */ ([[from, "--aspect"], [to, "--other-aspect"]])) {
    const [width, height] = side.picture.frame.pixels;
    element("panels").style.setProperty(name, String(width / height));
  }
  for (const side of [from, to]) side.view.fit(side.picture);
}

function draw() {
  const { shown } = keeper;
  from.draw({ dim: DIM, heat: outcome?.heat("source", shown), over: outcome?.layers("source", shown) });
  to.draw({ dim: 0, inside: outcome?.inside, heat: outcome?.heat("target", shown), over: outcome?.layers("target", shown) });
  showShown(from.store.doc.region.holes ? ["mesh", "measure"] : outcome?.mesh === null ? ["mesh"] : []);
}

/** @param {Result} result @param {boolean} done */
function onResult(result, done) {
  const before = outcome?.dilatation;
  outcome = new Outcome(result, { carry: (side, points) => scheduler.ask({ what: "points", side, points }) });
  draw();
  // What is said where nothing is pointed at is about the map too.
  if (before !== outcome.dilatation && !probe.pinned) probe.hide();
  else probe.refresh();
  element("to-words").textContent = outcome.dilatation === 1 ? "filled with the first" : "filled and stretched";
  if (done) showEvidence(pairRows(result.evidence));
}

function connectControls() {
  element("bare").onclick = () => press("bare", document.body.classList.toggle("bare"));
  element("swap").onclick = async () => {
    const [a, b] = [from.store.doc, to.store.doc];
    const step = newStep();
    await from.visit(b, step);
    await to.visit(a, step);
  };
  offerToSave({
    name: "regions",
    script,
    picture: () => from.picture,
    shape: () => to.view.frame.pixels,
    job: (pixels, kind) => {
      const { pixels: under, frame, file } = to.picture;
      return { from: from.outline, to: to.outline, ...careFor(pixels), view: onGrid(to.view.frame, pixels), behind: { pixels: under, frame, file }, show: wishesOf(keeper.shown, kind === "drawing") };
    },
    drawing: "both outlines, their vectors, triangles and grids",
    address,
  });
  menuOf(/** @type {HTMLButtonElement} */ (element("probe")), "The probe", [probeRow(probe, () => ({ side: "source", at: from.store.doc.region.center }))]);
  element("stop").onclick = () => scheduler.stop();
  offerAlone(() => refresh(true));
  const file = /** @type {HTMLInputElement} */ (element("file"));
  for (const [name, side] of /** @type {[string, Side][]} */ ([["from", from], ["to", to]])) {
    element(`${name}-open`).onclick = () => {
      active = side;
      file.click();
    };
    element(`${name}-stage`).addEventListener("dragover", () => (active = side));
    element(`${name}-undo`).onclick = () => undoLast(sharing(side, "lastStep"));
    element(`${name}-redo`).onclick = () => redoNext(sharing(side, "nextStep"));
  }
  acceptFiles(file, element("panels"), (chosen) => active.openFile(chosen), { take: (text, name) => outlines.take(text, name), looksLike: looksLikeOutline });
  goAlong(() => drawingFields(from.store.doc, firstFrom));
  window.addEventListener("hashchange", visit);
  onUndoKeys(
    () => undoLast(stores),
    () => redoNext(stores),
  );
}

/** The histories that take part in a side's next step back or forth. @param {Side} side @param {"lastStep" | "nextStep"} which */
function sharing(side, which) {
  return stores.filter((store) => store === side.store || store[which] === side.store[which]);
}
