import { rampColour } from '../scene/colours.js';

/** Decades of the scale below the largest value. */
const DECADES = 3;

/** The share of the colour scale, from 0 to 1, that a value has: logarithmic below the largest one. */
export function shareOf(value, largest) {
  return value > 0 ? Math.min(Math.max(1 + Math.log10(value / largest) / DECADES, 0), 1) : 0;
}

/** The components of a value's colour, 0 to 255. */
export const loadColour = (value, largest) => rampColour(shareOf(value, largest), []);

/** The lowest value that the scale tells apart. */
export const leastOf = (largest) => largest / 10 ** DECADES;
