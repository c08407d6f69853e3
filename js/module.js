// Which of the package's two modules this is: everything. The other's file is made by tools/assemble.mjs.

export const FILE = "conformal_warp_bg.wasm";
export const FOLDER = "conformal-warp/pkg/";
export const ENTRY = "conformal-warp/wasm";
export const INLINE = "conformal-warp/inline";
/** What its .wasm exports, and those of others do not. */
export const EXPORT = "region_new";
