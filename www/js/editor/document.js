// What an address says of a drawing → the document.

import { defaultRegion, shapeRegion } from "./presets.js";
import { makeRegion, towardPoint } from "./region.js";

/** @typedef {import("./store.js").Document} Document */

/**
 * @param {import("./url.js").Fields} fields @param {Document} usual what holds where they say nothing
 * @param {(image: string) => import("../common/frame.js").Frame} frameOf a picture @returns {Document}
 */
export function documentOf(fields, usual, frameOf) {
  const { image = usual.image, shape, region, path, holes, center, toward } = fields;
  const drawn = path ?? region;
  if (drawn) return { image, region: makeRegion(drawn, center, toward, holes) };
  const frame = frameOf(image);
  const named = shape ? shapeRegion(shape, frame.pixels) : image === usual.image ? usual.region : defaultRegion({ id: image, frame });
  if (!center && !toward && !holes) return { image, region: named };
  return { image, region: makeRegion(named, center ?? (holes ? undefined : named.center), toward ?? towardPoint(named), holes ?? named.holes) };
}
