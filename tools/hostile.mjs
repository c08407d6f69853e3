// npm run test:hostile [times]: the campaigns of tests/native/hostile/, so many times as much as in npm test, with their figures.

import { Failure, main, show } from "./steps.mjs";

await main(async () => {
  const [times = "20"] = process.argv.slice(2);
  if (!/^[1-9]\d*$/.test(times)) throw new Failure(`“${times}” must be a whole number: how many times as much as in npm test.`);
  await show(`campaigns, ${times} times npm test`, "cargo", ["test", "--release", "--test", "native", "hostile", "--", "--nocapture"], { HOSTILE: times });
});
