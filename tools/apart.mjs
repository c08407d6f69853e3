// Packages that one task needs, installed apart from the project's own.

import { createHash } from "node:crypto";
import { copyFileSync, existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { npm } from "./setup.mjs";
import { run, step } from "./steps.mjs";

/**
 * Installs what the package.json and package-lock.json of a folder list, unless it is there.
 *
 * @param {string} name for people
 * @param {string} lists the folder
 * @param {string} work where `node_modules` goes
 */
export async function installApart(name, lists, work) {
  const files = ["package.json", "package-lock.json"];
  const hash = createHash("sha256");
  for (const file of files) hash.update(readFileSync(join(lists, file)));
  const wanted = hash.digest("hex");
  const stamp = join(work, "installed");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === wanted) return;
  mkdirSync(work, { recursive: true });
  for (const file of files) copyFileSync(join(lists, file), join(work, file));
  // Install scripts only choose among binaries that are there already.
  await step(name, (note) => run(npm, ["ci", "--prefix", work, "--ignore-scripts", "--no-audit", "--no-fund"], { note }));
  writeFileSync(stamp, wanted);
}
