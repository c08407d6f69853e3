// What the package weighs as it is sent, and how much it may.

import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";
import { Failure } from "./steps.mjs";

/** In bytes of gzip; the goal beyond is 400 kB, 150 kB and 15 kB. */
const LIMITS = [
  { name: "the module", files: ["pkg/conformal_warp_bg.wasm"], most: 734_000 },
  { name: "its code", files: ["pkg/*"], most: 23_400 },
  { name: "the module of formulas", files: ["pkg/formula/formula_bg.wasm"], most: 197_500 },
  { name: "its code", files: ["pkg/formula/*"], most: 16_200 },
];

/** What the main entry imports. */
const CODE = /^(?!inline|bytes|pool|crew).*\.js$/;

/**
 * Prints the sizes.
 *
 * @param {string} folder the unpacked package
 */
export function checkSizes(folder) {
  const tooLarge = [];
  for (const { name, files, most } of LIMITS) {
    const paths = files.flatMap((file) => (file.endsWith("/*") ? codeIn(join(folder, file.slice(0, -2))) : [join(folder, file)]));
    const bytes = Buffer.concat(paths.map((path) => readFileSync(path)));
    const gzip = gzipSync(bytes, { level: 9 }).length;
    const brotli = brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length } }).length;
    const kilobytes = (/** @type {number} */ n) => `${(n / 1000).toFixed(1)} kB`;
    console.log(`  ${files[0].padEnd(30)} gzip ${kilobytes(gzip).padStart(9)} of ${kilobytes(most)}, brotli ${kilobytes(brotli)}`);
    if (!(gzip <= most)) tooLarge.push(`${name} (${files[0]}) weighs ${gzip} bytes, and may weigh ${most}`);
  }
  if (tooLarge.length > 0) throw new Failure(`The package has become too large: ${tooLarge.join("; ")}. See tools/sizes.mjs.`);
}

/** @param {string} folder */
function codeIn(folder) {
  return readdirSync(folder).filter((name) => CODE.test(name)).map((name) => join(folder, name));
}
