// The types of the npm package: the generated ones, with the hand-written loading of js/init.js.

import type { InitOutput } from "./conformal_warp.js";

export * from "./conformal_warp.js";

/** Where the .wasm is: an address, a response, its bytes or a compiled module. */
export type InitSource = URL | string | Request | Response | BufferSource | WebAssembly.Module;

/**
 * Loads the module; every other call of this package must wait for it. Idempotent, and safe to call twice at once.
 * Without a source it loads the file beside the package's code, in browsers and under Node.
 */
export default function init(source?: InitSource | Promise<InitSource>): Promise<InitOutput>;

/** Loads the module at once, from its bytes or a compiled module: for places where nothing can be awaited. */
export function initSync(source: BufferSource | WebAssembly.Module): InitOutput;
