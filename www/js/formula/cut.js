// The cut of logarithms, roots and powers, turned to any angle: the same formula, with each of them as the branch that it is.
//
// log w with its cut where arg w = θ, on sheet k, is log(w e^{−i(θ−π)}) + i(θ−π) + 2πik. The language has it already: with
// s = (θ − π)/2π + k it is log(w R, s), R = e^{−i(θ−π)}; a root is sqrt(w R, s), a power pow(w R, a, s), all with the same s.
// So a formula is read as src/formula/parser.rs reads it, and written again with those in their places.

import { CONSTANTS, COORDINATES, functionNamed, IMAGINARY, tokensOf } from "./words.js";

/** @typedef {import("./words.js").Kind} Kind */
/** Where the cut lies, in degrees from −180 to 180, and which sheet is shown. @typedef {{ angle: number, sheet: number }} Cut */
/** The formula with its cuts turned; what has a cut where its angle is θ, as formulas, where they can stand alone. @typedef {{ formula: string, arguments: string[] }} Turned */
/** Part of a formula, written again. @typedef {{ text: string, varies: boolean }} Part */

/** Where the language has it. @type {Cut} */
export const PRINCIPAL = { angle: 180, sheet: 0 };

/** How far the cut was turned, over all sheets, in degrees: a whole turn leads to the next sheet. @param {Cut} cut */
export const wholeTurn = ({ angle, sheet }) => angle + 360 * sheet;

/** The cut that was turned so far. @param {number} turn @returns {Cut} */
export function cutAt(turn) {
  const sheet = Math.ceil((turn - 180) / 360) || 0;
  return { angle: turn - 360 * sheet, sheet };
}

/** A formula whose cuts lie elsewhere; null where it cannot be read, or has none. @param {string} formula @param {Iterable<string>} params names @param {Cut} cut @returns {Turned | null} */
export function turned(formula, params, { angle, sheet }) {
  const tokens = tokensOf(formula);
  if (!tokens) return null;
  const back = ((180 - angle) * Math.PI) / 180;
  const turner = new Turner(tokens, new Set(params), number(Math.cos(back)), number(Math.sin(back)), number((angle - 180) / 360 + sheet));
  try {
    const text = turner.whole();
    return turner.found ? { formula: text, arguments: [...turner.arguments] } : null;
  } catch (error) {
    if (error instanceof Unread) return null;
    throw error;
  }
}

/** Whether the cut lies elsewhere than the language has it. @param {Cut} cut */
export const isTurned = (cut) => wholeTurn(cut) !== wholeTurn(PRINCIPAL);

/** What is drawn: the formula as it stands while its cut does. @param {string} formula @param {Iterable<string>} params @param {Cut} cut */
export function formulaWithCut(formula, params, cut) {
  return isTurned(cut) ? (turned(formula, params, cut)?.formula ?? formula) : formula;
}

class Unread extends Error {}

/** Written without an exponent, whose e a name could swallow. @param {number} x */
const number = (x) => `(${x.toFixed(14)})`;

/** A whole number. */
const WHOLE = /^[-−+(\s]*\d+[)\s]*$/u;

/** Operators bind so strongly. */
const [SUM, PRODUCT, SIGN, EXPONENT] = [0, 1, 2, 3];
/** How strongly they bind, and what stands to their right. @type {Map<Kind, [number, number]>} */
const OPERATORS = new Map([["+", [SUM, PRODUCT]], ["-", [SUM, PRODUCT]], ["*", [PRODUCT, SIGN]], ["/", [PRODUCT, SIGN]], ["power", [EXPONENT, SIGN]]]);

class Turner {
  found = false;
  /** @type {Set<string>} */
  arguments = new Set();
  #tokens;
  #at = 0;
  #params;
  #rotation;
  #turns;
  /** Names of loops, and whether they depend on z. @type {{ name: string, varies: boolean }[]} */
  #bound = [];
  #bars = 0;

  /** @param {import("./words.js").Token[]} tokens @param {Set<string>} params @param {string} re @param {string} im of R @param {string} turns s */
  constructor(tokens, params, re, im, turns) {
    this.#tokens = tokens;
    this.#params = params;
    this.#rotation = `(${re} + ${im} * i)`;
    this.#turns = turns;
  }

