/** Codes the numbers of a frame, as docs/reference/replay-file.md says. It knows nothing of the page. */

const KINDS = { position: 0, turn: 3, speed: 7, island: 8, damage: 9, parting: 10, newPairs: 11, first: 12, second: 13, status: 14, pair: 15 };
const WHOLE = 2 ** 32, LEAST_RANGE = 2 ** 24, EVEN = 2048, ONE = 4096, LONGEST = 20;
/** A set of shares has that of 0, of the sign, and by the digits so far and by their number those of `LONGEST` digits. */
const SIGN = 1, LONGER = 1, SECOND = LONGER + LONGEST, SET = SECOND + LONGEST + 1, SETS = 23 * 7;

/** No number of the kind was before. */
export const NO_PAST = 6;

export class NumberWriter {
  /** How likely a digit is 0. */
  #shares = new Uint16Array(SETS * SET).fill(EVEN);
  #bytes = [];
  #low = 0;
  #range = WHOLE - 1;

  forget() { this.#shares.fill(EVEN); }

  #raise(by) {
    this.#low += by;
    if (this.#low < WHOLE) return;
    this.#low -= WHOLE;
    // The carry runs through bytes of 255.
    let at = this.#bytes.length - 1;
    for (; this.#bytes[at] === 255; --at) this.#bytes[at] = 0;
    ++this.#bytes[at];
  }

  #narrow() {
    while (this.#range < LEAST_RANGE) {
      this.#range *= 256;
      this.#takeByte();
    }
  }

  #takeByte() {
    this.#bytes.push(Math.floor(this.#low / LEAST_RANGE));
    this.#low = this.#low % LEAST_RANGE * 256;
  }

  #digit(one, place) {
    const share = this.#shares[place], bound = Math.floor(this.#range / ONE) * share;
    if (one) this.#raise(bound);
    this.#range = one ? this.#range - bound : bound;
    this.#shares[place] = one ? share - Math.floor(share / 32) : share + Math.floor((ONE - share) / 32);
    this.#narrow();
  }

  #evenDigit(one) {
    this.#range = Math.floor(this.#range / 2);
    if (one) this.#raise(this.#range);
    this.#narrow();
  }

  /** Adds a number of a kind, such as `turn` of component `k`. Returns how many digits it has, at most 5. */
  add(kind, k, past, x) {
    const set = ((KINDS[kind] + k) * 7 + past) * SET, digits = x === 0 ? '' : Math.abs(x).toString(2), count = digits.length;
    this.#digit(count > 0, set);
    if (count === 0) return 0;
    this.#digit(x < 0, set + SIGN);
    for (let n = 1; n <= count; ++n) this.#digit(n < count, set + LONGER + Math.min(n, LONGEST));
    if (count > 1) this.#digit(digits[1] === '1', set + SECOND + Math.min(count, LONGEST));
    for (let n = 2; n < count; ++n) this.#evenDigit(digits[n] === '1');
    return Math.min(count, 5);
  }

  /** The bytes of a frame. */
  finish() {
    for (let k = 0; k < 4; ++k) this.#takeByte();
    const bytes = Buffer.from(this.#bytes);
    this.#bytes = [];
    this.#low = 0;
    this.#range = WHOLE - 1;
    return bytes;
  }
}
