// A picture drawn by a map itself, without a mesh: in bands of rows, between which the page is listened to.

/** @typedef {import("./frame.js").Frame} Frame */
/** @typedef {import("../../pkg/index.js").Texture} Texture */
/** @typedef {{ warp(texture: Texture, options: import("../../pkg/index.js").WarpOptions): Uint8ClampedArray }} Drawing */

/** Rows that are drawn at once. */
const BAND = 16;

/**
 * What lies on the first side of a map, on its second.
 * @param {Drawing} map @param {Texture} texture @param {Frame} frame of the texture @param {Frame} view
 * @param {(share: number) => void} onShare @param {(() => Promise<void>) | null} pause lets messages in, and ends what nobody waits for; none for drafts, of which a hand that moves on shows one after the other @returns {Promise<Uint8ClampedArray<ArrayBuffer>>}
 */
export async function pointByPoint(map, texture, frame, view, onShare, pause) {
  const [width, height] = view.pixels;
  const out = new Uint8ClampedArray(4 * width * height);
  for (let row = 0; row < height; row += BAND) {
    const end = Math.min(height, row + BAND);
    const band = out.subarray(4 * width * row, 4 * width * end);
    map.warp(texture, { texture: frame, view, direction: "push-forward", quality: "trilinear", out: band, rows: [row, end] });
    onShare(end / height);
    if (pause) await pause();
  }
  return out;
}
