// What the tests of two regions share.

/** @typedef {import("playwright-core").Page} Page */

/**
 * The right picture at places of its plane, and a sum over all of it.
 *
 * @param {Page} page
 * @param {[number, number][]} [points] of a square photo, [−1, 1] across
 */
export function picture(page, points = []) {
  return page.evaluate((wanted) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("to-photo"));
    const { width, height } = canvas;
    const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).getImageData(0, 0, width, height);
    const samples = wanted.map(([x, y]) => {
      const at = 4 * (Math.floor(((1 - y) / 2) * height) * width + Math.floor(((1 + x) / 2) * width));
      return [...data.slice(at, at + 4)];
    });
    return { digest: data.reduce((sum, value) => (Math.imul(sum, 31) + value) | 0, 0), samples };
  }, points);
}
