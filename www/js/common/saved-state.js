// The state of a page as a file, with the visitor's own photos in it, and back.

import { pageOf } from "./along.js";
import { addPicture, ownFile } from "./images.js";

/** As in the file. @typedef {{ application: string, page: string, state: Record<string, string>, photos: Record<string, { title: string, type: string, data: string }> }} SavedState */

const APPLICATION = "conformal-warp";

/** The file of an address. @param {string} hash without # @returns {Promise<Blob>} */
export async function stateFile(hash) {
  const state = Object.fromEntries(new URLSearchParams(hash));
  /** @type {SavedState["photos"]} */
  const photos = {};
  for (const value of Object.values(state)) {
    const own = ownFile(value);
    if (own) photos[value] = { title: own.title, type: own.blob.type, data: await base64(own.blob) };
  }
  /** @type {SavedState} */
  const saved = { application: APPLICATION, page: pageOf(location.href) || "index.html", state, photos };
  return new Blob([JSON.stringify(saved, null, 1)], { type: "application/json" });
}

/** Whether a text claims to be such a file. @param {string} text */
export const isState = (text) => text.trimStart().startsWith("{") && text.includes(`"${APPLICATION}"`);

/** Goes to the state of a file; its photos become the visitor's own. @param {string} text @param {string} name */
export async function openState(text, name) {
  const { page, state, photos } = read(text, name);
  for (const [id, { title, type, data }] of Object.entries(photos)) {
    const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
    const { id: own } = await addPicture(new File([bytes], title, { type }));
    for (const [field, value] of Object.entries(state)) if (value === id) state[field] = own;
  }
  const hash = new URLSearchParams(state).toString();
  if (page === (pageOf(location.href) || "index.html")) location.hash = hash;
  else location.assign(`${page === "index.html" ? "./" : page}#${hash}`);
}

/** @param {string} text @param {string} name @returns {SavedState} */
function read(text, name) {
  const refusal = new Error(`“${name}” is no state that was saved here: it must be a JSON file from Save.`);
  /** @type {any} */
  let found;
  try {
    found = JSON.parse(text);
  } catch {
    throw refusal;
  }
  const { application, page, state, photos = {} } = found ?? {};
  const known = typeof page === "string" && (page === "index.html" || pageOf(new URL(page, location.href).href) === page);
  const fields = state && typeof state === "object" && Object.values(state).every((value) => typeof value === "string");
  const pictures = Object.values(photos).every((/** @type {any} */ { title, type, data }) => [title, type, data].every((part) => typeof part === "string"));
  if (application !== APPLICATION || !known || !fields || !pictures) throw refusal;
  return found;
}

/** @param {Blob} blob @returns {Promise<string>} */
async function base64(blob) {
  const reader = new FileReader();
  reader.readAsDataURL(blob);
  await new Promise((resolve) => (reader.onloadend = resolve));
  return String(reader.result).replace(/^[^,]*,/, "");
}
