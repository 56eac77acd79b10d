import { inflate } from './inflate.js';
import { bytesOf, decodeFrame } from './frame.js';

const MAX_CACHE_BYTES = 96e6;
/** So many frames ahead are unpacked while one is decoded. */
const AHEAD = 6;

/** Decodes frames of a recording on demand, from the nearest key frame forward, and keeps those used last. */
export class FrameStore {
  #recording;
  /** @type {Map<number, import('./frame.js').Frame>} the least recently used first */
  #cache = new Map();
  #cacheBytes = 0;
  /** @type {Map<number, Promise<Uint8Array>>} */
  #contents = new Map();

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
    let from = i;
    while (!this.#cache.has(from) && !this.#recording.entry(from).isKey) --from;
    let frame = this.#cache.get(from) ?? null;
    for (let k = frame ? from + 1 : from; k <= i; ++k) {
      for (let ahead = k; ahead < k + AHEAD && ahead < this.#recording.end; ++ahead) this.#content(ahead);
      frame = this.#decode(k, await this.#content(k), frame);
    }
    return frame;
  }

  #content(i) {
    let content = this.#contents.get(i);
    if (!content) {
      content = inflate(this.#recording.entry(i).packed);
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
    for (const k of [...this.#cache.keys()]) if (k >= i) this.#forget(k);
    for (const k of [...this.#contents.keys()]) if (k >= i) this.#contents.delete(k);
  }
}
