// The lines of a grid over a view, and where a formula takes them.

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("./pipeline.js").Lines} Lines */

/** Points along a line. */
const STEPS = 600;
/** Lines each way, at most. */
const MOST = 96;
/** Rings of a polar grid. */
const RINGS = 24;

/** Rays of a polar grid as dense as a square one; an even number, so that a chessboard closes up. @param {number} density */
export const spokesOf = (density) => 2 * Math.round(0.75 * density);

/** The square ones where a kind has none of its own: a drawing is never empty. @param {Frame} view @param {Lines} kind @param {{ density: number, texture: { width: number } }} look @returns {Float64Array[]} */
export function gridLines({ center: [x, y], width, pixels }, kind, { density, texture }) {
  const height = (width * pixels[1]) / pixels[0];
  const [left, low] = [x - width / 2, y - height / 2];
  /** @param {(share: number) => [number, number]} at */
  const line = (at) => new Float64Array(Array.from({ length: STEPS + 1 }, (_, k) => at(k / STEPS)).flat());
  if (kind === "polar" || kind === "modulus" || kind === "phase") {
    const reach = Math.hypot(Math.abs(x) + width / 2, Math.abs(y) + height / 2);
    /** @param {number} radius @param {number} angle @returns {[number, number]} */
    const polar = (radius, angle) => [radius * Math.cos(angle), radius * Math.sin(angle)];
    const spokes = spokesOf(density);
    const step = (2 * Math.PI) / spokes;
    // The unit circle is one of them.
    const outermost = Math.exp(step * Math.floor(Math.log(reach) / step));
    const rings = Array.from({ length: RINGS }, (_, k) => outermost * Math.exp(-step * k));
    return [
      ...(kind === "modulus" ? [] : Array.from({ length: spokes }, (_, k) => line((s) => polar(reach * Math.exp(-step * RINGS * (1 - s)), k * step)))),
      ...(kind === "phase" ? [] : rings.map((radius) => line((s) => polar(radius, 2 * Math.PI * s)))),
    ];
  }
  const step = Math.max(texture.width / density, Math.max(width, height) / MOST);
  /** @param {number} from @param {number} to */
  const multiples = (from, to) => Array.from({ length: Math.max(0, Math.floor(to / step) - Math.ceil(from / step) + 1) }, (_, k) => (Math.ceil(from / step) + k) * step);
  return [
    ...(kind === "imaginary" ? [] : multiples(left, left + width).map((u) => line((s) => [u, low + s * height]))),
    ...(kind === "real" ? [] : multiples(low, low + height).map((v) => line((s) => [left + s * width, v]))),
  ];
}

/** A step so many times as long as the one before it is a jump over a branch cut or a pole. */
const JUMP = 12;

/** A carried line in the pieces that hold together. @param {Float64Array} line @returns {Float64Array[]} */
export function unbroken(line) {
  /** @type {number[][]} */
  const pieces = [[]];
  let before = Infinity;
  for (let k = 0; k < line.length; k += 2) {
    const last = pieces[pieces.length - 1];
    const [x, y] = [line[k], line[k + 1]];
    const step = last.length ? Math.hypot(x - last[last.length - 2], y - last[last.length - 1]) : 0;
    const whole = Number.isFinite(x) && Number.isFinite(y) && (step <= JUMP * before || last.length < 4);
    if (!whole) pieces.push([]);
    if (Number.isFinite(x) && Number.isFinite(y)) pieces[pieces.length - 1].push(x, y);
    before = whole && step > 0 ? step : Infinity;
  }
  return pieces.filter(({ length }) => length > 2).map((piece) => new Float64Array(piece));
}
