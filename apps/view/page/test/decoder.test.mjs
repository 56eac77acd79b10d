import assert from 'node:assert/strict';
import { test } from 'node:test';
import { decodeFrame, readPose, speedOf } from '../src/data/frame.js';
import { FrameStore } from '../src/data/frame_store.js';
import { PieceReader, ReplayError } from '../src/data/pieces.js';
import { Recording } from '../src/data/recording.js';
import { edgesOf, trianglesOf } from '../src/data/shapes.js';
import { makeReplay } from './make_replay.mjs';
import { ReplayWriter, piece } from './replay_writer.mjs';

/** Reads a whole replay. @returns {Promise<{recording: Recording, store: FrameStore, isCut: boolean}>} */
async function read(bytes, chunk = bytes.length, maxBytes = Infinity) {
  const reader = new PieceReader(), recording = new Recording(maxBytes);
  for (let at = 0; at < bytes.length; at += chunk) await recording.add(reader.push(bytes.subarray(at, at + chunk)));
  return { recording, store: new FrameStore(recording), isCut: reader.pending > 0 };
}

const HEAD = { scene: 'small', every: 0.1, until: 1, water_level: 0, tank: null, view: null, channels: [], contacts: 'all', damage: false, hull: null };

/** A body at a place; it turns about z by `angle`. */
const body = (id, p, angle = 0) => ({ id, kind: 0, shape: 0, fixed: false, thickness: 1, mass: 5, p, q: [Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)], speed: 0.1 });

/** The place of each body by its id. */
function places(frame) {
  const pose = new Float64Array(7), found = new Map();
  for (let b = 0; b < frame.bodies.id.length; ++b) {
    readPose(frame, b, pose);
    found.set(frame.bodies.id[b], Array.from(pose));
  }
  return found;
}

function assertNear(found, wanted, allowed, text) {
  found.forEach((x, k) => assert.ok(Math.abs(x - wanted[k]) <= allowed, `${text}: ${x} is not ${wanted[k]} within ${allowed}`));
}

test('a decoded frame has the values that were written, within half a quantum', async () => {
  const { bytes, frames } = makeReplay({ floes: 80, frames: 70, keyEvery: 16 });
  const { recording, store, isCut } = await read(bytes);
  assert.equal(isCut, false);
  assert.equal(recording.end, 70);
  assert.equal(recording.endReason, 'The run reached its end.');
  for (let i = 0; i < frames.length; ++i) {
    const frame = await store.get(i), wanted = frames[i];
    assert.equal(frame.time, wanted.time);
    assert.equal(frame.step, wanted.step);
    assert.deepEqual(Array.from(frame.bodies.id), wanted.bodies.map(({ id }) => id));
    assertBodies(frame, wanted);
    assertContacts(frame, wanted);
    assertNear(frame.channels, wanted.channels.flat(), 1e-4 * Math.max(...wanted.channels.flat().map(Math.abs)), 'channel');
    assert.deepEqual(frame.lines.map(({ kind, name }) => [kind, name]), wanted.lines.map(({ kind, name }) => [kind, name]));
    assertNear(frame.lines[0].points, wanted.lines[0].points.flat(), 1e-5, 'line');
  }
});

function assertBodies(frame, wanted) {
  const pose = new Float64Array(7);
  wanted.bodies.forEach((body, b) => {
    readPose(frame, b, pose);
    assertNear(pose.subarray(0, 3), body.p, 0.5001 * frame.quantum, 'place');
    const [x, y, z, w] = pose.subarray(3), sign = w * body.q[0] + x * body.q[1] + y * body.q[2] + z * body.q[3] < 0 ? -1 : 1;
    assertNear([w, x, y, z].map((c) => sign * c), body.q, 1.1 / 32768, 'turn');
    if (body.speed > 1e-6) assert.ok(Math.abs(speedOf(frame, b) / body.speed - 1) < 0.042, 'speed');
    else assert.equal(speedOf(frame, b), 0);
    assert.equal(frame.island[b], body.island ?? 0);
    assert.equal(frame.damage[b], Math.round(255 * body.damage));
    assert.equal(frame.bodies.kind[b], body.kind);
    assert.equal(frame.bodies.mass[b], Math.fround(body.mass));
    assert.equal(frame.bodies.names.get(body.id) ?? '', body.name ?? '');
  });
}

