// Plain data → maps of the visual field. What was solved for an outline is kept, and used for its other landmarks.

import { Region, RetinoCorticalMap, RiemannMap } from "../../pkg/index.js";
import { flatten } from "../common/frame.js";

/** @typedef {import("../../pkg/index.js").Hemisphere} Hemisphere */
/** @typedef {import("./models.js").Spec} Spec */
/** @typedef {import("./models.js").Outline} Outline */

/** The hemispheres in the order in which their halves of the field are seen. @type {Hemisphere[]} */
export const HEMISPHERES = ["right", "left"];

/** Loose enough to be quick: the disk has radius 1, and a hemisphere 80 mm. */
const TOLERANCE = 1e-6;
/** Outlines that are kept. */
const KEPT = 4;

/** @type {Map<string, RiemannMap>} */
const solved = new Map();

/** @param {Outline} outline */
export function solve({ boundary, center }) {
  const place = JSON.stringify([boundary, center]);
  const known = solved.get(place);
  if (known) return known;
  const [toward] = boundary;
  const shape = JSON.stringify(boundary);
  const same = [...solved].find(([key]) => key.startsWith(`[${shape},`));
  const map = same
    ? same[1].withCenter({ center, toward })
    : RiemannMap.solve(new Region({ boundary: flatten(boundary), center, toward }), { tolerance: TOLERANCE });
  solved.set(place, map);
  const [oldest] = solved.keys();
  if (solved.size > KEPT) {
    solved.get(oldest)?.free();
    solved.delete(oldest);
  }
  return map;
}

/** @param {Spec} spec @param {Hemisphere} hemisphere */
export function cortexOf(spec, hemisphere) {
  if (spec.kind === "formula") return RetinoCorticalMap.model({ ...spec.options, hemisphere });
  return RetinoCorticalMap.outline(solve(spec), { direction: spec.direction, hemisphere });
}
