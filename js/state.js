// What there is one of, whichever entries of the package are imported: the loaded module.

/** @typedef {import("./entry.js").InitOutput} InitOutput */

/**
 * `module` is what it was made from; `crashed` says how, once it has crashed.
 *
 * @type {{ output?: InitOutput, loading?: Promise<InitOutput>, module?: WebAssembly.Module, crashed?: string }}
 */
export const state = {};
