// A PNG file written row by row: no canvas has to hold all of it.

/** @typedef {import("./frame.js").Point} Point */

const SIGNATURE = Uint8Array.of(137, 80, 78, 71, 13, 10, 26, 10);
/** The row filter of PNG by which photos become smallest. */
const PAETH = 4;
/** Bytes of a pixel: RGBA. */
const DEPTH = 4;
/** What says which colours the bytes are: sRGB as PNG has always known it; Display P3 by its numbers in ITU-T H.273. @type {Record<PredefinedColorSpace, [name: string, data: number[]]>} */
const SPACES = { srgb: ["sRGB", [0]], "display-p3": ["cICP", [12, 13, 0, 1]] };

const CRCS = Uint32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; k++) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c;
});

export class PngWriter {
  #width;
  #stream = new CompressionStream("deflate");
  #writer = this.#stream.writable.getWriter();
  /** @type {Uint8Array<ArrayBuffer>[]} */ #parts;
  #reading;
  /** The last row as it was. @type {Uint8Array} */ #above;

  /** @param {Point} size @param {PredefinedColorSpace} [space] */
  constructor([width, height], space = "srgb") {
    this.#width = width;
    this.#above = new Uint8Array(DEPTH * width);
    const header = new DataView(new ArrayBuffer(13));
    header.setUint32(0, width);
    header.setUint32(4, height);
    header.setUint8(8, 8);
    header.setUint8(9, 6);
    const [name, data] = SPACES[space];
    this.#parts = [SIGNATURE, chunk("IHDR", new Uint8Array(header.buffer)), chunk(name, Uint8Array.from(data))];
    this.#reading = this.#read();
  }

  async #read() {
    const reader = this.#stream.readable.getReader();
    for (let next = await reader.read(); !next.done; next = await reader.read()) this.#parts.push(chunk("IDAT", next.value));
  }

  /** The rows that follow. @param {Uint8ClampedArray} pixels whole rows */
  async write(pixels) {
    const bytes = DEPTH * this.#width;
    const rows = pixels.length / bytes;
    const filtered = new Uint8Array(rows * (bytes + 1));
    for (let row = 0; row < rows; row++) {
      const here = pixels.subarray(row * bytes, (row + 1) * bytes);
      filtered[row * (bytes + 1)] = PAETH;
      filterInto(filtered.subarray(row * (bytes + 1) + 1, (row + 1) * (bytes + 1)), here, this.#above);
      this.#above = new Uint8Array(here);
    }
    await this.#writer.write(filtered);
  }

  /** The file. */
  async end() {
    await this.#writer.close();
    await this.#reading;
    return new Blob([...this.#parts, chunk("IEND", new Uint8Array())], { type: "image/png" });
  }
}

/** A row minus what its neighbours to the left and above foretell. @param {Uint8Array} out @param {ArrayLike<number>} here @param {ArrayLike<number>} above */
function filterInto(out, here, above) {
  for (let k = 0; k < here.length; k++) {
    const a = k < DEPTH ? 0 : here[k - DEPTH];
    const b = above[k];
    const c = k < DEPTH ? 0 : above[k - DEPTH];
    const pa = Math.abs(b - c);
    const pb = Math.abs(a - c);
    const pc = Math.abs(a + b - 2 * c);
    out[k] = here[k] - (pa <= pb && pa <= pc ? a : pb <= pc ? b : c);
  }
}

/** @param {string} name of four letters @param {Uint8Array} data @returns {Uint8Array<ArrayBuffer>} */
function chunk(name, data) {
  const bytes = new Uint8Array(12 + data.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  [...name].forEach((letter, k) => view.setUint8(4 + k, letter.charCodeAt(0)));
  bytes.set(data, 8);
  let crc = 0xffffffff;
  for (let k = 4; k < 8 + data.length; k++) crc = CRCS[(crc ^ bytes[k]) & 255] ^ (crc >>> 8);
  view.setUint32(8 + data.length, ~crc >>> 0);
  return bytes;
}
