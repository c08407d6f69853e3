// The npm package: cargo → wasm-bindgen → wasm-opt → pkg/, and the main entry's files for the page in www/pkg/.

import { createHash } from "node:crypto";
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { assemble } from "./assemble.mjs";
import { notices } from "./notices.mjs";
import { Failure, root, run, step } from "./steps.mjs";
import { wasmBindgen } from "./setup.mjs";

const target = "wasm32-unknown-unknown";
const built = join(process.env.CARGO_TARGET_DIR ?? join(root, "target"), target, "wasm");
const compiled = join(built, "conformal_warp.wasm");
const pkg = join(root, "pkg");
const page = join(root, "www", "pkg");

/** The two modules that the package holds: everything, and textures with formulas alone; and where the pages have them. */
const modules = {
  full: { features: [], folder: pkg, copy: page },
  formula: { features: ["--no-default-features"], folder: join(pkg, "formula"), copy: join(page, "formula") },
};

/**
 * Builds `pkg/` and `www/pkg/`. cargo decides about compiling; the rest is skipped while its inputs are the same.
 *
 * @param {{ complete?: boolean }} [options] `complete` adds the notices, which only the published package needs
 */
export async function buildPackage({ complete = false } = {}) {
  await buildModule("full", modules.full);
  await buildModule("formula", modules.formula);
  if (complete) await step("notices", () => writeFileSync(join(pkg, "THIRD-PARTY-NOTICES.txt"), notices(target)));
}

/**
 * @param {string} name
 * @param {{ features: string[], folder: string, copy: string }} module
 */
async function buildModule(name, { features, folder, copy }) {
  await step(`cargo build (${name}, profile wasm, simd128)`, (note) =>
    run("cargo", ["build", "--profile", "wasm", "--lib", "--target", target, ...features], { note }),
  );
  const stamp = join(built, `${name}.stamp`);
  const inputs = fingerprint();
  const present = existsSync(stamp) && [folder, copy].every((entry) => existsSync(join(entry, "index.js")));
  if (present && readFileSync(stamp, "utf8") === inputs) return;

  for (const target of [folder, copy]) empty(target);
  const generated = join(built, `bindgen-${name}`);
  await step("wasm-bindgen", () => run(wasmBindgen, [compiled, "--target", "web", "--out-dir", generated]));
  const module = await optimised(join(generated, "conformal_warp_bg.wasm"), name);
  await step("package", () => assemble(generated, module, folder, name === "full" ? undefined : name));
  const served = filesIn(folder).filter((file) => !/^inline|^bytes|^pool|^crew|\.cjs$|\.cts$/.test(file));
  for (const file of served) cpSync(join(folder, file), join(copy, file));
  writeFileSync(stamp, inputs);
}

/** A hash over everything that the package is made from after cargo. */
function fingerprint() {
  const hash = createHash("sha256");
  const folders = ["js", "tools"].map((name) => join(root, name));
  const scripts = folders.flatMap((folder) => filesIn(folder).map((name) => join(folder, name)));
  for (const file of [compiled, join(root, "package-lock.json"), join(root, "src", "error.rs"), ...scripts]) {
    hash.update(readFileSync(file));
  }
  return hash.digest("hex");
}

/**
 * The optimised module's path; what was optimised before is kept.
 *
 * @param {string} module
 * @param {string} name
 */
async function optimised(module, name) {
  // LLVM has inlined what it pays to inline: once more makes the module larger, not faster. In the order of how often they are
  // named, functions and locals have shorter names.
  const passes = ["-O3", "--one-caller-inline-max-function-size=0", "--flexible-inline-max-function-size=0", "--always-inline-max-function-size=0", "--reorder-functions", "--reorder-locals"];
  const inputs = createHash("sha256").update(readFileSync(module)).update(passes.join(" "));
  const result = join(built, `${name}-${inputs.digest("hex").slice(0, 16)}.wasm`);
  if (existsSync(result)) return result;
  for (const old of filesIn(built)) if (old.startsWith(`${name}-`)) rmSync(join(built, old));
  await step(`wasm-opt (${name})`, async (note) => {
    const before = statSync(module).size;
    const features = ["simd", "bulk-memory", "nontrapping-float-to-int", "sign-ext", "mutable-globals"];
    const enabled = [...features, "reference-types", "multivalue"].map((feature) => `--enable-${feature}`);
    const tool = join(root, "node_modules", "binaryen", "bin", "wasm-opt");
    await run(process.execPath, [tool, module, ...passes, ...enabled, "-o", result]);
    if (!existsSync(result)) throw new Failure("wasm-opt wrote nothing.");
    const kilobytes = (/** @type {number} */ bytes) => `${Math.round(bytes / 1024)} kB`;
    note(`${kilobytes(before)} → ${kilobytes(statSync(result).size)}`);
  });
  return result;
}

/**
 * A folder without files; its folders are other modules.
 *
 * @param {string} folder
 */
function empty(folder) {
  mkdirSync(folder, { recursive: true });
  for (const file of filesIn(folder)) rmSync(join(folder, file));
}

/** @param {string} folder */
function filesIn(folder) {
  return readdirSync(folder, { withFileTypes: true }).filter((entry) => entry.isFile()).map(({ name }) => name);
}
