import { FrameGoneError } from './data/frame_store.js';

/**
 * The time that is shown, and how it moves. Frames are fetched one at a time; while one is on its way, newer wishes
 * replace older ones.
 *
 * Events: `shown` (a frame was drawn), `changed` (playing or speed), `fault` (`detail` is a sentence).
 */
export const SPEEDS = [0.1, 0.2, 0.5, 1, 2, 5, 10];

export class Player extends EventTarget {
  isPlaying = false;
  /** Whether the newest frame is shown as it comes. */
  isLive = false;
  speed = 1;
  time = 0;
  /** The number of the frame that is drawn, -1 for none. */
  number = -1;
  #recording;
  #store;
  #world;
  #wanted = null;
  #busy = null;
  #lastTick = 0;
  #isBetween = false;

  constructor(recording, store, world) {
    super();
    this.#recording = recording;
    this.#store = store;
    this.#world = world;
    recording.addEventListener('grown', () => {
      if (this.isLive) this.seek(recording.endTime);
    });
  }

  /** Shows a time [s]: the frame at or before it, or with `between` bodies on their way to the next frame. Resolves when drawn. */
  seek(time, { between = false } = {}) {
    const { startTime, endTime } = this.#recording;
    this.#isBetween = between;
    this.time = Math.min(Math.max(Number(time) || 0, startTime), endTime);
    return this.#want();
  }

  /** Shows a frame by its number. */
  seekFrame(number) {
    const { first, end } = this.#recording;
    return this.seek(this.#recording.entry(Math.min(Math.max(number, first), end - 1)).time);
  }

  /** Goes some frames forward or back, and stops. */
  step(count) {
    this.pause();
    this.isLive = false;
    return this.seekFrame(this.#recording.frameAt(this.time) + count);
  }

  play() {
    if (this.isPlaying) return;
    if (this.time >= this.#recording.endTime - 1e-9) this.time = this.#recording.startTime;
    this.isPlaying = true;
    this.isLive = false;
    this.#lastTick = performance.now();
    requestAnimationFrame(() => this.#tick());
    this.#changed();
  }

  pause() {
    if (!this.isPlaying) return;
    this.isPlaying = false;
    this.#changed();
    // Between two frames bodies were moved on; at rest the frame itself is shown.
    this.seek(this.#recording.entry(this.#recording.frameAt(this.time)).time);
  }

  toggle() { this.isPlaying ? this.pause() : this.play(); }

  goLive() {
    this.pause();
    this.isLive = true;
    this.#changed();
    return this.seek(this.#recording.endTime);
  }

  /** The user chose a time, so the newest frame is no longer followed. */
  leaveLive() {
    if (!this.isLive) return;
    this.isLive = false;
    this.#changed();
  }

  setSpeed(speed) {
    this.speed = speed;
    this.#changed();
  }

  /** The next speed up or down. */
  changeSpeed(by) {
    const at = SPEEDS.findIndex((s) => s >= this.speed - 1e-9);
    this.setSpeed(SPEEDS[Math.min(Math.max(at + by, 0), SPEEDS.length - 1)]);
  }

  async #tick() {
    if (!this.isPlaying) return;
    const now = performance.now();
    // After a long pause of the page, such as one in the background, time does not jump.
    this.time += Math.min(now - this.#lastTick, 250) / 1000 * this.speed;
    this.#lastTick = now;
    if (this.time >= this.#recording.endTime) {
      this.time = this.#recording.endTime;
      this.pause();
      return;
    }
    await this.#want();
    requestAnimationFrame(() => this.#tick());
  }

  #want() {
    this.#wanted = this.time;
    this.#busy ??= this.#work().finally(() => { this.#busy = null; });
    return this.#busy;
  }

  async #work() {
    while (this.#wanted !== null) {
      const time = this.#wanted;
      this.#wanted = null;
      if (this.#recording.isEmpty) continue;
      try {
        await this.#show(time);
      } catch (error) {
        this.#fail(time, error);
      }
    }
  }

  /** A frame that was dropped or taken back while it was decoded is no fault: the nearest one is shown. */
  #fail(time, error) {
    const { startTime, endTime } = this.#recording;
    if (error instanceof FrameGoneError) this.#wanted ??= Math.min(Math.max(time, startTime), endTime);
    else this.dispatchEvent(Object.assign(new Event('fault'), { detail: `The frame at ${time.toFixed(2)} s cannot be shown: ${error.message}` }));
  }

  async #show(time) {
    const number = this.#recording.frameAt(time);
    const frame = await this.#store.get(number);
    const later = (this.isPlaying || this.#isBetween) && number + 1 < this.#recording.end ? await this.#store.get(number + 1) : null;
    const share = later ? Math.min(Math.max((time - frame.time) / (later.time - frame.time), 0), 1) : 0;
    this.number = number;
    this.#world.show(frame, later, share);
    this.dispatchEvent(new Event('shown'));
  }

  #changed() { this.dispatchEvent(new Event('changed')); }
}
