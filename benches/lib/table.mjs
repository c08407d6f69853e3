// Results as Markdown tables, targets beside what was measured.

/** A limit and what was measured. */
export class Target {
  /**
   * @param {number} measured
   * @param {number} limit at most this much
   * @param {(x: number) => string} show
   */
  constructor(measured, limit, show) {
    this.measured = measured;
    this.limit = limit;
    this.show = show;
  }

  toString() {
    const mark = this.measured <= this.limit ? "✔" : "✘";
    return `${this.show(this.measured)} (≤ ${this.show(this.limit)}) ${mark}`;
  }
}

export const ms = (/** @type {number} */ x) => (x >= 1000 ? `${(x / 1000).toFixed(2)} s` : `${x.toFixed(x < 10 ? 2 : 0)} ms`);
export const ratio = (/** @type {number} */ x) => `${x.toFixed(2)}×`;
export const scientific = (/** @type {number} */ x) => x.toExponential(1);

/**
 * @param {string} title
 * @param {string[]} columns
 * @param {(string | number | Target)[][]} rows
 */
export function printTable(title, columns, rows) {
  const cells = [columns, ...rows.map((row) => row.map(String))];
  const widths = columns.map((_, k) => Math.max(...cells.map((row) => [...(row[k] ?? "")].length)));
  const line = (/** @type {string[]} */ row) =>
    `| ${widths.map((width, k) => (row[k] ?? "").padEnd(width)).join(" | ")} |`;
  console.log(`\n## ${title}\n`);
  console.log(line(columns));
  console.log(`|${widths.map((width) => "-".repeat(width + 2)).join("|")}|`);
  for (const row of cells.slice(1)) console.log(line(row));
}
