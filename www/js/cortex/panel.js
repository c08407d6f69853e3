// One panel of the cortex: which map it shows, where that comes from, and how to change it.

import { toPlane } from "../common/frame.js";
import { ARROWS, onEscape } from "../common/keys.js";
import { pixelOf } from "../common/svg.js";
import { Pen } from "../editor/pen.js";
import { isOutline, MEASURED, models } from "./models.js";
import { CortexView } from "./views.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./pipeline.js").Panel} Panel */
/** @typedef {import("./models.js").Landmark} Landmark */
/** @typedef {import("./state.js").State} State */
/**
 * What a panel asks of the page.
 * @typedef {object} Wishes
 * @property {(name: string) => void} choose
 * @property {(shear: number) => void} shear a step of a drag
 * @property {(name: string, landmark: Landmark) => void} place a step of a drag
 * @property {(kept: boolean) => void} placed the drag has ended, or was given up
 * @property {(outline: Point[]) => void} draw
 * @property {() => void} read an outline from text
 * @property {() => void} look another part is looked at
 * @property {(event: PointerEvent | null) => void} point
 */

/** Steps of the arrow keys: in mm, in radians. */
const [STEP, TURN] = [0.5, 0.03];
/** A pause this long ends a series of arrow keys, in milliseconds. */
const KEY_PAUSE = 400;

export class CortexPanel {
  view;
  #figure;
  #wishes;
  #pen;
  #name = "";
  /** @type {Landmark | null} */
  #landmark = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #keys;

