// Packages that only the benchmarks need, which tools/bench.mjs has installed apart.

import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const require = createRequire(new URL("../../target/peers/package.json", import.meta.url));

/** The file of a package. @param {string} name @returns {string} */
export const peerFile = (name) => require.resolve(name);

/** @param {string} name of a package, or of a file of one @returns {Promise<any>} */
export const peer = (name) => import(pathToFileURL(name.startsWith("/") ? name : peerFile(name)).href);
