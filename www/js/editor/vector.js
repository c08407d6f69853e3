// The inward vector, drawn alike in both panels: from `toward` on the boundary to `center` inside.

import { set, svg } from "../common/svg.js";

/** @typedef {import("../common/frame.js").Point} Point */

/** @param {boolean} handles whether its ends can be dragged */
export function markVector(handles) {
  /** @param {string} part @param {string} label */
  const end = (part, label) =>
    svg("g", handles ? { class: `end ${part}`, "data-part": part, role: "button", tabindex: 0, "aria-label": label } : { class: `end ${part}` }, [
      svg("circle", { class: "reach" }),
      svg("circle", { class: "dot" }),
    ]);
  return svg("g", { class: "vector" }, [
    svg("path", { class: "shaft-halo" }),
    svg("path", { class: "shaft" }),
    end("toward", "The boundary point that goes to 1"),
    end("center", "The point that goes to 0, the centre of the disk"),
  ]);
}

/** @param {SVGGElement} group @param {Point} from toward, in pixels @param {Point} to center @param {boolean} wrong */
export function updateVector(group, from, to, wrong = false) {
  const [halo, shaft, toward, center] = group.children;
  const data = arrow(from, to);
  set(halo, { d: data });
  set(shaft, { d: data });
  set(toward, { transform: `translate(${from[0]} ${from[1]})` });
  set(center, { transform: `translate(${to[0]} ${to[1]})` });
  group.classList.toggle("wrong", wrong);
}

/** A shaft with an open head that stops short of the dot at its tip. @param {Point} from @param {Point} to */
function arrow([x0, y0], [x1, y1]) {
  const length = Math.hypot(x1 - x0, y1 - y0) || 1;
  const [ux, uy] = [(x1 - x0) / length, (y1 - y0) / length];
  const [tipX, tipY] = [x1 - 9 * ux, y1 - 9 * uy];
  /** @param {number} side */
  const barb = (side) => `${tipX - 9 * ux - side * 5 * uy} ${tipY - 9 * uy + side * 5 * ux}`;
  return `M${x0} ${y0}L${tipX} ${tipY}M${barb(1)}L${tipX} ${tipY}L${barb(-1)}`;
}
