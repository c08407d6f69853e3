// Where an outline is read from a file or from text: a dialog, drops and pastes; all end in the same way.

import { make } from "../common/menu.js";
import { remark, tell } from "../common/page.js";
import { outlineOf } from "./outline.js";
import { placedOn } from "./outline-text.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("./read-outline.js").OutlineAnswer} OutlineAnswer */
/**
 * What outlines are for.
 * @typedef {object} Destination
 * @property {(text: string) => Promise<OutlineAnswer | null>} parse in a worker
 * @property {() => Frame} photo on which they are placed
 * @property {(outline: import("./outline.js").Outline, holes?: import("./outline.js").Outline[]) => void} use
 */

export class OutlineReader {
  #destination;
  #dialog;
  #text = make("textarea", { rows: 7, spellcheck: false, label: "Outline", placeholder: "0.0 0.0\n1.0 0.0\n0.5 0.8" });
  #refusal = make("p", { className: "refusal" });
  /** The name of the file that the text is from. */
  #name = "";

  /** @param {Destination} destination */
  constructor(destination) {
    this.#destination = destination;
    this.#refusal.setAttribute("role", "alert");
    this.#dialog = this.#makeDialog();
    document.body.append(this.#dialog);
  }

  /** Asks for a file or a text. */
  ask() {
    this.#refusal.textContent = "";
    this.#dialog.showModal();
  }

  /** Takes the outline of a text, and says what was done; the page stays as it is where there is none. @param {string} text @param {string} name of the file, or "" */
  async take(text, name) {
    const refusal = await this.#use(text, name);
    if (refusal) remark(`${name ? `“${name}”` : "That text"} gives no outline. ${refusal}`);
  }

  /** @param {string} text @param {string} name @returns {Promise<string>} why not, or "" */
  async #use(text, name) {
    const { parse, photo, use } = this.#destination;
    const found = await parse(text);
    if (!found) return "It could not be read just now: try once more.";
    if ("refusal" in found) return found.refusal;
    const { holes = [] } = found;
    const [outline, ...inner] = placedOn([outlineOf(found.outline, found.curves), ...holes], photo());
    use(outline, inner);
    tell(`${name ? `“${name}”: ` : ""}${found.said} It is as large as the photo lets it be.`);
    return "";
  }

  #makeDialog() {
    const file = make("input", { type: "file", accept: ".svg,.json,.geojson,.wkt,.txt,.dat,.csv,.tsv", label: "A file with an outline" });
    const cancel = make("button", { type: "button", textContent: "Cancel" });
    const form = make("form", { method: "dialog" }, [
      make("h2", { id: "read-title", textContent: "An outline from a file or text" }),
      make("p", { textContent: "An SVG drawing or the data of its path, GeoJSON, WKT, an airfoil (.dat), or two columns of numbers. Of several outlines the largest is taken." }),
      this.#text,
      make("div", { className: "row" }, [file]),
      this.#refusal,
      make("div", { className: "row end" }, [cancel, make("button", { className: "strong", textContent: "Use it" })]),
    ]);
    const dialog = make("dialog", { id: "read-dialog", className: "dialog" }, [form]);
    dialog.setAttribute("aria-labelledby", "read-title");
    file.onchange = async () => {
      const [chosen] = file.files ?? [];
      this.#name = chosen?.name ?? "";
      this.#text.value = (await chosen?.text()) ?? "";
      file.value = "";
    };
    this.#text.oninput = () => (this.#name = "");
    cancel.onclick = () => dialog.close();
    form.onsubmit = async (event) => {
      event.preventDefault();
      this.#refusal.textContent = await this.#use(this.#text.value, this.#name);
      if (!this.#refusal.textContent) dialog.close();
    };
    return dialog;
  }
}
