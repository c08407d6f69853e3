// What a fresh machine lacks: npm's packages, the wasm target, the wasm-bindgen command-line tool.

import { existsSync, lstatSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { Failure, root, run, step } from "./steps.mjs";

export const npm = process.platform === "win32" ? "npm.cmd" : "npm";
const exe = process.platform === "win32" ? ".exe" : "";

/** The wasm-bindgen command-line tools, in the project's own ignored folder. */
export const wasmBindgen = join(root, ".tools", "bin", `wasm-bindgen${exe}`);

/** Makes the machine ready to build; each part does nothing where it is already done. */
export async function setUp() {
  checkNode();
  await installPackages();
  await installTarget();
  await installWasmBindgen();
}

function checkNode() {
  const major = Number(process.versions.node.split(".")[0]);
  if (major < 20) {
    throw new Failure(`Node ${process.versions.node} is too old: install Node 20 or newer from https://nodejs.org.`);
  }
}

/** npm writes its own record of what it installed; a lock file newer than that record has not been installed. */
async function installPackages() {
  const modules = join(root, "node_modules");
  // npm would empty the folder that a link leads to, which is somebody else's.
  if (lstatSync(modules, { throwIfNoEntry: false })?.isSymbolicLink()) return;
  const installed = join(modules, ".package-lock.json");
  if (existsSync(installed) && statSync(installed).mtimeMs >= statSync(join(root, "package-lock.json")).mtimeMs) return;
  await step("npm packages", (note) => run(npm, ["ci", "--no-audit", "--no-fund"], { note }));
}

async function installTarget() {
  const sysroot = (await run("rustc", ["--print", "sysroot"])).trim();
  if (existsSync(join(sysroot, "lib", "rustlib", "wasm32-unknown-unknown"))) return;
  await step("Rust's wasm32 target", (note) => run("rustup", ["target", "add", "wasm32-unknown-unknown"], { note }));
}

async function installWasmBindgen() {
  const version = pinnedVersion();
  if (existsSync(wasmBindgen) && (await run(wasmBindgen, ["--version"])).includes(version)) return;
  await step(`wasm-bindgen ${version} (compiled once, takes minutes)`, (note) =>
    run("cargo", ["install", "wasm-bindgen-cli", "--version", version, "--locked", "--root", ".tools"], { note }),
  );
}

/** The exact version of the wasm-bindgen crate in Cargo.toml: the tool must have the same one. */
function pinnedVersion() {
  const manifest = readFileSync(join(root, "Cargo.toml"), "utf8");
  const pinned = /^wasm-bindgen = "=([\d.]+)"/m.exec(manifest);
  if (!pinned) throw new Failure('Cargo.toml must pin the wasm-bindgen crate: wasm-bindgen = "=x.y.z".');
  return pinned[1];
}
