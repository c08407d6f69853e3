// The types of conformal-warp/pool: the package's classes, whose methods return promises.

import type * as warp from "conformal-warp";

/** An `AbortSignal`, where the platform has one. */
type Signal = typeof globalThis extends { AbortSignal: { prototype: infer T } } ? T : object;
/** What workers keep: an object of one of the package's classes. */
interface Made {
  free(): void;
}
type Value<R> = R extends Made ? Pooled<R> : Promise<R>;
type Argument<A> = A extends Made ? Pooled<A> : A extends ArrayBufferView | string | number | boolean | null | undefined | readonly unknown[] ? A : A & { signal?: Signal };
type Arguments<P extends unknown[]> = { [K in keyof P]: Argument<P[K]> };
type Call<F> = F extends (...args: infer P) => infer R ? (...args: Arguments<P>) => Value<R> : Promise<F>;

/**
 * An object that every worker of the pool has. It can be used at once; what could not be made is told by `ready`, and by the
 * first thing that is asked of it. Drawings take a `signal` to be aborted by among their options.
 */
export type Pooled<T> = { readonly [K in Exclude<keyof T, keyof Made | "paint" | symbol>]: Call<T[K]> } & {
  readonly ready: Promise<void>;
  free(): void;
};

type Statics<C> = { readonly [K in Exclude<keyof C, "prototype">]: Call<C[K]> };
type Constructor<C> = C extends new (...args: infer P) => infer T ? new (...args: Arguments<P>) => Pooled<T> : unknown;
type Classes = { readonly [K in keyof typeof warp as (typeof warp)[K] extends { prototype: Made } ? K : never]: Statics<(typeof warp)[K]> & Constructor<(typeof warp)[K]> };

/** The package's classes with workers behind them. */
export type Pool = Classes & {
  /** Number of workers. */
  readonly size: number;
  /** Ends the workers; what they have not finished is rejected with the code "pool-closed". */
  close(): void;
};

/** How a pool is made. */
export interface PoolOptions {
  /** Number of workers: as many as there are cores, 8 at most, by default. */
  workers?: number;
  /** Makes a worker whose script imports "conformal-warp/pool-worker": where a bundler does not take the usual one along. */
  worker?: () => object;
  /** Where the .wasm is, as for `init`. */
  source?: warp.InitSource | Promise<warp.InitSource>;
}

/** Starts workers, with one compiled module for all. No header for shared memory is needed. */
export function createPool(options?: PoolOptions): Promise<Pool>;
