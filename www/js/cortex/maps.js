// Plain data → maps of the visual field, and what is drawn of them whatever is looked at. What was made is kept for a while.

import { Region, RetinoCorticalMap, RiemannMap } from "../../pkg/index.js";
import { flatten, unflatten } from "../common/frame.js";
import { GRID, onSide, SMALL_CIRCLES } from "./field.js";
import { eccentricities } from "./plot-range.js";

/** @typedef {import("../common/frame.js").Point} Point */
/** @typedef {import("../../pkg/index.js").Hemisphere} Hemisphere */
/** @typedef {import("./field.js").FieldLine} FieldLine */
/** @typedef {import("./models.js").Spec} Spec */
/** @typedef {import("./models.js").Outline} Outline */
/** A line as it is drawn: x, y, x, y, … @typedef {{ name: string, at: Float64Array }} Line */
/**
 * What a panel shows beside its pictures.
 * @typedef {object} Drawn
 * @property {number} id of the map
 * @property {number} area of one hemisphere, in mm²
 * @property {[number, number]} [landmarkError] how far an outline's map misses its landmark: in mm, in radians
 * @property {import("./layout.js").Half} half
 * @property {Float64Array} outline of the left hemisphere
 * @property {Line[]} lines
 * @property {Line[]} circles
 * @property {Float64Array} magnification mm a degree along the horizontal meridian, at `eccentricities`
 */

/** The hemispheres in the order in which their halves of the field are seen, and those halves' sides. @type {{ hemisphere: Hemisphere, side: 1 | -1 }[]} */
export const HEMISPHERES = [{ hemisphere: "right", side: -1 }, { hemisphere: "left", side: 1 }];

/** Loose enough to be quick: the disk has radius 1, and a hemisphere 80 mm. */
const TOLERANCE = 1e-6;
/** Of a blind spot that is being moved: still far below a pixel. */
const DRAFT_TOLERANCE = 1e-4;
/** Outlines, and maps, that are kept. */
const KEPT = 4;

/** Values by key; of too many the oldest is freed. @template {{ free(): void }} T */
class Shelf {
  /** @type {Map<string, T>} */ #kept = new Map();

  /** @param {string} key @param {() => T} make @param {(known: T) => boolean} serves whether what is kept is good enough @returns {T} */
  get(key, make, serves) {
    const known = this.#kept.get(key);
    const value = known && serves(known) ? known : make();
    if (value !== known) known?.free();
    this.#kept.delete(key);
    this.#kept.set(key, value);
    const [oldest] = this.#kept.keys();
    if (this.#kept.size > KEPT) {
      this.#kept.get(oldest)?.free();
      this.#kept.delete(oldest);
    }
    return value;
  }

  /** The newest that fits. @param {(key: string) => boolean} fits @returns {T | undefined} */
  find(fits) {
    return [...this.#kept].findLast(([key]) => fits(key))?.[1];
  }
}

/** @type {Shelf<RiemannMap>} */
const solved = new Shelf();
/** @type {Shelf<Cortex>} */
const cortices = new Shelf();

/** @param {Outline} outline @param {number} tolerance */
function solve({ boundary, center }, tolerance) {
  const [toward] = boundary;
  const shape = JSON.stringify(boundary);
  const make = () => {
    const same = solved.find((key) => key.startsWith(`[${shape},`));
    if (same) return same.withCenter({ center, toward, tolerance });
    const region = new Region({ boundary: flatten(boundary), center, toward });
    try {
      return RiemannMap.solve(region, { tolerance: TOLERANCE });
    } finally {
      region.free();
    }
  };
  return solved.get(JSON.stringify([boundary, center]), make, (known) => known.stop !== "tolerance" || known.errorEstimate <= tolerance);
}

/** @param {Spec} spec @param {number} tolerance */
function mapsOf(spec, tolerance) {
  if (spec.kind === "formula") return { error: 0, maps: HEMISPHERES.map(({ hemisphere }) => RetinoCorticalMap.model({ ...spec.options, hemisphere })) };
  const map = solve(spec, tolerance);
  const maps = HEMISPHERES.map(({ hemisphere }) => RetinoCorticalMap.outline(map, { direction: spec.direction, hemisphere }));
  return { error: map.stop === "tolerance" ? map.errorEstimate : 0, maps };
}

/** The map of a spec, both hemispheres; that of a draft may be a little off. @param {Spec} spec @param {boolean} fine */
export function cortexOf(spec, fine) {
  const tolerance = fine ? TOLERANCE : DRAFT_TOLERANCE;
  return cortices.get(JSON.stringify(spec), () => new Cortex(spec, tolerance), ({ error }) => error <= tolerance);
}

/** Counts the maps. */
let made = 0;

export class Cortex {
  halves;
  /** Of the map, in units of the disk; 0 where it is as good as it can be. */ error;
  /** @type {Drawn} */ drawn;

  /** @param {Spec} spec @param {number} tolerance */
  constructor(spec, tolerance) {
    const { error, maps } = mapsOf(spec, tolerance);
    this.error = error;
    this.halves = HEMISPHERES.map(({ side }, k) => ({ side, map: maps[k] }));
    const { map } = this.halves[1];
    const outline = map.boundary;
    const points = unflatten(outline);
    this.drawn = {
      id: ++made,
      area: map.area,
      landmarkError: map.landmarkError,
      half: { width: Math.max(...points.map(([x]) => Math.abs(x))), height: Math.max(...points.map(([, y]) => Math.abs(y))) },
      outline,
      lines: this.#carried(GRID),
      circles: [],
      magnification: map.magnification(new Float64Array(eccentricities.flatMap((e) => [e, 0]))),
    };
  }

  free() {
    for (const { map } of this.halves) map.free();
  }

  /** What is shown of it, with circles where they are wanted. @param {boolean} circles */
  drawnWith(circles) {
    if (circles && !this.drawn.circles.length) this.drawn = { ...this.drawn, circles: this.#carried(SMALL_CIRCLES) };
    return this.drawn;
  }

  /** The half in which a point of the cortex lies. @param {Point} point */
  indexAt(point) {
    return point[0] < 0 ? 0 : 1;
  }

  /** @param {FieldLine[]} lines @returns {Line[]} */
  #carried(lines) {
    return this.halves.flatMap(({ side, map }) => lines.map(({ name, field }) => ({ name, at: finite(map.toCortex(onSide(field, side))) })));
  }
}

/** The points that are some. @param {Float64Array} flat */
export function finite(flat) {
  const kept = new Float64Array(flat.length);
  let length = 0;
  for (let k = 0; k < flat.length; k += 2) {
    if (!Number.isFinite(flat[k])) continue;
    kept[length++] = flat[k];
    kept[length++] = flat[k + 1];
  }
  return kept.slice(0, length);
}
