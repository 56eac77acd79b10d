import { deflateSync } from 'node:zlib';
import { ContactWriter } from './contact_writer.mjs';
import { NO_PAST, NumberWriter } from './number_writer.mjs';

const TURN_UNIT = 1 / 32768;

/** Appends numbers to a growing buffer, as docs/reference/replay-file.md says. */
class Bytes {
  #buffer = Buffer.alloc(1 << 16);
  #size = 0;

  #room(count) {
    if (this.#size + count <= this.#buffer.length) return;
    const grown = Buffer.alloc(2 * (this.#size + count));
    this.#buffer.copy(grown);
    this.#buffer = grown;
  }

  byte(x) {
    this.#room(1);
    this.#size = this.#buffer.writeUInt8(x & 255, this.#size);
  }

  float32(x) {
    this.#room(4);
    this.#size = this.#buffer.writeFloatLE(x, this.#size);
  }

  /** The upper half of a float32, rounded up. */
  halfFloat32(x) {
    const bits = Buffer.alloc(4);
    bits.writeFloatLE(Math.max(0, x));
    const value = Number.isFinite(x) && bits.readUInt16LE(0) > 0 ? bits.readUInt16LE(2) + 1 : bits.readUInt16LE(2);
    this.byte(value & 255);
    this.byte(value >> 8);
  }

  float64(x) {
    this.#room(8);
    this.#size = this.#buffer.writeDoubleLE(x, this.#size);
  }

  varint(x) {
    this.#room(8);
    for (; x >= 128; x = Math.floor(x / 128)) this.#buffer[this.#size++] = (x % 128) | 128;
    this.#buffer[this.#size++] = x;
  }

  signed(x) { this.varint(x >= 0 ? 2 * x : -2 * x - 1); }

  text(text) { this.block(Buffer.from(text)); }

  /** Bytes after their number. */
  block(bytes) {
    this.varint(bytes.length);
    this.#room(bytes.length);
    bytes.copy(this.#buffer, this.#size);
    this.#size += bytes.length;
  }

  done() { return this.#buffer.subarray(0, this.#size); }
}

/** A piece of a replay. @param {string} kind @param {Uint8Array|object} content bytes, or an object written as JSON */
export function piece(kind, content) {
  const packed = deflateSync(content instanceof Uint8Array ? content : Buffer.from(JSON.stringify(content)));
  const head = Buffer.alloc(5);
  head.write(kind, 'latin1');
  head.writeUInt32LE(packed.length, 1);
  return Buffer.concat([head, packed, Buffer.from([10])]);
}

/**
 * Writes a replay piece by piece. It knows nothing of the page, so that both can be tested against each other.
 *
 * A body of a frame is {id, kind, shape (null for a plane), fixed, thickness, mass, unit (else that of the frame), name, p,
 * q (w x y z), speed, island, damage}; a contact {status, exact, stored, first, second, p, n, force} with places in the list of bodies.
 */
export class ReplayWriter {
  parts = [Buffer.from('NILASRP4')];
  #bodies = [];
  #sinceKey = Infinity;
  #contacts = new ContactWriter();
  #numbers = new NumberWriter();

  constructor({ keyEvery = 64 } = {}) { this.keyEvery = keyEvery; }

  /** The next frame is a key frame. */
  breakOff() { this.#sinceKey = Infinity; }

  head(head) {
    this.numChannels = head.channels.length;
    this.hasDamage = head.damage;
    this.add('H', head);
  }

  add(kind, content) {
    const made = piece(kind, content);
    this.parts.push(made);
    return made;
  }

  /** @param {{number: number, type: number, parent: number, points: number[][], polygons: number[][]}[]} shapes */
  shapes(shapes) {
    const out = new Bytes();
    for (const { number, type, parent, points, polygons } of shapes) {
      out.varint(number);
      out.byte(type);
      out.varint(parent);
      out.varint(points.length);
      for (const x of points.flat()) out.float32(x);
      out.varint(polygons.length);
      for (const polygon of polygons) out.varint(polygon.length);
      for (const corner of polygons.flat()) out.varint(corner);
    }
    this.add('S', out.done());
  }

  frame({ time, step, stepLength, unit, bodies, islands = [], contacts = [], channels = [], lines = [] }) {
    const out = new Bytes(), isKey = this.#sinceKey >= this.keyEvery;
    if (isKey) {
      this.#bodies = [];
      this.#sinceKey = 0;
      this.#numbers.forget();
    }
    ++this.#sinceKey;
    for (const [value, least, most] of channels) {
      out.float32(value);
      out.halfFloat32(Math.fround(value) - least);
      out.halfFloat32(most - Math.fround(value));
    }
    out.byte(isKey ? 1 : 0);
    out.float64(time);
    out.varint(step);
    out.float64(stepLength);
    this.#writeList(out, bodies, unit);
    this.#writeMotion(bodies);
    this.#writeMarks(bodies);
    this.#contacts.writePairs(this.#numbers, contacts.filter(({ exact }) => !exact), bodies, this.#bodies, isKey);
    out.block(this.#numbers.finish());
    out.varint(islands.length);
    for (const island of islands) {
      out.varint(island.contacts);
      out.varint(island.iterations);
      out.float32(island.residual);
    }
    this.#contacts.writeExact(out, contacts.filter(({ exact }) => exact), this.#bodies);
    writeLines(out, lines);
    return this.add('F', out.done());
  }

  /** Bodies must keep their order, with those that came at the end. */
  #writeList(out, bodies, unit) {
    const ids = new Set(bodies.map(({ id }) => id)), gone = [];
    this.#bodies.forEach(({ id }, k) => { if (!ids.has(id)) gone.push(k); });
    out.varint(gone.length);
    gone.forEach((k, i) => out.varint(k - (i > 0 ? gone[i - 1] : -1)));
    this.#bodies = this.#bodies.filter(({ id }) => ids.has(id));
    const came = bodies.slice(this.#bodies.length);
    out.varint(came.length);
    let last = 0;
    for (const body of came) {
      out.signed(body.id - last);
      last = body.id;
      out.byte(body.kind);
      out.varint(body.shape === null ? 0 : body.shape + 1);
      out.byte(body.fixed ? 1 : 0);
      out.float32(body.thickness ?? 0);
      out.float32(body.mass);
      out.float32(body.unit ?? unit);
      out.text(body.name ?? '');
      this.#bodies.push({ id: body.id, unit: Math.fround(body.unit ?? unit), past: 0, now: new Array(7).fill(0), before: new Array(7).fill(0), speed: 0, island: 0, damage: 0, digits: {} });
    }
  }

  #add(stored, kind, k, x) { stored.digits[kind + k] = this.#numbers.add(kind, k, stored.digits[kind + k] ?? NO_PAST, x); }

  #writeMotion(bodies) {
    const arrays = Array.from({ length: 7 }, () => []);
    this.#bodies.forEach((stored, b) => {
      const { p, q } = bodies[b];
      let along = 0;
      for (let k = 0; k < 4; ++k) along += q[k] * (stored.past > 0 ? stored.now[3 + k] : k === 0 ? 1 : 0);
      const sign = along < 0 ? -1 : 1;
      const values = [...p.map((x) => Math.round(x / stored.unit)), ...q.map((x) => Math.round(sign * x / TURN_UNIT))];
      values.forEach((value, k) => {
        const predicted = stored.past === 0 ? 0 : stored.past === 1 ? stored.now[k] : 2 * stored.now[k] - stored.before[k];
        arrays[k].push(value - predicted);
        stored.before[k] = stored.now[k];
        stored.now[k] = value;
      });
      stored.past = Math.min(stored.past + 1, 2);
    });
    arrays.forEach((list, k) => list.forEach((x, b) => this.#add(this.#bodies[b], k < 3 ? 'position' : 'turn', k < 3 ? k : k - 3, x)));
  }

  #writeMarks(bodies) {
    const write = (key, value) => this.#bodies.forEach((stored, b) => {
      this.#add(stored, key, 0, value(bodies[b]) - stored[key]);
      stored[key] = value(bodies[b]);
    });
    write('speed', ({ speed }) => speed < 1e-6 ? 0 : 1 + Math.round(28 * (Math.log10(speed) + 6)));
    write('island', ({ island }) => island ?? 0);
    if (this.hasDamage) write('damage', ({ damage }) => Math.round(255 * (damage ?? 0)));
  }

  bytes() { return Buffer.concat(this.parts); }
}

function writeLines(out, lines) {
  out.varint(lines.length);
  for (const { kind, name, force, points } of lines) {
    out.byte(kind);
    out.text(name);
    out.float32(force);
    out.varint(points.length);
    for (const x of points.flat()) out.float32(x);
  }
}