  whole() {
    const kinds = this.#tokens.slice(0, 5).map(({ kind }) => kind);
    const head = kinds.join(" ") === "word ( word ) =" ? 5 : kinds[0] === "word" && kinds[1] === "=" ? 2 : 0;
    this.#at = head;
    const { text } = this.#expression(SUM);
    this.#require("end");
    return text;
  }

  get #kind() {
    return this.#tokens[this.#at].kind;
  }

  #next() {
    return this.#tokens[this.#at++];
  }

  /** @param {Kind} kind */
  #accept(kind) {
    if (this.#kind !== kind) return false;
    this.#at++;
    return true;
  }

  /** @param {Kind} kind */
  #require(kind) {
    if (this.#kind !== kind) throw new Unread();
    if (kind !== "end") this.#at++;
  }

  /** @param {number} least @returns {Part} */
  #expression(least) {
    let left = this.#operand();
    for (;;) {
      const more = this.#operator(left, least);
      if (!more) return left;
      left = more;
    }
  }

  /** @param {Part} left @param {number} least @returns {Part | null} */
  #operator(left, least) {
    if (this.#kind === "raised" || this.#kind === "overline") return { ...left, text: left.text + this.#next().text };
    const operator = OPERATORS.get(this.#kind);
    const unwritten = this.#kind === "word" || this.#kind === "(" || this.#kind === "√" || (this.#kind === "|" && this.#bars === 0);
    const [power, right] = operator ?? [unwritten ? PRODUCT : -1, SIGN];
    if (power < least) return null;
    const sign = operator ? this.#next() : null;
    const part = this.#expression(right);
    if (sign?.kind === "power") return this.#power(left, part);
    return { text: `${left.text} ${sign ? `${sign.text} ` : ""}${part.text}`, varies: left.varies || part.varies };
  }

  /** @param {Part} base @param {Part} exponent @returns {Part} */
  #power(base, exponent) {
    const varies = base.varies || exponent.varies;
    if (!base.varies || this.#isWhole(exponent)) return { text: `${base.text}^${exponent.text}`, varies };
    return { text: this.#branch("pow", base, `${exponent.text}, `), varies };
  }

  /** Whether a power with this exponent has no cut. @param {Part} exponent */
  #isWhole({ text }) {
    return WHOLE.test(text) || this.#bound.some(({ name, varies }) => name === text && !varies);
  }

  /** The branch of a function that has the cut where it is wanted. @param {string} name @param {Part} argument @param {string} between @param {string} [branch] that was asked for */
  #branch(name, argument, between = "", branch) {
    this.found = true;
    if (!this.#bound.length) this.arguments.add(argument.text);
    return `${name}((${argument.text}) * ${this.#rotation}, ${between}${branch ? `(${branch}) + ` : ""}${this.#turns})`;
  }

  /** @returns {Part} */
  #operand() {
    const { kind, text } = this.#next();
    if (kind === "number") return { text, varies: false };
    if (kind === "word") return this.#word(text);
    if (kind === "+" || kind === "-") {
      const part = this.#expression(SIGN);
      return { ...part, text: `${text} ${part.text}` };
    }
    if (kind === "√") {
      const part = this.#operand();
      return { ...part, text: part.varies ? this.#branch("sqrt", part) : `√${part.text}` };
    }
    if (kind === "(") {
      const part = this.#enclosed(0);
      this.#require(")");
      return { ...part, text: `(${part.text})` };
    }
    if (kind !== "|") throw new Unread();
    const part = this.#enclosed(this.#bars + 1);
    this.#require("|");
    // What is nowhere negative has no cut to turn.
    return { text: `abs(${part.text})`, varies: false };
  }

  /** @param {number} bars @returns {Part} */
  #enclosed(bars) {
    const outside = this.#bars;
    this.#bars = bars;
    const part = this.#expression(SUM);
    this.#bars = outside;
    return part;
  }

  /** @param {string} word @returns {Part} */
  #word(word) {
    const value = this.#valueNamed(word);
    if (value) return value;
    const known = functionNamed(word);
    if (known) return this.#call(word, known);
    const pieces = this.#split(word);
    if (pieces) {
      this.#tokens.splice(this.#at, 0, ...pieces.slice(1).map((text) => ({ kind: /** @type {Kind} */ ("word"), text })));
      return this.#word(pieces[0]);
    }
    if (word === IMAGINARY) return { text: "i", varies: false };
    if (COORDINATES.has(word)) return { text: word, varies: true };
    throw new Unread();
  }

  /** @param {string} name @returns {Part | null} */
  #valueNamed(name) {
    if (name === "z") return { text: name, varies: true };
    if (CONSTANTS.has(name)) return { text: name, varies: false };
    const bound = this.#bound.findLast((each) => each.name === name);
    if (bound) return { text: name, varies: bound.varies };
    return this.#params.has(name) ? { text: name, varies: false } : null;
  }

  /** The names that a word is made of, the longest first; a function only as the last, before a parenthesis. @param {string} word @returns {string[] | null} */
  #split(word) {
    const letters = [...word];
    const before = this.#kind === "(";
    /** @type {(string[] | null)[]} */
    const rests = Array(letters.length).fill(null).concat([[]]);
    for (let start = letters.length - 1; start >= 0; start--) {
      for (let end = letters.length; end > start && !rests[start]; end--) {
        const piece = letters.slice(start, end).join("");
        const fits = this.#valueNamed(piece) || (end === letters.length && before && functionNamed(piece));
        const rest = rests[end];
        if (rest && fits) rests[start] = [piece, ...rest];
      }
    }
    return rests[0]?.length ? rests[0] : null;
  }

  /** @param {string} word @param {{ name: string, plain: boolean }} what @returns {Part} */
  #call(word, { name, plain }) {
    let exponent = "";
    if (plain && this.#kind === "raised") exponent = this.#next().text;
    else if (plain && this.#accept("power")) exponent = `^${this.#next().text}`;
    /** @type {Part[]} */
    let parts;
    if (this.#accept("(")) {
      const outside = this.#bars;
      this.#bars = 0;
      parts = ["sum", "prod", "product", "iterate"].includes(name) ? this.#loop(name) : this.#list();
      this.#bars = outside;
      this.#require(")");
    } else if (plain) parts = [this.#bare()];
    else throw new Unread();
    return this.#applied(word, name, exponent, parts);
  }

  /** @param {string} word @param {string} name @param {string} exponent @param {Part[]} parts @returns {Part} */
  #applied(word, name, exponent, parts) {
    const varies = name !== "abs" && parts.some((part) => part.varies);
    const [first, second, third] = parts;
    if (first.varies) {
      if (name === "log" || name === "ln") return { text: withExponent(this.#branch("log", first, "", second?.text), exponent), varies };
      if (name === "sqrt") return { text: withExponent(this.#branch("sqrt", first, "", second?.text), exponent), varies };
      if (name === "log10" || name === "lg") return { text: withExponent(`(${this.#branch("log", first)} / log(10))`, exponent), varies };
      if (name === "pow" && second && (third || !this.#isWhole(second))) return { text: this.#branch("pow", first, `${second.text}, `, third?.text), varies };
    }
    return { text: `${word}${exponent}(${parts.map(({ text }) => text).join(", ")})`, varies };
  }

  /** @returns {Part[]} */
  #list() {
    const parts = [this.#expression(SUM)];
    while (this.#accept(",")) parts.push(this.#expression(SUM));
    return parts;
  }

  /** `n, from, to, body` or `w, start, count, body`. @param {string} kind @returns {Part[]} */
  #loop(kind) {
    const { text: name } = this.#next();
    const parts = [{ text: name, varies: false }];
    for (let k = 0; k < 2; k++) {
      this.#require(",");
      parts.push(this.#expression(SUM));
    }
    this.#require(",");
    this.#bound.push({ name, varies: kind === "iterate" });
    parts.push(this.#expression(SUM));
    this.#bound.pop();
    return parts;
  }

  /** Factors up to the next operator, parenthesis or function. @returns {Part} */
  #bare() {
    let part = this.#expression(SIGN);
    while (this.#kind === "word" && !functionNamed(this.#tokens[this.#at].text)) {
      const more = this.#expression(SIGN);
      part = { text: `${part.text} ${more.text}`, varies: part.varies || more.varies };
    }
    return part;
  }
}

/** @param {string} text of a call @param {string} exponent that stood after its name */
const withExponent = (text, exponent) => (exponent ? `(${text}${exponent})` : text);
