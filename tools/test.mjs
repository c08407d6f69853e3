// npm test: everything that must hold, from formatting to the page in a real browser.

import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { buildPackage } from "./package.mjs";
import { setUp } from "./setup.mjs";
import { Failure, main, root, run, show, step } from "./steps.mjs";

await main(async () => {
  const start = performance.now();
  await setUp();
  await installComponents();
  await buildPackage();

  await step("formatting (cargo fmt)", () => run("cargo", ["fmt", "--check"]));
  const deny = ["--", "-D", "warnings"];
  await step("clippy, native", (note) => run("cargo", ["clippy", "--all-targets", "--all-features", ...deny], { note }));
  await step("clippy, wasm32", (note) => run("cargo", ["clippy", ...wasmTests(), ...deny], { note }));
  await step("types of the page and the scripts (tsc)", () =>
    run(process.execPath, [join("node_modules", "typescript", "bin", "tsc"), "-p", "."]),
  );

  await show("native tests", "cargo", ["test"]);
  const parallel = ["test", "--features", "parallel"];
  await show("native tests of threads", "cargo", [...parallel, "--test", "parallel"]);
  await show("examples of threads", "cargo", [...parallel, "--doc", "parallel"]);
  await show("tests in wasm, under Node", "cargo", ["test", ...wasmTests()], {
    WASM_BINDGEN_TEST_ONLY_NODE: "1",
  });
  await show("the npm package, under Node", process.execPath, ["--test", ...testFiles("node")]);
  // Imported late: it needs the npm packages, which the set-up has installed.
  const { installChromium } = await import("./chromium.mjs");
  const CHROMIUM = await installChromium();
  // Two files at once: a page waits for its workers much of the time.
  await show("the page, in Chromium", process.execPath, ["--test", "--test-concurrency=2", ...testFiles("browser")], { CHROMIUM });

  console.log(`\nEverything holds; it took ${((performance.now() - start) / 1000).toFixed(0)} s.`);
});

/** rustfmt and clippy, which rustup's minimal profile leaves out. */
async function installComponents() {
  for (const component of ["rustfmt", "clippy"]) {
    const present = await run("cargo", [component === "rustfmt" ? "fmt" : component, "--version"]).catch(() => "");
    if (present) continue;
    await step(component, (note) => run("rustup", ["component", "add", component], { note }));
  }
}

/** Cargo's arguments for the tests that run in wasm: those inside the library, and tests/wasm_*.rs. */
function wasmTests() {
  const names = readdirSync(join(root, "tests")).filter((name) => /^wasm_.*\.rs$/.test(name));
  if (names.length === 0) throw new Failure("tests/ holds no wasm_*.rs.");
  const chosen = names.flatMap((name) => ["--test", name.slice(0, -".rs".length)]);
  return ["--target", "wasm32-unknown-unknown", "--lib", ...chosen];
}

/**
 * The test files directly in tests/`folder`; a folder without any is a failure, never a silent success.
 *
 * @param {string} folder
 */
function testFiles(folder) {
  const path = join(root, "tests", folder);
  const names = existsSync(path) ? readdirSync(path).filter((name) => name.endsWith(".mjs")) : [];
  if (names.length === 0) throw new Failure(`tests/${folder}/ holds no test.`);
  return names.sort().map((name) => join("tests", folder, name));
}
