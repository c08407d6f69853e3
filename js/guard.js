// Words instead of "null pointer passed to rust": calls before init() and uses after free() are told apart and named.

let ready = false;

/** Called once the module is loaded. */
export function setReady() {
  ready = true;
}

/**
 * @param {string} code
 * @param {string} message
 */
function failure(code, message) {
  return Object.assign(new Error(message), { code });
}

/** @param {string} name what was called */
function checkReady(name) {
  if (!ready) throw failure("not-initialized", `${name} was used before the module was loaded: await init() first.`);
}

/**
 * wasm-bindgen sets an object's pointer to 0 when it is freed.
 *
 * @param {any} value
 */
function checkAlive(value) {
  if (typeof value !== "object" || value === null || value.__wbg_ptr !== 0) return;
  const name = value.constructor?.name ?? "object";
  throw failure("freed", `This ${name} was freed: it cannot be used after free(), nor after the end of its "using" block.`);
}

/**
 * A generated class, or function, whose calls check first that the module is loaded and that nothing is used after free().
 *
 * @template {Function} T
 * @param {T} generated
 * @param {string} name
 * @returns {T}
 */
export function guard(generated, name) {
  if (generated.prototype) guardPrototype(generated.prototype);
  const isClass = typeof (/** @type {any} */ (generated.prototype)?.free) === "function";
  if (isClass) guardStatics(generated, name);
  return new Proxy(generated, {
    construct(target, args, newTarget) {
      checkReady(`new ${name}()`);
      args.forEach(checkAlive);
      return Reflect.construct(/** @type {any} */ (target), args, newTarget);
    },
    apply(target, self, args) {
      // A class called without `new` says so itself.
      if (!isClass) {
        checkReady(`${name}()`);
        args.forEach(checkAlive);
      }
      return Reflect.apply(/** @type {any} */ (target), self, args);
    },
  });
}

/** @param {any} prototype */
function guardPrototype(prototype) {
  if (prototype.free) freeOnce(prototype);
  for (const key of Reflect.ownKeys(prototype)) {
    // What starts with __ is for generated code only.
    if (key === "constructor" || key === "free" || key === Symbol.dispose || String(key).startsWith("__")) continue;
    const property = /** @type {PropertyDescriptor} */ (Object.getOwnPropertyDescriptor(prototype, key));
    for (const part of /** @type {const} */ (["value", "get", "set"])) {
      const original = property[part];
      if (typeof original !== "function") continue;
      property[part] = function (/** @type {any[]} */ ...args) {
        checkAlive(this);
        args.forEach(checkAlive);
        return original.apply(this, args);
      };
    }
    Object.defineProperty(prototype, key, property);
  }
}

/**
 * Freeing twice is harmless, as disposing twice must be.
 *
 * @param {any} prototype
 */
function freeOnce(prototype) {
  const { free } = prototype;
  prototype.free = function () {
    if (this.__wbg_ptr !== 0) free.call(this);
  };
  if (Symbol.dispose) prototype[Symbol.dispose] = prototype.free;
}

/**
 * @param {any} generated
 * @param {string} name
 */
function guardStatics(generated, name) {
  for (const key of Object.getOwnPropertyNames(generated)) {
    const original = generated[key];
    if (typeof original !== "function" || key === "prototype" || key.startsWith("__")) continue;
    generated[key] = function (/** @type {any[]} */ ...args) {
      checkReady(`${name}.${key}()`);
      args.forEach(checkAlive);
      return original.apply(generated, args);
    };
  }
}
