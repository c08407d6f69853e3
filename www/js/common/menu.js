// A button that opens a small panel of controls under itself; on a phone the panel is a sheet at the foot of the screen.

/** @typedef {HTMLElement | string} Part */

/** Room between a button and its panel, and between a panel and the window, in pixels. */
const ROOM = 6;

/**
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag @param {Partial<HTMLElementTagNameMap[K]> & { label?: string }} [properties] `label`: its name for those who do not see it @param {Part[]} [parts]
 * @returns {HTMLElementTagNameMap[K]}
 */
export function make(tag, { label, ...properties } = {}, parts = []) {
  const made = Object.assign(document.createElement(tag), properties);
  if (label) made.setAttribute("aria-label", label);
  made.append(...parts);
  return made;
}

/** A named row of a panel. @param {string} name @param {Part[]} parts @param {string} [meaning] */
export function menuRow(name, parts, meaning = "") {
  const words = make("p", { className: "menu-name" }, [make("b", { textContent: name }), ...(meaning ? [" ", meaning] : [])]);
  return make("div", { className: "menu-row" }, [words, make("div", { className: "menu-parts" }, parts)]);
}

/** Makes a panel for a button. @param {HTMLButtonElement} button @param {string} label @param {HTMLElement[]} rows */
export function menuOf(button, label, rows) {
  const panel = make("div", { id: `${button.id}-menu`, className: "menu", popover: "auto", label }, rows);
  panel.setAttribute("role", "dialog");
  button.setAttribute("aria-haspopup", "dialog");
  button.classList.add("opens");
  button.popoverTargetElement = panel;
  button.after(panel);
  panel.addEventListener("toggle", (event) => {
    if (/** @type {ToggleEvent} */ (event).newState === "open") place(panel, button);
  });
  window.addEventListener("resize", () => panel.matches(":popover-open") && place(panel, button));
  return panel;
}

/** @param {HTMLElement} panel @param {HTMLElement} button */
function place(panel, button) {
  const at = button.getBoundingClientRect();
  const { offsetWidth: width, offsetHeight: height } = panel;
  const left = Math.max(ROOM, Math.min(at.right - width, window.innerWidth - width - ROOM));
  const below = at.bottom + ROOM;
  const top = below + height > window.innerHeight ? Math.max(ROOM, Math.min(below, window.innerHeight - height - ROOM)) : below;
  panel.style.setProperty("--left", `${left}px`);
  panel.style.setProperty("--top", `${top}px`);
}
