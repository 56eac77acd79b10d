import { inflate } from './inflate.js';
import { bytesOf, decodeFrame } from './frame.js';

const MAX_CACHE_BYTES = 96e6;
/** So many frames ahead are unpacked while one is decoded. */
const AHEAD = 6;

/** The frame is not in the recording: it was dropped, or taken back by a run that was resumed. */
export class FrameGoneError extends Error {}

/** Decodes frames of a recording on demand, from the nearest key frame forward, and keeps those used last. */
export class FrameStore {
  #recording;
  /** @type {Map<number, import('./frame.js').Frame>} the least recently used first */
  #cache = new Map();
  #cacheBytes = 0;
  /** @type {Map<number, Promise<Uint8Array>>} */
  #contents = new Map();
  /** Counts how often frames were taken back. What was begun before is of no use then. */
  #cuts = 0;

  /** @param {import('./recording.js').Recording} recording */
  constructor(recording) {
    this.#recording = recording;
    this.decodeMs = 0;
    this.numDecoded = 0;
    recording.addEventListener('cut', (event) => this.#forgetFrom(event.detail));
  }

  get cacheBytes() { return this.#cacheBytes; }
  get cachedFrames() { return this.#cache.size; }

  /** The frame if it is at hand. */
  peek(i) { return this.#cache.get(i) ?? null; }

  /** @param {number} i @returns {Promise<import('./frame.js').Frame>} */
  async get(i) {
    const cached = this.#cache.get(i);
    if (cached) {
      this.#cache.delete(i);
      this.#cache.set(i, cached);
      return cached;
    }
    for (;;) {
      const frame = await this.#decodeUpTo(i);
      if (frame) return frame;
    }
  }

  /** Null where frames were taken back meanwhile. */
  async #decodeUpTo(i) {
    const cuts = this.#cuts;
    let from = i;
    while (!this.#cache.has(from) && !this.#entry(from).isKey) --from;
    let frame = this.#cache.get(from) ?? null;
    for (let k = frame ? from + 1 : from; k <= i; ++k) {
      for (let ahead = k; ahead < k + AHEAD && ahead < this.#recording.end; ++ahead) this.#content(ahead);
      const content = await this.#content(k);
      if (cuts !== this.#cuts) return null;
      frame = this.#decode(k, content, frame);
    }
    return frame;
  }

  #entry(i) {
    const entry = this.#recording.entry(i);
    if (!entry) throw new FrameGoneError(`Frame ${i} is not there.`);
    return entry;
  }

  #content(i) {
    let content = this.#contents.get(i);
    if (!content) {
      content = inflate(this.#entry(i).packed);
      // One that nobody waits for yet may be damaged; it is tried again when it is asked for.
      content.catch(() => { if (this.#contents.get(i) === content) this.#contents.delete(i); });
      this.#contents.set(i, content);
      if (this.#contents.size > 4 * AHEAD) this.#contents.delete(this.#contents.keys().next().value);
    }
    return content;
  }

  #decode(i, content, before) {
    const start = performance.now();
    const frame = decodeFrame(content, this.#recording.head, before);
    this.decodeMs += performance.now() - start;
    ++this.numDecoded;
    this.#contents.delete(i);
    if (!this.#cache.has(i)) {
      this.#cache.set(i, frame);
      this.#cacheBytes += bytesOf(frame);
    }
    while (this.#cacheBytes > MAX_CACHE_BYTES && this.#cache.size > 2) this.#forget(this.#cache.keys().next().value);
    return frame;
  }

  #forget(i) {
    this.#cacheBytes -= bytesOf(this.#cache.get(i));
    this.#cache.delete(i);
  }

  #forgetFrom(i) {
    ++this.#cuts;
    for (const k of [...this.#cache.keys()]) if (k >= i) this.#forget(k);
    for (const k of [...this.#contents.keys()]) if (k >= i) this.#contents.delete(k);
  }
}
