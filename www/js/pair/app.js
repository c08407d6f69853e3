// The page that maps one region to another: two sides, one scheduler, the picture of the first in the second.

import { acceptFiles } from "../common/files.js";
import { element, mark, say, sayBroken, saveCanvas, showEvidence, showProgress } from "../common/page.js";
import { photos } from "../common/photos.js";
import { Probe } from "../common/probe.js";
import { Scheduler } from "../common/scheduler.js";
import { failureWords, pairRows, readingWords } from "../editor/evidence.js";
import { Locator } from "../editor/locate.js";
import { meshEdges } from "../editor/overlay.js";
import { photoRegion } from "../editor/presets.js";
import { decode, encodeDocument } from "../editor/url.js";
import { firstFrom, firstTo } from "./first.js";
import { Side } from "./side.js";

/** @typedef {import("./pipeline.js").Job} Job */
/** @typedef {import("./pipeline.js").Result} Result */
/** @typedef {import("../editor/store.js").Document} Document */

/** How dark the first photo is outside its region; the second one is not, so that the two make one picture. */
const DIM = 0.42;

/** What is drawn from the last good result. @type {{ result: Result, edges: Uint32Array, locator: Locator, picture: HTMLCanvasElement } | null} */
let outcome = null;
let showMesh = new URLSearchParams(location.hash.slice(1)).get("show") === "mesh";
/** The side that was edited last: Ctrl Z acts on it. @type {Side} */
let active;

const from = await Side.open("from", documentAt("a.", firstFrom));
const to = await Side.open("to", documentAt("b.", firstTo));
active = from;

/** @type {Scheduler<Job, Result>} */
const scheduler = new Scheduler(new URL("./worker.js", import.meta.url), {
  onResult,
  onFailure: (failure) => say(failureWords(failure, outcome !== null), "invalid"),
  onProgress: showProgress,
  onBroken: sayBroken,
});
const probe = new Probe(from.view, to.view, () => outcome?.locator ?? null, (reading) => {
  element("reading").textContent = readingWords(reading);
});

for (const side of [from, to]) side.store.subscribe((change) => onChange(side, change));
connectControls();
new ResizeObserver(() => refresh(true)).observe(element("panels"));
refresh(true);

/** @param {string} prefix of this side's fields @param {Document} usual @returns {Document} */
function documentAt(prefix, usual) {
  const { image, region } = decode(location.hash, prefix);
  const id = image && image in photos ? image : usual.image;
  return { image: id, region: region ?? (id === usual.image ? usual.region : photoRegion(id)) };
}

/** @param {Side} side @param {import("../editor/store.js").Change} change */
async function onChange(side, change) {
  active = side;
  await side.follow();
  refresh(change === "drag" || change === "commit", change === "drag");
}

/** Draws the page, and computes it anew if asked to. @param {boolean} solving @param {boolean} [dragging] */
function refresh(solving, dragging = false) {
  layOut();
  draw();
  if (solving) solve(dragging);
  if (!dragging) history.replaceState(null, "", `#${address()}`);
}

function address() {
  const sides = [encodeDocument(from.store.doc, "a."), encodeDocument(to.store.doc, "b.")];
  return [...sides, ...(showMesh ? ["show=mesh"] : [])].join("&");
}

/** @param {boolean} dragging */
function solve(dragging) {
  probe.hide();
  if (document.body.dataset.state !== "loading") mark("working");
  const [a, b] = [from.outline, to.outline];
  scheduler.run(
    ({ tolerance, maxErrorPixels, sharpness }) => ({ from: a, to: b, tolerance, maxErrorPixels, view: to.frame(sharpness) }),
    from.picture,
    dragging,
  );
}

function layOut() {
  for (const [side, name] of /** @type {[Side, string][]} */ ([[from, "--aspect"], [to, "--other-aspect"]])) {
    const [width, height] = side.picture.frame.pixels;
    element("panels").style.setProperty(name, String(width / height));
  }
  for (const side of [from, to]) side.view.fit(side.picture);
}

function draw() {
  const mesh = outcome?.result.mesh;
  const edges = outcome?.edges;
  const meshed = showMesh && mesh && edges;
  from.draw({ dim: DIM, mesh: meshed ? { points: mesh.source, edges } : undefined });
  to.draw({ dim: 0, inside: outcome?.picture, mesh: meshed ? { points: mesh.target, edges } : undefined });
  element("mesh").setAttribute("aria-pressed", String(showMesh));
}

/** @param {Result} result @param {boolean} done */
function onResult(result, done) {
  const [width, height] = result.view.pixels;
  const picture = Object.assign(document.createElement("canvas"), { width, height });
  picture.getContext("2d")?.putImageData(new ImageData(result.pixels, width, height), 0, 0);
  outcome = { result, edges: meshEdges(result.mesh.triangles), locator: new Locator(result.mesh), picture };
  draw();
  say("", done ? "ready" : "draft");
  if (done) showEvidence(pairRows(result.evidence));
}

function connectControls() {
  element("mesh").onclick = () => {
    showMesh = !showMesh;
    refresh(false);
  };
  element("bare").onclick = () => {
    const bare = element("bare").getAttribute("aria-pressed") !== "true";
    element("bare").setAttribute("aria-pressed", String(bare));
    document.body.classList.toggle("bare", bare);
  };
  element("swap").onclick = async () => {
    const [a, b] = [from.store.doc, to.store.doc];
    await from.visit(b);
    await to.visit(a);
  };
  element("save").onclick = () => saveCanvas(element("to-photo"), "regions.png");
  const file = /** @type {HTMLInputElement} */ (element("file"));
  for (const [name, side] of /** @type {[string, Side][]} */ ([["from", from], ["to", to]])) {
    element(`${name}-open`).onclick = () => {
      active = side;
      file.click();
    };
    element(`${name}-stage`).addEventListener("dragover", () => (active = side));
  }
  acceptFiles(file, element("panels"), (chosen) =>
    active.openFile(chosen).catch((error) => say(error instanceof Error ? error.message : String(error), "invalid")),
  );
  window.addEventListener("hashchange", async () => {
    await from.visit(documentAt("a.", firstFrom));
    await to.visit(documentAt("b.", firstTo));
  });
  window.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || event.key.toLowerCase() !== "z") return;
    if (event.shiftKey) active.store.redo();
    else active.store.undo();
    event.preventDefault();
  });
}
