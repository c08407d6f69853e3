// The camera as a picture that changes: its frames are handed over one by one.

import { contextOf } from "../common/canvas.js";
import { photoFrame } from "../common/frame.js";

/** @typedef {import("../common/images.js").Picture} Picture */

const [WIDTH, HEIGHT] = [640, 480];

export class Camera {
  /** @type {Picture} */
  picture;
  #video;
  #context;
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
    this.#context = contextOf(canvas, { willReadFrequently: true });
    this.picture = { id: "camera", title: "Camera", canvas, pixels: this.frame(), frame: photoFrame(WIDTH, HEIGHT) };
    const next = () => {
      if (!this.#open) return;
      onFrame();
      video.requestVideoFrameCallback(next);
    };
    video.requestVideoFrameCallback(next);
  }

  /** The newest frame's pixels; the picture's canvas shows it from then on. */
  frame() {
    this.#context.drawImage(this.#video, 0, 0, WIDTH, HEIGHT);
    return this.#context.getImageData(0, 0, WIDTH, HEIGHT).data;
  }

  close() {
    this.#open = false;
    for (const track of /** @type {MediaStream} */ (this.#video.srcObject).getTracks()) track.stop();
  }
}
