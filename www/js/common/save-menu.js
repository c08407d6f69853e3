// The menu under Save: a picture of any size, its lines, the state of the page, links.

import { make, menuOf, menuRow } from "./menu.js";
import { attempt, element, wordsOf } from "./page.js";
import { openState, stateFile } from "./saved-state.js";
import { handOver, Saver } from "./saver.js";

/** @typedef {import("./frame.js").Point} Point */
/** `file` holds it larger than `pixels`, at `fullSize`. @typedef {{ pixels: Uint8ClampedArray, frame: import("./frame.js").Frame, file?: Blob, fullSize?: Point }} Picture */
/**
 * What a page gives away.
 * @typedef {object} Goods
 * @property {string} name of the files
 * @property {URL} script of the page's worker
 * @property {() => Picture} picture that is warped, if a photo is
 * @property {boolean} [photo] false where nothing of a visitor's own is shown but lines, which are then saved too
 * @property {() => Point} shape of the picture's panel, in CSS pixels
 * @property {(pixels: Point, kind: "picture" | "drawing") => object} job for a picture of so many pixels, or a drawing
 * @property {string} drawing what lines the SVG file has
 * @property {() => string} address of the state, after the #
 */

/** Longer sides of the pictures that can be saved. */
const SIDES = [1024, 2048, 4096, 8192];
/** What is offered first where there is no photo whose size it could be. */
const USUAL = 2048;
/** A button says that something was done for so long, in milliseconds. */
const SAID = 1800;

/** @param {Goods} goods */
export function offerToSave(goods) {
  const button = /** @type {HTMLButtonElement} */ (element("save"));
  const saver = new Saver(goods.script);
  const size = make("select", { id: "save-size", label: "Size of the picture" });
  const lines = make("input", { type: "checkbox", id: "save-lines", label: "With lines" });
  const bar = make("progress", { max: 1, value: 0, label: "Making the file" });
  const cancel = make("button", { type: "button", id: "save-cancel", textContent: "Cancel" });
  const busy = make("div", { className: "menu-busy", hidden: true }, [bar, cancel]);
  const words = make("p", { className: "menu-words" });
  words.setAttribute("role", "status");
  const picture = make("button", { type: "button", id: "save-picture", className: "strong", textContent: "Save PNG" });
  const drawing = make("button", { type: "button", id: "save-drawing", textContent: "Save SVG" });
  lines.checked = goods.photo === false;
  const state = make("button", { type: "button", id: "save-state", textContent: "Save JSON" });
  const open = make("button", { type: "button", id: "open-state", textContent: "Open\u200a…" });
  const file = make("input", { type: "file", id: "state-file", accept: ".json,application/json", hidden: true, label: "A state saved before" });
  const link = make("button", { type: "button", id: "copy-link", textContent: "Copy link", title: goods.photo === false ? "" : "Your own photos are not in it" });
  const embed = make("button", { type: "button", id: "copy-embed", textContent: "Copy embed code", title: "An <iframe> for your own page, with the pictures alone" });

  menuOf(button, "Save and share", [
    menuRow("Picture", [size, make("label", { className: "check" }, [lines, " with lines"]), picture]),
    busy,
    menuRow("Drawing", [drawing], goods.drawing),
    menuRow("State", [state, open, file], `to go on with later${goods.photo === false ? "" : ", your own photo too"}`),
    menuRow("Share", [link, embed]),
    words,
  ]).addEventListener("beforetoggle", () => fillSizes(size, goods));

  /** @param {"picture" | "drawing"} kind @param {Point} pixels @param {string} name */
  const produce = async (kind, pixels, name) => {
    const shape = goods.shape();
    const wanted = { kind, lines: lines.checked, density: pixels[0] / shape[0], title: document.title };
    busy.hidden = false;
    bar.removeAttribute("value");
    words.textContent = "";
    try {
      const blob = await saver.make(goods.job(pixels, kind), goods.picture(), wanted, (share) => (bar.value = share));
      if (blob) handOver(blob, name);
      words.textContent = blob ? `${name} is made: ${pixels.join(" × ")}${kind === "picture" ? " pixels" : ""}, ${sizeWords(blob.size)}.` : "Cancelled: no file was made.";
    } catch (error) {
      words.textContent = wordsOf(error);
    }
    busy.hidden = true;
  };
  picture.onclick = () => produce("picture", pixelsOf(Number(size.value), goods.shape()), `${goods.name}.png`);
  drawing.onclick = () => produce("drawing", pixelsOf(1000, goods.shape()), `${goods.name}.svg`);
  cancel.onclick = () => saver.cancel();
  state.onclick = () => attempt(stateFile(goods.address()), (blob) => handOver(blob, `${goods.name}.json`));
  open.onclick = () => file.click();
  file.onchange = () => {
    const [chosen] = file.files ?? [];
    file.value = "";
    if (chosen) attempt(chosen.text().then((text) => openState(text, chosen.name)), () => {});
  };
  link.onclick = () => copy(link, location.href);
  embed.onclick = () => copy(embed, embedCode());
}

/** @param {HTMLButtonElement} button @param {string} text */
function copy(button, text) {
  const { textContent: name } = button;
  const copied = navigator.clipboard?.writeText(text) ?? Promise.reject(new Error("This browser lets no page copy: take the address from its bar."));
  attempt(copied, () => {
    button.textContent = "Copied";
    setTimeout(() => (button.textContent = name), SAID);
  });
}

/** A frame with the pictures alone, at what is seen now. */
function embedCode() {
  const address = new URL(location.href);
  address.search = "embed";
  const title = document.title.replaceAll('"', "&quot;");
  return `<iframe src="${address.href.replaceAll("&", "&amp;")}" width="960" height="520" title="${title}" allow="fullscreen" loading="lazy"></iframe>`;
}

/** @param {HTMLSelectElement} select @param {Goods} goods */
function fillSizes(select, { picture, shape, photo: warped = true }) {
  const { frame, fullSize = frame.pixels } = picture();
  const photo = warped ? Math.min(SIDES[SIDES.length - 1], Math.max(...fullSize)) : 0;
  const chosen = select.value || String(photo || USUAL);
  /** @param {number} side @param {string} name */
  const option = (side, name) => new Option(`${name}${pixelsOf(side, shape()).join(" × ")}`, String(side));
  select.replaceChildren(...(photo ? [option(photo, "the photo’s own: ")] : []), ...SIDES.filter((side) => side !== photo).map((side) => option(side, "")));
  select.value = [...select.options].some(({ value }) => value === chosen) ? chosen : String(photo || USUAL);
}

/** So many pixels along the longer side. @param {number} side @param {Point} shape @returns {Point} */
function pixelsOf(side, [width, height]) {
  const scale = side / Math.max(width, height);
  return [Math.max(16, Math.round(width * scale)), Math.max(16, Math.round(height * scale))];
}

/** @param {number} bytes */
const sizeWords = (bytes) => (bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))} kB` : `${(bytes / 1e6).toFixed(1)} MB`);
