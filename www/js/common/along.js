// What goes along from page to page: links between the pages, own photos to forget.

import { forgetOwn, ownPictures } from "./images.js";
import { workOffline } from "./offline.js";
import { attempt, remark } from "./page.js";

/** What goes along: the fields of a drawing, or of a photo alone; none where they are as at first. @typedef {Record<string, string>} Fields */

const PAGES = ["", "regions.html", "formula.html", "cortex.html", "flow.html", "fields.html"];
/** Under which names a page knows the fields that others hand over. @param {string} page */
const prefixOf = (page) => (page === "regions.html" ? "a." : "");
/** Pages whose address holds a region. @param {string} page */
const draws = (page) => page === "" || page === "regions.html";
/** Pages that warp a photo. @param {string} page */
const warps = (page) => page !== "flow.html" && page !== "fields.html";
const DRAWING = ["image", "region", "path", "holes", "center", "toward"];

/** The name of a page of ours; "" for the first. @param {string} address */
export const pageOf = (address) => {
  const name = new URL(address, location.href).pathname.split("/").at(-1) ?? "";
  return PAGES.includes(name) ? name : "";
};

/** @param {string} page */
const keyOf = (page) => `address of ${page || "index.html"}`;

/**
 * Where a link to another page leads: what was last there, with what comes along.
 * @param {string} last its own address after the # @param {Fields} fields @param {string} page @returns {string}
 */
export function addressFor(last, fields, page) {
  const address = new URLSearchParams(last);
  const prefix = prefixOf(page);
  const sent = draws(page) ? fields : "image" in fields && warps(page) ? { image: fields.image } : {};
  const same = address.get(`${prefix}image`) === sent.image;
  if (sent.image !== undefined && !(same && !sent.region && !sent.path)) {
    // Another photo or drawing: the region drawn on the last one and the place that was looked at there are not meant.
    for (const name of draws(page) ? [...DRAWING, "shape"] : ["fixation"]) address.delete(prefix + name);
  }
  for (const [name, value] of Object.entries(sent)) address.set(prefix + name, value);
  return address.toString().replaceAll("%2C", ",").replaceAll("%3B", ";");
}

/** Connects the links between the pages, and the button that forgets photos. @param {() => Fields} fields of what is shown now */
export function goAlong(fields) {
  const own = pageOf(location.href);
  window.addEventListener("pagehide", () => sessionStorage.setItem(keyOf(own), location.hash.slice(1)));
  for (const link of /** @type {NodeListOf<HTMLAnchorElement>} */ (document.querySelectorAll("nav a:not([aria-current])"))) {
    const page = pageOf(link.href);
    const lead = () => {
      const address = addressFor(sessionStorage.getItem(keyOf(page)) ?? "", fields(), page);
      link.hash = address ? `#${address}` : "";
    };
    for (const event of ["pointerdown", "focus", "click"]) link.addEventListener(event, lead);
  }
  offerToForget();
  workOffline();
}

function offerToForget() {
  const button = Object.assign(document.createElement("button"), { type: "button", id: "forget", textContent: "Forget my photos" });
  const place = Object.assign(document.createElement("p"), { id: "own-photos" });
  place.append("Your own photos are kept in this browser, for your next visit. ", button);
  const update = () => (place.hidden = !ownPictures().length);
  button.onclick = () => attempt(forgetOwn(), () => remark("Your photos are forgotten; one that is shown stays until you leave the page."));
  window.addEventListener("own-pictures", update);
  document.querySelector("footer")?.append(place);
  update();
}
