// The words of formulas, and what they are spelled with; as src/formula/lexer.rs and names.rs have it.

/** @typedef {"number" | "word" | "raised" | "overline" | "power" | "end" | "+" | "-" | "*" | "/" | "√" | "(" | ")" | "|" | "," | "="} Kind */
/** @typedef {{ kind: Kind, text: string }} Token */

const PIECE = /(?<space>[\s\u200b-\u200d\u2060-\u2062]+)|(?<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?<raised>[⁻⁺]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)|(?<word>℘|\p{Alphabetic}(?:(?![⁰¹²³⁴⁵⁶⁷⁸⁹])[\p{Alphabetic}\p{N}_])*)|(?<power>\*\*|\^)|(?<other>.)/gsu;

/** Signs that have several forms. @type {[Kind, string][]} */
const SIGNS = [["+", "+"], ["-", "-−–﹣－"], ["*", "*·×⋅∙∗"], ["/", "/÷∕⁄"], ["overline", "\u0304\u0305"], ["√", "√"], ["(", "(["], [")", ")]"], ["|", "|∣"], [",", ",;"], ["=", "="]];

/** The tokens of a formula, the last one its end; null for a sign that no formula has. @param {string} text @returns {Token[] | null} */
export function tokensOf(text) {
  /** @type {Token[]} */
  const tokens = [];
  for (const { 0: piece, groups = {} } of text.matchAll(PIECE)) {
    if (groups.space) continue;
    const named = /** @type {const} */ (["number", "raised", "word", "power"]).find((kind) => groups[kind] !== undefined);
    const kind = named ?? SIGNS.find(([, forms]) => forms.includes(piece))?.[0];
    if (!kind) return null;
    tokens.push({ kind, text: piece });
  }
  return [...tokens, { kind: "end", text: "" }];
}

/** Values that have a name. */
export const CONSTANTS = new Set(["i", "e", "pi", "π", "tau", "τ"]);
/** What depends on z where nothing else has the name, and what does not. */
export const COORDINATES = new Set(["x", "y", "Z"]);
export const IMAGINARY = "I";

/** Functions of one argument, which may stand without parentheses and have an exponent after the name. */
const PLAIN = new Set(
  ("exp log ln log10 lg sqrt sin cos tan sec csc cosec cot sinh cosh tanh sech csch coth asin acos atan asec acsc acot arcsin arccos arctan arcsec arccsc arccot " +
    "asinh acosh atanh asech acsch acoth arsinh arcosh artanh arsech arcsch arcoth arcsinh arccosh arctanh arcsech arccsch arccoth " +
    "gamma sinc floor conj re im abs arg erf erfc zeta lambertw").split(" "),
);
const MORE = new Set("pow mod besselj sn cn dn wp ℘ wpp sum prod product iterate".split(" "));

/** The usual name of a function, and whether it has one argument; undefined where there is none. @param {string} name */
export function functionNamed(name) {
  const lower = name === "Γ" ? "gamma" : name.toLowerCase();
  return PLAIN.has(lower) || MORE.has(lower) ? { name: lower, plain: PLAIN.has(lower) } : undefined;
}
