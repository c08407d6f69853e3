// How long something takes.

/**
 * Milliseconds that `work` takes: the median of several runs after one that warms up. A run is repeated until
 * `budget` milliseconds are spent, at least `least` times.
 *
 * @param {() => void} work
 * @param {{ least?: number, budget?: number }} [options]
 */
export function milliseconds(work, { least = 3, budget = 300 } = {}) {
  const once = () => {
    const start = performance.now();
    work();
    return performance.now() - start;
  };
  const first = once();
  // What takes seconds does not profit from being warm.
  if (first > 5000) return first;
  /** @type {number[]} */
  const runs = [];
  for (let spent = 0; runs.length < least || spent < budget; spent += runs[runs.length - 1]) runs.push(once());
  runs.sort((a, b) => a - b);
  return runs[runs.length >> 1];
}

/**
 * Milliseconds that a promise takes: the best of several, after one that warms up.
 *
 * @param {() => Promise<unknown>} work
 * @param {number} [rounds]
 */
export async function millisecondsOf(work, rounds = 5) {
  let best = Infinity;
  for (let round = 0; round <= rounds; round++) {
    const start = performance.now();
    await work();
    if (round > 0) best = Math.min(best, performance.now() - start);
  }
  return best;
}

/**
 * Milliseconds of several rivals, in turns: whatever else the machine does meets them all alike. The best of the rounds.
 *
 * @template {string} Name
 * @param {Record<Name, () => void>} rivals
 * @param {number} [rounds]
 * @returns {Record<Name, number>}
 */
export function inTurns(rivals, rounds = 7) {
  const names = /** @type {Name[]} */ (Object.keys(rivals));
  const best = /** @type {Record<Name, number>} */ (Object.fromEntries(names.map((name) => [name, Infinity])));
  for (let round = 0; round <= rounds; round++) {
    for (const name of names) {
      const start = performance.now();
      rivals[name]();
      const time = performance.now() - start;
      // The first round warms up.
      if (round > 0) best[name] = Math.min(best[name], time);
    }
  }
  return best;
}
