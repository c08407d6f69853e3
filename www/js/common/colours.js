// The colour space of photos, on the page and in its workers: Display P3 where the screen shows it and the browser draws it.

/** Workers are told by their name. */
const onPage = typeof document !== "undefined";

/** @returns {PredefinedColorSpace} */
function spaceOfPage() {
  if (!matchMedia("(color-gamut: p3)").matches) return "srgb";
  const context = document.createElement("canvas").getContext("2d", { colorSpace: "display-p3" });
  // Browsers that know no other space take no notice of the wish.
  return context?.getContextAttributes?.().colorSpace === "display-p3" ? "display-p3" : "srgb";
}

/** What the bytes of photos, and of what becomes of them, mean. @type {PredefinedColorSpace} */
export const SPACE = onPage ? spaceOfPage() : self.name === "display-p3" ? "display-p3" : "srgb";

/** How workers are started. @type {WorkerOptions} */
export const WORKER = { type: "module", name: SPACE };

/** Pixels of a photo, or of what became of one. @param {Uint8ClampedArray} pixels @param {number} width @param {number} height @param {PredefinedColorSpace} [space] */
export const imageOf = (pixels, width, height, space = SPACE) => new ImageData(/** @type {Uint8ClampedArray<ArrayBuffer>} */ (pixels), width, height, { colorSpace: space });

/** A canvas off the page. @param {number} width @param {number} height @param {PredefinedColorSpace} [space] */
export function offscreen(width, height, space = SPACE) {
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true, colorSpace: space });
  if (!context) throw new Error("This browser gives no 2d canvas.");
  return context;
}
