// Where the package's files are: beside its code, unless a bundler has moved that.

import { failure } from "./failure.js";
import { FOLDER } from "./module.js";
import { builtin, findInstalled } from "./source.js";

/** Vite 5 to 7 bundle what is imported from packages into node_modules/.vite/deps/, without the files that lie beside it. */
const MOVED = /^(.*\/node_modules\/)\.vite\/[^/]+\/([^/?]+)/;

/** Whether the code at this address is without the files beside it. @param {string} address */
export function isMoved(address) {
  return MOVED.test(address);
}

/**
 * @param {() => URL} address of a file beside the package's code
 * @returns {URL}
 */
export function beside(address) {
  let url;
  try {
    url = address();
  } catch {
    // Bundles in the form of CommonJS have no import.meta.url.
    return fromWorkingFolder();
  }
  const moved = MOVED.exec(url.href);
  return moved ? new URL(`${moved[1]}${FOLDER}${moved[2]}`) : url;
}

function fromWorkingFolder() {
  const { pathToFileURL } = builtin("node:url") ?? {};
  const installed = pathToFileURL && findInstalled(pathToFileURL(`${globalThis.process.cwd()}/bundle.js`).href);
  if (installed && pathToFileURL) return pathToFileURL(installed);
  const message = 'The bundle does not say where it lies: give init() the module, or import "conformal-warp/inline".';
  throw failure("load-failed", message);
}
