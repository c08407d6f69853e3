// The page of lessons: each figure comes to life when it is about to be seen.

import { Courier } from "../common/courier.js";
import { Place } from "./place.js";
import { workOffline } from "../common/offline.js";
import { watchErrors, wordsOf } from "../common/page.js";

watchErrors();
workOffline();
const courier = new Courier(new URL("worker.js", import.meta.url));

/** @param {HTMLElement} figure */
async function enliven(figure) {
  try {
    const { mount } = await import(`./figures/${figure.dataset.figure}.js`);
    const place = new Place(figure, courier);
    await mount(place);
    figure.querySelector(".still")?.remove();
  } catch (error) {
    figure.dataset.state = "failed";
    const words = Object.assign(document.createElement("p"), { className: "reading", textContent: `This figure stays still: ${wordsOf(error)}.` });
    figure.append(words);
  }
}

const seen = new IntersectionObserver(
  (entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      seen.unobserve(target);
      enliven(/** @type {HTMLElement} */ (target));
    }
  },
  { rootMargin: "600px" },
);

for (const figure of document.querySelectorAll("figure[data-figure]")) seen.observe(figure);
document.body.dataset.state = "ready";