  /** @param {HTMLElement} figure made from the page's template @param {string} label @param {Wishes} wishes */
  constructor(figure, label, wishes) {
    this.#figure = figure;
    this.#wishes = wishes;
    this.view = new CortexView(this.#part("canvas"), this.#part("svg"), wishes.look);
    const choice = /** @type {HTMLSelectElement} */ (this.#part("select"));
    choice.setAttribute("aria-label", label);
    const groups = Object.groupBy([...models], ([, { group }]) => group);
    for (const [title, members] of Object.entries(groups)) {
      const group = Object.assign(document.createElement("optgroup"), { label: title });
      group.append(...(members ?? []).map(([name, model]) => new Option(model.title, name)));
      choice.append(group);
    }
    choice.onchange = () => wishes.choose(choice.value);
    const shear = /** @type {HTMLInputElement} */ (this.#part(".shear input"));
    shear.oninput = () => wishes.shear(Number(shear.value));
    shear.onchange = () => wishes.placed(true);
    this.#pen = this.#makePen();
    this.#part(".draw").onclick = () => this.#pen.begin();
    this.#part(".read").onclick = () => wishes.read();
    this.#followLandmark();
    this.view.root.addEventListener("pointermove", (event) => wishes.point(event));
    this.view.root.addEventListener("pointerleave", () => wishes.point(null));
  }

  /** @param {string} selector @returns {any} the element, of whatever kind the template has there */
  #part(selector) {
    return this.#figure.querySelector(selector);
  }

  #makePen() {
    const { root } = this.view;
    return new Pen({
      view: this.view,
      isActive: () => root.classList.contains("drawing"),
      onMode: (drawing) => root.classList.toggle("drawing", drawing),
      onOutline: (outline) => this.#wishes.draw(outline),
    });
  }

  #followLandmark() {
    const { root } = this.view;
    /** @type {string | undefined} */
    let part;
    // A finger on a handle does not scroll the page.
    root.addEventListener("touchstart", (event) => event.target instanceof SVGElement && event.target.dataset.part && event.preventDefault(), { passive: false });
    root.addEventListener("pointerdown", (event) => {
      part = event.target instanceof SVGElement ? event.target.dataset.part : undefined;
      if (part) root.setPointerCapture(event.pointerId);
    });
    root.addEventListener("pointermove", (event) => {
      if (!part || !root.hasPointerCapture(event.pointerId) || !this.#landmark) return;
      const at = toPlane(this.view.frame, pixelOf(root, event));
      const { center, direction } = this.#landmark;
      if (part === "center") this.#wishes.place(this.#name, { center: at, direction });
      else this.#wishes.place(this.#name, { center, direction: Math.atan2(at[1] - center[1], at[0] - center[0]) });
    });
    /** @param {boolean} kept */
    const release = (kept) => {
      const held = part !== undefined;
      part = undefined;
      if (held) this.#wishes.placed(kept);
      return held;
    };
    root.addEventListener("pointerup", () => release(true));
    root.addEventListener("pointercancel", () => release(true));
    onEscape(() => release(false));
    root.addEventListener("keydown", (event) => {
      const handle = event.target instanceof SVGElement ? event.target.dataset.part : undefined;
      const step = ARROWS.get(event.key);
      if (!handle || !step || !this.#landmark) return;
      event.preventDefault();
      const { center, direction } = this.#landmark;
      const moved = handle === "center" ? { center: /** @type {Point} */ ([center[0] + STEP * step[0], center[1] + STEP * step[1]]), direction } : { center, direction: direction + TURN * (step[1] - step[0]) };
      this.#wishes.place(this.#name, moved);
      clearTimeout(this.#keys);
      this.#keys = setTimeout(() => this.#wishes.placed(true), KEY_PAUSE);
    });
  }

  /** The panel's own controls. @param {string} name @param {State} state */
  update(name, { shear, landmarks }) {
    if (name !== this.#name) this.#landmark = null;
    this.#name = name;
    this.#mark(isOutline(name) ? (landmarks[name] ?? this.#landmark) : null);
    this.#part("select").value = name;
    this.#part(".shear").hidden = name !== "wedge";
    const slider = /** @type {HTMLInputElement} */ (this.#part(".shear input"));
    slider.value = String(shear);
    this.#part(".shear output").textContent = `α = ${shear.toFixed(2)}`;
    this.#part(".edit").hidden = name !== "own";
    this.#part(".tools").hidden = name !== "wedge" && name !== "own";
  }

  /** @param {Landmark | null} landmark */
  #mark(landmark) {
    this.#landmark = landmark;
    this.view.mark(landmark);
  }

  /** What was found out about this panel's map; one that refuses keeps its picture. @param {Panel} panel @param {Point[]} sizes of the hemispheres' pictures @param {import("./layout.js").Half} half @param {State} state */
  show(panel, sizes, half, { lines, circles }) {
    const refused = "refusal" in panel;
    this.#figure.classList.toggle("refused", refused);
    this.view.fit(half);
    this.#mark(panel.landmark);
    if (refused) {
      this.#part(".note").textContent = panel.refusal;
      return;
    }
    this.view.paint(panel.pixels, sizes);
    this.view.show(panel.drawn.id, panel.drawn.outline, lines ? panel.drawn.lines : [], circles ? panel.drawn.circles : []);
    this.#explain(panel.drawn, panel.landmark?.fromFormula);
  }

  /** Where the map comes from, and what it says of itself. @param {import("./maps.js").Drawn} drawn @param {number} [fromFormula] how far the outline’s formula has the blind spot from the landmark, in mm */
  #explain({ area, landmarkError }, fromFormula) {
    const { source = "" } = models.get(this.#name) ?? {};
    const sentences = [`${isOutline(this.#name) ? "Symm’s map of " : ""}${source}; ${Math.round(area)} mm² a hemisphere.`];
    sentences[0] = sentences[0][0].toUpperCase() + sentences[0].slice(1);
    if (landmarkError) {
      const [distance, angle] = landmarkError;
      sentences.push(`The blind spot lands ${power(distance)} mm from its place, its meridian ${power(angle)} radians from its direction.`);
    }
    if (fromFormula) sentences.push(`The dipole itself, which takes the sphere for a plane, has it ${fromFormula.toFixed(1)} mm further out.`);
    this.#part(".note").textContent = sentences.join(" ");
    this.#part(".note").title = MEASURED;
  }
}

/** 0.000000002 → "2·10⁻⁹". @param {number} value */
function power(value) {
  const [digits, exponent] = value.toExponential(0).split("e");
  return `${digits}·10${[...exponent].map((sign) => ({ "-": "⁻", "+": "" })[sign] ?? "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(sign)]).join("")}`;
}
