// npm run bench [topic …]: times in wasm under Node, one thread, as tables; every file of benches/ is a topic.
// With --write all topics go into BENCHMARKS.md.

import { execFileSync } from "node:child_process";
import { readdirSync, writeFileSync } from "node:fs";
import { cpus, loadavg } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { printed } from "../benches/lib/table.mjs";
import { installApart } from "./apart.mjs";
import { buildPackage } from "./package.mjs";
import { setUp } from "./setup.mjs";
import { Failure, main, root, run } from "./steps.mjs";

await main(async () => {
  const isWritten = process.argv.includes("--write");
  const chosen = process.argv.slice(2).filter((argument) => argument !== "--write");
  const folder = join(root, "benches");
  const topics = readdirSync(folder).filter((name) => name.endsWith(".mjs")).map((name) => name.slice(0, -".mjs".length));
  const unknown = chosen.find((topic) => !topics.includes(topic));
  if (unknown) throw new Failure(`There is no topic "${unknown}"; there are ${topics.join(", ")}.`);
  if (isWritten && chosen.length > 0) throw new Failure("BENCHMARKS.md holds all topics: --write takes none by name.");

  await setUp();
  await buildPackage();
  await installApart("peers", join(folder, "peers"), join(root, "target", "peers"));

  const load = loadavg()[0];
  const machine = `Node ${process.versions.node}, ${cpus()[0]?.model ?? "unknown processor"}, ${cpus().length} cores, one thread where nothing else is said`;
  console.log(`\n${machine}`);
  await (await import("conformal-warp")).default();
  for (const topic of chosen.length > 0 ? chosen : topics) {
    const { default: bench } = await import(pathToFileURL(join(folder, `${topic}.mjs`)).href);
    await bench();
  }
  if (isWritten) {
    printed.push(...(await native()));
    writeFileSync(join(root, "BENCHMARKS.md"), page(machine, load));
  }
  // A peer's workers would keep the process waiting.
  process.exit(0);
});

/** What Python's OpenCV takes for the same, where it is installed. */
async function native() {
  try {
    return ["", ...(await run("python3", [join(root, "benches", "native_cv2.py")])).trimEnd().split("\n")];
  } catch {
    return ["", "Rows of native OpenCV: `pip install opencv-python-headless`, then `python3 benches/native_cv2.py`."];
  }
}

/**
 * @param {string} machine
 * @param {number} load of the machine before
 */
function page(machine, load) {
  const commit = execFileSync("git", ["rev-parse", "--short", "HEAD"], { cwd: root, encoding: "utf8" }).trim();
  const busy = load > 0.5 ? ` The machine was busy with other things (load ${load.toFixed(1)}): ratios say more than times.` : "";
  return [
    "# Benchmarks",
    "",
    `Written by \`npm run bench -- --write\` at ${commit} on ${new Date().toISOString().slice(0, 10)}: ${machine}.${busy}`,
    "",
    "Rivals take turns in one process, and the best of several rounds counts. Rows in which another library is faster or nearer stand",
    "among the others. ✔ and ✘ say whether a time keeps the limit that this project has set itself.",
    ...printed,
    "",
  ].join("\n");
}
