// The entry that carries the module in itself: for places where no file can lie beside the code.

import { bytes } from "./bytes.js";
import { loader } from "./load.js";

export * from "./classes.js";

export const { init, initSync } = loader(bytes, bytes);
export default init;
