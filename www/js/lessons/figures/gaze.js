// A photo and what both hemispheres receive of it.

import { Board } from "../board.js";
import { loadPicture } from "../../common/images.js";
import { POLIMENI } from "../../cortex/models.js";

const DEGREES = 80;
/** Millimetres of cortex across the board. */
const ACROSS = 150;

/** @param {import("../place.js").Place} place */
export async function mount(place) {
  const picture = await loadPicture("astronaut");
  place.know(picture);
  const left = new Board("A photo, and where one looks", [0, 0], 2);
  const right = new Board("What the visual cortex receives: the right hemisphere at the left, the left one at the right", [0, 0], ACROSS);
  place.put(left, right);
  left.show(picture);
  const fixation = left.handle([-0.13, 0.58], { label: "Where one looks", kind: "gold", onMove: () => draw() });

  function draw() {
    const side = right.sharpness;
    place.ask({ what: "gaze", model: POLIMENI, picture: picture.id, fieldOfView: DEGREES, fixation: fixation.at, view: right.view(side) }, (pixels) => {
      right.paint(pixels, [side, side]);
      place.say(`The photo spans ${DEGREES}° of the visual field. What one looks at takes most of the cortex.`);
    });
  }
  draw();
}
