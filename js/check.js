// Arguments are checked here, once, against the types that the package declares: signatures.js holds them as data.
// What comes out is what the wasm module takes: fresh plain objects without absent keys, numbers in the array it wants.

import { isCurrent } from "./conformal_warp.js";
import { failure } from "./failure.js";
import { types } from "./signatures.js";

/**
 * A type: the name of a kind or of a declared type, "unknown" for whatever is checked elsewhere, or one of the composed ones.
 *
 * @typedef {string | { oneOf: string[] } | { any: Type[] } | { tuple: Type[] } | { list: Type } | { record: Type }
 *   | Fields | { methods: string[] }} Type
 */

/** @typedef {{ fields: Record<string, [type: Type, optional: 0 | 1]>, open?: boolean }} Fields `open`: other keys do not matter */

/** @typedef {[name: string, type: Type, optional: 0 | 1]} Parameter */

/** @typedef {{ argument: string, path: string, call: string, exact?: boolean }} Place where a value was found; `exact`: no other array does */

const LARGEST_COUNT = 2 ** 32 - 1;

/** The classes that objects may have to be of, by the names that the package gives them. @type {Map<string, Function>} */
export const classes = new Map();

/** @type {Record<string, { words: string, make: { from(values: ArrayLike<number>): ArrayBufferView }, whole?: number }>} */
const arrays = {
  Float64Array: { words: "a Float64Array", make: Float64Array },
  Uint32Array: { words: "a Uint32Array", make: Uint32Array, whole: LARGEST_COUNT },
  Uint8Array: { words: "a Uint8Array", make: Uint8Array, whole: 255 },
  Uint8ClampedArray: { words: "a Uint8ClampedArray", make: Uint8ClampedArray, whole: 255 },
};

/**
 * The arguments of a call as the wasm module takes them.
 *
 * @param {string} call its name, for people
 * @param {Parameter[]} parameters
 * @param {ArrayLike<unknown>} given
 */
export function checkArguments(call, parameters, given) {
  return parameters.map(([name, type, optional], k) => {
    const value = given[k];
    if (value === undefined || value === null) {
      if (optional) return undefined;
      throw failure("invalid-argument", `${call} needs ${name}: ${words(type)}.`, { argument: name });
    }
    return read(type, value, { argument: name, path: "", call });
  });
}

/**
 * @param {Type} type
 * @param {any} value
 * @param {Place} place
 * @returns {unknown}
 */
function read(type, value, place) {
  if (isRevoked(value)) return refuse(type, value, place);
  if (typeof type === "string") return readNamed(type, value, place);
  if ("oneOf" in type) return type.oneOf.includes(value) ? value : refuse(type, value, place);
  if ("any" in type) return readAny(type, value, place);
  if ("tuple" in type) return readTuple(type.tuple, value, place);
  if ("record" in type) return readRecord(type, value, place);
  if ("list" in type) {
    if (!Array.isArray(value)) return refuse(type, value, place);
    return Array.from(value, (item, k) => {
      const isEndless = typeof item === "number" && !Number.isFinite(item);
      return isEndless ? refuse("Finite", item, at(place, k)) : read(type.list, item, at(place, k));
    });
  }
  if ("methods" in type) {
    return type.methods.every((name) => typeof value[name] === "function") ? value : refuse(type, value, place);
  }
  return readFields(type, value, place);
}

/**
 * @param {string} type
 * @param {any} value
 * @param {Place} place
 */
function readNamed(type, value, place) {
  if (type === "unknown") return value;
  if (type === "Count") return isCount(value, LARGEST_COUNT) ? value : refuse(type, value, place);
  if (type === "function" && isClass(value)) return refuse(type, value, place);
  if (type in arrays) return readArray(type, value, place);
  if (classes.has(type)) return checkObject(type, value, () => refuse(type, value, place));
  if (type in types) return read(/** @type {any} */ (types)[type], value, place);
  return typeof value === type ? value : refuse(type, value, place);
}

/**
 * The first of several types that fits.
 *
 * @param {{ any: Type[] }} type
 * @param {any} value
 * @param {Place} place
 */
