// The package's main entry: the .wasm is a file beside this one.

import { loader } from "./load.js";
import { beside } from "./place.js";

export * from "./classes.js";

/** Bundlers know this form, and take the file along. */
const usual = () => beside(() => new URL("conformal_warp_bg.wasm", import.meta.url));

export const { init, initSync } = loader(usual);
export default init;
