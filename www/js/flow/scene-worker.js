// The worker that makes files of flows and fields.

import { imageOf, offscreen } from "../common/colours.js";
import { flatten, scaledTo, toPlane } from "../common/frame.js";
import { serveJobs } from "../common/serve.js";
import { drawBodies, drawGround, drawLines, drawMarks } from "./scene.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/layers.js").Drawing} Drawing */
/** @typedef {import("./scene.js").Scene} Scene */
/** `density`: pixels of the picture that stand for one of the page. @typedef {{ version: number, scene: Scene, frame: Frame, density: number, drawing: boolean, name: string }} Job */

/** Scales of colours are sRGB's. */
const SPACE_OF_PLATES = "srgb";
/** Rows that are drawn at once. */
const BAND = 512;

// Lines and bodies are drawn by the browser alone.
serveJobs({
  setPicture() {},

  run() {
    throw new Error("Pictures of scenes are drawn on the page.");
  },

  /** @param {Job} job @returns {Promise<import("../common/plate.js").Plate>} */
  async plate({ scene, frame, density, drawing, name }) {
    const { plate } = scene;
    const colours = plate && (await createImageBitmap(imageOf(plate.pixels, ...plate.size, SPACE_OF_PLATES)));
    /** @param {[number, number]} rows @param {(drawing: Drawing) => void} draw */
    const band = ([from, to], draw) => {
      const [width, height] = [frame.pixels[0], to - from];
      const context = offscreen(width, height, SPACE_OF_PLATES);
      context.translate(0, -from);
      draw({ context, frame, density });
      return context.getImageData(0, 0, width, height).data;
    };
    return {
      frame,
      band: BAND,
      draw: (rows) => band(rows, (on) => {
        on.context.fillStyle = scene.palette.paper;
        on.context.fillRect(0, 0, ...frame.pixels);
        drawGround(on, scene, colours);
        drawBodies(on, scene);
      }),
      tint: (rows) => band(rows, (on) => {
        drawLines(on, scene);
        drawMarks(on, scene);
      }),
      space: SPACE_OF_PLATES,
      panels: drawing ? [{ name, frame: scaledTo(frame, 1000), layers: layersOf(scene) }] : [],
      free: () => colours?.close(),
    };
  },
}, async () => undefined);

/** @param {Scene} scene @returns {import("../common/layers.js").Layer[]} */
function layersOf({ grid, strokes, bodies }) {
  const lines = strokes.flatMap(({ lines, pieces = [] }) => [
    ...lines.map(flatten),
    ...Array.from({ length: pieces.length / 4 }, (_, k) => flatten([toPlane(grid, [pieces[4 * k], pieces[4 * k + 1]]), toPlane(grid, [pieces[4 * k + 2], pieces[4 * k + 3]])])),
  ]);
  return [
    { ink: "lines", lines },
    { ink: "outline", closed: true, lines: bodies.map(({ outline }) => flatten(outline)) },
  ];
}
