// Which regions go into each other, by the holes that they have.

/** @param {number} count */
const holesIn = (count) => (count ? (count === 1 ? "one hole" : `${count} holes`) : "none");

/**
 * Whether regions go into each other by rings, and not by disks. Throws words for those that do not go into each other at all.
 * @param {{ from: { holes: string[] }, to: { holes: string[] } }} job
 */
export function goesByRings({ from, to }) {
  const [first, second] = [from.holes.length, to.holes.length];
  if (first !== second) {
    const words = `The first region has ${first ? holesIn(first) : "no hole"}, the second ${holesIn(second)}: no conformal map changes that. Draw a hole, or take one out (Shift Delete at a point of it), until each has one, or none.`;
    throw Object.assign(new Error(words), { code: "different-holes" });
  }
  if (first > 1) {
    const words = `Each region has ${first} holes: a conformal map would need ${3 * first - 3} numbers of them, the moduli, to agree. Leave each one hole, or none; see each alone on the page Region to disk.`;
    throw Object.assign(new Error(words), { code: "many-holes" });
  }
  return first === 1;
}
