const HALF = new DataView(new ArrayBuffer(4));

/**
 * Reads numbers from the unpacked content of a piece. All numbers are little-endian.
 * The encoding is described in docs/reference/replay-file.md.
 */
export class ByteReader {
  /** @param {Uint8Array} bytes */
  constructor(bytes) {
    this.bytes = bytes;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.at = 0;
  }

  get isAtEnd() { return this.at >= this.bytes.length; }

  /** Throws unless `count` more bytes are there. */
  demand(count) {
    if (this.at + count > this.bytes.length) throw new RangeError('The content of a piece is too short.');
  }

  byte() {
    this.demand(1);
    return this.bytes[this.at++];
  }

  float32() {
    this.demand(4);
    const value = this.view.getFloat32(this.at, true);
    this.at += 4;
    return value;
  }

  /** The upper half of a float32; the lower half is 0. */
  halfFloat32() {
    HALF.setUint16(0, this.byte() | (this.byte() << 8));
    return HALF.getFloat32(0);
  }

  float64() {
    this.demand(8);
    const value = this.view.getFloat64(this.at, true);
    this.at += 8;
    return value;
  }

  /** An unsigned integer of 7 bits a byte, lowest first. Integers stay below 2^53, so a double holds them. */
  varint() {
    const { bytes } = this;
    let byte = bytes[this.at++];
    if (byte < 128) return byte;
    let value = byte & 127, scale = 128;
    do {
      if (this.at >= bytes.length) throw new RangeError('The content of a piece is too short.');
      byte = bytes[this.at++];
      value += (byte & 127) * scale;
      scale *= 128;
    } while (byte >= 128);
    return value;
  }

  /** A signed integer: 2 x for x >= 0 and -2 x - 1 for x < 0. */
  signed() {
    const coded = this.varint();
    if (coded < 2147483648) return (coded & 1) ? -((coded + 1) / 2) : coded >>> 1;
    return coded % 2 === 1 ? -(coded + 1) / 2 : coded / 2;
  }

  varintArray(count, Type = Uint32Array) {
    this.demand(count);
    const values = new Type(count);
    for (let i = 0; i < count; ++i) values[i] = this.varint();
    return values;
  }

  /** `count` float32. They need not lie at a multiple of 4 bytes. */
  float32Array(count) {
    this.demand(4 * count);
    const values = new Float32Array(count);
    for (let i = 0; i < count; ++i) values[i] = this.view.getFloat32(this.at + 4 * i, true);
    this.at += 4 * count;
    return values;
  }

  /** A view of `count` bytes, not a copy. */
  span(count) {
    this.demand(count);
    const part = this.bytes.subarray(this.at, this.at + count);
    this.at += count;
    return part;
  }

  /** The length as a varint, then UTF-8. */
  text() { return new TextDecoder().decode(this.span(this.varint())); }
}
