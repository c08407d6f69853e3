// Whether somebody asked their system for pictures that do not move by themselves.

const STILL = matchMedia("(prefers-reduced-motion: reduce)");

export const isStill = () => STILL.matches;

/** @param {() => void} act called when that is asked for, or no more */
export const onStillness = (act) => STILL.addEventListener("change", act);
