// What an edge is: a line, an arc or a curve. Chosen in the toolbar for the edge after the selected point, or in a small menu at the edge itself.

import { make } from "../common/menu.js";
import { kindOf } from "./curve.js";
import { partOf } from "./edit.js";
import { canRemove, convertEdge, edgeAfter, holeAt, removeHole } from "./region.js";

/** @typedef {import("./curve.js").Kind} Kind */
/** @typedef {import("./edit.js").Editor} Editor */
/** @typedef {import("./store.js").Store} Store */

/** @type {[kind: Kind, name: string, key: string][]} */
const KINDS = [["line", "Straight", "L"], ["arc", "Arc", "A"], ["curve", "Curve", "C"]];

/** The menu stays so far from the window's edges, in pixels. */
const ROOM = 8;

/** A drawing whose edges are offered. @typedef {{ store: Store, editor: Editor, view: { root: SVGSVGElement } }} Drawing */

/** @param {HTMLSelectElement} select for the drawing of which a point was chosen last @param {Drawing[]} drawings */
export function offerEdges(select, drawings) {
  let [{ store, editor }] = drawings;
  select.append(new Option("Edge", ""), ...KINDS.map(([kind, name]) => new Option(name, kind)));
  select.title = "What the edge after the chosen point is: keys L, A, C on the point";
  select.onchange = () => editor.convertSelected(/** @type {Kind} */ (select.value));
  const update = () => {
    const { selected, mode, doc } = store;
    select.disabled = selected === null || mode !== "edit";
    select.options[0].hidden = !select.disabled;
    select.value = select.disabled || selected === null ? "" : kindOf(edgeAfter(doc.region, selected)[2]);
  };
  for (const drawing of drawings) {
    drawing.store.subscribe(() => {
      if (drawing.store.selected !== null) ({ store, editor } = drawing);
      update();
    });
    openAtEdges(drawing);
  }
  update();
}

/** A menu where an edge, or a point, is pressed with the other button, or for long. @param {Drawing} drawing */
function openAtEdges({ store, editor, view: { root } }) {
  const menu = make("div", { className: "menu edge-menu", popover: "auto", label: "This edge" });
  menu.setAttribute("role", "menu");
  root.after(menu);
  /** @param {string} name @param {string} key @param {boolean} on @param {() => void} act */
  const item = (name, key, on, act) => {
    const button = make("button", { type: "button", className: on ? "on" : "" }, [name, " ", make("kbd", { textContent: key })]);
    button.setAttribute("role", "menuitem");
    button.onclick = () => {
      menu.hidePopover();
      act();
    };
    return button;
  };
  root.addEventListener("contextmenu", (event) => {
    const { part, index } = partOf(event.target);
    if (store.mode !== "edit" || (part !== "edge" && part !== "vertex")) return;
    event.preventDefault();
    const { region } = store.doc;
    store.select(index);
    const kind = kindOf(edgeAfter(region, index)[2]);
    const kinds = KINDS.map(([name, title, key]) => item(title, key, name === kind, () => store.commit({ region: convertEdge(region, index, name) })));
    const remove = part === "vertex" && canRemove(region, index) ? [item("Remove the point", "Del", false, () => editor.removeSelected())] : [];
    const hole = holeAt(region, index);
    if (hole !== null) remove.push(item("Remove the hole", "⇧ Del", false, () => store.commit({ region: removeHole(region, hole) })));
    menu.replaceChildren(make("p", { className: "menu-name", textContent: part === "edge" ? "This edge" : "The edge after this point" }), ...kinds, ...remove);
    menu.showPopover();
    menu.style.setProperty("--left", `${Math.max(ROOM, Math.min(event.clientX, window.innerWidth - menu.offsetWidth - ROOM))}px`);
    menu.style.setProperty("--top", `${Math.max(ROOM, Math.min(event.clientY, window.innerHeight - menu.offsetHeight - ROOM))}px`);
    kinds[0].focus();
  });
}
