// node tools/figures.mjs: the report's figures 3 to 6 on the README's photo, in docs/. The package must be built
// (npm run build).

import init, { JointTriangulation, Region, RiemannMap, Texture } from "conformal-warp";
import { readJpeg, save, sheet } from "./pictures.mjs";
import { main, step } from "./steps.mjs";

/** @typedef {import("./pictures.mjs").Pixels} Pixels */
/** @typedef {{ center: [number, number], width: number, pixels: [number, number] }} Frame */
/** @typedef {{ points: Float64Array, triangles: Uint32Array, outline: Uint32Array }} Copy one copy of a mesh */

const SIZE = 512;
const INK = [16, 42, 82];
const LIGHT = [255, 238, 150];

// The photo, 512 × 512, in the plane: one unit a pixel, y up. As in the report, the point that is fixed is the
// highlight on the nose, and the inward vector comes from above the forehead.
/** @type {Frame} */
const photoFrame = { center: [256, -256], width: 512, pixels: [512, 512] };
/** The same plane, closer to the region. @type {Frame} */
const headFrame = { center: [217, -155], width: 324, pixels: [512, 512] };
const nose = [225, 125];
const head = outlineOf(
  "146 148, 128 96, 142 44, 176 14, 226 4, 276 16, 306 56, 312 104, 292 150, 300 182, 330 214, 322 260, 290 292, " +
    "236 306, 180 300, 132 276, 104 236, 106 196, 130 172",
);
const headTop = [226, 4];

// Another region for figures 5 and 6: a spade with a notch and a long tail.
const leaf = outlineOf(
  "256 20, 318 92, 412 120, 486 196, 470 286, 398 330, 330 312, 300 330, 318 400, 366 474, 286 446, 250 490, 226 440, 150 470, " +
    "196 398, 212 330, 180 312, 112 330, 40 286, 28 196, 100 120, 194 92",
);
const leafCenter = [250, 220];
const leafTop = [256, 20];

/** "x y, x y, …" in pixels, y down → a boundary in the plane. @param {string} text */
function outlineOf(text) {
  return Float64Array.from(text.split(",").flatMap((pair) => inPlane(pair.trim().split(" ").map(Number))));
}

/** @param {number[]} pixel @returns {[number, number]} */
function inPlane([x, y]) {
  return [x, -y];
}

await main(async () => {
  await init();
  const photo = readJpeg("astronaut.jpg");
  const texture = new Texture(photo.data, photo.width, photo.height, { wrap: "transparent" });
  const from = solve(head, nose, headTop);
  const to = solve(leaf, leafCenter, leafTop);
  /** @type {Frame} */
  const disk = { center: [0, 0], width: 2.1, pixels: [SIZE, SIZE] };

  const coarse = { spacing: 17 };
  await step("figure 3", () => {
    const mesh = JointTriangulation.regionToDisk(from, coarse);
    const [source, target] = copies(mesh);
    const region = drawVector(sketch(outlineOnly(source), headFrame), headFrame, nose, headTop);
    save("figure-3.jpg", sheet([region, dots(source, headFrame), sketch(target, disk), sketch(source, headFrame)], 2));
    tell(mesh);
  });
  await step("figure 4", () => {
    const mesh = JointTriangulation.regionToDisk(from, coarse);
    const exact = JointTriangulation.regionToDisk(from, { frame: disk });
    const [source, target] = copies(mesh);
    const data = exact.warp(texture, { texture: photoFrame, view: disk, quality: "best" });
    const warped = { width: SIZE, height: SIZE, data };
    save("figure-4.jpg", sheet([photo, overlay(photo, source, photoFrame), warped, overlay(warped, target, disk)], 2));
    tell(exact);
  });
  const [fine, exact] = [coarse, { frame: photoFrame }].map((density) =>
    JointTriangulation.regionToRegion(from, to, density),
  );
  await step("figure 5", () => {
    const [source, target] = copies(fine);
    const onDisk = { ...source, points: from.toDisk(source.points) };
    const region = drawVector(sketch(outlineOnly(target), photoFrame), photoFrame, leafCenter, leafTop);
    save("figure-5.jpg", sheet([region, dots(target, photoFrame), sketch(onDisk, disk), sketch(target, photoFrame)], 2));
    tell(fine);
  });
  await step("figure 6", () => {
    const [source, target] = copies(fine);
    const data = exact.warp(texture, { texture: photoFrame, view: photoFrame, quality: "best" });
    const warped = { width: SIZE, height: SIZE, data };
    save("figure-6.jpg", sheet([photo, overlay(photo, source, photoFrame), warped, overlay(warped, target, photoFrame)], 2));
    tell(exact);
  });
});

/** @param {Float64Array} boundary @param {number[]} center @param {number[]} toward @returns {RiemannMap} */
function solve(boundary, center, toward) {
  return RiemannMap.solve(new Region({ boundary, center: inPlane(center), toward: inPlane(toward) }));
}

