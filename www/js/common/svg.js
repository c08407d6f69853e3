// Small helpers for drawings made of SVG elements.

/** @typedef {import("./frame.js").Point} Point */

/**
 * @template {keyof SVGElementTagNameMap} K
 * @param {K} name @param {Record<string, string | number>} [attributes] @param {Element[]} [children]
 * @returns {SVGElementTagNameMap[K]}
 */
export function svg(name, attributes = {}, children = []) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  set(element, attributes);
  element.append(...children);
  return element;
}

/** Sets what is not so already: each setting costs a style anew. @param {Element} element @param {Record<string, string | number>} attributes */
export function set(element, attributes) {
  for (const name in attributes) {
    const value = String(attributes[name]);
    if (element.getAttribute(name) !== value) element.setAttribute(name, value);
  }
}

/** Path data through points, in pixels. @param {Point[]} points @param {boolean} closed */
export function pathData(points, closed) {
  if (!points.length) return "";
  return `M${points.map(([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`).join("L")}${closed ? "Z" : ""}`;
}

/**
 * Keeps `parent` holding as many children as there are items, each set by `update`; elements are kept, so that focus
 * and pointers stay with them.
 * @template T @template {Element} E
 * @param {Element} parent @param {T[]} items @param {(index: number) => E} create
 * @param {(element: E, item: T, index: number) => void} update
 */
export function match(parent, items, create, update) {
  while (parent.children.length > items.length) parent.lastElementChild?.remove();
  while (parent.children.length < items.length) parent.append(create(parent.children.length));
  items.forEach((item, k) => update(/** @type {E} */ (parent.children[k]), item, k));
}

/** Places that were found out: asking again, after something was drawn, would lay the page out anew. @type {WeakMap<Event, Map<SVGSVGElement, Point>>} */
const places = new WeakMap();

/** Where a pointer is, in the pixels of an element that fills its box. @param {Element} root @param {MouseEvent} event @returns {Point} */
export function pixelOf(root, event) {
  const known = places.get(event) ?? new Map();
  if (!known.size) places.set(event, known);
  const place = known.get(root);
  if (place) return place;
  const box = root.getBoundingClientRect();
  /** @type {Point} */
  const found = [event.clientX - box.left, event.clientY - box.top];
  known.set(root, found);
  return found;
}
