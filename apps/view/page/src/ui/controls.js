import { SPEEDS } from '../player.js';
import { el, setText } from './dom.js';
import { formatTime } from './format.js';

const ICON = {
  first: 'M2 2h2v12H2zM14 2v12L5 8z', back: 'M4 2h2v12H4zM13 2v12L6 8z', play: 'M3 1l11 7-11 7z', pause: 'M3 2h4v12H3zM9 2h4v12H9z',
  on: 'M10 2h2v12h-2zM3 2v12l7-6z', last: 'M12 2h2v12h-2zM2 2v12l9-6z',
};
const icon = (name) => `<svg viewBox="0 0 16 16" aria-hidden="true"><path d="${ICON[name]}"/></svg>`;
const PAUSE_RUN = 'Pause the run', SLOW_FACTORS = [0, 1, 0.5, 0.2, 0.1];

/** A factor of real time in words; 0 lets the run go as fast as it can. */
const slowText = (f) => f === 0 ? 'full speed' : f === 1 ? 'real time' : `${f}× real time`;

/** The bar below: time, play, step and speed; in the live view also what steers the run. */
export class Controls {
  /**
   * @param {import('../player.js').Player} player
   * @param {import('../data/recording.js').Recording} recording
   * @param {import('../sources/live.js').LiveSource|null} live
   * @param {(text: string) => void} warn
   */
  constructor(box, player, recording, live, warn) {
    Object.assign(this, { player, recording, live, warn });
    const button = (name, title, click, extra = {}) => {
      const made = el('button', { type: 'button', title, 'aria-label': title, click, ...extra });
      if (ICON[name]) made.innerHTML = icon(name);
      return made;
    };
    const jump = (time) => {
      player.pause();
      player.leaveLive();
      player.seek(time);
    };
    this.play = button('play', 'Play or pause (space)', () => player.toggle(), { class: 'play' });
    this.slider = el('input', { type: 'range', min: 0, max: 1, step: 'any', value: 0, 'aria-label': 'Time', input: () => {
      player.leaveLive();
      if (player.isPlaying) player.pause();
      player.seek(Number(this.slider.value));
    } });
    this.speed = el('select', { title: 'Speed (- and +)', 'aria-label': 'Speed', change: () => player.setSpeed(Number(this.speed.value)) },
                    ...SPEEDS.map((s) => el('option', { value: s }, `${s}×`)));
    this.text = el('output');
    box.append(button('first', 'To the start (Home)', () => jump(recording.startTime)),
               button('back', 'One frame back (left arrow)', () => player.step(-1)), this.play,
               button('on', 'One frame on (right arrow)', () => player.step(1)),
               button('last', 'To the end (End)', () => jump(recording.endTime)), this.slider, this.text, this.speed);
    if (live) this.#addLive(box);
    for (const name of ['shown', 'changed']) player.addEventListener(name, () => this.refresh());
    recording.addEventListener('grown', () => this.refresh());
    this.refresh();
  }

  #addLive(box) {
    this.liveButton = el('button', { type: 'button', class: 'live', title: 'Shows the newest frame', click: () => this.player.goLive() }, 'Live');
    this.pauseRun = el('button', { type: 'button', click: () => this.#command(this.isRunPaused ? 'resume' : 'pause') }, PAUSE_RUN);
    this.stepRun = el('button', { type: 'button', title: 'The run goes on by one frame', click: () => this.#command('step') }, 'Step');
    this.slow = el('select', { title: 'Slow motion of the run', 'aria-label': 'Slow motion of the run',
                               change: () => this.#command('slow', Number(this.slow.value)) },
                   ...SLOW_FACTORS.map((f) => el('option', { value: f }, slowText(f))));
    box.append(this.liveButton, el('span', { class: 'run' }, this.pauseRun, this.stepRun, this.slow));
    this.recording.addEventListener('state', () => {
      this.isRunPaused = Boolean(this.recording.liveState.paused);
      const { factor } = this.recording.liveState;
      if (SLOW_FACTORS.includes(factor)) this.slow.value = factor;
      this.refresh();
    });
    this.live.addEventListener('status', () => this.refresh());
  }

  async #command(action, factor) {
    // Who goes on wants to see it. That is now, and not when the run has answered: the user may look back meanwhile.
    if (action === 'step' || action === 'resume') this.player.goLive();
    try {
      await this.live.control(action, factor);
      if (action !== 'slow') this.isRunPaused = action !== 'resume';
    } catch (error) {
      this.warn(error.message);
    }
    this.refresh();
  }

  refresh() {
    const { player, recording } = this;
    if (recording.isEmpty) return;
    this.slider.min = recording.startTime;
    this.slider.max = recording.endTime;
    if (document.activeElement !== this.slider || player.isPlaying || player.isLive) this.slider.value = player.time;
    const every = recording.head.every || 0.1;
    setText(this.text, `${formatTime(player.time, every)} / ${formatTime(recording.endTime, every)} s`);
    const shown = player.isPlaying ? 'pause' : 'play';
    if (this.play.dataset.shown !== shown) {
      this.play.dataset.shown = shown;
      this.play.innerHTML = icon(shown);
    }
    this.speed.value = player.speed;
    if (this.live) this.#refreshLive();
  }

  #refreshLive() {
    const runs = this.live.state === 'open' || this.live.state === 'connecting';
    this.liveButton.setAttribute('aria-pressed', this.player.isLive && runs);
    setText(this.pauseRun, this.isRunPaused ? 'Resume the run' : PAUSE_RUN);
    for (const input of [this.pauseRun, this.stepRun, this.slow]) input.disabled = this.live.state !== 'open';
  }
}
