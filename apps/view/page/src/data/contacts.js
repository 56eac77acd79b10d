import { Kind, NO_PAST } from './numbers.js';
import { turned } from './turn.js';

export const ContactStatus = { open: 0, stick: 1, slip: 2, crush: 3 };
const STATUS_MASK = 63, STORED_FLAG = 64;
const NORMAL_UNIT = 1 / 127, POINT_UNITS = 4, PAIR_POINT_UNITS = 256;
/** Normals and forces are turned in these steps of a circle, and the size of forces has these steps of a decade. */
const CIRCLE = 128, FORCE_CIRCLE = 64, FORCE_STEPS = 20;
/** The numbers of a pair, in the order of the file. */
const OF_PAIR = { normalAround: 0, normalUp: 1, forceUp: 2, x: 3, y: 4, z: 5, force: 6, forceAround: 7 };
const NUMBERS = 8, TURNING = new Map([[OF_PAIR.normalAround, CIRCLE], [OF_PAIR.forceAround, FORCE_CIRCLE]]);

/**
 * The contacts of a frame: first those whose force is stored exactly, then the sums over pairs of bodies.
 * @typedef {object} Contacts
 * @property {number} count
 * @property {Uint8Array} status one of ContactStatus
 * @property {Uint8Array} exact whether the force is stored exactly
 * @property {Uint8Array} stored whether contacts.h5 has the contact
 * @property {Uint32Array} first the place of the first body in the list
 * @property {Uint32Array} second
 * @property {Float64Array} point x, y, z of each contact [m]
 * @property {Float32Array} normal x, y, z of each, into the first body
 * @property {Float32Array} force x, y, z of each, on the first body [N]
 * @property {Int32Array} pairNumbers the stored numbers of all pairs, kind by kind; the next frame counts from them
 * @property {Uint8Array} pairPast the digits of their newest differences
 */

/**
 * @param {import('./bytes.js').ByteReader} reader
 * @param {import('./numbers.js').NumberReader} numbers
 * @param {{place: Float64Array, turn: Int32Array, unit: Float32Array, count: number}} bodies those of this frame
 * @param {{contacts: Contacts, placeNow: (place: number) => number}|null} before the frame before, and where its bodies
 *   are in the list now, -1 for one that went
 * @returns {Contacts}
 */
export function decodeContacts(reader, numbers, bodies, before) {
  const numExact = reader.varint();
  const exact = decodeExact(reader, bodies, numExact);
  const pairs = decodePairs(numbers, before), count = numExact + pairs.first.length;
  const contacts = {
    count, status: new Uint8Array(count), exact: new Uint8Array(count).fill(1, 0, numExact), stored: new Uint8Array(count),
    first: new Uint32Array(count), second: new Uint32Array(count),
    point: new Float64Array(3 * count), normal: new Float32Array(3 * count), force: new Float32Array(3 * count),
    pairNumbers: pairs.numbers, pairPast: pairs.past,
  };
  for (const key of ['status', 'stored', 'first', 'second', 'point', 'normal', 'force']) contacts[key].set(exact[key]);
  for (const key of ['status', 'first', 'second']) contacts[key].set(pairs[key], numExact);
  placePairs(contacts, numExact, bodies);
  return contacts;
}

function decodeExact(reader, bodies, count) {
  const flags = reader.span(count), first = new Uint32Array(count);
  for (let i = 0, at = 0; i < count; ++i) first[i] = at += reader.signed();
  const second = reader.varintArray(count);
  demandBodies(first, second, bodies.count);
  const point = new Float64Array(3 * count), normal = new Float32Array(3 * count);
  for (let k = 0; k < 3; ++k) {
    for (let i = 0; i < count; ++i) {
      point[3 * i + k] = (bodies.place[k * bodies.count + first[i]] + POINT_UNITS * reader.signed()) * bodies.unit[first[i]];
    }
  }
  const codes = reader.span(3 * count);
  for (let k = 0; k < 3; ++k) {
    for (let i = 0; i < count; ++i) normal[3 * i + k] = ((codes[k * count + i] << 24) >> 24) * NORMAL_UNIT;
  }
  return { status: flags.map((flag) => flag & STATUS_MASK), stored: flags.map((flag) => flag & STORED_FLAG ? 1 : 0), first, second,
           point, normal, force: reader.float32Array(3 * count) };
}

