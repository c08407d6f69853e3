// The pages as a folder for any static host: their files, with the list by which a browser keeps them.

import { createHash } from "node:crypto";
import { cp, readdir, readFile, rm, writeFile } from "node:fs/promises";
import { join, sep } from "node:path";

const WORKER = "service-worker.js";

/** Writes the site; its version, and how many bytes a browser keeps. @param {string} from the source folder, built @param {string} to is replaced */
export async function writeSite(from, to) {
  await rm(to, { recursive: true, force: true });
  await cp(from, to, { recursive: true });
  const paths = await filesOf(to);
  const version = (await Promise.all(paths.map((path) => digest(join(to, path))))).join();
  const short = createHash("sha256").update(version).digest("hex").slice(0, 16);
  for (const path of paths.filter((name) => name.endsWith(".html"))) {
    const html = await readFile(join(to, path), "utf8");
    await writeFile(join(to, path), html.replace("<head>", `<head>\n<meta name="site-version" content="${short}">`));
  }
  // Types are for those who program.
  const kept = paths.filter((path) => path !== WORKER && !path.endsWith(".d.ts"));
  const files = Object.fromEntries(await Promise.all(kept.map(async (path) => [path, `sha256-${await digest(join(to, path))}`])));
  const worker = await readFile(join(to, WORKER), "utf8");
  const listed = worker.replace('const VERSION = "";', `const VERSION = "${short}";`).replace("const FILES = {};", `const FILES = ${JSON.stringify(files, null, 2)};`);
  await writeFile(join(to, WORKER), listed);
  return { version: short, files: kept.length };
}

/** Paths of all files, with / between folders, in order. @param {string} folder */
async function filesOf(folder) {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  const all = entries.filter((entry) => entry.isFile()).map((entry) => join(entry.parentPath, entry.name).slice(folder.length + 1));
  return all.map((path) => path.split(sep).join("/")).sort();
}

/** @param {string} path */
const digest = async (path) => createHash("sha256").update(await readFile(path)).digest("base64");
