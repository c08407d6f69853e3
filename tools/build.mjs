// npm run build: the npm package's files in pkg/; with --package also the notices, which only the published package needs.

import { buildPackage } from "./package.mjs";
import { setUp } from "./setup.mjs";
import { main } from "./steps.mjs";

await main(async () => {
  await setUp();
  await buildPackage({ complete: process.argv.includes("--package") });
});
