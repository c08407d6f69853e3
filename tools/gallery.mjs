// node tools/gallery.mjs: the README's pictures of formulas, in docs/: the report's figures 1 and 2, and the classics.
// The package must be built (npm run build).

import init, { FormulaMap, Texture, presets } from "conformal-warp";
import { readJpeg, save, sheet } from "./pictures.mjs";
import { main, step } from "./steps.mjs";

/** @typedef {import("./pictures.mjs").Pixels} Pixels */
/** @typedef {ReturnType<typeof presets>[number]} Preset */

await main(async () => {
  await init();
  const photo = readJpeg("astronaut.jpg");
  const named = (/** @type {string} */ name) => {
    const preset = presets().find((preset) => preset.name === name);
    if (!preset) throw new Error(`There is no preset "${name}".`);
    return preset;
  };
  const show = (/** @type {string} */ name, /** @type {number} */ size, /** @type {object[]} */ ...overlays) =>
    render(named(name), photo, size, overlays);
  // With the face at 0.
  const face = (/** @type {string} */ name, /** @type {number} */ size, /** @type {object[]} */ ...overlays) =>
    render({ ...named(name), texture: { center: [0.12, -0.55], width: 2 } }, photo, size, overlays);

  const thin = { width: 1.2, color: [255, 255, 255, 150] };
  await step("figure 1", () => {
    const [cosine, lattice] = ["cosine", "fractional-linear-lattice"].map((name) => show(name, 480));
    const [logarithm, photo] = ["logarithm", "fractional-linear"].map((name) => face(name, 480));
    save("figure-1.jpg", sheet([cosine, logarithm, photo, lattice], 2));
  });
  await step("figure 2", () => {
    const preset = named("half-disk");
    const disk = render({ ...preset, formula: "z", view: preset.texture }, photo, 480, []);
    const half = show("half-disk", 480);
    outline(disk, preset.texture, (x, y) => Math.hypot(x, y) - 1);
    outline(half, preset.view, halfDisk);
    save("figure-2.jpg", sheet([disk, half], 2));
  });
  await step("the classics", () => {
    const flow = { kind: "cartesian", spacing: 0.25, ...thin, color: [20, 40, 90, 220] };
    save(
      "formulas.jpg",
      sheet(
        [
          show("exponential", 320),
          face("square", 320, { kind: "polar", spokes: 16, ...thin }),
          show("inversion", 320),
          face("tangent", 320),
          show("joukowski", 320, flow),
          show("cayley", 320, { kind: "cartesian", spacing: 0.5, ...thin }),
          show("droste", 320),
          face("julia", 320),
          render({ ...named("square"), formula: "(z^3 - 1)/(z^2 + z + 2i)", view: { center: [0, 0], width: 5 } }, photo, 320, [
            { kind: "argument" },
            { kind: "polar", spokes: 12, ...thin },
          ]),
        ],
        3,
      ),
    );
  });
});

/**
 * A preset's picture, with overlays.
 *
 * @param {Preset} preset
 * @param {Pixels} photo
 * @param {number} size of the picture's sides, in pixels
 * @param {any[]} overlays options of `FormulaMap.overlay` without the view
 * @returns {Pixels}
 */
function render(preset, photo, size, overlays) {
  const picture = preset.picture === "lattice" ? lattice(512) : photo;
  const texture = new Texture(picture.data, picture.width, picture.height, { wrap: preset.wrap });
  const map = new FormulaMap(preset.formula, { params: preset.params });
  const view = { ...preset.view, pixels: /** @type {[number, number]} */ ([size, size]) };
  const place = { ...preset.texture, pixels: /** @type {[number, number]} */ ([picture.width, picture.height]) };
  const data = map.warp(texture, { texture: place, view, direction: preset.direction, quality: "best" });
  for (const overlay of overlays) map.overlay({ ...overlay, view, out: data });
  map.free();
  texture.free();
  return { width: size, height: size, data };
}

/**
 * A lattice of lines on a pale checkerboard.
 *
 * @param {number} size
 * @returns {Pixels}
 */
function lattice(size) {
  const cell = size / 8;
  const data = new Uint8ClampedArray(4 * size * size);
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const edge = Math.min(x % cell, y % cell, cell - 1 - (x % cell), cell - 1 - (y % cell));
      const odd = (Math.floor(x / cell) + Math.floor(y / cell)) % 2 === 1;
      const color = edge < 3 ? [38, 50, 86] : odd ? [214, 224, 240] : [250, 246, 236];
      data.set([...color, 255], 4 * (y * size + x));
    }
  }
  return { width: size, height: size, data };
}

/** Signed distance to the upper half disk. @param {number} x @param {number} y */
function halfDisk(x, y) {
  return Math.max(Math.hypot(x, y) - 1, -y);
}

/**
 * Draws the line where a signed distance is 0 and pales what lies outside.
 *
 * @param {Pixels} pixels
 * @param {{ center: [number, number], width: number }} view
 * @param {(x: number, y: number) => number} distance in plane units
 */
function outline({ width, height, data }, { center, width: extent }, distance) {
  const size = extent / width;
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      const x = center[0] + (column + 0.5 - width / 2) * size;
      const y = center[1] - (row + 0.5 - height / 2) * size;
      const away = distance(x, y) / size;
      const outside = Math.min(1, Math.max(0, away + 0.5));
      const line = Math.min(1, Math.max(0, 2 - Math.abs(away)));
      const at = 4 * (row * width + column);
      for (let channel = 0; channel < 3; channel++) {
        const paled = data[at + channel] + 0.6 * outside * (255 - data[at + channel]);
        data[at + channel] = paled + line * ([20, 30, 60][channel] - paled);
      }
    }
  }
}
