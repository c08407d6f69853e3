// What maps say over both pictures, as it is drawn: lines, fences, triangles, |f'| as colours; each made when first shown.

import { canvasOf } from "../common/canvas.js";
import { meshEdges } from "../common/layers.js";

/** @typedef {import("../common/layers.js").Layer} Layer */
/** @typedef {import("../common/probe.js").Side} Side */
/** @typedef {import("./locate.js").Mesh} Mesh */
/** @typedef {import("./photo-view.js").Placed} Placed */
/** @typedef {import("./store.js").Shown} Shown */
/** Colours over a part of the plane. @typedef {{ pixels: Uint8ClampedArray<ArrayBuffer>, frame: import("../common/frame.js").Frame }} Heat */
/** What a map says on one side: lines of the grid, the measure's fence, |f'| as colours. @typedef {{ lines: Float64Array[], fence: Float64Array | null, heat: Heat | null }} Over */
/** What is to be found out for that. @typedef {{ mesh: boolean, grid: import("./field.js").Grid | null, heat: boolean, measure: boolean }} Wishes */

/** What is to be found out to show that. @param {Shown} shown @param {boolean} all that a drawing has, shown or not @returns {Wishes} */
export function wishesOf({ mesh, grid, field, heat, measure, density }, all) {
  return { mesh: mesh || all, grid: grid || field || all ? { field, density } : null, heat, measure };
}

/** The pictures in what maps say: they are handed over instead of copied. @param {Record<Side, Over>} over */
export const heatPixels = (over) => [over.source, over.target].flatMap(({ heat }) => (heat ? [heat.pixels] : []));

export class Overlays {
  #mesh;
  #over;
  /** @type {Uint32Array | undefined} */ #edges;
  /** @type {Partial<Record<Side, Placed>>} */ #heats = {};

  /** @param {Mesh | null} mesh @param {Record<Side, Over>} over */
  constructor(mesh, over) {
    this.#mesh = mesh;
    this.#over = over;
  }

  /** The lines of a side. @param {Side} side @param {Shown} shown @returns {Layer[]} */
  layers(side, shown) {
    const { lines, fence } = this.#over[side];
    const mesh = this.#mesh;
    return [
      ...(shown.measure && fence ? [fenceLayer(fence)] : []),
      ...(shown.mesh && mesh ? [/** @type {Layer} */ ({ ink: "mesh", points: mesh[side], edges: (this.#edges ??= meshEdges(mesh.triangles)) })] : []),
      ...(shown.grid || shown.field ? [/** @type {Layer} */ ({ ink: "lines", lines })] : []),
    ];
  }

  /** |f'| as colours. @param {Side} side @param {Shown} shown @returns {Placed | null} */
  heat(side, shown) {
    const { heat } = this.#over[side];
    if (!shown.heat || !heat) return null;
    return (this.#heats[side] ??= { picture: canvasOf(heat.pixels, heat.frame.pixels, "srgb"), frame: heat.frame });
  }
}

/** @param {Float64Array} fence @returns {Layer} */
const fenceLayer = (fence) => ({ ink: "fence", lines: [fence], closed: true });

/** The lines of a drawing's file. @param {Over} over @param {Float64Array | undefined} points of the triangles @param {Uint32Array | null} edges @returns {Layer[]} */
export function drawnLayers({ lines, fence }, points, edges) {
  return [
    ...(fence ? [fenceLayer(fence)] : []),
    ...(points && edges ? [/** @type {Layer} */ ({ ink: "mesh", points, edges })] : []),
    ...(lines.length ? [/** @type {Layer} */ ({ ink: "lines", lines })] : []),
  ];
}
