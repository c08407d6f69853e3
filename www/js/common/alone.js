// The pictures alone: in a frame of somebody else's page (?embed in the address), or before a class, on all of the screen.

import { make } from "./menu.js";
import { element } from "./page.js";
import { set, svg } from "./svg.js";

/** Corners of a screen, and the same turned inwards. */
const OUT = "M3 7.5V3.5h4.5M12.5 3.5H17v4M17 12.5v4h-4.5M7.5 16.5H3v-4";
const IN = "M7.5 3.5v4H3M17 7.5h-4.5v-4M12.5 16.5v-4H17M3 12.5h4.5v4";

/** Whether the page is in a frame that asked for the pictures alone. */
const embedded = () => new URLSearchParams(location.search).has("embed");

/** Hides what is beside the pictures where a frame asks for that, and offers the projector's view. @param {() => void} onChange called when lines are to be drawn anew */
export function offerAlone(onChange) {
  if (embedded()) {
    document.body.classList.add("embed");
    const whole = make("a", { className: "whole", target: "_blank", rel: "noopener", textContent: "Open the page" });
    const lead = () => (whole.href = `${location.pathname}${location.hash}`);
    for (const event of ["pointerdown", "focus"]) whole.addEventListener(event, lead);
    lead();
    document.body.append(whole);
    return;
  }
  const shape = svg("path", { d: OUT });
  const button = make("button", { type: "button", id: "present", className: "icon", label: "Projector: the pictures alone, on all of the screen" });
  button.title = "Projector: the pictures alone, on all of the screen (P)";
  button.append(svg("svg", { viewBox: "0 0 20 20", "aria-hidden": "true" }, [shape]));
  /** @param {boolean} on */
  const present = async (on) => {
    document.body.classList.toggle("projector", on);
    button.setAttribute("aria-pressed", String(on));
    set(shape, { d: on ? IN : OUT });
    // Where a browser gives no full screen the window is used.
    const screen = on ? document.documentElement.requestFullscreen?.() : document.fullscreenElement && document.exitFullscreen();
    await Promise.resolve(screen).catch(() => {});
    onChange();
  };
  button.setAttribute("aria-pressed", "false");
  button.onclick = () => present(!document.body.classList.contains("projector"));
  document.addEventListener("fullscreenchange", () => {
    if (!document.fullscreenElement && document.body.classList.contains("projector")) present(false);
  });
  window.addEventListener("keydown", ({ key, target, ctrlKey, metaKey, altKey }) => {
    const typing = target instanceof Element && target.closest("input:not([type=range], [type=checkbox]), textarea, select");
    if (key.toLowerCase() === "p" && !typing && !ctrlKey && !metaKey && !altKey) button.click();
  });
  // After the menu of Save, which stands after its button.
  element("save-menu").after(button);
}
