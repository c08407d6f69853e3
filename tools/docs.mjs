// npm run docs: the package's reference as pages, in target/api, from its types alone, and the crate's, in target/doc; a warning is a
// failure.

import { existsSync } from "node:fs";
import { join } from "node:path";
import { installApart } from "./apart.mjs";
import { buildPackage } from "./package.mjs";
import { setUp } from "./setup.mjs";
import { Failure, main, root, run, step } from "./steps.mjs";

const work = join(root, "target", "typedoc");
const out = join(root, "target", "api");

await main(async () => {
  await setUp();
  await buildPackage();
  await installApart("TypeDoc", join(root, "docs", "typedoc"), work);
  await step("reference", async () => {
    const typedoc = join(work, "node_modules", "typedoc", "bin", "typedoc");
    await run(process.execPath, [typedoc, "--options", join(root, "docs", "typedoc", "typedoc.json"), "--out", out]);
    if (!existsSync(join(out, "index.html"))) throw new Failure("TypeDoc wrote nothing.");
  });
  await step("reference of the crate", (note) =>
    run("cargo", ["doc", "--no-deps", "--all-features"], { note, env: { RUSTDOCFLAGS: "-D warnings" } }),
  );
  console.log(`\n${join(out, "index.html")}\n${join(root, "target", "doc", "conformal_warp", "index.html")}`);
});
