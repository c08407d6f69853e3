// The npm package: cargo → wasm-bindgen → wasm-opt → pkg/, and the same files for the page in www/pkg/.

import { createHash } from "node:crypto";
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { Failure, root, run, step } from "./steps.mjs";
import { wasmBindgen } from "./setup.mjs";

const target = "wasm32-unknown-unknown";
const built = join(process.env.CARGO_TARGET_DIR ?? join(root, "target"), target, "release");
const compiled = join(built, "conformal_warp.wasm");
const pkg = join(root, "pkg");
const stamp = join(built, "package.stamp");

/** Builds `pkg/` and `www/pkg/`. cargo decides about compiling; the rest is skipped while its inputs are the same. */
export async function buildPackage() {
  await step("cargo build (release, simd128)", (note) =>
    run("cargo", ["build", "--release", "--lib", "--target", target], { note }),
  );
  const inputs = fingerprint();
  const present = [stamp, join(pkg, "index.js"), join(root, "www", "pkg", "index.js")].every((file) => existsSync(file));
  if (present && readFileSync(stamp, "utf8") === inputs) return;

  rmSync(stamp, { force: true });
  rmSync(pkg, { recursive: true, force: true });
  await step("wasm-bindgen", () => run(wasmBindgen, [compiled, "--target", "web", "--out-dir", pkg]));
  await step("wasm-opt", optimise);
  await step("package", assemble);
  writeFileSync(stamp, inputs);
}

/** A hash over everything that the package is made from after cargo. */
function fingerprint() {
  const hash = createHash("sha256");
  const scripts = readdirSync(join(root, "js")).map((name) => join(root, "js", name));
  for (const file of [compiled, join(root, "tools", "package.mjs"), join(root, "package-lock.json"), ...scripts]) {
    hash.update(readFileSync(file));
  }
  return hash.digest("hex");
}

/** @param {(text: string) => void} note */
async function optimise(note) {
  const module = join(pkg, "conformal_warp_bg.wasm");
  const before = statSync(module).size;
  const features = ["simd", "bulk-memory", "nontrapping-float-to-int", "sign-ext", "mutable-globals"];
  const enabled = [...features, "reference-types", "multivalue"].map((feature) => `--enable-${feature}`);
  const tool = join(root, "node_modules", "binaryen", "bin", "wasm-opt");
  await run(process.execPath, [tool, module, "-O3", ...enabled, "-o", module]);
  const kilobytes = (/** @type {number} */ bytes) => `${Math.round(bytes / 1024)} kB`;
  note(`${kilobytes(before)} → ${kilobytes(statSync(module).size)}`);
}

/** Adds the hand-written entry of js/ and copies the whole to the page. */
async function assemble() {
  cpSync(join(root, "js"), pkg, { recursive: true });
  // wasm-bindgen ignores its folder with a .gitignore, which npm would obey when it packs.
  rmSync(join(pkg, ".gitignore"), { force: true });
  writeFileSync(join(pkg, "index.js"), await entry());
  const page = join(root, "www", "pkg");
  rmSync(page, { recursive: true, force: true });
  mkdirSync(page, { recursive: true });
  cpSync(pkg, page, { recursive: true });
}

/** The package's entry: every class and function that wasm-bindgen made, guarded (see js/guard.js). */
async function entry() {
  const generated = await import(pathToFileURL(join(pkg, "conformal_warp.js")).href);
  const loading = ["default", "initSync", "start"];
  const names = Object.keys(generated).filter((name) => !loading.includes(name));
  if (names.length === 0) throw new Failure("wasm-bindgen exported nothing.");
  return [
    "// Made by tools/package.mjs from what wasm-bindgen exports.",
    'import * as generated from "./conformal_warp.js";',
    'import { guard } from "./guard.js";',
    'export { default, initSync } from "./init.js";',
    ...names.map((name) => `export const ${name} = guard(generated.${name}, "${name}");`),
    "",
  ].join("\n");
}
