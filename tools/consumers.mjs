// npm run test:consumers: the package's tarball, in the hands of those who use it.

import { readdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { installApart } from "./apart.mjs";
import { buildPackage } from "./package.mjs";
import { npm, setUp } from "./setup.mjs";
import { checkSizes } from "./sizes.mjs";
import { Failure, main, root, run, show, step } from "./steps.mjs";

const tests = join(root, "tests", "consumers");
const work = join(root, "target", "consumers");

await main(async () => {
  await setUp();
  await buildPackage({ complete: true });
  await installApart("bundlers", tests, work);
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

/** The tarball as npm makes it, unpacked into `package/`. */
async function pack() {
  const output = await run(npm, ["pack", "--ignore-scripts", "--json", "--pack-destination", work]);
  const listed = JSON.parse(output);
  const { filename } = Array.isArray(listed) ? listed[0] : /** @type {any} */ (Object.values(listed)[0]);
  rmSync(join(work, "package"), { recursive: true, force: true });
  await run("tar", ["-xzf", join(work, filename), "-C", work]);
}
