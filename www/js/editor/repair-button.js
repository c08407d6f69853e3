// A button over a drawing whose outline meets itself: it repairs the outline, and the page says how.

import { make } from "../common/menu.js";
import { remark, tell } from "../common/page.js";
import { contains } from "./geometry.js";
import { polygonOf } from "./outline.js";
import { makeRegion, meetingEdges, towardPoint } from "./region.js";
import { changeWords, repairOutline } from "./repair.js";

/** @typedef {import("./region.js").Region} Region */
/** @typedef {import("./store.js").Store} Store */

/** The region with its outline repaired, and what was done; null where nothing can be. @param {Region} region @returns {{ region: Region, said: string } | null} */
export function repaired(region) {
  const found = repairOutline(polygonOf(region));
  if (!found) return null;
  const { outline, changes } = found;
  const center = contains(outline, region.center) ? region.center : undefined;
  return { region: makeRegion(outline, center, center && towardPoint(region), region.holes), said: changeWords(changes) + (region.curves ? " Its curves are many short lines now." : "") };
}

/** @param {Store} store of the drawing @param {HTMLElement} stage over which the button lies */
export function offerRepair(store, stage) {
  const button = make("button", { type: "button", className: "repair", textContent: "Repair outline", title: "Takes out spikes and cuts off loops, and says what was changed", hidden: true });
  button.onclick = () => {
    const found = repaired(store.doc.region);
    if (!found) return remark("Too little of this outline would be left: undo, or draw a new one.");
    store.commit({ region: found.region });
    tell(found.said);
  };
  /** @type {Region | null} */
  let looked = null;
  const update = () => {
    const { region } = store.doc;
    if (store.dragging || store.mode !== "edit") {
      button.hidden = true;
      looked = null;
    } else if (region !== looked) {
      looked = region;
      button.hidden = !meetingEdges(region).size;
    }
  };
  stage.append(button);
  store.subscribe(update);
  update();
}
