import { el, setText } from './dom.js';
import { channelTitle, formatNumber } from './format.js';

/** The time that the phases of a step took, as bars, with a mark at the mean over all frames. */
export class TimeBars {
  #rows;

  constructor(box, recording) {
    this.recording = recording;
    this.places = recording.head.channels.map((channel, c) => ({ ...channel, c })).filter((channel) => channel.group === 'time');
    this.#rows = this.places.map((channel) => {
      const bar = el('div'), mean = el('u'), value = el('span');
      box.append(el('div', { class: 'row' }, el('span', {}, channelTitle(channel.name)), el('div', { class: 'track' }, bar, mean), value));
      return { bar, mean, value };
    });
  }

  update(frame) {
    const { entries } = this.recording;
    if (this.numFrames !== entries.length) {
      this.numFrames = entries.length;
      this.means = this.places.map(({ c }) => meanOf(entries.map(({ channels }) => channels[3 * c])));
    }
    const values = this.places.map(({ c }) => frame.channels[3 * c]);
    const most = Math.max(...[...values, ...this.means].filter(Number.isFinite), 1e-9);
    this.#rows.forEach(({ bar, mean, value }, k) => {
      bar.style.width = `${100 * Math.max(values[k] || 0, 0) / most}%`;
      mean.style.left = `${100 * (this.means[k] || 0) / most}%`;
      setText(value, `${formatNumber(values[k])} ms`);
    });
  }
}

/** The mean of those that are known; the first frame, before any step, knows none. */
function meanOf(values) {
  const known = values.filter(Number.isFinite);
  return known.reduce((sum, value) => sum + value, 0) / known.length;
}
