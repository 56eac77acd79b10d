import { ByteReader } from './bytes.js';
import { decodeContacts } from './contacts.js';
import { Kind, NO_PAST, NumberReader, evenShares } from './numbers.js';

export const BodyKind = { floe: 0, vessel: 1, rigid: 2, wall: 3, part: 4 };
const KEY_FLAG = 1, TURN_UNIT = 1 / 32768, BODY_KINDS = Kind.parting;

/**
 * What stays the same of the bodies while none comes or goes, so frames share it.
 * @typedef {object} BodyList
 * @property {Float64Array} id
 * @property {Uint8Array} kind one of BodyKind
 * @property {Int32Array} shape number of the shape, -1 for a plane
 * @property {Uint8Array} fixed
 * @property {Float32Array} thickness [m]
 * @property {Float32Array} mass [kg]
 * @property {Float32Array} unit of positions [m]
 * @property {Map<number, string>} names by id, of those that have one
 */

/**
 * The state at the end of a step. Positions are in units of the body, turns (w, x, y, z) in units of 2^-15.
 * @typedef {object} Frame
 * @property {boolean} isKey
 * @property {number} time [s]
 * @property {number} step
 * @property {number} stepLength [s]
 * @property {BodyList} bodies
 * @property {Float64Array} place x of all bodies, then y, then z
 * @property {Int32Array} turn w of all bodies, then x, y, z
 * @property {Float64Array} placeBefore as `place`, of the frame before; valid where `age` > 0
 * @property {Int32Array} turnBefore
 * @property {Uint8Array} age frames since the body came, at most 1
 * @property {Uint8Array} past for each kind of number and body the digits of the newest number, as `NumberReader` has them
 * @property {Uint16Array} shares of the coded numbers after this frame
 * @property {Int32Array} speedCode
 * @property {Int32Array} island
 * @property {Uint8Array|null} damage in units of 1/255
 * @property {{contacts: number, iterations: number, residual: number}[]} islands
 * @property {import('./contacts.js').Contacts} contacts
 * @property {Float32Array} channels value, smallest and largest of each channel; not a number where it is not known
 * @property {Line[]} lines
 */

/** @typedef {{kind: number, name: string, force: number, points: Float32Array}} Line */

/** Value, smallest and largest of each channel. The file has how far it was below and above the value. */
function decodeChannels(reader, count) {
  const channels = new Float32Array(3 * count);
  for (let c = 0; c < channels.length; c += 3) {
    const value = reader.float32();
    channels[c] = value;
    channels[c + 1] = value - reader.halfFloat32();
    channels[c + 2] = value + reader.halfFloat32();
  }
  return channels;
}

/** What the index needs of a frame, without its bodies. @returns {{time: number, isKey: boolean, channels: Float32Array}} */
export function decodeFrameHead(content, numChannels) {
  const reader = new ByteReader(content);
  const channels = decodeChannels(reader, numChannels);
  const isKey = (reader.byte() & KEY_FLAG) !== 0;
  return { channels, isKey, time: reader.float64() };
}

/**
 * Decodes a frame.
 * @param {Uint8Array} content
 * @param {{channels: unknown[], damage: boolean}} head
 * @param {Frame|null} before the frame before it; a key frame needs none
 * @returns {Frame}
 */
export function decodeFrame(content, head, before) {
  const reader = new ByteReader(content);
  const channels = decodeChannels(reader, head.channels.length);
  const isKey = (reader.byte() & KEY_FLAG) !== 0;
  if (!isKey && !before) throw new Error('A frame that is no key frame was decoded without the frame before it.');
  const time = reader.float64(), step = reader.varint(), stepLength = reader.float64();
  const last = isKey ? null : before, { bodies, origin } = decodeBodyList(reader, last);
  const numbers = new NumberReader(reader.span(reader.varint()), last ? last.shares.slice() : evenShares());
  const past = pastOf(origin, last), motion = decodeMotion(numbers, past, origin, last);
  const marks = decodeMarks(numbers, past, origin, last, head.damage);
  const islands = decodeIslands(reader);
  const contacts = decodeContacts(reader, numbers, { ...motion, unit: bodies.unit, count: bodies.id.length },
                                  last ? { contacts: last.contacts, placeNow: placesNow(origin, last) } : null);
  return { isKey, time, step, stepLength, bodies, ...motion, ...marks, past, shares: numbers.shares, islands, contacts, channels,
           lines: decodeLines(reader) };
}

