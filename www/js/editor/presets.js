// A region drawn for each of the photos, and shapes that fit any photo.

import { photoFrame, toPlane } from "../common/frame.js";
import { photos } from "../common/photos.js";
import { placed } from "./outline.js";
import { readPath, readPaths } from "./path.js";
import { makeRegion } from "./region.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("./region.js").Region} Region */
/** In a photo's pixels. @typedef {{ outline: Point[], center: Point, toward: Point }} Drawn */

/** The region drawn for each photo. @type {Map<string, Drawn>} */
const drawn = new Map(Object.entries({
  astronaut: {
    outline: [
      [196, 22], [232, 14], [268, 22], [292, 46], [303, 84], [290, 118], [272, 140], [258, 168], [296, 206],
      [306, 248], [286, 284], [238, 298], [186, 288], [146, 258], [120, 216], [124, 176], [152, 152], [180, 150],
      [184, 132], [160, 104], [154, 74], [170, 40],
    ],
    center: [222, 108],
    toward: [286, 123],
  },
  chelsea: {
    outline: [
      [34, 96], [44, 34], [96, 8], [180, 4], [262, 8], [330, 22], [362, 66], [368, 120], [352, 168], [330, 216],
      [304, 258], [262, 284], [212, 270], [164, 236], [110, 204], [58, 168],
    ],
    center: [256, 150],
    toward: [353.2, 164.6],
  },
  coffee: {
    outline: [
      [180, 52], [214, 26], [270, 16], [340, 28], [388, 54], [404, 68], [424, 74], [420, 108], [462, 160], [480, 220],
      [462, 292], [408, 350], [330, 384], [244, 380], [158, 346], [102, 290], [78, 222], [92, 158], [132, 108], [174, 84],
    ],
    center: [290, 128],
    toward: [422.1, 89.8],
  },
  retina: {
    outline: [
      [110, 640], [160, 470], [330, 330], [560, 290], [800, 340], [1010, 440], [1150, 580], [1200, 720],
      [1130, 860], [980, 990], [780, 1060], [540, 1070], [320, 1000], [160, 850],
    ],
    center: [560, 690],
    toward: [1179.8, 663.4],
  },
}));

/** @type {(count: number, at: (turns: number, k: number) => Point) => Point[]} */
const around = (count, at) => Array.from({ length: count }, (_, k) => at(k / count, k));

/** @type {(radius: number, turns: number) => Point} */
const polar = (radius, turns) => [radius * Math.cos(2 * Math.PI * turns), radius * Math.sin(2 * Math.PI * turns)];

/** A band along four fifths of a circle, open to the right. */
function horseshoe() {
  /** @type {(radius: number) => Point[]} */
  const arc = (radius) => around(31, (_, k) => polar(radius, 0.1 + (0.8 * k) / 30));
  return [...arc(0.9), ...arc(0.48).reverse()];
}

/** A rough coast of a hundred corners, always the same one. */
function coast() {
  return around(100, (turns, k) => {
    const slow = 0.16 * Math.cos(2 * Math.PI * (2 * turns + 0.1)) + 0.12 * Math.sin(2 * Math.PI * 5 * turns);
    const rough = 0.06 * Math.sin(k * k * 12.9898);
    return polar(0.74 + slow + rough, turns);
  });
}

/** An outline about [−1, 1] in size: points, or a path with y upwards. @typedef {{ title: string } & ({ outline: Point[], path?: undefined } | { path: string })} Shape */

