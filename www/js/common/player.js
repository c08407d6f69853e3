// A button that lets time run: something moves until it is pressed again, or has come to its end.

import { make } from "./menu.js";
import { isStill, onStillness } from "./motion.js";

/** A picture that was late is not made up for: no step is longer than this, in seconds. */
const LONGEST = 0.1;
/** Where nothing is to move by itself each press goes on by so much, in seconds. */
const STRIDE = 0.5;

/**
 * @param {string} name what moves, for those who do not see it @param {(seconds: number) => boolean | void} step false: it has come to its end
 * @returns {HTMLButtonElement & { stop(): void }}
 */
export function playButton(name, step) {
  const button = make("button", { type: "button", className: "play", textContent: "▶", label: `Play ${name}`, title: "Play, or stop; one step where your system asks for less motion" });
  let [last, frame] = [0, 0];
  const stop = () => {
    cancelAnimationFrame(frame);
    frame = 0;
    button.setAttribute("aria-pressed", "false");
    button.textContent = "▶";
  };
  /** @param {number} now */
  const run = (now) => {
    // It was taken off the page.
    if (!button.isConnected) return stop();
    const seconds = Math.min(LONGEST, (now - last) / 1000);
    last = now;
    frame = requestAnimationFrame(run);
    if (step(seconds) === false) stop();
  };
  button.setAttribute("aria-pressed", "false");
  button.onclick = () => {
    if (frame) return stop();
    if (isStill()) return void step(STRIDE);
    button.setAttribute("aria-pressed", "true");
    button.textContent = "❚❚";
    last = performance.now();
    frame = requestAnimationFrame(run);
  };
  onStillness(() => isStill() && frame && stop());
  return Object.assign(button, { stop });
}
