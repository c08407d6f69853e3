// How the package is loaded: the hand-written part of its types.

type Global = typeof globalThis;
/** A class of the platform's, where there is one. */
type Platform<Name extends string> = Global extends { [K in Name]: { prototype: infer T } } ? T : never;

/** A compiled module: a `WebAssembly.Module`. */
export type CompiledModule = Global extends { WebAssembly: { Module: { prototype: infer T } } } ? T : object;

/** Where the .wasm is: an address, a response, its bytes or a compiled module. */
export type InitSource =
  | string
  | Platform<"URL">
  | Platform<"Request">
  | Platform<"Response">
  | ArrayBuffer
  | ArrayBufferView<ArrayBuffer>
  | CompiledModule;

/** The raw exports of the loaded module. */
export interface InitOutput {
  readonly memory: { readonly buffer: ArrayBuffer };
}

/**
 * Loads the module; every other call of this package must wait for it. Idempotent, and safe to call twice at once; after a
 * failure, which has the code "load-failed" or "not-wasm", it can be called again. Without a source it loads the file beside
 * the package's code (or, from `conformal-warp/inline`, what the code carries), in browsers and under Node.
 */
export function init(source?: InitSource | Promise<InitSource>): Promise<InitOutput>;
export namespace init {
  /** Loads the module again, into a memory of its own: after a crash (code "crashed"). What was made before is gone. */
  function reset(): Promise<InitOutput>;
}
export default init;

/**
 * Loads the module at once, from its bytes or a compiled module: for places where nothing can be awaited. From
 * `conformal-warp/inline` it needs no source.
 */
export function initSync(source?: ArrayBuffer | ArrayBufferView<ArrayBuffer> | CompiledModule): InitOutput;
