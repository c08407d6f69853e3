// Sliders for the parameters that a formula names.

/** @typedef {import("../common/frame.js").Point} Point */

/** How far a slider goes, each way. */
const REACH = 4;
/** A slider rests on multiples of this. */
const STEP = 0.01;

/**
 * Shows two sliders a parameter, real and imaginary part; those that are there stay, so that one being moved keeps the hand.
 * @param {HTMLElement} list @param {Record<string, Point>} params @param {(name: string, value: Point) => void} onChange
 */
export function showParams(list, params, onChange) {
  const wanted = Object.keys(params);
  for (const row of [...list.children]) if (!wanted.includes(/** @type {HTMLElement} */ (row).dataset.name ?? "")) row.remove();
  for (const name of wanted) {
    const row = [...list.children].find((child) => /** @type {HTMLElement} */ (child).dataset.name === name) ?? newRow(list, name, onChange);
    const value = params[name];
    row.querySelectorAll("input").forEach((input, k) => {
      if (Number(input.value) !== value[k]) input.value = String(value[k]);
    });
    const output = row.querySelector("output");
    if (output) output.value = complexWords(value);
  }
}

/** @param {HTMLElement} list @param {string} name @param {(name: string, value: Point) => void} onChange */
function newRow(list, name, onChange) {
  const row = document.createElement("li");
  row.dataset.name = name;
  const inputs = ["real part", "imaginary part"].map((part) => {
    const input = Object.assign(document.createElement("input"), { type: "range", min: -REACH, max: REACH, step: STEP });
    input.setAttribute("aria-label", `${name}, ${part}`);
    return input;
  });
  for (const input of inputs) input.addEventListener("input", () => onChange(name, [Number(inputs[0].value), Number(inputs[1].value)]));
  const label = Object.assign(document.createElement("i"), { textContent: name });
  row.append(label, " = ", document.createElement("output"), ...inputs);
  list.append(row);
  return row;
}

/** [1, −2] → “1 − 2i”. @param {Point} value */
function complexWords([re, im]) {
  const [x, y] = [re, Math.abs(im)].map((part) => String(Number(part.toFixed(2))).replace("-", "−"));
  if (y === "0") return x;
  const imaginary = y === "1" ? "i" : `${y}i`;
  if (x === "0" || x === "−0") return im < 0 ? `−${imaginary}` : imaginary;
  return `${x} ${im < 0 ? "−" : "+"} ${imaginary}`;
}
