// Projects of people who use the package: each in a folder of its own, with the tarball's files in its node_modules.

import { spawn } from "node:child_process";
import { cpSync, mkdirSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { pathToFileURL } from "node:url";
import { root } from "../../../tools/steps.mjs";

/** Where tools/consumers.mjs has installed the bundlers, and unpacked the package. */
export const work = process.env.CONSUMERS ?? join(root, "target", "consumers");
export const unpacked = join(work, "package");

/** What every consumer must compute: the conformal radius of a square, and pixels of z². */
export const WORK = `
export function work({ Region, RiemannMap, FormulaMap, Texture }) {
  const boundary = new Float64Array([-1, -1, 1, -1, 1, 1, -1, 1]);
  const radius = Region ? RiemannMap.solve(new Region({ boundary, center: [0, 0], toward: [1, 0] })).conformalRadius : 0;
  const rgba = new Uint8ClampedArray(4 * 64).map((_, k) => (k * 37) % 256);
  const frame = { center: [0, 0], width: 2, pixels: [8, 8] };
  const pixels = new FormulaMap("z^2").warp(new Texture(rgba, 8, 8), { texture: frame, view: frame });
  return radius.toFixed(10) + " " + pixels.reduce((sum, byte, k) => (sum * 31 + byte + k) % 1000003, 0);
}
`;

/** As above, but for an entry. @param {string} entry */
const main = (entry) => `
import init, * as warp from "${entry}";
import { work } from "./work.js";
const tell = (text) => { globalThis.result = text; if (typeof document === "undefined") console.log(text); };
init().then(() => tell(work(warp)), (error) => tell(error.code + ": " + error.message));
`;

/** A project whose pictures are drawn by a pool. */
export const POOLED = `
import { createPool } from "conformal-warp/pool";
import { work } from "./work.js";
async function draw() {
  const pool = await createPool({ workers: 2 });
  const region = new pool.Region({ boundary: new Float64Array([-1, -1, 1, -1, 1, 1, -1, 1]), center: [0, 0], toward: [1, 0] });
  const radius = await pool.RiemannMap.solve(region).conformalRadius;
  const rgba = new Uint8ClampedArray(4 * 64).map((_, k) => (k * 37) % 256);
  const frame = { center: [0, 0], width: 2, pixels: [8, 8] };
  const pixels = await new pool.FormulaMap("z^2").warp(new pool.Texture(rgba, 8, 8), { texture: frame, view: frame });
  pool.close();
  return radius.toFixed(10) + " " + pixels.reduce((sum, byte, k) => (sum * 31 + byte + k) % 1000003, 0);
}
const tell = (text) => { globalThis.result = text; if (typeof document === "undefined") console.log(text); };
draw().then(tell, (error) => tell(error.code + ": " + error.message));
`;

/**
 * A fresh project with index.html and main.js, which computes with the given entry of the package.
 *
 * @param {string} name
 * @param {string} [entry]
 * @param {Record<string, string>} [files] more of them, or others
 * @returns {string} its folder
 */
export function project(name, entry = "conformal-warp", files = {}) {
  const folder = join(work, "run", name);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(join(folder, "node_modules"), { recursive: true });
  cpSync(unpacked, join(folder, "node_modules", "conformal-warp"), { recursive: true });
  const all = {
    "package.json": JSON.stringify({ name, private: true, type: "module", dependencies: { "conformal-warp": "*" } }),
    "index.html": '<!doctype html><meta charset="utf-8"><title>consumer</title><script type="module" src="./main.js"></script>',
    "main.js": main(entry),
    "work.js": WORK,
    ...files,
  };
  for (const [path, text] of Object.entries(all)) {
    mkdirSync(dirname(join(folder, path)), { recursive: true });
    writeFileSync(join(folder, path), text);
  }
  return folder;
}

/** A bundler. @param {string} name @returns {Promise<any>} */
export async function tool(name) {
  const from = join(work, "load.mjs");
  writeFileSync(from, "export const load = (name) => import(name);");
  return (await import(pathToFileURL(from).href)).load(name);
}

/**
 * Runs a program in a folder.
 *
 * @param {string} folder
 * @param {string[]} command
 * @param {Record<string, string>} [env]
 * @returns {Promise<string>} what it printed on standard output; an Error with all that it printed if it failed
 */
export function run(folder, [program, ...args], env = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, { cwd: folder, env: { ...process.env, ...env }, stdio: ["ignore", "pipe", "pipe"] });
    let printed = "";
    let errors = "";
    child.stdout.on("data", (chunk) => (printed += chunk));
    child.stderr.on("data", (chunk) => (errors += chunk));
    child.on("error", reject);
    child.on("close", (code) => (code === 0 ? resolve(printed) : reject(new Error(`${printed}\n${errors}`))));
  });
}

/** @param {string} path of a program among the bundlers' packages */
export const program = (path) => join(work, "node_modules", path);
