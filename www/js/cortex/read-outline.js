// The dialog in which an outline is read from text: JSON, the data of an SVG path, or a whole SVG file.

import { Region } from "../../pkg/index.js";
import { unflatten } from "../common/frame.js";
import { element } from "../common/page.js";

/** @typedef {import("../common/frame.js").Point} Point */

/** @param {(outline: Point[]) => void} use @returns {() => void} opens the dialog */
export function outlineDialog(use) {
  const dialog = /** @type {HTMLDialogElement} */ (element("outline-dialog"));
  const text = /** @type {HTMLTextAreaElement} */ (element("outline-text"));
  const scale = /** @type {HTMLInputElement} */ (element("outline-scale"));
  const file = /** @type {HTMLInputElement} */ (element("outline-file"));
  const refusal = element("outline-refusal");
  file.onchange = async () => {
    text.value = (await file.files?.[0]?.text()) ?? "";
    file.value = "";
  };
  element("outline-cancel").onclick = () => dialog.close();
  element("outline-form").addEventListener("submit", (event) => {
    event.preventDefault();
    try {
      const outline = parse(text.value, Number(scale.value));
      dialog.close();
      use(outline);
    } catch (error) {
      refusal.textContent = error instanceof Error ? error.message : String(error);
    }
  });
  return () => {
    refusal.textContent = "";
    dialog.showModal();
  };
}

/** @param {string} text @param {number} scale mm a unit @returns {Point[]} */
function parse(text, scale) {
  const outline = Region.parseOutline(text.includes("<svg") ? firstPath(text) : text, { scale });
  // Whether it can be an outline at all is known before it is shown.
  const points = unflatten(outline);
  const middle = /** @type {Point} */ ([0, 1].map((k) => points.reduce((sum, p) => sum + p[k], 0) / points.length));
  try {
    new Region({ boundary: outline, center: middle, toward: points[0] ?? middle }).free();
  } catch (error) {
    // The middle of a bent outline may lie outside: the page looks for a better one.
    if (/** @type {{ code?: string }} */ (error).code !== "center-outside") throw error;
  }
  return points;
}

/** @param {string} text of an SVG file */
function firstPath(text) {
  const path = new DOMParser().parseFromString(text, "image/svg+xml").querySelector("path");
  if (!path) throw new Error("The SVG file has no path.");
  return path.getAttribute("d") ?? "";
}