/**
 * The list of bodies, and for each its place in the list of the frame before, -1 for one that came. `origin` is null
 * where the list is unchanged.
 */
function decodeBodyList(reader, before) {
  const old = before ? before.bodies : null, oldCount = old ? old.id.length : 0;
  const gone = new Uint8Array(oldCount);
  const numGone = reader.varint();
  for (let i = 0, at = -1; i < numGone; ++i) {
    at += reader.varint();
    if (at >= oldCount) throw new RangeError('A frame removes a body that is not there.');
    gone[at] = 1;
  }
  const numCame = reader.varint();
  if (old && numGone === 0 && numCame === 0) return { bodies: old, origin: null };
  const count = oldCount - numGone + numCame;
  const bodies = {
    id: new Float64Array(count), kind: new Uint8Array(count), shape: new Int32Array(count), fixed: new Uint8Array(count),
    thickness: new Float32Array(count), mass: new Float32Array(count), unit: new Float32Array(count), names: new Map(old ? old.names : []),
  };
  const origin = new Int32Array(count).fill(-1);
  let at = 0;
  for (let k = 0; k < oldCount; ++k) {
    if (gone[k]) {
      bodies.names.delete(old.id[k]);
      continue;
    }
    origin[at] = k;
    for (const key of ['id', 'kind', 'shape', 'fixed', 'thickness', 'mass', 'unit']) bodies[key][at] = old[key][k];
    ++at;
  }
  for (let id = 0; at < count; ++at) {
    id += reader.signed();
    bodies.id[at] = id;
    bodies.kind[at] = reader.byte();
    bodies.shape[at] = reader.varint() - 1;
    bodies.fixed[at] = reader.byte();
    bodies.thickness[at] = reader.float32();
    bodies.mass[at] = reader.float32();
    bodies.unit[at] = reader.float32();
    const name = reader.text();
    if (name) bodies.names.set(id, name);
  }
  return { bodies, origin };
}

/** A function that gives the place of a body in the list from that in the frame before, -1 if it went. */
function placesNow(origin, before) {
  if (!origin) return (place) => place;
  const now = new Int32Array(before.bodies.id.length).fill(-1);
  for (let b = 0; b < origin.length; ++b) if (origin[b] >= 0) now[origin[b]] = b;
  return (place) => now[place];
}

/** `values` of the frame before, in the order of the new list; `ofNew` for a body that came. */
function reordered(values, origin, oldCount, numArrays, ofNew = 0) {
  if (!origin) return values;
  const count = origin.length;
  const result = new values.constructor(numArrays * count).fill(ofNew);
  for (let k = 0; k < numArrays; ++k) {
    for (let b = 0; b < count; ++b) if (origin[b] >= 0) result[k * count + b] = values[k * oldCount + origin[b]];
  }
  return result;
}

/** The digits of the newest numbers of the bodies, before this frame's are read. */
function pastOf(origin, before) {
  if (!before) return new Uint8Array(BODY_KINDS * origin.length).fill(NO_PAST);
  return origin ? reordered(before.past, origin, before.bodies.id.length, BODY_KINDS, NO_PAST) : before.past.slice();
}

