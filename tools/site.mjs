// npm run site: the pages as a folder, site/, that any static host serves from any path.

import { cp, rm } from "node:fs/promises";
import { join } from "node:path";
import { buildPackage } from "./package.mjs";
import { setUp } from "./setup.mjs";
import { main, root, step } from "./steps.mjs";

await main(async () => {
  await setUp();
  await buildPackage();
  const site = join(root, "site");
  await step("site/", async () => {
    await rm(site, { recursive: true, force: true });
    await cp(join(root, "www"), site, { recursive: true });
  });
  console.log(`\n${site} is complete: copy it to any folder of a static host.`);
});
