// npm start: sets the machine up, builds, and serves the page.

import { join } from "node:path";
import { buildPackage } from "./package.mjs";
import { contentPolicy, serve } from "./server.mjs";
import { setUp } from "./setup.mjs";
import { main, root } from "./steps.mjs";

await main(async () => {
  const start = performance.now();
  await setUp();
  await buildPackage();
  const { url } = await serve(join(root, "www"), Number(process.env.PORT ?? 8080), contentPolicy);
  console.log(`\nReady after ${((performance.now() - start) / 1000).toFixed(1)} s: open ${url}  (Ctrl-C ends it)`);
});