function readAny(type, value, place) {
  const exact = type.any.find((one) => typeof one === "string" && kindOf(value) === one);
  if (exact) return read(exact, value, place);
  /** @type {unknown} */
  let inside;
  for (const one of type.any) {
    try {
      return read(one, value, place);
    } catch (/** @type {any} */ error) {
      // The next may fit; if none does, what is wrong within an array says more than that it is one.
      if (Array.isArray(value) && error.option?.endsWith("]") && error.option !== place.path) inside ??= error;
    }
  }
  if (inside) throw inside;
  return refuse(type, value, place);
}

/**
 * Whatever holds numbers becomes the array that is wanted; one that is to be written to must be it.
 *
 * @param {string} type
 * @param {any} value
 * @param {Place} place
 */
function readArray(type, value, place) {
  const kind = kindOf(value);
  const { make, whole } = arrays[type];
  const element = whole === undefined ? "number" : whole === LARGEST_COUNT ? "Count" : "Byte";
  if (kind === type) return value;
  const isOut = place.path ? place.path === "out" : place.argument === "out";
  const holdsNumbers = Array.isArray(value) || (kind !== undefined && kind !== "DataView" && !kind.startsWith("Big"));
  if (isOut || place.exact || !holdsNumbers) return refuse(type, value, place);
  const fits = whole === undefined ? (/** @type {unknown} */ n) => typeof n === "number" : (/** @type {unknown} */ n) => isCount(n, whole);
  for (let k = 0; k < value.length; k++) {
    if (!fits(value[k])) return refuse(element, value[k], at(place, k));
  }
  return make.from(value);
}

/**
 * @param {Type[]} tuple
 * @param {any} value
 * @param {Place} place
 */
function readTuple(tuple, value, place) {
  const isList = Array.isArray(value) || (kindOf(value) !== undefined && kindOf(value) !== "DataView");
  if (!isList || value.length !== tuple.length) return refuse({ tuple }, value, place);
  return tuple.map((type, k) => read(type, value[k], at(place, k)));
}

/**
 * @param {{ record: Type }} type
 * @param {any} value
 * @param {Place} place
 */
function readRecord(type, value, place) {
  if (!isPlain(value)) return refuse(type, value, place);
  const entries = Object.keys(value).map((key) => [key, read(type.record, value[key], at(place, key))]);
  return Object.fromEntries(entries);
}

/**
 * @param {Fields} type
 * @param {any} value
 * @param {Place} place
 */
function readFields(type, value, place) {
  const names = Object.keys(type.fields);
  if (!isPlain(value) && !(type.open && typeof value === "object")) return refuse(type, value, place);
  // A misspelled option must not be silently ignored.
  const unknown = keysOf(value).find((key) => !Object.hasOwn(type.fields, key) && value[key] !== undefined);
  if (unknown !== undefined && !type.open) {
    const { path } = at(place, unknown);
    throw failure("invalid-option", `There is no option "${path}"; there are ${names.join(", ")}.`, { option: path });
  }
  /** @type {Record<string, unknown>} */
  const fresh = {};
  for (const name of names) {
    const [field, optional] = type.fields[name];
    const inside = { ...at(place, name), exact: type.open };
    const found = value[name];
    if (found !== undefined && found !== null) fresh[name] = read(field, found, inside);
    else if (!optional) {
      const message = `The option "${inside.path}" is missing: ${words(field)}.`;
      throw failure("invalid-option", message, { option: inside.path });
    }
  }
  return fresh;
}

/** The names that an object answers to, inherited ones too; but not what somebody gave to all objects. @param {object} value */
function keysOf(value) {
  const names = [];
  for (const name in value) if (!Object.hasOwn(Object.prototype, name)) names.push(name);
  return names;
}

/**
 * An object of one of the package's classes, alive.
 *
 * @param {string} name
 * @param {any} value
 * @param {() => never} refused
 */
export function checkObject(name, value, refused) {
  const made = /** @type {any} */ (classes.get(name));
  if (typeof value !== "object" || value === null || !(value instanceof made) || !("__wbg_ptr" in value)) refused();
  if (value.__wbg_ptr === 0) {
    const message = `This ${name} was freed: it cannot be used after free(), nor after the end of its "using" block.`;
    throw failure("freed", message);
  }
  if (!isCurrent(value)) {
    throw failure("stale", `This ${name} went with the module when init.reset() loaded it anew: make it again.`);
  }
  return value;
}

