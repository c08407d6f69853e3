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
export function encode({ image, region }, shown) {
  const layers = Object.entries(shown).flatMap(([name, on]) => (on ? [name] : []));
  const fields = [
    ["image", image],
    ["region", write(region.boundary)],
    ["center", write([region.center])],
    ["toward", write([towardPoint(region)])],
  ];
  if (layers.length) fields.push(["show", layers.join(",")]);
  return fields.map(([key, value]) => `${key}=${value}`).join("&");
}

/** What an address says; what it leaves out, or garbles, is left out. @param {string} hash @returns {Address} */
export function decode(hash) {
  const fields = new URLSearchParams(hash.replace(/^#/, ""));
  const layers = (fields.get("show") ?? "").split(",");
  const outline = read(fields.get("region"));
  const [center] = read(fields.get("center"));
  const [toward] = read(fields.get("toward"));
  return {
    image: fields.get("image") ?? undefined,
    shape: fields.get("shape") ?? undefined,
    region: outline.length >= 3 ? makeRegion(outline, center, toward) : undefined,
    shown: fields.has("region") || fields.has("show") ? { mesh: layers.includes("mesh"), grid: layers.includes("grid") } : undefined,
  };
}
