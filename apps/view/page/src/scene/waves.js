/** The waves of a replay, and which of them can be drawn. */

/**
 * Waves that begin together and meet the same ice.
 * @typedef {object} Train
 * @property {number} start [s]
 * @property {number} ramp the time in which they rise [s]
 * @property {number[]} edge a point of the ice edge [m]
 * @property {number[]} inward a unit vector across the edge, into the ice
 * @property {number[][]} components of each wave: amplitude [m], frequency [rad/s], wave number x, y [1/m], phase [rad],
 *   decay of the amplitude under ice [1/m]
 */

/** @typedef {{amplitude: number, frequency: number, number: number[], phase: number, decay: number, train: Train}} Wave */

/** All waves, the highest first. @returns {Wave[]} */
function wavesOf(seas) {
  const waves = (seas?.trains ?? []).flatMap((train) => train.components.map(([amplitude, frequency, kx, ky, phase, decay]) =>
    ({ amplitude, frequency, number: [kx, ky], phase, decay, train })));
  return waves.sort((a, b) => b.amplitude - a.amplitude);
}

const lengthOf = ({ number }) => 2 * Math.PI / Math.max(Math.hypot(...number), 1e-12);

/** The length of a wave in the middle of the energy [m], infinite without waves. */
export function middleWaveLength(seas) {
  const waves = wavesOf(seas).sort((a, b) => lengthOf(a) - lengthOf(b)), energy = ({ amplitude }) => amplitude ** 2;
  const whole = waves.reduce((sum, wave) => sum + energy(wave), 0);
  let sum = 0;
  const middle = waves.find((wave) => (sum += energy(wave)) >= whole / 2);
  return middle ? lengthOf(middle) : Infinity;
}

/** The highest waves that are at least so long [m]. */
export function drawnWaves(seas, shortest, most) { return wavesOf(seas).filter((wave) => lengthOf(wave) >= shortest).slice(0, most); }

/** The share of its amplitude that a train has at a time. */
export function rampAt({ start, ramp }, time) {
  const share = ramp > 0 ? Math.min(Math.max((time - start) / ramp, 0), 1) : 1;
  return 0.5 * (1 - Math.cos(Math.PI * share));
}
