// A region in the form of a letter of the page's serif font.

import { make } from "../common/menu.js";
import { tell } from "../common/page.js";
import { placedOn } from "./outline-text.js";
import { readPath } from "./path.js";

/** By characters: paths, of the outline and of the holes in it. @typedef {Record<string, [outline: string, ...holes: string[]]>} Letters */

/** @type {Promise<Letters> | null} */
let loading = null;

/** They are loaded when first asked for; a failure is forgotten. @returns {Promise<Letters>} */
function letters() {
  loading ??= fetch(new URL("../../letters.json", import.meta.url)).then((answer) => {
    if (!answer.ok) throw new Error(`the letters could not be loaded (${answer.status})`);
    return answer.json();
  });
  loading.catch(() => (loading = null));
  return loading;
}

/** @param {Omit<import("./outline-dialog.js").Destination, "parse">} destination @returns {() => void} asks for a letter */
export function letterDialog({ photo, use }) {
  const field = make("input", { type: "text", className: "letter", maxLength: 2, autocomplete: "off", label: "A letter or a digit" });
  const refusal = make("p", { className: "refusal" });
  refusal.setAttribute("role", "alert");
  const cancel = make("button", { type: "button", textContent: "Cancel" });
  const form = make("form", { method: "dialog" }, [
    make("h2", { id: "letter-title", textContent: "A letter as the region" }),
    make("p", { textContent: "Type a letter or a digit: its outline is taken as it is drawn, Bézier curves and all." }),
    make("div", { className: "row" }, [field]),
    refusal,
    make("div", { className: "row end" }, [cancel, make("button", { className: "strong", textContent: "Use it" })]),
  ]);
  const dialog = make("dialog", { className: "dialog" }, [form]);
  dialog.setAttribute("aria-labelledby", "letter-title");
  document.body.append(dialog);
  // The last one typed counts.
  field.oninput = () => (field.value = [...field.value].at(-1) ?? "");
  cancel.onclick = () => dialog.close();
  form.onsubmit = async (event) => {
    event.preventDefault();
    refusal.textContent = await take(field.value).catch((error) => `It did not work: ${error instanceof Error ? error.message : error}. Try once more.`);
    if (!refusal.textContent) dialog.close();
  };
  /** @param {string} character @returns {Promise<string>} why not, or "" */
  async function take(character) {
    const known = await letters();
    if (!Object.hasOwn(known, character)) return character ? `There is no outline of “${character}” here: take another letter.` : "Type a letter.";
    const [outline, ...holes] = placedOn(known[character].map(readPath), photo());
    use(outline, holes);
    tell(`The letter “${character}”, its curves as they are.`);
    return "";
  }
  return () => {
    refusal.textContent = "";
    dialog.showModal();
    field.select();
  };
}