/** Positions and turns: predicted by 2 a - b from the two frames before. */
function decodeMotion(numbers, past, origin, before) {
  const oldCount = before ? before.bodies.id.length : 0;
  const count = origin ? origin.length : oldCount;
  const one = (values, arrays, Type) => before ? reordered(values, origin, oldCount, arrays) : new Type(arrays * count);
  const placeBefore = one(before?.place, 3, Float64Array), turnBefore = one(before?.turn, 4, Int32Array);
  const placeTwo = one(before?.placeBefore, 3, Float64Array), turnTwo = one(before?.turnBefore, 4, Int32Array);
  const ageBefore = one(before?.age, 1, Uint8Array);
  const age = new Uint8Array(count);
  for (let b = 0; b < count; ++b) age[b] = before && (!origin || origin[b] >= 0) ? 1 : 0;
  const predict = (now, two, Type, arrays, kind) => {
    const values = new Type(arrays * count);
    for (let k = 0, i = 0; k < arrays; ++k) {
      for (let b = 0; b < count; ++b, ++i) {
        // `now` is 0 for a body that came.
        values[i] = numbers.next(kind + k, past, (kind + k) * count + b) + (ageBefore[b] && age[b] ? 2 * now[i] - two[i] : now[i]);
      }
    }
    return values;
  };
  const place = predict(placeBefore, placeTwo, Float64Array, 3, Kind.position);
  const turn = predict(turnBefore, turnTwo, Int32Array, 4, Kind.turn);
  return { place, turn, placeBefore, turnBefore, age };
}

/** Speed, island and damage: predicted by the frame before. */
function decodeMarks(numbers, past, origin, before, hasDamage) {
  const oldCount = before ? before.bodies.id.length : 0;
  const count = origin ? origin.length : oldCount;
  const decode = (kind, old, Type) => {
    const last = before ? reordered(old, origin, oldCount, 1) : null;
    const values = new Type(count);
    for (let b = 0; b < count; ++b) values[b] = numbers.next(kind, past, kind * count + b) + (last ? last[b] : 0);
    return values;
  };
  return {
    speedCode: decode(Kind.speed, before?.speedCode, Int32Array),
    island: decode(Kind.island, before?.island, Int32Array),
    damage: hasDamage ? decode(Kind.damage, before?.damage, Uint8Array) : null,
  };
}

function decodeIslands(reader) {
  const islands = new Array(reader.varint());
  for (let i = 0; i < islands.length; ++i) {
    islands[i] = { contacts: reader.varint(), iterations: reader.varint(), residual: reader.float32() };
  }
  return islands;
}

/** @returns {Line[]} */
function decodeLines(reader) {
  const lines = new Array(reader.varint());
  for (let i = 0; i < lines.length; ++i) {
    lines[i] = { kind: reader.byte(), name: reader.text(), force: reader.float32(),
                 points: reader.float32Array(3 * reader.varint()) };
  }
  return lines;
}

/** Coordinate k of the place of a body [m]. */
export function coordinate({ bodies, place }, b, k) { return place[k * bodies.id.length + b] * bodies.unit[b]; }

/** Position [m] and unit quaternion (x, y, z, w) of a body, into `pose` from `at` on. */
export function readPose(frame, b, pose, at = 0) {
  const n = frame.bodies.id.length;
  for (let k = 0; k < 3; ++k) pose[at + k] = coordinate(frame, b, k);
  const w = frame.turn[b] * TURN_UNIT, x = frame.turn[n + b] * TURN_UNIT;
  const y = frame.turn[2 * n + b] * TURN_UNIT, z = frame.turn[3 * n + b] * TURN_UNIT;
  const scale = 1 / (Math.hypot(w, x, y, z) || 1);
  pose[at + 3] = x * scale;
  pose[at + 4] = y * scale;
  pose[at + 5] = z * scale;
  pose[at + 6] = w * scale;
}

/** The speed of a body [m/s]. */
export function speedOf(frame, b) {
  const code = frame.speedCode[b];
  return code === 0 ? 0 : 10 ** ((code - 1) / 28 - 6);
}

/** The bytes that a frame holds in memory, about. */
export function bytesOf(frame) {
  return 130 * frame.bodies.id.length + 110 * frame.contacts.count + 4 * frame.channels.length + frame.shares.byteLength + 2000;
}
