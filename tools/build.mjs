// npm run build: the npm package's files in pkg/.

import { buildPackage } from "./package.mjs";
import { setUp } from "./setup.mjs";
import { main } from "./steps.mjs";

await main(async () => {
  await setUp();
  await buildPackage();
});
