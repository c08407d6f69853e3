// The two regions that the page opens with: a cat's face, and the head in a space suit that it goes into.

import { regionOn } from "../editor/presets.js";

/** @typedef {import("../editor/store.js").Document} Document */

/** @type {Document} */
export const firstFrom = {
  image: "chelsea",
  region: regionOn("chelsea", {
    outline: [
      [34, 96], [44, 34], [96, 8], [180, 4], [262, 8], [330, 22], [362, 66], [368, 120], [352, 168], [330, 216],
      [304, 258], [262, 284], [212, 270], [164, 236], [110, 204], [58, 168],
    ],
    center: [246, 136],
    toward: [355, 159.1],
  }),
};

/** @type {Document} */
export const firstTo = {
  image: "astronaut",
  region: regionOn("astronaut", {
    outline: [
      [196, 22], [232, 14], [268, 22], [292, 46], [303, 84], [294, 118], [276, 142], [262, 166], [240, 186], [214, 186],
      [194, 166], [183, 140], [164, 116], [154, 82], [168, 42],
    ],
    center: [224, 108],
    toward: [288, 126],
  }),
};
