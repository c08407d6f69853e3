// What TypeScript that becomes CommonJS writes.
import warp = require("conformal-warp");
void warp.init();
