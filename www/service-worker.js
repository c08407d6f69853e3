// Keeps the site for use without a network: all of its files, of one version. `npm run site` writes the two constants; from
// the source folder no page starts it.

/** Which files these are; another version has a cache of its own. */
const VERSION = "";
/** The files of the site, each with what it must be. @type {Record<string, string>} */
const FILES = {};

const PREFIX = "conformal-warp ";
const CACHE = PREFIX + VERSION;

/** What a service worker knows that a page does not. @typedef {{ waitUntil(work: Promise<unknown>): void }} Lasting */
/** @typedef {Lasting & { request: Request, respondWith(answer: Promise<Response>): void }} Fetching */
/**
 * @typedef {object} Scope
 * @property {{ scope: string }} registration
 * @property {{ matchAll(options: { type: "window", includeUncontrolled: boolean }): Promise<unknown[]> }} clients
 * @property {() => Promise<void>} skipWaiting
 * @property {(type: string, listener: (event: any) => void) => void} addEventListener
 */
const worker = /** @type {Scope} */ (/** @type {unknown} */ (self));

// All files or none: one that is not of this version, as in the middle of an upload, stops the installation; it is tried again.
worker.addEventListener("install", (/** @type {Lasting} */ event) => {
  const requests = Object.entries(FILES).map(([path, integrity]) => new Request(new URL(path, worker.registration.scope), { integrity, cache: "no-cache" }));
  event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(requests)));
});

// This happens when no page of the last version is open any more.
worker.addEventListener("activate", (/** @type {Lasting} */ event) => {
  event.waitUntil(caches.keys().then((names) => Promise.all(names.filter((name) => name.startsWith(PREFIX) && name !== CACHE).map((name) => caches.delete(name)))));
});

// A page that was just opened asks for the newer version; where it is the only one it gets it, and loads itself anew.
worker.addEventListener("message", (/** @type {Lasting & { data: unknown }} */ event) => {
  if (event.data !== "take over") return;
  event.waitUntil(worker.clients.matchAll({ type: "window", includeUncontrolled: true }).then(({ length }) => (length < 2 ? worker.skipWaiting() : undefined)));
});

worker.addEventListener("fetch", (/** @type {Fetching} */ event) => {
  const path = pathOf(event.request);
  if (path !== null) event.respondWith(answer(path, event.request));
});

/** The file of the site that is asked for; null for all else. @param {Request} request */
function pathOf({ method, url }) {
  const { scope } = worker.registration;
  const plain = url.replace(/[?#].*$/, "");
  if (method !== "GET" || !plain.startsWith(scope)) return null;
  const path = plain.slice(scope.length) || "index.html";
  return Object.hasOwn(FILES, path) ? path : null;
}

/** @param {string} path @param {Request} request */
async function answer(path, request) {
  const cache = await caches.open(CACHE);
  return (await cache.match(new URL(path, worker.registration.scope))) ?? fetch(request);
}