/** @param {JointTriangulation} mesh */
function tell(mesh) {
  mesh.validate();
  console.log(`  ${mesh.source.length / 2} nodes, ${mesh.triangles.length / 3} triangles`, mesh.evidence);
}

/** @param {JointTriangulation} mesh @returns {Copy[]} source and target */
function copies(mesh) {
  const { triangles, outline } = mesh;
  return [mesh.source, mesh.target].map((points) => ({ points, triangles, outline }));
}

/** @param {Copy} copy @returns {Copy} */
function outlineOnly(copy) {
  return { ...copy, triangles: new Uint32Array() };
}

/** The mesh as lines on paper. @param {Copy} copy @param {Frame} frame @returns {Pixels} */
function sketch(copy, frame) {
  const paper = { width: SIZE, height: SIZE, data: new Uint8ClampedArray(4 * SIZE * SIZE).fill(255) };
  drawMesh(paper, copy, frame, INK, 0.75);
  return paper;
}

/** The nodes as dots, and the outline. @param {Copy} copy @param {Frame} frame @returns {Pixels} */
function dots(copy, frame) {
  const paper = sketch(outlineOnly(copy), frame);
  const place = placing(copy.points, frame);
  for (let k = 0; k < copy.points.length / 2; k++) drawLine(paper, place(k), place(k), 3.5, INK, 1);
  return paper;
}

/** The mesh over a picture. @param {Pixels} picture @param {Copy} copy @param {Frame} frame @returns {Pixels} */
function overlay(picture, copy, frame) {
  const over = { ...picture, data: Uint8ClampedArray.from(picture.data) };
  drawMesh(over, copy, frame, LIGHT, 0.75);
  return over;
}

/**
 * The inward vector, from the boundary to the center.
 *
 * @param {Pixels} picture
 * @param {Frame} frame
 * @param {number[]} center
 * @param {number[]} toward
 */
function drawVector(picture, frame, center, toward) {
  const place = placing(Float64Array.from([...inPlane(toward), ...inPlane(center)]), frame);
  const red = [190, 40, 40];
  drawLine(picture, place(0), place(1), 2, red, 1);
  drawLine(picture, place(1), place(1), 8, red, 1);
  return picture;
}

/** @param {Pixels} picture @param {Copy} copy @param {Frame} frame @param {number[]} color @param {number} opacity */
function drawMesh(picture, { points, triangles, outline }, frame, color, opacity) {
  const place = placing(points, frame);
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const [a, b] = [triangles[t + k], triangles[t + ((k + 1) % 3)]];
      if (a < b) drawLine(picture, place(a), place(b), 0.7, color, opacity);
    }
  }
  outline.forEach((a, k) => drawLine(picture, place(a), place(outline[(k + 1) % outline.length]), 1.6, color, 1));
}

/**
 * Node → pixels.
 *
 * @param {Float64Array} points
 * @param {Frame} frame
 * @returns {(node: number) => number[]}
 */
function placing(points, { center, width, pixels }) {
  const scale = pixels[0] / width;
  return (node) => [
    (points[2 * node] - center[0]) * scale + pixels[0] / 2,
    pixels[1] / 2 - (points[2 * node + 1] - center[1]) * scale,
  ];
}

/**
 * A line with round ends, antialiased.
 *
 * @param {Pixels} picture
 * @param {number[]} a
 * @param {number[]} b
 * @param {number} thickness
 * @param {number[]} color
 * @param {number} opacity
 */
function drawLine({ width, height, data }, a, b, thickness, color, opacity) {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const length = dx * dx + dy * dy || 1;
  const reach = thickness / 2 + 1;
  const [left, right] = [Math.min(a[0], b[0]) - reach, Math.max(a[0], b[0]) + reach];
  const [top, bottom] = [Math.min(a[1], b[1]) - reach, Math.max(a[1], b[1]) + reach];
  for (let y = Math.max(0, Math.floor(top)); y < Math.min(height, bottom); y++) {
    for (let x = Math.max(0, Math.floor(left)); x < Math.min(width, right); x++) {
      const [px, py] = [x + 0.5 - a[0], y + 0.5 - a[1]];
      const share = Math.min(1, Math.max(0, (px * dx + py * dy) / length));
      const away = Math.hypot(px - share * dx, py - share * dy);
      const alpha = opacity * Math.min(1, Math.max(0, thickness / 2 + 0.5 - away));
      if (alpha === 0) continue;
      const at = 4 * (y * width + x);
      const under = data[at + 3] / 255;
      for (let c = 0; c < 3; c++) {
        const below = 255 + under * (data[at + c] - 255);
        data[at + c] = below + alpha * (color[c] - below);
      }
      data[at + 3] = 255;
    }
  }
}
