// Sets of conductors: cross-sections of lines, wires and shields.

/** @typedef {import("../common/frame.js").Point} Point */
/**
 * @typedef {object} Conductors
 * @property {string} title
 * @property {Point[][]} outlines counter-clockwise
 * @property {Point[]} [shield] a conductor around all others; the field is within it
 * @property {"polygon" | "smooth"} curve
 * @property {number[]} potentials in volts; the shield's comes first
 */

/** @param {Point} center @param {number} radius @returns {Point[]} */
const circle = ([x, y], radius) =>
  Array.from({ length: 64 }, (_, k) => [x + radius * Math.cos((2 * Math.PI * k) / 64), y + radius * Math.sin((2 * Math.PI * k) / 64)]);

/** @param {Point} center @param {number} width @param {number} height @returns {Point[]} */
const bar = ([x, y], width, height) => [[x - width / 2, y - height / 2], [x + width / 2, y - height / 2], [x + width / 2, y + height / 2], [x - width / 2, y + height / 2]];

/** @type {Map<string, Conductors>} */
export const conductors = new Map(Object.entries({
  pair: { title: "Two wires", outlines: [circle([-0.9, 0], 0.4), circle([0.9, 0], 0.4)], curve: "smooth", potentials: [1, -1] },
  strip: { title: "Strip over a plate", outlines: [bar([0, 0.25], 1.4, 0.16), bar([0, -0.5], 3.6, 0.16)], curve: "polygon", potentials: [1, -1] },
  capacitor: { title: "Plates of a capacitor", outlines: [bar([0, 0.4], 2.6, 0.1), bar([0, -0.4], 2.6, 0.1)], curve: "polygon", potentials: [1, -1] },
  edges: { title: "A square and a round wire", outlines: [bar([-1, 0], 1, 1), circle([1, 0], 0.5).filter((_, k) => k % 4 === 0)], curve: "polygon", potentials: [1, -1] },
  three: { title: "Three wires", outlines: [circle([-1.1, -0.5], 0.3), circle([1.1, -0.5], 0.3), circle([0, 0.8], 0.3)], curve: "smooth", potentials: [1, 1, -1] },
  coax: { title: "Wire in a shield", shield: circle([0, 0], 1.65), outlines: [circle([0.3, 0.1], 0.4)], curve: "smooth", potentials: [-1, 1] },
  twin: { title: "Two wires in a square shield", shield: bar([0, 0], 4.4, 3.1), outlines: [bar([-0.9, 0], 0.7, 0.7), bar([0.9, 0], 0.7, 0.7)], curve: "polygon", potentials: [0, 1, -1] },
}));
