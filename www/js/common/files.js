// A visitor's own files: pictures, outlines, saved states; chosen, dropped or pasted.

import { attempt, remark } from "./page.js";
import { isState, openState } from "./saved-state.js";

/** @typedef {{ take: (text: string, name: string) => void, looksLike: (text: string) => boolean }} Outlines what takes a text as an outline, and tells one from other texts */

/** Names of files that are text. */
const TEXT = /\.(json|geojson|wkt|txt|dat|csv|tsv)$/i;
/** Text that is longer is not looked at when it is pasted. */
const LONGEST = 2e7;

/**
 * @param {HTMLInputElement} input for pictures @param {HTMLElement} target where files may be dropped
 * @param {(file: File) => void} open a picture @param {Outlines} [outlines] none on pages that draw none
 */
export function acceptFiles(input, target, open, outlines) {
  /** @param {FileList | undefined} files */
  const choose = (files) => [...(files ?? [])].find(({ type }) => type.startsWith("image/")) ?? files?.[0];
  /** @param {FileList | undefined} files */
  const take = (files) => {
    const file = choose(files);
    if (!file) return;
    if (TEXT.test(file.name) || file.type.startsWith("text/") || file.type.endsWith("json")) file.text().then((text) => takeText(text, file.name));
    else if (outlines && /svg/.test(file.type)) file.text().then((text) => (drawsOneShape(text) ? outlines.take(text, file.name) : open(file)));
    else open(file);
  };
  /** @param {string} text @param {string} name */
  const takeText = (text, name) => {
    if (isState(text)) attempt(openState(text, name), () => {});
    else if (outlines) outlines.take(text, name);
    else remark(`“${name}” is neither a picture nor a state that was saved here. Outlines are drawn on the pages of regions.`);
  };
  input.addEventListener("change", () => {
    const file = choose(input.files ?? undefined);
    input.value = "";
    if (file) open(file);
  });
  window.addEventListener("dragover", (event) => {
    event.preventDefault();
    target.classList.add("dropping");
  });
  window.addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) target.classList.remove("dropping");
  });
  window.addEventListener("drop", (event) => {
    event.preventDefault();
    target.classList.remove("dropping");
    take(event.dataTransfer?.files);
  });
  window.addEventListener("paste", (event) => {
    if (event.target instanceof Element && event.target.closest("input, textarea")) return;
    const files = event.clipboardData?.files;
    if (files?.length) return take(files);
    const text = event.clipboardData?.getData("text/plain") ?? "";
    if (text.length < LONGEST && (isState(text) || outlines?.looksLike(text))) takeText(text, "");
  });
}

/** Whether an SVG file is an outline, and no picture: one shape, no photo, no words. @param {string} text */
const drawsOneShape = (text) => (text.match(/<(path|polygon|polyline|rect|circle|ellipse)\b/g) ?? []).length === 1 && !/<(image|text|use|foreignObject)\b/.test(text);
