// The picture of one region in the other, and its lines, to be saved.

import { Texture } from "../../pkg/index.js";
import { scaledTo } from "../common/frame.js";
import { arrowLines, meshEdges } from "../common/layers.js";
import { BAND, bitmapOf } from "../common/plate.js";
import { drawnLayers } from "../editor/overlays.js";
import { linesOf } from "../editor/path.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/probe.js").Side} Side */
/** @typedef {import("./pipeline.js").Over} Over */
/** @typedef {import("./pipeline.js").SavedJob} SavedJob */
/**
 * What is drawn: by what, |f'| as colours over the first region, lines, and the mesh, if there is one.
 * @typedef {{ map: import("../common/point-by-point.js").Drawing, heat: import("../editor/overlays.js").Heat | null, over: Over, mesh?: import("../editor/locate.js").Mesh | null, free(): void }} Drawn
 */

/** @param {SavedJob} job @param {{ texture: Texture, frame: Frame }} picture @param {Drawn} drawn @returns {Promise<import("../common/plate.js").Plate>} */
export async function plateOf(job, { texture, frame }, { map, heat, over, mesh, free }) {
  const { view, behind } = job;
  const colours = heat && new Texture(heat.pixels, ...heat.frame.pixels);
  const edges = mesh && job.show.mesh ? meshEdges(mesh.triangles) : null;
  const way = { view, direction: /** @type {const} */ ("push-forward"), quality: /** @type {const} */ ("best") };
  /** @param {import("../editor/solved-map.js").Outline} outline @param {Side} side @param {Frame} place @returns {import("../common/layers.js").Layer[]} */
  const lines = ({ boundary, holes, center, toward }, side, place) => [
    ...drawnLayers(over[side], mesh?.[side], edges),
    { ink: "outline", lines: [boundary, ...linesOf(holes)], closed: true },
    { ink: "vector", lines: arrowLines(toward, center, place) },
  ];
  return {
    frame: view,
    band: BAND,
    draw: (rows) => map.warp(texture, { ...way, texture: frame, rows }),
    tint: colours && heat && ((rows) => map.warp(colours, { ...way, texture: heat.frame, rows })),
    behind: { picture: await bitmapOf(behind), frame: behind.frame },
    panels: [
      { name: "first", frame: scaledTo(frame, view.pixels[0]), layers: lines(job.from, "source", frame) },
      { name: "second", frame: view, layers: lines(job.to, "target", view) },
    ],
    free: () => {
      free();
      colours?.free();
    },
  };
}
