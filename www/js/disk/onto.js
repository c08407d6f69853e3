// What a region with holes becomes.

/** @typedef {import("../editor/store.js").Onto} Onto */

/** What holes become where nobody chose, or what was chosen cannot be. @param {Onto | null} wanted @param {number} holes @returns {Onto} */
export function ontoOf(wanted, holes) {
  if (wanted && (wanted !== "ring" || holes === 1)) return wanted;
  return holes === 1 ? "ring" : "circles";
}