/**
 * @param {Place} place
 * @param {string | number} key
 * @returns {Place}
 */
function at(place, key) {
  const step = typeof key === "number" ? `[${key}]` : place.path ? `.${key}` : key;
  return { ...place, path: place.path + step };
}

/**
 * @param {Type} type
 * @param {unknown} value
 * @param {Place} place
 * @returns {never}
 */
function refuse(type, value, { argument, path, call }) {
  const expected = `expected ${words(type)}, found ${describe(value)}`;
  if (path === "") throw failure("invalid-argument", `${call}: ${argument} cannot be used: ${expected}.`, { argument });
  const what = path.startsWith("[") ? `${argument}${path}` : path;
  throw failure("invalid-option", `The option "${what}" cannot be used: ${expected}.`, { option: what });
}

/**
 * A type, for people.
 *
 * @param {Type} type
 * @returns {string}
 */
function words(type) {
  if (typeof type !== "string") {
    if ("oneOf" in type) return `one of ${type.oneOf.map((one) => `"${one}"`).join(", ")}`;
    if ("any" in type) return type.any.map(words).join(" or ");
    if ("tuple" in type) return `an array of ${type.tuple.length} ${type.tuple.every(isTuple) ? "points" : "numbers"}`;
    if ("list" in type) return "an array";
    if ("methods" in type) return `an object with a method ${type.methods.join(", ")}`;
    return "fields" in type ? `an object with keys of ${Object.keys(type.fields).join(", ")}` : "an object of names and values";
  }
  if (type === "Count") return "a whole number from 0 to 2³² − 1";
  if (type === "Finite") return "a finite number";
  if (type === "Byte") return "a whole number from 0 to 255";
  if (type in arrays) return arrays[type].words;
  if (type in types) return words(/** @type {any} */ (types)[type]);
  return classes.has(type) ? `${withArticle(type)}, made by this package` : withArticle(type);
}

/** @param {Type} type */
function isTuple(type) {
  const named = typeof type === "string" ? types[type] : type;
  return typeof named === "object" && "tuple" in named;
}

/** @param {string} name @param {string} article */
export function withArticle(name, article = "a") {
  return `${article}${/^[AEIOU]/i.test(name) ? "n" : ""} ${name}`;
}

/**
 * A value, for people, in few words.
 *
 * @param {any} value
 */
export function describe(value) {
  if (value === undefined || value === null || typeof value === "boolean") return String(value);
  if (isRevoked(value)) return "a revoked proxy";
  if (isClass(value)) return "a class";
  if (typeof value === "string") return JSON.stringify(value.length > 40 ? `${value.slice(0, 40)}…` : value);
  if (typeof value === "number") return String(value);
  if (Array.isArray(value)) return `an array of ${value.length}`;
  const kind = kindOf(value);
  if (kind !== undefined) return `a ${kind} of ${value.length ?? value.byteLength}`;
  for (const [name, made] of classes) if (typeof value === "object" && value instanceof made) return withArticle(name);
  return typeof value === "object" ? "an object" : `a ${typeof value}`;
}

/**
 * The name of a view's class, whatever window or realm it comes from.
 *
 * @param {unknown} value
 * @returns {string | undefined}
 */
function kindOf(value) {
  return ArrayBuffer.isView(value) ? Object.prototype.toString.call(value).slice(8, -1) : undefined;
}

/**
 * @param {unknown} value
 * @param {number} most
 */
function isCount(value, most) {
  return typeof value === "number" && Number.isInteger(value) && value >= 0 && value <= most;
}

/** A proxy that has been revoked throws whatever is asked of it. @param {unknown} value */
function isRevoked(value) {
  try {
    Array.isArray(value);
    return false;
  } catch {
    return true;
  }
}

/** What can be called by `new` alone. @param {unknown} value */
function isClass(value) {
  return typeof value === "function" && /^class\b/.test(Function.prototype.toString.call(value));
}

/** @param {any} value */
function isPlain(value) {
  return Object.prototype.toString.call(value) === "[object Object]" && !("__wbg_ptr" in value);
}
