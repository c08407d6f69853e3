// The generated classes with a door: arguments are checked, use before init(), after free() and after a crash is told in
// words, and a crash, which would be a bug of ours or a lack of memory, never lets a broken module answer again.

import { checkArguments, checkObject, classes, withArticle } from "./check.js";
import { failure } from "./failure.js";
import { abandon, isCurrent, roomFor } from "./conformal_warp.js";
import { state } from "./state.js";

/** @typedef {import("./check.js").Parameter} Parameter */

/** @typedef {{ new?: Parameter[], static?: Record<string, Parameter[]>, methods?: Record<string, Parameter[]>,
 *   makes?: Record<string, string>, properties?: string[] }} Signature `makes`: the classes of the objects that calls return */

/** @param {string} call */
function checkReady(call) {
  if (state.crashed) {
    const message = `${call} was used after the module had crashed (${state.crashed}): await init.reset(), then make its objects anew.`;
    throw failure("crashed", message);
  }
  if (!state.output) throw failure("not-initialized", `${call} was used before the module was loaded: await init() first.`);
}

/**
 * Calls into the module; what fails there is told in words.
 *
 * @param {string} call
 * @param {Function} target
 * @param {unknown} self
 * @param {unknown[]} args
 * @param {Function} [newTarget]
 */
function run(call, target, self, args, newTarget) {
  const { output } = state;
  let result;
  try {
    checkRoom(call, args);
    result = newTarget ? Reflect.construct(target, args, newTarget) : Reflect.apply(target, self, args);
  } catch (error) {
    throw translate(call, error);
  }
  if (state.output !== output) throw failure("stale", `${call} had not ended when init.reset() loaded the module anew: call it again.`);
  return result;
}

/** Arguments of so many bytes are passed without asking first whether there is room for them. */
const SMALL = 2 ** 26;

/**
 * Large arrays are copied into the module, which must have room for them and for what is made of them. But pictures are read where
 * they are, row by row.
 *
 * @param {string} call
 * @param {unknown[]} args
 */
function checkRoom(call, args) {
  let bytes = 0;
  for (const arg of args) {
    // Points, what they become, and its derivatives; a stored map and what is made of it.
    const isPicture = (arg instanceof Uint8Array || arg instanceof Uint8ClampedArray) && !call.endsWith("fromBytes()");
    if (ArrayBuffer.isView(arg) && !isPicture) bytes += arg.byteLength * (arg instanceof Float64Array ? 6 : 3);
    else if (typeof arg === "string") bytes += 6 * arg.length;
  }
  if (bytes > SMALL) roomFor(bytes);
}

/**
 * @param {string} call
 * @param {any} error
 */
function translate(call, error) {
  const isTrap =
    error instanceof WebAssembly.RuntimeError ||
    (error instanceof RangeError && /call stack/.test(error.message)) ||
    error?.name === "InternalError";
  if (error?.code === "crashed") return error;
  // What fails around a crash in a call within this one, as from onProgress, fails by it.
  if (isTrap || state.crashed) {
    state.crashed ??= `${call}: ${error.message}`;
    abandon();
    const message = `The module crashed in ${call}, for want of memory or by a fault of its own: await init.reset(), then make its objects anew.`;
    return Object.assign(failure("crashed", message), { cause: error });
  }
  if (error?.code === undefined && /recursive use of an object|attempted to take ownership/.test(error?.message)) {
    return failure("in-use", `${call}: an object was used while a call that changes it had not ended: not from its onProgress.`);
  }
  if (error?.code === undefined && /null pointer passed/.test(error?.message)) {
    return failure("freed", `${call}: an object was freed while its arguments were read.`);
  }
  if (error instanceof TypeError && /detached/.test(error.message)) {
    return failure("invalid-argument", `${call}: the memory of an array was handed over to somebody else before.`);
  }
  return error;
}

/**
 * A generated class or function, guarded.
 *
 * @template {Function} T
 * @param {T} generated
 * @param {string} name
 * @param {Signature | Parameter[]} signature
 * @returns {T}
 */
export function guard(generated, name, signature) {
  return Array.isArray(signature) ? guardFunction(generated, name, signature) : guardClass(generated, name, signature);
}

/**
 * @template {Function} T
 * @param {T} generated
 * @param {string} name
 * @param {Parameter[]} parameters
 * @returns {T}
 */
