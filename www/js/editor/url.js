// The state in the address, after the #: a link is a drawing.

import { makeRegion, towardPoint } from "./region.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./region.js").Region} Region */
/** @typedef {import("./store.js").Shown} Shown */
/** @typedef {{ image?: string, shape?: string, region?: Region, shown?: Shown }} Address */

/** A ten-thousandth of half the photo is finer than a screen's pixel. @param {number} x */
const short = (x) => String(Number(x.toFixed(4)));

/** @param {Point[]} points */
const write = (points) => points.map((p) => p.map(short).join(",")).join(";");

/** @param {string | null} text @returns {Point[]} */
function read(text) {
  const points = (text ?? "").split(";").map((pair) => pair.split(",").map(Number));
  return /** @type {Point[]} */ (points.filter((p) => p.length === 2 && p.every(Number.isFinite)));
}

/** @param {import("./store.js").Document} doc @param {Shown} shown @returns {string} the hash, without # */
export function encode(doc, shown) {
  const layers = Object.entries(shown).flatMap(([name, on]) => (on ? [name] : []));
  return encodeDocument(doc, "") + (layers.length ? `&show=${layers.join(",")}` : "");
}

/** @param {import("./store.js").Document} doc @param {string} prefix of the fields' names */
export function encodeDocument({ image, region }, prefix) {
  const fields = [
    ["image", image],
    ["region", write(region.boundary)],
    ["center", write([region.center])],
    ["toward", write([towardPoint(region)])],
  ];
  return fields.map(([key, value]) => `${prefix}${key}=${value}`).join("&");
}

/** What an address says; what it leaves out, or garbles, is left out. @param {string} hash @param {string} [prefix] @returns {Address} */
export function decode(hash, prefix = "") {
  const fields = new URLSearchParams(hash.replace(/^#/, ""));
  /** @param {string} name */
  const field = (name) => fields.get(prefix + name);
  const layers = (fields.get("show") ?? "").split(",");
  const outline = read(field("region"));
  const [center] = read(field("center"));
  const [toward] = read(field("toward"));
  const told = field("region") !== null || fields.has("show");
  return {
    image: field("image") ?? undefined,
    shape: field("shape") ?? undefined,
    region: outline.length >= 3 ? makeRegion(outline, center, toward) : undefined,
    shown: told ? { mesh: layers.includes("mesh"), grid: layers.includes("grid") } : undefined,
  };
}
