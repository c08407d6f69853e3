// What was computed and how well, in plain words.

import { readingWords } from "../common/probe.js";

/** Of a picture made through a mesh. @typedef {{ errorEstimate: number, unknowns: number, nodes: number, triangles: number, flipped: number, solveMs: number, meshMs: number, warpMs: number }} PairEvidence */
/** @typedef {PairEvidence & { conformalRadius: number }} DiskEvidence */
/** Of a region with holes: `facts` are its own rows. @typedef {{ errorEstimate: number, unknowns?: number, facts: [string, string, string][], solveMs: number, warpMs: number }} HoledEvidence */

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
 * @param {DiskEvidence | HoledEvidence} evidence @returns {[string, string, string][]}
 */
export function rows(evidence) {
  if ("facts" in evidence) return holedRows(evidence);
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

/** @param {HoledEvidence} evidence @returns {[string, string, string][]} */
function holedRows({ errorEstimate, unknowns, facts, solveMs, warpMs }) {
  return [
    ["Estimated error", power(errorEstimate), "largest, of any point’s place beside the disk of radius 1"],
    unknowns ? ["Unknowns", whole(unknowns), `numbers solved for, on all outlines together, in ${time(solveMs)}`] : ["Solved in", time(solveMs), "in rounds, until every hole is round"],
    ...facts,
    pictureRow(warpMs),
  ];
}

/**
 * The same of a map from region to region.
 * @param {PairEvidence | HoledEvidence} evidence @returns {[string, string, string][]}
 */
export function pairRows(evidence) {
  if ("facts" in evidence) return holedRows(evidence);
  const { errorEstimate, unknowns, nodes, triangles, flipped, solveMs, meshMs, warpMs } = evidence;
  return [
    ["Estimated error", power(errorEstimate), "the larger of the two maps to the disk of radius 1"],
    ["Unknowns", whole(unknowns), `for both regions, in ${time(solveMs)}`],
    ...(triangles ? [trianglesRow(triangles, nodes, meshMs), flippedRow(flipped)] : [POINT_BY_POINT]),
    pictureRow(warpMs),
  ];
}

/** @type {[string, string, string]} */
const POINT_BY_POINT = ["Triangles", "none", "these maps crowd a mesh too closely: the picture is drawn point by point, by both maps themselves"];

/** @param {number} triangles @param {number} nodes @param {number} ms @returns {[string, string, string]} */
const trianglesRow = (triangles, nodes, ms) => ["Triangles", whole(triangles), `over ${whole(nodes)} points, made in ${time(ms)}`];

/** @param {number} flipped @returns {[string, string, string]} */
function flippedRow(flipped) {
  return ["Turned over", flipped ? whole(flipped) : "none", flipped ? "triangles; the picture is folded there" : "no triangle is flipped: no fold"];
}

/** @param {number} ms @returns {[string, string, string]} */
const pictureRow = (ms) => ["Picture", time(ms), "to draw, filtered so that nothing flickers"];

/** What the pointer sees. @param {import("../common/probe.js").Reading | null} reading @param {number} [dilatation] how much longer than wide the map makes small circles */
export function probeWords(reading, dilatation = 1) {
  if (dilatation === 1) return reading ? readingWords(reading, "photo") : "Point at either picture: the little circle stays a circle, and its cross stays square.";
  if (reading) return `Here the photo is stretched ${reading.most.toFixed(2)} times one way and ${reading.least.toFixed(2)} times across it: angles are not kept.`;
  return `Angles are not kept: the two rings differ, and every little circle becomes an ellipse ${dilatation.toFixed(2)} times as long as wide.`;
}

/** What is wrong and what to do, by the error's code. @type {Map<string, string>} */
const WORDS = new Map([
  ["self-intersecting", "These two red edges cross or touch. Drag a point until they no longer do, press Repair outline, or undo."],
  ["center-outside", "The round end of the vector lies outside the outline. Drag it back inside."],
  ["cusp", "The outline turns back on itself in a point, and the gap there is outside. Drag the points or handles beside it apart."],
  ["holes-meet", "A hole meets another outline, at the red edges. Drag one of them away, or undo."],
  ["hole-outside", "A hole does not lie inside the outline. Drag it in, remove it, or undo."],
  ["too-few-vertices", "Fewer than three corners are apart from each other. Drag them apart, or draw a new region."],
  ["negative-mass", "No trustworthy map was found: part of the outline is too far out of the centre’s sight. Drag the round end of the vector nearer to it, or make the narrow places wider."],
  ["crowded", "Parts of the outline are too far out of the centre’s sight for a mesh. Drag the round end of the vector nearer to them."],
  ["too-far-apart", "These regions are too far apart: far ends would come together in directions that nobody can tell. Drag the vectors’ ends into the parts that should."],
  ["crashed", "The computation broke down and was started anew. Change the region a little."],
]);

/** What is shown meanwhile. */
const KEPT = { draft: "The picture is a coarse one.", older: "The picture stays as it was until then.", nothing: "" };

/** @param {import("../common/serve.js").Failure} failure @param {keyof typeof KEPT} shown */
export function failureWords({ code, message }, shown) {
  return [WORDS.get(code) ?? message, KEPT[shown]].join(" ").trim();
}
