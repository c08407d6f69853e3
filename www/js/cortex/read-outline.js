// The dialog in which an outline is read from text: JSON, the data of an SVG path, or a whole SVG file.

import { element } from "../common/page.js";

/** @typedef {import("../common/frame.js").Point} Point */

/**
 * @param {(text: string, scale: number) => Promise<{ outline: Point[] } | { refusal: string } | null>} parse mm a unit
 * @param {(outline: Point[]) => void} use @returns {() => void} opens the dialog
 */
export function outlineDialog(parse, use) {
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
  element("outline-form").addEventListener("submit", async (event) => {
    event.preventDefault();
    const found = await parse(text.value, Number(scale.value));
    if (!found || "refusal" in found) {
      refusal.textContent = found ? found.refusal : "The outline could not be read just now: try once more.";
      return;
    }
    dialog.close();
    use(found.outline);
  });
  return () => {
    refusal.textContent = "";
    dialog.showModal();
  };
}
