// Joint triangulations: making them, and drawing pictures through them.

import { JointTriangulation, RiemannMap, Texture } from "conformal-warp";
import { fixture, regionOf } from "./lib/fixtures.mjs";
import { remapper } from "./lib/opencv.mjs";
import { peer, peerFile } from "./lib/peers.mjs";
import { coordinates, picture } from "./lib/pictures.mjs";
import { Table, Target, ms, ratio } from "./lib/table.mjs";
import { inTurns, milliseconds } from "./lib/timing.mjs";

/** @typedef {import("./lib/pictures.mjs").Frame} Frame */

/** @type {Frame} The texture's place, around blob100. */
const around = { center: [0, 0], width: 3, pixels: [1024, 1024] };

export default async function bench() {
  const [map, other] = ["blob100", "sc_24_105"].map((name) => RiemannMap.solve(regionOf(fixture(name)), { tolerance: 1e-8 }));
  making(map, other);
  await triangulating(map);
  await drawing(map);
}

/**
 * A mesh beside what delaunator makes of its nodes: their Delaunay triangulation, without edges to keep and one copy of it.
 *
 * @param {RiemannMap} map
 */
async function triangulating(map) {
  const { default: Delaunator } = await peer(peerFile("delaunator"));
  const table = new Table("Mesh: beside delaunator, which triangulates given points alone", { nodes: 8, "joint triangulation": 20, delaunator: 12 });
  for (const spacing of [0.05, 0.0145]) {
    const mesh = JointTriangulation.regionToDisk(map, { spacing });
    const nodes = mesh.source;
    mesh.free();
    const times = inTurns({ ours: () => JointTriangulation.regionToDisk(map, { spacing }).free(), peer: () => void new Delaunator(nodes) });
    table.row(nodes.length / 2, ms(times.ours), ms(times.peer));
  }
}

/** @param {RiemannMap} map @param {RiemannMap} other */
function making(map, other) {
  const table = new Table("Mesh: solved maps → joint triangulation, blob100", {
    mesh: 36, nodes: 6, triangles: 9, flipped: 7, "largest error": 13, time: 22,
  });
  /** @type {[string, () => JointTriangulation][]} */
  const makers = [
    ["region → disk, spacing 0.05", () => JointTriangulation.regionToDisk(map, { spacing: 0.05 })],
    ["region → disk, spacing 0.0145", () => JointTriangulation.regionToDisk(map, { spacing: 0.0145 })],
    ["region → disk, ¼ pixel of 1024²", () => JointTriangulation.regionToDisk(map, { maxErrorPixels: 0.25, frame: disk(1024) })],
    ["region → region, exact", () => JointTriangulation.regionToRegion(map, other, { spacing: 0.0131 })],
    ["region → region, located", () => JointTriangulation.regionToRegion(map, other, { spacing: 0.0131, route: "located" })],
  ];
  for (const [name, make] of makers) {
    const mesh = make();
    const { source, triangles, flipped, evidence } = mesh;
    const time = milliseconds(() => make().free());
    const limited = name.startsWith("region → region") ? new Target(time, 120, ms) : ms(time);
    table.row(name, source.length / 2, triangles.length / 3, flipped, evidence.largestError.toExponential(1), limited);
    mesh.free();
  }
}

/** @param {number} size @returns {Frame} */
function disk(size) {
  return { center: [0, 0], width: 2, pixels: [size, size] };
}

/** @param {RiemannMap} map */
async function drawing(map) {
  const table = new Table("Raster: blob100 on the disk, OpenCV.js 4.12 remap (bilinear, float map) in turns", {
    output: 6, quality: 9, nodes: 6, time: 8, "per megapixel": 13, OpenCV: 8, "against OpenCV": 18,
  });
  const image = picture(1024);
  const texture = new Texture(image.data, image.width, image.height);
  for (const size of [1024, 2048]) {
    const view = disk(size);
    const mesh = JointTriangulation.regionToDisk(map, { maxErrorPixels: 0.25, frame: view });
    // OpenCV looks the same number of pixels up: how far apart they lie in the picture hardly matters to it.
    const peer = await remapper(image, size, size, coordinates(view, around, (points) => points.map((x) => x * 1.3)));
    const out = new Uint8ClampedArray(4 * size * size);
    for (const quality of /** @type {const} */ (["bilinear", "trilinear", "best"])) {
      const ours = () => mesh.warp(texture, { texture: around, view, quality, out });
      const time = inTurns({ ours, peer: peer.draw });
      const share = time.ours / time.peer;
      const against = quality === "trilinear" ? new Target(share, 0.8, ratio) : ratio(share);
      const megapixels = (size * size) / 1e6;
      table.row(`${size}²`, quality, mesh.source.length / 2, ms(time.ours), ms(time.ours / megapixels), ms(time.peer), against);
    }
    peer.free();
    mesh.free();
  }
  texture.free();
}
