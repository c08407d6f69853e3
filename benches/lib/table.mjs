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

export const decibel = (/** @type {number} */ x) => `${x.toFixed(1)} dB`;

/** Everything that tables have printed. @type {string[]} */
export const printed = [];

/** @param {string} line */
function print(line) {
  console.log(line);
  printed.push(line);
}

/** A table whose rows are printed as they come. */
export class Table {
  /**
   * @param {string} title
   * @param {Record<string, number>} columns each with its width
   */
  constructor(title, columns) {
    this.widths = Object.entries(columns).map(([name, width]) => Math.max(width, name.length));
    print(`\n## ${title}\n`);
    this.row(...Object.keys(columns));
    print(`|${this.widths.map((width) => "-".repeat(width + 2)).join("|")}|`);
  }

  /** @param {...(string | number | Target)} cells */
  row(...cells) {
    print(`| ${this.widths.map((width, k) => String(cells[k] ?? "").padEnd(width)).join(" | ")} |`);
  }
}
