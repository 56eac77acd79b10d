/** Bytes as letters of the page: 13 bits in two letters. The README of the page has the rule. */

const LETTERS = 91, BITS = 13, BITS_OF_ONE = 6, FIRST = 33, LEFT_OUT = new Set(['"', '&', '<']);

/** The number of each letter by its code. */
const NUMBER = (() => {
  const numbers = new Uint8Array(128);
  for (let code = FIRST, number = 0; number < LETTERS; ++code) if (!LEFT_OUT.has(String.fromCharCode(code))) numbers[code] = number++;
  return numbers;
})();

/** The bytes of a block. */
export function bytesOfBlock(text) {
  const pairs = text.length >> 1, bits = BITS * pairs + (text.length & 1 ? BITS_OF_ONE : 0), bytes = new Uint8Array(bits >> 3);
  let waiting = 0, count = 0, at = 0;
  const take = (value, width) => {
    waiting |= value << count;
    for (count += width; count >= 8; count -= 8) {
      bytes[at++] = waiting;
      waiting >>>= 8;
    }
  };
  for (let i = 0; i < 2 * pairs; i += 2) take(NUMBER[text.charCodeAt(i)] + LETTERS * NUMBER[text.charCodeAt(i + 1)], BITS);
  if (text.length & 1) take(NUMBER[text.charCodeAt(text.length - 1)], BITS_OF_ONE);
  return bytes;
}
