import { Rods } from './rods.js';
import { Dots } from './dots.js';
import { COLOURS } from './shading.js';

export const LineKind = { mooring: 0, rod: 1, thruster: 2, carriage: 3, wind: 4, path: 5 };
/** The colours of the kinds, in their order. */
export const LINE_COLOURS = [COLOURS.mooring, COLOURS.rod, COLOURS.thruster, COLOURS.carriage, COLOURS.wind, COLOURS.path];
const WIDTH = [0.0016, 0.006, 0.006, 0.006, 0.006, 0.002];

/** Mooring lines, rods, paths, and the forces of thrusters, carriage and wind. */
export class LineLayer {
  rods = new Rods({ order: 2 });
  arrows = new Rods({ arrows: true, order: 12 });
  dots = new Dots({ order: 13 });

  get objects() { return [this.rods.object, this.arrows.object, this.dots.object]; }
  get layers() { return [this.rods, this.arrows, this.dots]; }

  /** Paths are drawn on still water, where it has a `level` [m]. @param {import('../data/frame.js').Line[]} lines */
  update(lines, { length, metresPerNewton }, isShown, level) {
    for (const layer of this.layers) layer.clear();
    if (isShown) for (const line of lines) this.#add(onWater(line, level, length), length, metresPerNewton);
    for (const layer of this.layers) layer.done();
  }

  #add({ kind, force, points }, length, metresPerNewton) {
    const colour = LINE_COLOURS[kind] ?? COLOURS.rod, width = (WIDTH[kind] ?? 0.002) * length, count = points.length / 3;
    if (kind >= LineKind.thruster && kind <= LineKind.wind && count >= 2) {
      this.#addForce(points, force, length, metresPerNewton, width, colour);
      return;
    }
    for (let k = 1; k < count; ++k) this.rods.add(...points.subarray(3 * k - 3, 3 * k + 3), width, colour);
    const ends = kind === LineKind.mooring ? [0, count - 1] : kind === LineKind.path && count === 1 ? [0] : [];
    for (const k of ends) this.dots.add(...points.subarray(3 * k, 3 * k + 3), kind === LineKind.path ? 12 : 6, colour);
  }

  /** An arrow from where a force acts; without a force only its direction, a tenth of the scene's length. */
  #addForce(points, force, length, metresPerNewton, width, colour) {
    const along = [0, 1, 2].map((k) => points[3 + k] - points[k]), norm = Math.hypot(...along);
    if (!(norm > 0)) return;
    const size = (force !== 0 ? force * metresPerNewton : 0.1 * length) / norm;
    this.arrows.add(points[0], points[1], points[2], points[0] + size * along[0], points[1] + size * along[1],
                    points[2] + size * along[2], width, colour);
  }
}

/** A path, which is given at the height of the vessel, just above the water; other lines as they are. */
function onWater(line, level, length) {
  if (line.kind !== LineKind.path || !Number.isFinite(level)) return line;
  return { ...line, points: line.points.map((x, k) => k % 3 === 2 ? level + 0.002 * length : x) };
}
