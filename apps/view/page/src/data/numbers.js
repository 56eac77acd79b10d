/** Reads the coded numbers of a frame. The coding is described in docs/reference/replay-file.md. */

/** What a number tells. Each kind has shares of its own; of a range of kinds the first is named. */
export const Kind = { position: 0, turn: 3, speed: 7, island: 8, damage: 9, parting: 10, newPairs: 11, first: 12, second: 13, status: 14, pair: 15 };
const KINDS = 23;
/** There was no number of the kind before. Else it counts how many digits that had, at most 5. */
export const NO_PAST = 6;
const PASTS = 7, MOST_DIGITS = 5;

/** A set of shares: of 0, of the sign, by the digits so far, and of the second digit by their number. */
const LENGTHS = 20, ZERO = 0, NEGATIVE = 1, LONGER = 2, SECOND = LONGER + LENGTHS, SHARES = SECOND + LENGTHS;
const SHARE_BITS = 12, ONE = 1 << SHARE_BITS, LEARNING = 5, LEAST_RANGE = 2 ** 24, MOST_LENGTH = 63;

/** The shares of a key frame: all digits are as likely 0 as 1. */
export const evenShares = () => new Uint16Array(KINDS * PASTS * SHARES).fill(ONE / 2);

/** How many digits a number has, at most 5. */
const digitsOf = (x) => Math.min(32 - Math.clz32(Math.min(Math.abs(x), 255)), MOST_DIGITS);

export class NumberReader {
  #at = 0;
  #range = 0xffffffff;
  #code = 0;

  /** `shares` change with each number that is read. @param {Uint8Array} bytes @param {Uint16Array} shares */
  constructor(bytes, shares) {
    this.bytes = bytes;
    this.shares = shares;
    for (let k = 0; k < 4; ++k) this.#code = (this.#code << 8 | this.#byte()) >>> 0;
  }

  #byte() {
    if (this.#at >= this.bytes.length) throw new RangeError('The content of a piece is too short.');
    return this.bytes[this.#at++];
  }

  #narrow() {
    while (this.#range < LEAST_RANGE) {
      this.#range = (this.#range << 8) >>> 0;
      this.#code = (this.#code << 8 | this.#byte()) >>> 0;
    }
  }

  #digit(place) {
    const { shares } = this, share = shares[place], bound = (this.#range >>> SHARE_BITS) * share;
    const one = this.#code >= bound;
    if (one) {
      this.#code -= bound;
      this.#range -= bound;
      shares[place] = share - (share >> LEARNING);
    } else {
      this.#range = bound;
      shares[place] = share + ((ONE - share) >> LEARNING);
    }
    this.#narrow();
    return one;
  }

  #evenDigit() {
    this.#range >>>= 1;
    const one = this.#code >= this.#range;
    if (one) this.#code -= this.#range;
    this.#narrow();
    return one ? 1 : 0;
  }

  /** The next number, of a kind and after one of `past` digits. */
  number(kind, past) {
    const at = (kind * PASTS + past) * SHARES;
    if (!this.#digit(at + ZERO)) return 0;
    const isNegative = this.#digit(at + NEGATIVE);
    let digits = 1;
    while (this.#digit(at + LONGER + Math.min(digits, LENGTHS) - 1)) {
      if (++digits > MOST_LENGTH) throw new RangeError('A number of a frame is too large.');
    }
    let size = 1;
    if (digits > 1) size = 2 + (this.#digit(at + SECOND + Math.min(digits, LENGTHS) - 1) ? 1 : 0);
    for (let k = digits - 2; k > 0; --k) size = 2 * size + this.#evenDigit();
    return isNegative ? -size : size;
  }

  /** The next number of the kind `kind` for place `i` in `past`, which keeps the digits of the newest. */
  next(kind, past, i) {
    const x = this.number(kind, past[i]);
    past[i] = digitsOf(x);
    return x;
  }
}
