// npm run site: the pages as a folder, site/, that any static host serves from any path.

import { join } from "node:path";
import { buildPackage } from "./package.mjs";
import { setUp } from "./setup.mjs";
import { writeSite } from "./site-files.mjs";
import { main, root, step } from "./steps.mjs";

await main(async () => {
  await setUp();
  await buildPackage();
  const site = join(root, "site");
  const { version, files } = await step("site/", () => writeSite(join(root, "www"), site));
  console.log(`\n${site} is complete, version ${version}, ${files} files: copy it to any folder of a static host.`);
});