function assertContacts({ contacts, quantum }, wanted) {
  assert.equal(contacts.count, wanted.contacts.length);
  const largest = Math.max(0, ...wanted.contacts.filter(({ exact }) => !exact).flatMap(({ force }) => force.map(Math.abs)));
  wanted.contacts.forEach((contact, i) => {
    assert.equal(contacts.status[i], contact.status);
    assert.equal(contacts.exact[i], contact.exact ? 1 : 0);
    assert.equal(contacts.stored[i], contact.stored ? 1 : 0);
    assert.equal(contacts.first[i], contact.first);
    assert.equal(contacts.second[i], contact.second);
    // The point counts from the body's rounded place, in units of four quanta.
    assertNear(contacts.point.subarray(3 * i, 3 * i + 3), contact.p, 3 * quantum, 'point');
    assertNear(contacts.normal.subarray(3 * i, 3 * i + 3), contact.n, 0.51 / 127, 'normal');
    assertNear(contacts.force.subarray(3 * i, 3 * i + 3), contact.force, contact.exact ? 1e-5 * largest + 1e-4 : largest / 3999, 'force');
  });
}

test('predictions hold where bodies come and go', async () => {
  const writer = new ReplayWriter();
  writer.head(HEAD);
  const lists = [[1, 2, 3, 4], [1, 3, 4], [1, 3, 4, 5, 6], [3, 5, 6], [3, 5, 6, 7], [7], [], [8, 9]];
  const placeOf = (id, i) => [1e3 * id + i * i * 0.37, -id * i * 0.11, 0.01 * id + i];
  lists.forEach((ids, i) => writer.frame({ time: 0.1 * i, step: i, stepLength: 0.1, quantum: 1e-4, bodies: ids.map((id) => body(id, placeOf(id, i), 0.3 * i)) }));
  const { store } = await read(writer.bytes());
  for (let i = 0; i < lists.length; ++i) {
    const found = places(await store.get(i));
    assert.deepEqual([...found.keys()], lists[i]);
    for (const [id, pose] of found) assertNear(pose.slice(0, 3), placeOf(id, i), 0.5001e-4, `body ${id} in frame ${i}`);
  }
});

test('large and negative numbers are kept', async () => {
  const writer = new ReplayWriter(), far = [[3.1e9, -4.4e9, 2e9], [-3.1e9, 4.4e9, -2e9], [0, 0, 0]];
  writer.head(HEAD);
  far.forEach((p, i) => writer.frame({ time: i, step: i, stepLength: 1, quantum: 1e-5, bodies: [body(4e9, p)] }));
  const { store } = await read(writer.bytes());
  for (let i = 0; i < far.length; ++i) assertNear(places(await store.get(i)).get(4e9).slice(0, 3), far[i], 1e-5, `frame ${i}`);
});

test('seeking gives the same frame as playing forward', async () => {
  const { bytes } = makeReplay({ floes: 60, frames: 90, keyEvery: 20 });
  const played = await read(bytes);
  const forward = [];
  for (let i = 0; i < 90; ++i) forward.push(await played.store.get(i));
  for (const i of [89, 3, 41, 40, 39, 60, 0, 77]) {
    const { store } = await read(bytes);
    assert.deepEqual(await store.get(i), forward[i], `frame ${i}`);
  }
  for (const i of [70, 12, 71, 11]) assert.deepEqual(await played.store.get(i), forward[i]);
});

test('a replay that was cut anywhere gives its whole pieces', async () => {
  const { bytes } = makeReplay({ floes: 10, frames: 12 });
  const whole = (await read(bytes)).recording;
  let last = 0;
  for (let end = 9; end < bytes.length; end += 97) {
    const { recording, isCut } = await read(bytes.subarray(0, end));
    assert.ok(recording.end >= last && recording.end <= whole.end);
    assert.ok(isCut || recording.end === 0 || recording.entry(recording.end - 1).time <= whole.endTime);
    last = recording.end;
  }
  const { recording, isCut } = await read(bytes.subarray(0, bytes.length - 1));
  assert.equal(isCut, true);
  assert.equal(recording.end, 12);
  assert.equal(recording.endReason, null);
});

test('pieces are the same whatever chunks they come in', async () => {
  const { bytes } = makeReplay({ floes: 10, frames: 12 });
  const whole = await read(bytes);
  for (const chunk of [1, 7, 100, 4097]) {
    const { recording, store, isCut } = await read(bytes, chunk);
    assert.equal(isCut, false);
    assert.equal(recording.end, 12);
    assert.deepEqual(await store.get(11), await whole.store.get(11));
  }
});

test('another version and another file are refused in plain words', () => {
  assert.throws(() => new PieceReader().push(Buffer.from('NILASRP2xxxx')), { constructor: ReplayError, message: /has version 2, and this page reads version 1/ });
  assert.throws(() => new PieceReader().push(Buffer.from('<scene version="1"/>')), { constructor: ReplayError, message: /not a replay of Nilas/ });
});

