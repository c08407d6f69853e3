// The rows of a menu that choose the probe's figure and size, and pin it.

import { make, menuRow } from "./menu.js";
import { REACH } from "./probe.js";

/** @typedef {import("./probe.js").Figure} Figure */
/** @typedef {import("./probe.js").Probe} Probe */

/** @type {[Figure, string][]} */
const NAMES = [["circle", "circle"], ["square", "square"], ["letter", "letter F"]];

/** @param {Probe} probe @param {() => { side: import("./probe.js").Side, at: import("./frame.js").Point }} place where it is pinned first @returns {HTMLElement} */
export function probeRow(probe, place) {
  const figure = make("select", { id: "probe-figure", label: "Figure of the probe" });
  figure.append(...NAMES.map(([value, name]) => new Option(name, value)));
  const reach = make("input", { type: "range", id: "probe-size", min: "8", max: "80", step: "1", value: String(REACH), label: "Size of the probe" });
  const pin = make("input", { type: "checkbox", id: "probe-pin", label: "Pinned" });
  const become = () => probe.become(/** @type {Figure} */ (figure.value), Number(reach.value));
  figure.onchange = become;
  reach.oninput = become;
  pin.onchange = () => probe.pin(pin.checked ? place() : null);
  return menuRow("Probe", [figure, make("label", { className: "check" }, [pin, " pinned, to be dragged"]), make("label", { className: "slide" }, ["Size", reach])]);
}
