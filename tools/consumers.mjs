// npm run test:consumers: the package's tarball, in the hands of those who use it.

import { createHash } from "node:crypto";
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { buildPackage } from "./package.mjs";
import { npm, setUp } from "./setup.mjs";
import { checkSizes } from "./sizes.mjs";
import { Failure, main, root, run, show, step } from "./steps.mjs";

const tests = join(root, "tests", "consumers");
const work = join(root, "target", "consumers");

await main(async () => {
  await setUp();
  await buildPackage({ complete: true });
  mkdirSync(work, { recursive: true });
  await installBundlers();
  await step("npm pack", pack);
  checkSizes(join(work, "package"));
  const { installChromium } = await import("./chromium.mjs");
  const CHROMIUM = await installChromium();
  const chosen = process.argv.slice(2);
  const files = readdirSync(tests).filter((name) => name.endsWith(".test.mjs") && (chosen.length === 0 || chosen.some((part) => name.startsWith(part))));
  if (files.length === 0) throw new Failure(`tests/consumers has no ${chosen.join(", ")}.`);
  const paths = files.map((name) => join(tests, name));
  await show("consumers of the package", process.execPath, ["--test", "--test-concurrency=1", ...paths], { CHROMIUM, CONSUMERS: work });
});

/** The bundlers, in the versions of tests/consumers/package-lock.json, apart from the project's own packages. */
async function installBundlers() {
  const lists = ["package.json", "package-lock.json"];
  const hash = createHash("sha256");
  for (const name of lists) hash.update(readFileSync(join(tests, name)));
  const wanted = hash.digest("hex");
  const stamp = join(work, "installed");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === wanted) return;
  for (const name of lists) copyFileSync(join(tests, name), join(work, name));
  // Their install scripts only choose among binaries that are there already.
  await step("bundlers", (note) => run(npm, ["ci", "--prefix", work, "--ignore-scripts", "--no-audit", "--no-fund"], { note }));
  writeFileSync(stamp, wanted);
}

/** The tarball as npm makes it, unpacked into `package/`. */
async function pack() {
  const output = await run(npm, ["pack", "--ignore-scripts", "--json", "--pack-destination", work]);
  const listed = JSON.parse(output);
  const { filename } = Array.isArray(listed) ? listed[0] : /** @type {any} */ (Object.values(listed)[0]);
  rmSync(join(work, "package"), { recursive: true, force: true });
  await run("tar", ["-xzf", join(work, filename), "-C", work]);
}
