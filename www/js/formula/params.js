// Sliders and numbers for the parameters that a formula names, and time that moves them.

import { make } from "../common/menu.js";
import { playButton } from "../common/player.js";

/** @typedef {import("../common/frame.js").Point} Point */

/** How far a slider goes, each way, at first; it goes farther where a number asks for that. */
const REACH = 4;
const FARTHEST = 1e6;
/** A slider rests on so many places. */
const PLACES = 800;
/** This letter is time, which runs on; others go to and fro. */
const TIME = "t";

/**
 * Shows real and imaginary part of each parameter; rows that are there stay, so that a slider being moved keeps the hand.
 * @param {HTMLElement} list @param {Record<string, Point>} params @param {(name: string, value: Point) => void} onChange
 * @param {() => number} speed units a second at which a parameter is played
 */
export function showParams(list, params, onChange, speed) {
  const wanted = Object.keys(params);
  for (const row of [...list.children]) if (!wanted.includes(/** @type {HTMLElement} */ (row).dataset.name ?? "")) row.remove();
  for (const name of wanted) {
    const known = [...list.children].find((child) => /** @type {HTMLElement} */ (child).dataset.name === name);
    const row = known ? rows.get(known) : newRow(list, name, onChange, speed);
    row?.show(params[name]);
  }
}

/** @typedef {{ show(value: Point): void }} Row */
/** @type {WeakMap<Element, Row>} */
const rows = new WeakMap();

/** @param {number} x */
const short = (x) => String(Number(x.toPrecision(6)));

/** @param {HTMLElement} list @param {string} name @param {(name: string, value: Point) => void} onChange @param {() => number} speed @returns {Row} */
function newRow(list, name, onChange, speed) {
  /** @type {Point} */
  let value = [0, 0];
  let reach = REACH;
  let way = 1;
  const item = make("li");
  item.dataset.name = name;
  const parts = /** @type {const} */ (["re", "im"]).map((part, k) => {
    const words = `${part === "re" ? "real" : "imaginary"} part of ${name}`;
    const slider = make("input", { type: "range", label: words });
    const number = make("input", { type: "number", step: "any", className: "number", label: `${words}, as a number` });
    const take = (/** @type {HTMLInputElement} */ input) => {
      if (input.value === "" || !(Math.abs(Number(input.value)) <= FARTHEST)) return;
      onChange(name, k ? [value[0], Number(input.value)] : [Number(input.value), value[1]]);
    };
    slider.oninput = () => take(slider);
    number.oninput = () => take(number);
    item.append(make("label", { className: "part" }, [make("span", { textContent: part }), slider]), number);
    return { slider, number };
  });
  const play = playButton(name, (seconds) => {
    let re = value[0] + way * seconds * speed();
    if (name !== TIME && Math.abs(re) > reach) {
      way = re > 0 ? -1 : 1;
      re = Math.sign(re) * reach;
    }
    onChange(name, [Number(re.toFixed(4)), value[1]]);
  });
  play.title = name === TIME ? "Play: t is time, in seconds" : `Play: ${name} goes to and fro along the real axis`;
  item.prepend(make("i", { textContent: name }), " =");
  item.append(play);
  list.append(item);
  /** @type {Row} */
  const row = {
    show(next) {
      value = next;
      while (Math.max(...next.map(Math.abs)) > reach) reach *= 2;
      parts.forEach(({ slider, number }, k) => {
        Object.assign(slider, { min: -reach, max: reach, step: (2 * reach) / PLACES });
        if (Number(slider.value) !== next[k]) slider.value = String(next[k]);
        if (number.value === "" ? document.activeElement !== number : Number(number.value) !== next[k]) number.value = short(next[k]);
      });
    },
  };
  rows.set(item, row);
  return row;
}
