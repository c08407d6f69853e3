// The static server of npm start: right types, nothing outside its folder, the next port when one is used.

import assert from "node:assert/strict";
import { mkdir, mkdtemp, readdir, readFile, rm, symlink, writeFile } from "node:fs/promises";
import { request } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { contentPolicy, serve } from "../../tools/server.mjs";
import { root } from "../../tools/steps.mjs";

/** @type {string} */
let folder;
/** @type {Awaited<ReturnType<typeof serve>>} */
let server;

before(async () => {
  folder = await mkdtemp(join(tmpdir(), "serve-"));
  await mkdir(join(folder, "www", "a b"), { recursive: true });
  await writeFile(join(folder, "secret.txt"), "secret");
  await writeFile(join(folder, "www", "index.html"), "<p>home");
  await writeFile(join(folder, "www", "code.js"), "1");
  await writeFile(join(folder, "www", "code.wasm"), "\0asm");
  await writeFile(join(folder, "www", "a b", "ü.txt"), "umlaut");
  await symlink(join(folder, "secret.txt"), join(folder, "www", "link.txt"));
  server = await serve(join(folder, "www"), 0, contentPolicy);
});

after(async () => {
  await server.close();
  await rm(folder, { recursive: true });
});

/**
 * The status of a path that is sent as it is: fetch would resolve its dots.
 *
 * @param {string} path
 * @returns {Promise<number | undefined>}
 */
function status(path, method = "GET") {
  const { port } = new URL(server.url);
  return new Promise((resolve, reject) => {
    request({ host: "127.0.0.1", port, path, method }, (response) => {
      response.resume();
      resolve(response.statusCode);
    })
      .on("error", reject)
      .end();
  });
}

test("files come with their types", async () => {
  const typeOf = async (/** @type {string} */ path) => (await fetch(server.url + path)).headers.get("Content-Type");
  assert.equal(await typeOf(""), "text/html; charset=utf-8");
  assert.equal(await typeOf("code.js"), "text/javascript; charset=utf-8");
  assert.equal(await typeOf("code.wasm"), "application/wasm");
  assert.equal(await (await fetch(`${server.url}a%20b/${encodeURIComponent("ü.txt")}?query#hash`)).text(), "umlaut");
});

test("nothing outside the folder is served", async () => {
  const paths = ["/../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "/..%5csecret.txt", "/link.txt"];
  for (const path of [...paths, "//etc/passwd", "/%00", "/%", "/none", "/a%20b"]) {
    assert.equal(await status(path), 404, path);
  }
  assert.equal(await status("/", "POST"), 405);
});

test("a used port moves on to the next", async () => {
  const { port } = new URL(server.url);
  const next = await serve(join(folder, "www"), Number(port));
  assert.ok(Number(new URL(next.url).port) > Number(port));
  await next.close();
});

test("a file that the browser has is not sent again; one that has changed is", async () => {
  const first = await fetch(`${server.url}code.js`);
  const tag = first.headers.get("ETag") ?? "";
  assert.match(tag, /^".+"$/);
  const ask = (/** @type {Record<string, string>} */ headers) => fetch(`${server.url}code.js`, { headers, cache: "no-store" }).then(({ status }) => status);
  assert.equal(await ask({ "If-None-Match": tag }), 304);
  assert.equal(await ask({ "If-Modified-Since": first.headers.get("Last-Modified") ?? "" }), 304);
  await writeFile(join(folder, "www", "code.js"), "22");
  assert.equal(await ask({ "If-None-Match": tag }), 200);
});

test("the server and every page say the same about what may be loaded", async () => {
  const policy = (await fetch(server.url)).headers.get("Content-Security-Policy") ?? "";
  assert.ok(policy.startsWith(contentPolicy));
  const www = join(root, "www");
  const pages = (await readdir(www)).filter((name) => name.endsWith(".html"));
  assert.ok(pages.length >= 4);
  for (const page of pages) assert.ok((await readFile(join(www, page), "utf8")).includes(`<meta http-equiv="Content-Security-Policy" content="${contentPolicy}">`), page);
});
