import { BodyKind, speedOf } from '../data/frame.js';
import { COLOURS, bytesOfColour } from './shading.js';

/** Viridis at equal steps, from low to high. */
const RAMP = [[68, 1, 84], [71, 44, 122], [59, 81, 139], [44, 113, 142], [33, 144, 141], [39, 173, 129], [92, 200, 99],
              [170, 220, 50], [253, 231, 37]];
const NONE = [206, 214, 220];

/** The colour of a share from 0 to 1, into `to`. */
export function rampColour(share, to) {
  const at = Math.min(Math.max(share, 0), 1) * (RAMP.length - 1), k = Math.min(Math.floor(at), RAMP.length - 2), f = at - k;
  for (let i = 0; i < 3; ++i) to[i] = Math.round(RAMP[k][i] * (1 - f) + RAMP[k + 1][i] * f);
  return to;
}

/** CSS of the ramp. */
export const RAMP_CSS = `linear-gradient(90deg, ${RAMP.map((c) => `rgb(${c.join(' ')})`).join(', ')})`;

/** The sum of the sizes of contact forces on each body [N]. */
export function forceOnBodies(frame) {
  const { contacts } = frame, sums = new Float64Array(frame.bodies.id.length);
  for (let i = 0; i < contacts.count; ++i) {
    const size = Math.hypot(contacts.force[3 * i], contacts.force[3 * i + 1], contacts.force[3 * i + 2]);
    sums[contacts.first[i]] += size;
    if (contacts.second[i] !== contacts.first[i]) sums[contacts.second[i]] += size;
  }
  return sums;
}

/** What floes can be coloured by. `decades`: a scale of powers of ten below the largest value. */
const MEASURES = {
  speed: { title: 'Speed', unit: 'm/s', values: (frame) => (b) => speedOf(frame, b) },
  thickness: { title: 'Thickness', unit: 'm', values: (frame) => (b) => frame.bodies.thickness[b], fitsLeast: true },
  force: { title: 'Sum of contact forces', unit: 'N', decades: 3, values: (frame) => {
    const sums = forceOnBodies(frame);
    return (b) => sums[b];
  } },
  residual: { title: "Residual of the floe's island", unit: 'm/s', decades: 6, values: (frame) => (b) => {
    const island = frame.islands[frame.island[b] - 1];
    return island ? island.residual : 0;
  } },
  damage: { title: 'Largest damage', unit: '', fixed: [0, 1], values: (frame) => (b) => frame.damage ? frame.damage[b] / 255 : 0 },
};

/** The least number 1, 2 or 5 times a power of ten that is not below `value`. */
export function roundUp(value) {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].find((k) => k * power >= value * (1 - 1e-9)) * power;
}

/**
 * Gives floes their colours. The scale of a measure only grows while it is shown, so that colours keep their meaning.
 */
export class Colours {
  #mode = 'plain';
  #most = 0;
  #least = Infinity;

  /** What the legend shows: null without a scale. */
  legend = null;

  set mode(mode) {
    this.#mode = mode;
    this.#most = 0;
    this.#least = Infinity;
  }

  /** A function that gives the colour of a body of the frame, as [red, green, blue]. */
  of(frame) {
    const measure = MEASURES[this.#mode];
    if (measure) return this.#byMeasure(frame, measure);
    this.legend = this.#mode === 'island' ? { title: 'Island: floes in contact share a colour', unit: '', isList: true } : null;
    const plain = bytesOfColour(COLOURS.ice);
    if (this.#mode === 'island') return (b) => frame.island[b] > 0 ? islandColour(frame.island[b]) : NONE;
    return () => plain;
  }

  #byMeasure(frame, measure) {
    const value = measure.values(frame), { kind } = frame.bodies;
    for (let b = 0; b < kind.length; ++b) {
      if (kind[b] !== BodyKind.floe) continue;
      const x = value(b);
      if (x > this.#most) this.#most = x;
      if (x > 0 && x < this.#least) this.#least = x;
    }
    const [low, high] = measure.fixed ?? this.#range(measure);
    this.legend = { title: measure.title, unit: measure.unit, low, high, isLog: Boolean(measure.decades) };
    const colour = [0, 0, 0];
    if (!measure.decades) return (b) => rampColour((value(b) - low) / (high - low || 1), colour);
    const span = Math.log10(high / low);
    return (b) => {
      const x = value(b);
      return x > 0 ? rampColour(Math.log10(x / low) / span, colour) : NONE;
    };
  }

  #range(measure) {
    const high = measure.fitsLeast ? this.#most : roundUp(this.#most);
    if (measure.decades) return [high / 10 ** measure.decades, high];
    if (!measure.fitsLeast || this.#least === Infinity) return [0, high];
    return this.#least < high ? [this.#least, high] : [0, high];
  }
}

/** Neighbouring numbers get colours that differ much. */
function islandColour(island) {
  const hue = (island * 0.61803398875) % 1, light = 0.52 + 0.14 * ((island * 0.37) % 1);
  const channel = (shift) => {
    const k = (shift + hue * 12) % 12;
    return Math.round(255 * (light - 0.55 * Math.min(light, 1 - light) * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [channel(0), channel(8), channel(4)];
}