/** Shapes, stretched to fit the photo. @type {Map<string, Shape>} */
export const shapes = new Map(Object.entries({
  square: { title: "Square", outline: [[-0.75, -0.75], [0.75, -0.75], [0.75, 0.75], [-0.75, 0.75]] },
  ell: { title: "L", outline: [[-0.8, -0.8], [0.8, -0.8], [0.8, 0], [0, 0], [0, 0.8], [-0.8, 0.8]] },
  star: { title: "Star", outline: around(10, (turns, k) => polar(k % 2 ? 0.42 : 0.95, turns + 0.05)) },
  ellipse: { title: "Ellipse", outline: around(64, (turns) => [0.9 * polar(1, turns)[0], 0.5 * polar(1, turns)[1]]) },
  slit: {
    title: "Slit",
    outline: [[-0.8, -0.8], [0.8, -0.8], [0.8, -0.01], [-0.1, -0.01], [-0.1, 0.01], [0.8, 0.01], [0.8, 0.8], [-0.8, 0.8]],
  },
  dumbbell: {
    title: "Two rooms",
    outline: [
      [-0.9, -0.4], [-0.15, -0.4], [-0.15, -0.1], [0.15, -0.1], [0.15, -0.4], [0.9, -0.4],
      [0.9, 0.4], [0.15, 0.4], [0.15, 0.1], [-0.15, 0.1], [-0.15, 0.4], [-0.9, 0.4],
    ],
  },
  horseshoe: { title: "Horseshoe", outline: horseshoe() },
  coast: { title: "Coast, 100 corners", outline: coast() },
  half: { title: "Half disk", path: "M-.9-.45L.9-.45A.9 .9 0 0 1-.9-.45Z" },
  lens: { title: "Lens", path: "M.9 0A1.1 1.1 0 0 1-.9 0A1.1 1.1 0 0 1 .9 0Z" },
  leaf: { title: "Leaf", path: "M-.9-.6C0-.8 .8-.2 .9 .7C0 .9-.8 .4-.9-.6Z" },
  heart: { title: "Heart", path: "M0-.85C.3-.5 .95-.15 .95 .35C.95 .65 .72 .85 .45 .85C.22 .85 .06 .7 0 .5C-.06 .7-.22 .85-.45 .85C-.72 .85-.95 .65-.95 .35C-.95-.15-.3-.5 0-.85Z" },
}));

/** The same with holes. @type {Map<string, Shape & { holes: string }>} */
export const holedShapes = new Map(Object.entries({
  frame: { title: "Frame, one hole", outline: [[-0.85, -0.85], [0.85, -0.85], [0.85, 0.85], [-0.85, 0.85]], holes: "M-.4-.4L.4-.4L.4 .4L-.4 .4Z" },
  mask: {
    title: "Mask, three holes",
    path: "M0-.9C.5-.9 .85-.3 .85 .2C.85 .65 .5 .9 0 .9C-.5 .9-.85 .65-.85 .2C-.85-.3-.5-.9 0-.9Z",
    holes: "M-.58 .24C-.5 .06-.24 .06-.16 .24C-.24 .42-.5 .42-.58 .24ZM.16 .24C.24 .06 .5 .06 .58 .24C.5 .42 .24 .42 .16 .24ZM-.34-.36C-.2-.62 .2-.62 .34-.36C.12-.46-.12-.46-.34-.36Z",
  },
}));

/** In the menu of shapes: one of the visitor's own, and one of the letters. */
export const READ = "read";
export const LETTER = "letter";

/** Fills a menu with all shapes. @param {HTMLSelectElement} select */
export function listShapes(select) {
  const all = [...shapes, ...holedShapes];
  select.append(...all.map(([name, { title }]) => new Option(title, name)), new Option("A letter\u200a…", LETTER), new Option("From a file or text\u200a…", READ));
}

/** The first region on a picture: the one drawn for the photo, or an ellipse. @param {{ id: string, frame: import("../common/frame.js").Frame }} picture @returns {Region} */
export function defaultRegion({ id, frame }) {
  const drawing = drawn.get(id);
  return drawing ? regionOn(id, drawing) : shapeRegion("ellipse", frame.pixels);
}

/** The region drawn for a photo of the page. @param {string} name @returns {Region} */
export function photoRegion(name) {
  return defaultRegion({ id: name, frame: frameOf(name) });
}

/** The frame of a photo that need not be loaded. @param {string} name */
export function frameOf(name) {
  return photoFrame(...(photos.get(name)?.size ?? /** @type {[number, number]} */ ([1, 1])));
}

/** A region given in a photo's pixels. @param {string} name @param {Drawn} drawing @returns {Region} */
export function regionOn(name, { outline, center, toward }) {
  const frame = frameOf(name);
  /** @param {Point} pixel */
  const plane = (pixel) => toPlane(frame, pixel);
  return makeRegion(outline.map(plane), plane(center), plane(toward));
}

/** A shape in the middle of a photo, as large as fits. @param {string} name @param {Point} size of the photo @returns {Region} */
export function shapeRegion(name, [width, height]) {
  const scale = Math.min(width, height) / Math.max(width, height);
  const holed = holedShapes.get(name);
  const shape = holed ?? shapes.get(name);
  const outline = shape?.path === undefined ? { boundary: shape?.outline ?? [] } : readPath(shape.path);
  /** @param {import("./outline.js").Outline} drawn */
  const fitted = (drawn) => placed(drawn, scale, [0, 0]);
  return makeRegion(fitted(outline), undefined, undefined, holed && readPaths(holed.holes).map(fitted));
}