test('a piece without its line feed is damage', () => {
  const { bytes } = makeReplay({ floes: 3, frames: 3 }), broken = Buffer.from(bytes);
  const size = broken.readUInt32LE(9);
  broken[8 + 5 + size] = 0;
  assert.throws(() => new PieceReader().push(broken), ReplayError);
});

test('damage in the middle leaves what came before', async () => {
  const { bytes } = makeReplay({ floes: 5, frames: 30 }), half = Math.floor(bytes.length / 2);
  for (const [from, to] of [[half, half + 600], [half, half + 3]]) {
    const broken = Buffer.from(bytes), reader = new PieceReader(), recording = new Recording();
    broken.fill(0, from, to);
    await assert.rejects(async () => {
      await recording.add(reader.push(broken));
      reader.check();
    }, ReplayError);
    assert.ok(recording.end > 5 && recording.end < 30, `${recording.end} frames`);
  }
});

test('a kind of piece that is unknown is skipped and named', async () => {
  const { bytes } = makeReplay({ floes: 5, frames: 3 });
  const { recording } = await read(Buffer.concat([bytes.subarray(0, 8), piece('Q', { x: 1 }), bytes.subarray(8), piece('Z', {})]));
  assert.deepEqual([...recording.skippedKinds], ['Q', 'Z']);
  assert.equal(recording.end, 3);
});

test('a frame that is too short is a fault', async () => {
  const { bytes } = makeReplay({ floes: 5, frames: 1 });
  const { recording } = await read(bytes);
  const { inflate } = await import('../src/data/inflate.js');
  const content = await inflate(recording.entry(0).packed);
  for (const share of [0.4, 0.7, 0.95]) {
    assert.throws(() => decodeFrame(content.subarray(0, Math.floor(share * content.length)), recording.head, null), RangeError);
  }
});

test('a resumed run replaces the frames that it repeats', async () => {
  const writer = new ReplayWriter();
  writer.head(HEAD);
  const write = (i, x) => writer.frame({ time: 0.1 * i, step: i, stepLength: 0.1, quantum: 1e-3, bodies: [body(1, [x, 0, 0])] });
  for (let i = 0; i < 10; ++i) write(i, i);
  writer.head(HEAD);
  writer.breakOff();
  for (let i = 6; i < 12; ++i) write(i, 100 + i);
  const { recording, store } = await read(writer.bytes());
  assert.equal(recording.end, 12);
  for (let i = 0; i < 12; ++i) assertNear([places(await store.get(i)).get(1)[0]], [i < 6 ? i : 100 + i], 1e-3, `frame ${i}`);
});

test('a long live run drops its oldest frames, from key frame to key frame', async () => {
  const { bytes, frames } = makeReplay({ floes: 20, frames: 60, keyEvery: 8 });
  const { recording, store } = await read(bytes, 5000, 20000);
  assert.ok(recording.first > 0 && recording.first % 8 === 0, `first frame ${recording.first}`);
  assert.equal(recording.end, 60);
  assert.ok(recording.packedBytes <= 20000 + 8 * 3000);
  assert.equal((await store.get(recording.first)).time, frames[recording.first].time);
  assert.equal(recording.frameAt(0), recording.first);
});

test('edges are those of the body, not of its triangles', () => {
  const box = { points: new Float32Array([0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0, 0, 0, 3, 2, 0, 3, 2, 1, 3, 0, 1, 3]), counts: [], corners: [] };
  for (const [a, b, c, d] of [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]) {
    box.counts.push(3, 3);
    box.corners.push(a, b, c, a, c, d);
  }
  assert.equal(edgesOf(box).length / 2, 12);
  assert.equal(trianglesOf(box).length / 3, 12);
});

test('a frame with 100 000 contacts is read', async () => {
  const writer = new ReplayWriter(), count = 100000;
  writer.head(HEAD);
  const bodies = [body(1, [0, 0, 0]), body(2, [1, 0, 0])];
  const contacts = Array.from({ length: count }, (_, i) => ({ status: i % 4, exact: i % 2 === 0, stored: false, first: i % 2, second: 1 - i % 2, p: [i * 1e-5, 0, 0], n: [1, 0, 0], force: [i, 0, -i] }));
  writer.frame({ time: 0, step: 0, stepLength: 0.1, quantum: 1e-4, bodies, contacts });
  const { store } = await read(writer.bytes()), frame = await store.get(0);
  assert.equal(frame.contacts.count, count);
  assert.equal(frame.contacts.force[3 * (count - 2)], count - 2);
});
