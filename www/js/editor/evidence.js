// What was computed and how well, in plain words.

/** Of a picture made through a mesh. @typedef {{ errorEstimate: number, unknowns: number, nodes: number, triangles: number, flipped: number, solveMs: number, meshMs: number, warpMs: number }} PairEvidence */
/** @typedef {PairEvidence & { conformalRadius: number }} DiskEvidence */

/** @param {number} n */
const whole = (n) => n.toLocaleString("en", { maximumFractionDigits: 0 });

/** @param {number} ms */
const time = (ms) => (ms < 1 ? "under 1 ms" : ms < 1000 ? `${whole(ms)} ms` : `${(ms / 1000).toFixed(1)} s`);

const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** 3.2e-9 → “3 × 10⁻⁹”. @param {number} x */
export function power(x) {
  if (!(x > 0)) return "0";
  const [digit, exponent] = x.toExponential(0).split("e").map(Number);
  const raised = String(Math.abs(exponent)).replace(/\d/g, (d) => SUPERSCRIPTS[Number(d)]);
  return `${digit} × 10${exponent < 0 ? "⁻" : ""}${raised}`;
}

/**
 * The rows of the evidence: name, value, what it means.
 * @param {DiskEvidence} evidence @returns {[string, string, string][]}
 */
export function rows(evidence) {
  const { errorEstimate, unknowns, conformalRadius, nodes, triangles, flipped, solveMs, meshMs, warpMs } = evidence;
  return [
    ["Estimated error", power(errorEstimate), "largest, of any point’s place on the disk of radius 1"],
    ["Unknowns", whole(unknowns), `numbers solved for, in ${time(solveMs)}`],
    ["Conformal radius", conformalRadius.toFixed(4), "of the region seen from its center; the photo’s longer side is 2"],
    trianglesRow(triangles, nodes, meshMs),
    flippedRow(flipped),
    pictureRow(warpMs),
  ];
}

/**
 * The same of a map from region to region.
 * @param {PairEvidence} evidence @returns {[string, string, string][]}
 */
export function pairRows({ errorEstimate, unknowns, nodes, triangles, flipped, solveMs, meshMs, warpMs }) {
  return [
    ["Estimated error", power(errorEstimate), "the larger of the two maps to the disk of radius 1"],
    ["Unknowns", whole(unknowns), `for both regions, in ${time(solveMs)}`],
    trianglesRow(triangles, nodes, meshMs),
    flippedRow(flipped),
    pictureRow(warpMs),
  ];
}

/** @param {number} triangles @param {number} nodes @param {number} ms @returns {[string, string, string]} */
const trianglesRow = (triangles, nodes, ms) => ["Triangles", whole(triangles), `over ${whole(nodes)} points, made in ${time(ms)}`];

/** @param {number} flipped @returns {[string, string, string]} */
function flippedRow(flipped) {
  return ["Turned over", flipped ? whole(flipped) : "none", flipped ? "triangles; the picture is folded there" : "no triangle is flipped: no fold"];
}

/** @param {number} ms @returns {[string, string, string]} */
const pictureRow = (ms) => ["Picture", time(ms), "to draw, filtered so that nothing flickers"];

/** What the map does under the pointer. @param {import("../common/probe.js").Reading | null} reading */
export function readingWords(reading) {
  if (!reading) return "Point at either picture: the little circle stays a circle, and its cross stays square.";
  const { stretch, turn } = reading;
  const size = stretch >= 1 ? `enlarged ${stretch.toFixed(1)} times` : `shrunk ${(1 / stretch).toFixed(1)} times`;
  const angle = Math.round(Math.abs(turn));
  const way = turn > 0 ? "to the left" : "to the right";
  return `Here the photo is ${size} and turned ${angle}°${angle ? ` ${way}` : ""}.`;
}

/** What to do about an error, by its code. @type {Record<string, string>} */
const REMEDIES = {
  "self-intersecting": "Drag a point until the red edges no longer cross.",
  "center-outside": "Drag the round end of the vector back inside the outline.",
  "too-few-vertices": "Add a point, or draw a new region.",
  crashed: "The computation broke down; change the region a little.",
};

/** @param {import("../common/serve.js").Failure} failure @param {boolean} kept whether an earlier picture is still shown */
export function failureWords({ code, message }, kept) {
  return [message, REMEDIES[code] ?? "", kept ? "The picture stays as it was until then." : ""].join(" ");
}
