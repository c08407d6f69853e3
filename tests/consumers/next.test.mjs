// The package in a Next application, bundled by Turbopack: on a page, and in a route that computes on the server.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { root } from "../../tools/steps.mjs";
import { closeBrowser, resultAt } from "./support/browser.mjs";
import { answer, freePort } from "./support/ports.mjs";
import { program, project, run, work } from "./support/project.mjs";

const next = program("next/dist/bin/next");
const quiet = { NEXT_TELEMETRY_DISABLED: "1", CI: "true" };
/** What Node computes from the same files. @type {string} */
let expected;

before(async () => {
  expected = (await run(project("next-reference"), [process.execPath, "main.js"])).trim();
});

after(closeBrowser);

/** The route of docs/RECIPES.md. */
function route() {
  const [, code] = /** @type {RegExpExecArray} */ (/^## Next$[\s\S]*?```ts\n([\s\S]*?)```/m.exec(readFileSync(join(root, "docs", "RECIPES.md"), "utf8")));
  return code;
}

test("Next with Turbopack", async () => {
  const folder = project("next", undefined, {
    // The tests' packages lie above the project.
    "next.config.mjs": `export default { turbopack: { root: ${JSON.stringify(work)} }, outputFileTracingRoot: ${JSON.stringify(work)} };`,
    "app/layout.js": "export default function Layout({ children }) { return <html><body>{children}</body></html>; }",
    "app/page.js": `
      "use client";
      import { useEffect } from "react";
      import init, * as warp from "conformal-warp";
      import { work } from "../work.js";
      export default function Page() {
        useEffect(() => { init().then(() => { globalThis.result = work(warp); }, (error) => { globalThis.result = error.message; }); }, []);
        return <p>conformal</p>;
      }`,
    "app/radius/route.js": `export const dynamic = "force-dynamic";\n${route()}`,
  });
  await run(folder, [process.execPath, next, "build"], quiet);
  const port = await freePort();
  const server = spawn(process.execPath, [next, "start", "-p", String(port)], { cwd: folder, env: { ...process.env, ...quiet }, stdio: "ignore" });
  try {
    const { radius } = /** @type {any} */ (await (await answer(`http://127.0.0.1:${port}/radius`)).json());
    assert.equal(radius.toFixed(10), expected.split(" ")[0]);
    assert.equal(await resultAt(`http://127.0.0.1:${port}/`), expected);
  } finally {
    server.kill();
  }
});
