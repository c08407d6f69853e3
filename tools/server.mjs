// A static file server for one folder, on localhost only.

import { createReadStream } from "node:fs";
import { realpath, stat } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, sep } from "node:path";
import { Failure } from "./steps.mjs";

/** @type {Record<string, string>} */
const types = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".ico": "image/x-icon",
  ".jpeg": "image/jpeg",
  ".jpg": "image/jpeg",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json; charset=utf-8",
  ".map": "application/json; charset=utf-8",
  ".md": "text/plain; charset=utf-8",
  ".mjs": "text/javascript; charset=utf-8",
  ".mp4": "video/mp4",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".ts": "text/plain; charset=utf-8",
  ".txt": "text/plain; charset=utf-8",
  ".wasm": "application/wasm",
  ".webm": "video/webm",
  ".webmanifest": "application/manifest+json",
  ".webp": "image/webp",
};

/** What a page may load: its own files, pictures that it makes or is given, WebAssembly; no code from text, nothing from elsewhere. */
export const contentPolicy =
  "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob: data:; object-src 'none'; base-uri 'none'; form-action 'none'";

/**
 * Serves the files of `folder` on 127.0.0.1. A used port moves on to the next one; port 0 takes any free one.
 *
 * @param {string} folder
 * @param {number} [port]
 * @param {string} [policy] what its pages may load; anything if empty
 * @returns {Promise<{ url: string, close: () => Promise<void> }>}
 */
export async function serve(folder, port = 0, policy = "") {
  const base = await realpath(folder);
  const server = createServer((request, response) => {
    answer(base, policy, request, response).catch(() => {
      if (!response.headersSent) response.writeHead(500);
      response.end();
    });
  });
  const used = await listen(server, port);
  return {
    url: `http://localhost:${used}/`,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}

/**
 * @param {import("node:http").Server} server
 * @param {number} first
 * @returns {Promise<number>} the port that it listens on
 */
async function listen(server, first) {
  for (let port = first; port < first + 100; port++) {
    try {
      await new Promise((resolve, reject) => {
        server.once("error", reject);
        server.listen(port, "127.0.0.1", () => {
          server.off("error", reject);
          resolve(undefined);
        });
      });
      const address = server.address();
      return typeof address === "object" && address ? address.port : port;
    } catch (error) {
      if (/** @type {NodeJS.ErrnoException} */ (error).code !== "EADDRINUSE") throw error;
    }
  }
  throw new Failure(`All ports from ${first} to ${first + 99} are in use: free one, or name another with PORT=….`);
}

/**
 * @param {string} base
 * @param {string} policy
 * @param {import("node:http").IncomingMessage} request
 * @param {import("node:http").ServerResponse} response
 */
async function answer(base, policy, request, response) {
  const refuse = (/** @type {number} */ status) => {
    response.writeHead(status, { "Content-Type": "text/plain; charset=utf-8" });
    response.end(`${status}\n`);
  };
  if (request.method !== "GET" && request.method !== "HEAD") return refuse(405);
  const file = await fileOf(base, request.url ?? "/");
  if (!file) return refuse(404);
  const validators = { ETag: `"${file.size.toString(36)}-${file.changed.getTime().toString(36)}"`, "Last-Modified": file.changed.toUTCString(), "Cache-Control": "no-cache" };
  if (isFresh(request.headers, validators, file.changed)) {
    response.writeHead(304, validators);
    return response.end();
  }
  response.writeHead(200, {
    ...validators,
    "Content-Type": types[extname(file.path).toLowerCase()] ?? "application/octet-stream",
    "Content-Length": file.size,
    ...(policy && { "Content-Security-Policy": `${policy}; frame-ancestors 'self'` }),
    "X-Content-Type-Options": "nosniff",
  });
  if (request.method === "HEAD") return response.end();
  createReadStream(file.path).on("error", () => response.destroy()).pipe(response);
}

/**
 * Whether the browser has the file as it is.
 *
 * @param {import("node:http").IncomingHttpHeaders} asked
 * @param {{ ETag: string }} validators
 * @param {Date} changed
 */
function isFresh(asked, { ETag }, changed) {
  const known = asked["if-none-match"];
  if (known !== undefined) return known.split(",").some((tag) => tag.trim().replace(/^W\//, "") === ETag);
  const since = Date.parse(asked["if-modified-since"] ?? "");
  return Math.floor(changed.getTime() / 1000) * 1000 <= since;
}

/**
 * The file that an address names, if it lies inside the folder (links resolved) and exists.
 *
 * @param {string} base
 * @param {string} url
 */
async function fileOf(base, url) {
  try {
    const path = decodeURIComponent(new URL(url, "http://localhost").pathname);
    if (path.includes("\0")) return undefined;
    let file = await realpath(join(base, path));
    if ((await stat(file)).isDirectory()) file = await realpath(join(file, "index.html"));
    if (!file.startsWith(base + sep)) return undefined;
    const { size, mtime } = await stat(file);
    return { path: file, size, changed: mtime };
  } catch {
    return undefined;
  }
}
