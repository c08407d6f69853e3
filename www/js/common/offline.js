// The site works without a network after one visit, where it was written by `npm run site`.

/** A visit's first pictures come first, in milliseconds. */
const LATER = 1500;

/** Has the browser keep the site's files. */
export function workOffline() {
  const kept = document.querySelector('meta[name="site-version"]');
  if (!kept || !("serviceWorker" in navigator)) return;
  // Where the browser keeps nothing, as in some private windows, the page works as before.
  const keep = () => setTimeout(() => navigator.serviceWorker.register(new URL("../../service-worker.js", import.meta.url)).catch(() => {}), LATER);
  takeNewer();
  if (document.readyState === "complete") keep();
  else window.addEventListener("load", keep);
}

/** A newer version that came during the last visit is shown, where no other page is open that is of the old one. */
async function takeNewer() {
  const registration = await navigator.serviceWorker.getRegistration().catch(() => undefined);
  if (!registration?.waiting || !navigator.serviceWorker.controller) return;
  navigator.serviceWorker.addEventListener("controllerchange", () => location.reload(), { once: true });
  registration.waiting.postMessage("take over");
}
