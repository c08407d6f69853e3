// The two regions that the page opens with: a cat's face, and the head in a space suit that it goes into.

import { toPlane } from "../common/frame.js";
import { frameOf, photoRegion, regionOn } from "../editor/presets.js";
import { moveCenter, moveToward } from "../editor/region.js";

/** @typedef {import("../editor/store.js").Document} Document */

const cat = frameOf("chelsea");

/** The cat's outline as on the other pages; the vector is another one. @type {Document} */
export const firstFrom = {
  image: "chelsea",
  region: moveToward(moveCenter(photoRegion("chelsea"), toPlane(cat, [246, 136])), toPlane(cat, [355, 159.1])),
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
