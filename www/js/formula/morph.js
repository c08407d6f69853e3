// The way from z to f(z).

/** `f(z) =` or `w =`, which may stand before a formula. */
const HEAD = /^\s*\p{L}\w*\s*(?:\(\s*[zZ]\s*\)\s*)?=/u;

/** (1 − s) z + s f(z) as a formula: the identity where s = 0, f where s = 1. @param {string} formula @param {number} s */
export function morphed(formula, s) {
  if (s === 1) return formula;
  // Nothing is written that a name could swallow: 0.25 z, not 0.25z or 2.5e-1 z.
  return `${(1 - s).toFixed(4)} * z + ${s.toFixed(4)} * (${formula.replace(HEAD, "")})`;
}
