// The menu of what is shown over both pictures.

import { make, menuOf, menuRow } from "../common/menu.js";

/** @typedef {import("./store.js").Store} Store */
/** @typedef {"mesh" | "grid" | "field" | "heat" | "measure"} Name */

/** @param {Store} store @param {HTMLButtonElement} button @param {HTMLElement[]} [more] rows @returns {(missing?: Name[]) => void} shows the state; what is missing cannot be chosen */
export function showMenu(store, button, more = []) {
  /** @type {[Name, HTMLInputElement][]} */
  const boxes = [];
  /** @param {Name} name @param {string} words */
  const check = (name, words) => {
    const box = make("input", { type: "checkbox", id: name, label: words });
    // The two grids would hide each other.
    const others = name === "grid" ? { field: false } : name === "field" ? { grid: false } : {};
    box.onchange = () => store.show({ [name]: box.checked, ...(box.checked && others) });
    boxes.push([name, box]);
    return make("label", { className: "check" }, [box, ` ${words}`]);
  };
  const density = make("input", { type: "range", id: "density", min: "6", max: "48", step: "2", label: "Number of rays, or field lines" });
  density.oninput = () => store.show({ density: Number(density.value), ...(!store.shown.grid && !store.shown.field && { grid: true }) });
  menuOf(button, "What is shown over the pictures", [
    menuRow("Lines", [check("mesh", "Triangles"), check("grid", "Polar grid"), check("field", "Field lines and equipotentials"), make("label", { className: "slide" }, ["Density", density])]),
    menuRow("Stretch", [check("heat", "|f′| as colours")], "white as at the centre, red larger, blue smaller"),
    menuRow("Boundary", [check("measure", "Harmonic measure")], "how often walkers from the centre come out there"),
    ...more,
  ]);
  return (missing = []) => {
    const { shown } = store;
    for (const [name, box] of boxes) {
      box.checked = shown[name];
      box.disabled = missing.includes(name);
    }
    density.value = String(shown.density);
    button.classList.toggle("on", boxes.some(([name]) => shown[name]));
  };
}