function guardFunction(generated, name, parameters) {
  const call = `${name}()`;
  const guarded = (/** @type {unknown[]} */ ...args) => {
    checkReady(call);
    return run(call, generated, undefined, checkArguments(call, parameters, args));
  };
  return /** @type {any} */ (guarded);
}

/**
 * @template {Function} T
 * @param {T} generated
 * @param {string} name
 * @param {Signature} signature
 * @returns {T}
 */
function guardClass(generated, name, signature) {
  classes.set(name, generated);
  guardPrototype(generated.prototype, name, signature.methods ?? {});
  guardStatics(generated, name, signature.static ?? {});
  const call = `new ${name}()`;
  const guarded = new Proxy(generated, {
    construct(target, args, newTarget) {
      checkReady(call);
      checkMaker(name, signature, true);
      return run(call, target, undefined, checkArguments(call, signature.new ?? [], args), newTarget);
    },
    apply: () => checkMaker(name, signature, false),
  });
  Object.defineProperty(generated.prototype, "constructor", { value: guarded, writable: true, configurable: true });
  // Minifiers rename classes.
  Object.defineProperty(generated, "name", { value: name, configurable: true });
  return guarded;
}

/**
 * Whether objects of a class are made as was tried: by `new` or without.
 *
 * @param {string} name
 * @param {Signature} signature
 * @param {boolean} isNew
 */
export function checkMaker(name, signature, isNew) {
  if (signature.new && isNew) return;
  const makers = Object.keys(signature.static ?? {}).map((maker) => `${name}.${maker}()`);
  const by = signature.new ? `new ${name}()` : makers.length > 0 ? makers.join(" or ") : "a method of another class";
  const message = `${withArticle(name, "A")} is not made by ${isNew ? "new" : `${name}()`} but by ${by}.`;
  // As when any class is called like a function.
  throw Object.assign(new TypeError(message), { code: "no-constructor" });
}

/**
 * @param {any} prototype
 * @param {string} name
 * @param {Record<string, Parameter[]>} methods
 */
function guardPrototype(prototype, name, methods) {
  freeOnce(prototype, name);
  for (const key of Reflect.ownKeys(prototype)) {
    // What starts with __ is for generated code only.
    if (typeof key !== "string" || key === "constructor" || key === "free" || key.startsWith("__")) continue;
    const property = /** @type {PropertyDescriptor} */ (Object.getOwnPropertyDescriptor(prototype, key));
    const call = `${name}.${key}${property.value ? "()" : ""}`;
    for (const part of /** @type {const} */ (["value", "get", "set"])) {
      const original = property[part];
      if (typeof original !== "function") continue;
      property[part] = function (/** @type {unknown[]} */ ...args) {
        checkReady(call);
        checkReceiver(name, call, this);
        return run(call, original, this, part === "value" ? checkArguments(call, methods[key] ?? [], args) : args);
      };
    }
    Object.defineProperty(prototype, key, property);
  }
}

/**
 * @param {string} name
 * @param {string} call
 * @param {any} self
 */
function checkReceiver(name, call, self) {
  checkObject(name, self, () => {
    throw wrongReceiver(name, call);
  });
}

/** @param {string} name @param {string} call */
function wrongReceiver(name, call) {
  return failure("wrong-receiver", `${call} must be called on ${withArticle(name)}: as x.${call.slice(name.length + 1)}, not apart from its object.`);
}

/**
 * Freeing twice is harmless, as disposing twice must be; so is freeing what a module that is gone had made.
 *
 * @param {any} prototype
 * @param {string} name
 */
function freeOnce(prototype, name) {
  const { free } = prototype;
  prototype.free = function () {
    if (!this?.__wbg_ptr) return;
    if (!(this instanceof /** @type {any} */ (classes.get(name)))) throw wrongReceiver(name, `${name}.free()`);
    if (Object.isFrozen(this)) throw failure("wrong-receiver", `This ${name} cannot be freed: Object.freeze() holds it as it is.`);
    if (isCurrent(this)) run("free()", free, this, []);
    else this.__wbg_ptr = 0;
  };
  if (Symbol.dispose) prototype[Symbol.dispose] = prototype.free;
}

/**
 * @param {any} generated
 * @param {string} name
 * @param {Record<string, Parameter[]>} statics
 */
function guardStatics(generated, name, statics) {
  for (const [key, parameters] of Object.entries(statics)) {
    const original = generated[key];
    const call = `${name}.${key}()`;
    generated[key] = (/** @type {unknown[]} */ ...args) => {
      checkReady(call);
      return run(call, original, generated, checkArguments(call, parameters, args));
    };
  }
}
