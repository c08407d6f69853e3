// The camera as a picture that changes: its frames go through prepared warps, on the page's own thread.

import { Texture } from "../../pkg/index.js";
import { photoFrame } from "../common/frame.js";

/** @typedef {import("../common/frame.js").Frame} Frame */
/** @typedef {import("../common/images.js").Picture} Picture */
/** @typedef {import("../../pkg/index.js").PreparedWarp} PreparedWarp */
/** @typedef {import("./eye.js").Eye} Eye */
/** @typedef {Uint8ClampedArray<ArrayBuffer>} Pixels */

/** The picture's id. */
export const CAMERA = "camera";
const [WIDTH, HEIGHT] = [640, 480];

export class Camera {
  /** @type {Picture} */
  picture;
  #video;
  #context;
  #texture;
  /** One a hemisphere, for each panel. @type {PreparedWarp[][]} */
  #warps = [];
  #open = true;

  /** Asks for the camera. @param {() => void} onFrame @returns {Promise<Camera>} */
  static async open(onFrame) {
    const stream = await navigator.mediaDevices?.getUserMedia({ video: { width: WIDTH, height: HEIGHT } }).catch((error) => {
      throw new Error(`The camera could not be opened: ${error.message}`);
    });
    if (!stream) throw new Error("This browser gives no camera to a page that was not loaded over https.");
    const video = Object.assign(document.createElement("video"), { srcObject: stream, muted: true, playsInline: true });
    await video.play();
    return new Camera(video, onFrame);
  }

  /** @param {HTMLVideoElement} video @param {() => void} onFrame */
  constructor(video, onFrame) {
    this.#video = video;
    const canvas = Object.assign(document.createElement("canvas"), { width: WIDTH, height: HEIGHT });
    const context = canvas.getContext("2d", { willReadFrequently: true });
    if (!context) throw new Error("This browser gives no 2d canvas.");
    this.#context = context;
    const pixels = this.#frame();
    this.#texture = new Texture(pixels, WIDTH, HEIGHT);
    this.picture = { id: CAMERA, title: "Camera", canvas, pixels, frame: photoFrame(WIDTH, HEIGHT) };
    const next = () => {
      if (!this.#open) return;
      onFrame();
      video.requestVideoFrameCallback(next);
    };
    video.requestVideoFrameCallback(next);
  }

  #frame() {
    this.#context.drawImage(this.#video, 0, 0, WIDTH, HEIGHT);
    return this.#context.getImageData(0, 0, WIDTH, HEIGHT).data;
  }

  /** Finds all out that does not change from frame to frame. @param {Eye[]} eyes @param {Frame[]} views of the two hemispheres */
  prepare(eyes, views) {
    this.#freeWarps();
    this.#warps = eyes.map((eye) => eye.prepare(this.#texture, this.picture.frame, views));
  }

  /** The newest frame on the cortex: for each panel one picture a hemisphere. @returns {Pixels[][]} */
  draw() {
    this.#texture.replace(this.#frame());
    return this.#warps.map((warps) => warps.map((warp) => /** @type {Pixels} */ (warp.warp(this.#texture))));
  }

  #freeWarps() {
    for (const warp of this.#warps.flat()) warp.free();
    this.#warps = [];
  }

  close() {
    this.#open = false;
    this.#freeWarps();
    this.#texture.free();
    for (const track of /** @type {MediaStream} */ (this.#video.srcObject).getTracks()) track.stop();
  }
}
