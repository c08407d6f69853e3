// The keys that work everywhere on a page.

/** @typedef {import("./frame.js").Point} Point */

/** Where the arrow keys lead in a plane. @type {Map<string, Point>} */
export const ARROWS = new Map([["ArrowLeft", [-1, 0]], ["ArrowRight", [1, 0]], ["ArrowUp", [0, 1]], ["ArrowDown", [0, -1]]]);

/** Ctrl Z, Ctrl Shift Z and Ctrl Y, but for those who type, and for a drawing that has its own. @param {() => void} undo @param {() => void} redo */
export function onUndoKeys(undo, redo) {
  window.addEventListener("keydown", (event) => {
    const meaning = undoOrRedo(event);
    if (!meaning || event.defaultPrevented || types(event.target)) return;
    event.preventDefault();
    if (meaning === "undo") undo();
    else redo();
  });
}

/** @param {KeyboardEvent} event @returns {"undo" | "redo" | null} */
export function undoOrRedo(event) {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return null;
  const key = event.key.toLowerCase();
  if (key === "z") return event.shiftKey ? "redo" : "undo";
  return key === "y" ? "redo" : null;
}

/** Escape, whoever has the focus, unless somebody else has taken it. @param {() => boolean} cancel whether there was something to cancel */
export function onEscape(cancel) {
  window.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && !event.defaultPrevented && cancel()) event.preventDefault();
  });
}

/** Whether keys are text there. @param {EventTarget | null} target */
function types(target) {
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLInputElement && !["range", "checkbox", "file"].includes(target.type));
}
