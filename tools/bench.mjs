// npm run bench [topic …]: times in wasm under Node, one thread, as tables; every file of benches/ is a topic.

import { readdirSync } from "node:fs";
import { cpus } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { buildPackage } from "./package.mjs";
import { setUp } from "./setup.mjs";
import { Failure, main, root } from "./steps.mjs";

await main(async () => {
  await setUp();
  await buildPackage();

  const folder = join(root, "benches");
  const topics = readdirSync(folder).filter((name) => name.endsWith(".mjs")).map((name) => name.slice(0, -".mjs".length));
  const chosen = process.argv.slice(2);
  const unknown = chosen.find((topic) => !topics.includes(topic));
  if (unknown) throw new Failure(`There is no topic "${unknown}"; there are ${topics.join(", ")}.`);

  console.log(`\nNode ${process.versions.node}, ${cpus()[0]?.model ?? "unknown processor"}, one thread`);
  await (await import("conformal-warp")).default();
  for (const topic of chosen.length > 0 ? chosen : topics) {
    const { default: bench } = await import(pathToFileURL(join(folder, `${topic}.mjs`)).href);
    await bench();
  }
});
