/** Splits a stream of bytes into the pieces of a replay. */

export const SIGNATURE = 'NILASRP4';
const HEAD_BYTES = 5;

/** The replay is of another version, or no replay at all. `message` is a sentence for the user. */
export class ReplayError extends Error {}

/** @typedef {{kind: string, packed: Uint8Array}} Piece */

export class PieceReader {
  #rest = new Uint8Array(0);
  #started = false;
  #fault = null;

  /** The number of bytes of an incomplete piece at the end. */
  get pending() { return this.#rest.length; }

  /**
   * Takes the next bytes and returns the pieces that are whole now. Pieces are views of `bytes` where possible.
   * Where the bytes are damaged, the pieces before are returned, and `check` and the next call throw.
   * @param {Uint8Array} bytes
   * @returns {Piece[]}
   */
  push(bytes) {
    this.check();
    let data = bytes;
    if (this.#rest.length > 0) {
      data = new Uint8Array(this.#rest.length + bytes.length);
      data.set(this.#rest);
      data.set(bytes, this.#rest.length);
    }
    let at = 0;
    if (!this.#started) {
      checkSignature(data);
      if (data.length < SIGNATURE.length) {
        this.#rest = data;
        return [];
      }
      this.#started = true;
      at = SIGNATURE.length;
    }
    const pieces = [];
    for (let piece; (piece = this.#pieceAt(data, at)) !== null; at += HEAD_BYTES + piece.packed.length + 1) pieces.push(piece);
    this.#rest = data.slice(at);
    if (pieces.length === 0) this.check();
    return pieces;
  }

  /** Throws if the bytes were damaged. */
  check() { if (this.#fault) throw this.#fault; }

  /** The piece that starts at `at`, null where it is not whole. */
  #pieceAt(data, at) {
    if (at + HEAD_BYTES > data.length) return null;
    const size = data[at + 1] + data[at + 2] * 256 + data[at + 3] * 65536 + data[at + 4] * 16777216;
    const end = at + HEAD_BYTES + size;
    if (end >= data.length) return null;
    if (data[end] !== 10) {
      this.#fault = new ReplayError('The replay is damaged: a piece does not end where it should.');
      return null;
    }
    return { kind: String.fromCharCode(data[at]), packed: data.subarray(at + HEAD_BYTES, end) };
  }
}

function checkSignature(data) {
  const length = Math.min(data.length, SIGNATURE.length);
  const found = String.fromCharCode(...data.subarray(0, length));
  if (found === SIGNATURE.slice(0, length)) return;
  if (found.startsWith('NILASRP'.slice(0, length))) {
    throw new ReplayError(`This replay has version ${found.slice(7)}, and this page reads version ${SIGNATURE.slice(7)}. ` +
      'Write the page again with the program that made the run.');
  }
  throw new ReplayError('This file is not a replay of Nilas.');
}