function demandBodies(first, second, count) {
  for (const places of [first, second]) {
    for (const place of places) if (place >= count) throw new RangeError('A contact names a body that is not there.');
  }
}

/** Pairs that stay come first, in their order, then new ones. Their numbers count from those of the frame before. */
function decodePairs(reader, before) {
  const kept = before ? keptPairs(reader, before) : { first: [], second: [], from: [] };
  const { first, second, from } = kept, numKept = first.length, old = before?.contacts, oldCount = old ? old.pairNumbers.length / NUMBERS : 0;
  const numNew = reader.number(Kind.newPairs, NO_PAST);
  if (numNew < 0) throw new RangeError('The count of new pairs of a frame is negative.');
  for (let i = 0, at = 0; i < numNew; ++i) {
    first.push(at += reader.number(Kind.first, NO_PAST));
    second.push(at + reader.number(Kind.second, NO_PAST));
  }
  const count = first.length, numbers = new Int32Array(NUMBERS * count), past = new Uint8Array(NUMBERS * count).fill(NO_PAST);
  const status = new Uint8Array(count), start = old ? old.count - oldCount : 0;
  for (let i = 0; i < count; ++i) {
    const read = reader.number(Kind.status, i < numKept ? old.status[start + from[i]] : NO_PAST);
    if (!(read >= 0 && read < NO_PAST)) throw new RangeError('The status of a pair of a frame is unknown.');
    status[i] = read;
  }
  for (let k = 0; k < NUMBERS; ++k) {
    const circle = TURNING.get(k);
    for (let i = 0; i < count; ++i) {
      const at = k * count + i, was = k * oldCount + from[i];
      if (i < numKept) past[at] = old.pairPast[was];
      const value = reader.next(Kind.pair + k, past, at) + (i < numKept ? old.pairNumbers[was] : 0);
      numbers[at] = circle ? value & (circle - 1) : value;
    }
  }
  return { first, second, status, numbers, past };
}

/** The pairs of the frame before whose bodies are still there and that are not named as gone. */
function keptPairs(reader, { contacts, placeNow }) {
  const first = [], second = [], from = [], start = contacts.count - contacts.pairNumbers.length / NUMBERS;
  for (let i = start; i < contacts.count; ++i) {
    const a = placeNow(contacts.first[i]), b = placeNow(contacts.second[i]);
    if (a < 0 || b < 0 || reader.number(Kind.parting, contacts.status[i]) !== 0) continue;
    first.push(a);
    second.push(b);
    from.push(i - start);
  }
  return { first, second, from };
}

/** Fills in points, normals and forces of pairs from their numbers, which are in the frame of the first body. */
function placePairs({ first, second, point, normal, force, pairNumbers }, start, bodies) {
  const count = pairNumbers.length / NUMBERS, step = 2 * Math.PI / CIRCLE, forceStep = 2 * Math.PI / FORCE_CIRCLE;
  demandBodies(first.subarray(start), second.subarray(start), bodies.count);
  const number = (k, i) => pairNumbers[k * count + i];
  for (let i = 0; i < count; ++i) {
    const b = first[start + i], at = 3 * (start + i), q = [0, 1, 2, 3].map((k) => bodies.turn[k * bodies.count + b]);
    const offset = turned(q, number(OF_PAIR.x, i), number(OF_PAIR.y, i), number(OF_PAIR.z, i));
    for (let k = 0; k < 3; ++k) {
      point[at + k] = (bodies.place[k * bodies.count + b] + PAIR_POINT_UNITS * offset[k]) * bodies.unit[b];
    }
    const around = step * number(OF_PAIR.normalAround, i), up = step * number(OF_PAIR.normalUp, i);
    normal.set(turned(q, ...direction(around, up, 1)), at);
    const size = 10 ** (number(OF_PAIR.force, i) / FORCE_STEPS);
    force.set(turned(q, ...direction(around + forceStep * number(OF_PAIR.forceAround, i), up + forceStep * number(OF_PAIR.forceUp, i), size)), at);
  }
}

function direction(around, up, size) {
  return [size * Math.cos(up) * Math.cos(around), size * Math.cos(up) * Math.sin(around), size * Math.sin(up)];
}
