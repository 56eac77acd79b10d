import { inflate, inflateJson } from './inflate.js';
import { decodeShapes } from './shapes.js';
import { decodeFrameHead } from './frame.js';
import { ReplayError } from './pieces.js';

/** So many pieces are unpacked at once. */
const BATCH = 48;

/**
 * All pieces of a run that have come so far. Frames stay packed; times, key flags and channels are read at once.
 * Frames are numbered from the first that ever came; those before `first` were dropped to save memory.
 *
 * Events: `head`, `shapes`, `waves`, `grown` (frames were added), `cut` (frames from `detail` on were replaced),
 * `ended`, `state` (of a live run).
 */
export class Recording extends EventTarget {
  /** @param {number} maxBytes of packed frames; older ones are dropped */
  constructor(maxBytes = Infinity) {
    super();
    this.maxBytes = maxBytes;
    this.head = null;
    /** @type {Map<number, import('./shapes.js').Shape>} */
    this.shapes = new Map();
    this.waves = null;
    this.endReason = null;
    this.liveState = null;
    this.first = 0;
    this.packedBytes = 0;
    this.skippedKinds = new Set();
    /** @type {{packed: Uint8Array, time: number, isKey: boolean, channels: Float32Array}[]} */
    this.entries = [];
  }

  /** One past the number of the last frame. */
  get end() { return this.first + this.entries.length; }
  get isEmpty() { return this.entries.length === 0; }
  get startTime() { return this.isEmpty ? 0 : this.entries[0].time; }
  get endTime() { return this.isEmpty ? 0 : this.entries[this.entries.length - 1].time; }

  entry(i) { return this.entries[i - this.first]; }

  /** The number of the last frame at or before `time`; the first frame if there is none. */
  frameAt(time) {
    let low = 0, high = this.entries.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.entries[middle].time <= time + 1e-9) low = middle;
      else high = middle - 1;
    }
    return this.first + low;
  }

  /** Takes pieces in their order. @param {import('./pieces.js').Piece[]} pieces */
  async add(pieces) {
    for (let from = 0; from < pieces.length; from += BATCH) await this.#addBatch(pieces.slice(from, from + BATCH));
  }

  async #addBatch(pieces) {
    const known = pieces.filter((piece) => 'HSFWEL'.includes(piece.kind));
    for (const piece of pieces) if (!known.includes(piece)) this.skippedKinds.add(piece.kind);
    const outcomes = await Promise.allSettled(known.map((piece) => 'SF'.includes(piece.kind) ? inflate(piece.packed)
                                                                                               : inflateJson(piece.packed)));
    const events = new Set();
    try {
      // What comes before a damaged piece is taken.
      known.forEach((piece, i) => {
        if (outcomes[i].status === 'rejected') throw new ReplayError(`The replay is damaged: ${outcomes[i].reason.message}`);
        events.add(this.#take(piece, outcomes[i].value));
      });
    } finally {
      this.#dropOld();
      for (const name of events) this.dispatchEvent(new Event(name));
    }
  }

  /** Returns the name of the event. */
  #take(piece, content) {
    switch (piece.kind) {
      case 'H':
        this.head = content;
        // A resumed run goes on after an end.
        this.endReason = null;
        return 'head';
      case 'S':
        for (const shape of decodeShapes(content)) this.shapes.set(shape.number, shape);
        return 'shapes';
      case 'W':
        this.waves = content;
        return 'waves';
      case 'E':
        this.endReason = content.reason || 'The run has ended.';
        return 'ended';
      case 'L':
        this.liveState = content;
        return 'state';
      default:
        this.#takeFrame(piece.packed, content);
        return 'grown';
    }
  }

  #takeFrame(packed, content) {
    if (!this.head) throw new Error('A frame came before the head.');
    const entry = { packed, ...decodeFrameHead(content, this.head.channels.length) };
    if (this.entries.length > 0 && entry.time <= this.endTime) this.#cutFrom(entry.time);
    if (this.entries.length === 0 && !entry.isKey) return;
    this.entries.push(entry);
    this.packedBytes += packed.length;
  }

  /** A resumed run repeats a part: what was there of it is replaced. */
  #cutFrom(time) {
    const kept = this.entries.findIndex((entry) => entry.time >= time);
    for (const entry of this.entries.splice(kept)) this.packedBytes -= entry.packed.length;
    this.dispatchEvent(Object.assign(new Event('cut'), { detail: this.first + kept }));
  }

  /** Drops whole spans from one key frame to the next. */
  #dropOld() {
    while (this.packedBytes > this.maxBytes) {
      const next = this.entries.findIndex((entry, i) => i > 0 && entry.isKey);
      if (next < 0) return;
      for (const entry of this.entries.splice(0, next)) this.packedBytes -= entry.packed.length;
      this.first += next;
    }
  }
}
