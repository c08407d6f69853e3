// The address after the #: read field by field against a page's schema, each wrong field said in words.

import { photos } from "./photos.js";

/** @typedef {import("./frame.js").Point} Point */
/** A field's text → its value; throws words that go on after the field's name. @template T @typedef {(text: string) => T} Reader */
/** @typedef {Record<string, Reader<any>>} Schema */
/** @template {Schema} S @typedef {{ [K in keyof S]?: ReturnType<S[K]> }} Values */

/** Longer outlines cannot be edited by hand. */
const MOST_POINTS = 2000;
/** Nothing on a page lies farther out. */
const FARTHEST = 1e12;

/**
 * What an address says, and what of it is wrong: one sentence for each wrong field.
 * @template {Schema} S
 * @param {string} hash with or without # @param {S} schema @param {(name: string) => Reader<any> | undefined} [others] readers of fields with names that the schema does not know
 * @returns {{ values: Values<S>, others: Map<string, any>, wrong: string[] }}
 */
export function readAddress(hash, schema, others = () => undefined) {
  /** @type {Record<string, unknown>} */
  const values = {};
  /** @type {Map<string, any>} */
  const more = new Map();
  /** @type {string[]} */
  const wrong = [];
  for (const [name, text] of new URLSearchParams(hash.replace(/^#/, ""))) {
    const known = Object.hasOwn(schema, name);
    const reader = known ? schema[name] : others(name);
    if (!reader) {
      wrong.push(`this page knows no “${shortened(name)}”`);
      continue;
    }
    try {
      const value = reader(text);
      if (known) values[name] = value;
      else more.set(name, value);
    } catch (error) {
      wrong.push(`“${name}=${shortened(text)}” ${error instanceof Error ? error.message : error}`);
    }
  }
  return { values: /** @type {Values<S>} */ (values), others: more, wrong };
}

/** What is wrong with an address, for its visitor; "" for nothing. @param {string[]} wrong */
export function wrongWords(wrong) {
  if (!wrong.length) return "";
  const [first, ...rest] = wrong;
  const more = rest.length ? `, and ${rest.length} more ${rest.length === 1 ? "field is" : "fields are"} wrong` : "";
  return `The address could not be read altogether: ${first}${more}. The rest of it is shown; the address stays as it is until you change something.`;
}

/** @param {string} text */
const shortened = (text) => (text.length > 40 ? `${text.slice(0, 40)}…` : text);

/** @param {string} text @returns {number} */
function finite(text) {
  const value = text.trim() === "" ? NaN : Number(text);
  if (!(Math.abs(value) <= FARTHEST)) throw new Error(`has something else than a number: “${shortened(text)}”`);
  return value;
}

/** @param {number} low @param {number} high @returns {Reader<number>} */
export const between = (low, high) => (text) => {
  const value = finite(text);
  if (!(value >= low && value <= high)) throw new Error(`must be from ${low} to ${high}`);
  return value;
};

/** Numbers with commas between them. @param {number} count @returns {Reader<number[]>} */
export const numbers = (count) => (text) => {
  const parts = text.split(",");
  if (parts.length !== count) throw new Error(`needs ${count} numbers with commas between them`);
  return parts.map(finite);
};

/** @type {Reader<Point>} */
export const point = (text) => /** @type {Point} */ (numbers(2)(text));

/** An outline: "x,y;x,y;…", or all with commas. @type {Reader<Point[]>} */
export const outline = (text) => {
  const parts = text.includes(";") ? text.split(";") : inPairs(text.split(","));
  if (parts.length < 3) throw new Error("needs at least 3 points");
  if (parts.length > MOST_POINTS) throw new Error(`has ${parts.length} points; at most ${MOST_POINTS} can be edited here`);
  return parts.map(point);
};

/** "x", "y", "x", … → "x,y", … @param {string[]} texts */
const inPairs = (texts) => texts.flatMap((text, k) => (k % 2 ? [] : [texts.slice(k, k + 2).join(",")]));

/** One of some words. @template {string} T @param {Iterable<T>} allowed @returns {Reader<T>} */
export function oneOf(allowed) {
  const names = [...allowed];
  return (text) => {
    const found = names.find((name) => name === text);
    if (found === undefined) throw new Error(`must be one of ${names.join(", ")}`);
    return found;
  };
}

/** Several of some words. @template {string} T @param {Iterable<T>} allowed @returns {Reader<T[]>} */
export function someOf(allowed) {
  const one = oneOf(allowed);
  return (text) => (text === "" || text === "none" ? [] : text.split(",").map(one));
}

/** @type {Reader<boolean>} */
export const flag = (text) => oneOf(["0", "1"])(text) === "1";

/** A photo of the page; a visitor's own is never in an address that somebody else opens. @param {(id: string) => boolean} known @returns {Reader<string>} */
export const photo = (known) => (text) => {
  if (known(text)) return text;
  if (/^own-\d+$/.test(text)) throw new Error("is a picture from somebody’s own computer, which is not in a link: open it again");
  if (text === "camera") throw new Error("is a camera’s picture, which is not in a link: switch the camera on again");
  return oneOf(photos.keys())(text);
};
