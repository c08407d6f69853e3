// OKLab → the screen's colours: a space in which equal steps look equal (B. Ottosson, A perceptual color space for image processing, 2020).

const { cos, sin, min, max, round } = Math;

/** The largest chroma that every hue can have on the screen at a lightness of 0.74; less of it towards black and white. */
const CHROMA = 0.115;
const FULL = 0.74;
/** Red at argument 0, as is the custom; in radians. */
const RED = 0.5;

/** Linear light → a byte, looked up. */
const BYTES = Uint8ClampedArray.from({ length: 4097 }, (_, k, x = k / 4096) => round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055)));

/** @param {number} linear */
const byteOf = (linear) => BYTES[round(4096 * min(1, max(0, linear)))];

/** The chroma that all hues can have at a lightness. @param {number} light */
export const chromaAt = (light) => CHROMA * max(0, min(1, light / FULL, (1 - light) / (1 - FULL)));

/** A hue at a lightness, with a share of the chroma that all hues can have there. @param {number} light @param {number} angle @param {number} share @param {Uint8ClampedArray} out @param {number} at */
export function evenHue(light, angle, share, out, at) {
  const chroma = share * chromaAt(light);
  labToBytes(light, chroma * cos(angle + RED), chroma * sin(angle + RED), out, at);
}

/** @param {number} x */
const cube = (x) => x * x * x;

/** @param {number} light @param {number} a @param {number} b @param {Uint8ClampedArray} out @param {number} at */
export function labToBytes(light, a, b, out, at) {
  const l = cube(light + 0.3963377774 * a + 0.2158037573 * b);
  const m = cube(light - 0.1055613458 * a - 0.0638541728 * b);
  const s = cube(light - 0.0894841775 * a - 1.291485548 * b);
  out[at] = byteOf(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s);
  out[at + 1] = byteOf(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s);
  out[at + 2] = byteOf(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s);
}
