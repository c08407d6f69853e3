// Where magnification is plotted.

/** In degrees. */
export const [LOWEST_E, HIGHEST_E] = [0.1, 90];

/** Eccentricities at which curves are drawn. */
export const eccentricities = Array.from({ length: 120 }, (_, k) => LOWEST_E * (HIGHEST_E / LOWEST_E) ** (k / 119));
