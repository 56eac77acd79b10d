/** How long the arrows of forces are. One scale holds for all arrows of a picture. */

const LENGTH_SHARE = 0.45, RANK = 0.9;

/**
 * A force that is large in this run [N]: nine in ten frames with a load stay below. It is read from the channels, so
 * it is the same whatever was looked at before. Null without loads.
 */
export function typicalForce(recording) {
  const places = recording.head.channels.map((channel, c) => ({ channel, c }))
    .filter(({ channel }) => channel.group === 'load' && channel.unit === 'N' && /contact_f[xyz]$|ice_resistance$/.test(channel.name))
    .map(({ c }) => c);
  const peaks = [];
  for (const { channels } of recording.entries) {
    let peak = 0;
    // A frame before the first step has no numbers.
    for (const c of places) peak = Math.max(peak, Math.abs(channels[3 * c + 1]) || 0, Math.abs(channels[3 * c + 2]) || 0);
    if (peak > 0) peaks.push(peak);
  }
  if (peaks.length === 0) return null;
  return Float64Array.from(peaks).sort()[Math.floor(RANK * (peaks.length - 1))];
}

/** The largest force in a frame [N]. */
export function largestForce(frame) {
  const { force, count } = frame.contacts;
  let largest = 0;
  for (let i = 0; i < 3 * count; i += 3) largest = Math.max(largest, force[i] ** 2 + force[i + 1] ** 2 + force[i + 2] ** 2);
  largest = Math.sqrt(largest);
  for (const line of frame.lines) if (line.kind >= 2 && line.kind <= 4) largest = Math.max(largest, Math.abs(line.force));
  return largest;
}

export class ForceScale {
  #typical = null;
  #numFrames = 0;

  constructor(recording) { this.recording = recording; }

  /** Metres of arrow per newton. `length`: that of the scene [m]; `factor`: what the user chose. */
  metresPerNewton(frame, length, factor) {
    // Half as many frames again may have other loads.
    if (this.recording.entries.length > 1.5 * this.#numFrames) {
      this.#numFrames = this.recording.entries.length;
      this.#typical = typicalForce(this.recording);
    }
    const force = this.#typical ?? largestForce(frame);
    return force > 0 ? factor * LENGTH_SHARE * length / force : 0;
  }
}
