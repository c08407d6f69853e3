// Finding a Chromium, or installing one, and starting it for the browser tests.

import { existsSync } from "node:fs";
import { chromium } from "playwright-core";
import { Failure, run, step } from "./steps.mjs";

const usualPlaces = [
  "/usr/bin/chromium",
  "/usr/bin/chromium-browser",
  "/usr/bin/google-chrome",
  "/usr/bin/google-chrome-stable",
  "/snap/bin/chromium",
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
  "/Applications/Chromium.app/Contents/MacOS/Chromium",
  "C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe",
  "C:\\Program Files (x86)\\Google\\Chrome\\Application\\chrome.exe",
  "C:\\Program Files (x86)\\Microsoft\\Edge\\Application\\msedge.exe",
];

/** Without these it looks up its maker's hosts at every start … */
const flags = [
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  // … and has no camera: this one shows a test picture.
  "--use-fake-device-for-media-stream",
  "--use-fake-ui-for-media-stream",
];

/** The path of a Chromium on this machine: the variable CHROMIUM, a usual place, or Playwright's own download. */
export function findChromium() {
  const named = process.env.CHROMIUM;
  if (named) {
    if (!existsSync(named)) throw new Failure(`CHROMIUM names "${named}", which does not exist.`);
    return named;
  }
  return [...usualPlaces, chromium.executablePath()].find((path) => path && existsSync(path));
}

/** Makes sure that there is a Chromium: Playwright's own is tried, then Debian's package when root. */
export async function installChromium() {
  const found = findChromium();
  if (found) return found;
  const attempts = [() => run("npx", ["playwright-core", "install", "chromium"])];
  if (process.getuid?.() === 0 && existsSync("/usr/bin/apt-get")) {
    const env = { DEBIAN_FRONTEND: "noninteractive" };
    attempts.push(async () => {
      await run("apt-get", ["update"], { env });
      return run("apt-get", ["install", "-y", "--no-install-recommends", "chromium"], { env });
    });
  }
  await step("installing Chromium", async () => {
    for (const attempt of attempts) {
      await attempt().catch(() => {});
      if (findChromium()) return;
    }
  });
  const installed = findChromium();
  if (!installed) {
    throw new Failure(
      "The page's tests need Chromium, and none was found or could be installed: install Chromium or Chrome, " +
        'run "npx playwright-core install chromium", or set CHROMIUM to its path.',
    );
  }
  return installed;
}

/** Starts a headless Chromium with an empty profile; the caller closes it. */
export async function launchChromium() {
  const executablePath = findChromium();
  if (!executablePath) throw new Failure("No Chromium was found: run npm test once, which installs one.");
  // Root may not use Chromium's sandbox.
  const sandbox = process.getuid?.() === 0 ? ["--no-sandbox"] : [];
  return chromium.launch({ executablePath, headless: true, args: [...flags, ...sandbox] });
}
