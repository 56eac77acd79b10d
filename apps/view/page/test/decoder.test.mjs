import assert from 'node:assert/strict';
import { test } from 'node:test';
import { decodeFrame, readPose, speedOf } from '../src/data/frame.js';
import { FrameGoneError, FrameStore } from '../src/data/frame_store.js';
import { PieceReader, ReplayError } from '../src/data/pieces.js';
import { Recording } from '../src/data/recording.js';
import { edgesOf, trianglesOf } from '../src/data/shapes.js';
import { bytesOfBlock } from '../src/sources/block_text.js';
import { drawnWaves, middleWaveLength, rampAt } from '../src/scene/waves.js';
import { blockText } from './fill_page.mjs';
import { makeReplay } from './make_replay.mjs';
import { ReplayWriter, piece } from './replay_writer.mjs';
import { randomNumbers } from './shapes.mjs';

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

test('bytes of any number and value come back from the letters of a block', () => {
  for (let length = 0; length < 60; ++length) {
    const bytes = Uint8Array.from({ length }, (_, k) => (k * 167 + length * 31) & 255);
    for (const list of [bytes, bytes.map(() => 255), bytes.map(() => 0)]) {
      const text = blockText(list);
      assert.match(text, /^[!-~]*$/);
      assert.doesNotMatch(text, /["&<]/);
      assert.ok(text.length <= 16 * length / 13 + 2);
      assert.deepEqual(bytesOfBlock(text), list);
    }
  }
});

test('a decoded frame has the values that were written, within the stated errors', async () => {
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
    wanted.channels.forEach(([value, least, most], c) => {
      const rounding = 1e-6 * (Math.abs(least) + Math.abs(most));
      assert.equal(frame.channels[3 * c], Math.fround(value));
      assertNear([frame.channels[3 * c + 1], frame.channels[3 * c + 2]], [least, most], (most - least) / 128 + rounding, 'range');
      assert.ok(frame.channels[3 * c + 1] <= least + rounding && frame.channels[3 * c + 2] >= most - rounding, 'range');
    });
    assert.deepEqual(frame.lines.map(({ kind, name }) => [kind, name]), wanted.lines.map(({ kind, name }) => [kind, name]));
    assertNear(frame.lines[0].points, wanted.lines[0].points.flat(), 1e-5, 'line');
  }
});

function assertBodies(frame, wanted) {
  const pose = new Float64Array(7);
  wanted.bodies.forEach((body, b) => {
    readPose(frame, b, pose);
    assertNear(pose.subarray(0, 3), body.p, 0.5001 * frame.bodies.unit[b], 'place');
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

/** Exact contacts keep their order; sums over pairs are found by their bodies. */
function assertContacts({ contacts, bodies }, wanted) {
  assert.equal(contacts.count, wanted.contacts.length);
  const list = wanted.contacts.filter(({ exact }) => exact), sums = wanted.contacts.filter(({ exact }) => !exact);
  for (let i = list.length; i < contacts.count; ++i) {
    list.push(sums.find(({ first, second }) => first === contacts.first[i] && second === contacts.second[i]));
  }
  assert.equal(new Set(list).size, contacts.count);
  list.forEach((contact, i) => {
    const part = (values) => values.subarray(3 * i, 3 * i + 3), unit = bodies.unit[contact.first], size = Math.hypot(...contact.force);
    for (const key of ['status', 'first', 'second']) assert.equal(contacts[key][i], contact[key], key);
    for (const key of ['exact', 'stored']) assert.equal(contacts[key][i], contact[key] ? 1 : 0, key);
    // The point counts from the body's rounded place: in units of four there, and of 256 in a pair.
    assertNear(part(contacts.point), contact.p, (contact.exact ? 3 : 224) * unit, 'point');
    assertNear(part(contacts.normal), contact.n, contact.exact ? 0.51 / 127 : 0.036, 'normal');
    const along = contact.exact ? 1e-5 * size : 0.07 * size;
    assert.ok(Math.abs(Math.hypot(...part(contacts.force)) - size) <= (contact.exact ? 1e-6 : 0.06) * size, 'size of the force');
    assertNear(part(contacts.force).map((f) => f * size / Math.hypot(...part(contacts.force))), contact.force, along, 'force');
  });
}

test('predictions hold where bodies come and go', async () => {
  const writer = new ReplayWriter();
  writer.head(HEAD);
  const lists = [[1, 2, 3, 4], [1, 3, 4], [1, 3, 4, 5, 6], [3, 5, 6], [3, 5, 6, 7], [7], [], [8, 9]];
  const placeOf = (id, i) => [1e3 * id + i * i * 0.37, -id * i * 0.11, 0.01 * id + i];
  lists.forEach((ids, i) => writer.frame({ time: 0.1 * i, step: i, stepLength: 0.1, unit: 1e-4, bodies: ids.map((id) => body(id, placeOf(id, i), 0.3 * i)) }));
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
  far.forEach((p, i) => writer.frame({ time: i, step: i, stepLength: 1, unit: 1e-5, bodies: [body(4e9, p)] }));
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
  assert.throws(() => new PieceReader().push(Buffer.from('NILASRP1xxxx')), { constructor: ReplayError, message: /has version 1, and this page reads version 4/ });
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
  const write = (i, x) => writer.frame({ time: 0.1 * i, step: i, stepLength: 0.1, unit: 1e-3, bodies: [body(1, [x, 0, 0])] });
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
  const writer = new ReplayWriter(), count = 100000, bodies = Array.from({ length: 400 }, (_, k) => body(k + 1, [k, 0, 0]));
  writer.head(HEAD);
  const contacts = Array.from({ length: count }, (_, i) => ({ status: i % 4, exact: i % 2 === 0, stored: false, first: Math.floor(i / 400), second: 399 - i % 399,
    p: [Math.floor(i / 400), 1e-4 * i, 0], n: [1, 0, 0], force: [i, 0, -i] }));
  for (const k of [0, 1]) writer.frame({ time: k, step: k, stepLength: 0.1, unit: 1e-4, bodies, contacts });
  const { store } = await read(writer.bytes());
  for (const k of [0, 1]) {
    const { contacts: found } = await store.get(k);
    assert.equal(found.count, count);
    assert.equal(found.force[3 * (count / 2 - 1)], count - 2);
    assert.ok(Math.abs(found.force[3 * (count - 1)] / (count - 1) - 1) < 0.05);
  }
});

test('pairs keep their numbers while bodies come, go and touch anew', async () => {
  const writer = new ReplayWriter({ keyEvery: 5 }), random = randomNumbers(5);
  writer.head(HEAD);
  let ids = [1, 2, 3, 4, 5, 6], next = 7;
  const wanted = [];
  for (let i = 0; i < 24; ++i) {
    if (i % 3 === 2) ids = [...ids.filter((_, k) => k !== i % ids.length), next++, next++];
    const bodies = ids.map((id) => body(id, [id, i * 0.01, 0.1], 0.4 * i + id)), contacts = [];
    for (let a = 0; a < ids.length; ++a) {
      for (let b = 0; b < ids.length; ++b) {
        if (a === b || random() < 0.4) continue;
        const n = [random() - 0.5, random() - 0.5, random() - 0.5], size = Math.hypot(...n);
        contacts.push({ status: Math.floor(4 * random()), exact: random() < 0.2, stored: false, first: a, second: b,
                        p: [ids[a] + random(), random(), random()], n: n.map((x) => x / size), force: n.map((x) => x * 10 ** (8 * random() - 4)) });
      }
    }
    writer.frame({ time: i, step: i, stepLength: 1, unit: 1e-4, bodies, contacts });
    wanted.push({ contacts });
  }
  const { store } = await read(writer.bytes());
  for (const i of [23, 2, 14, 0, 1, 7, 22]) assertContacts(await store.get(i), wanted[i]);
});

test('a frame that is taken back while it is decoded is not kept', async () => {
  const writer = new ReplayWriter();
  writer.head(HEAD);
  const write = (i, x) => writer.frame({ time: 0.1 * i, step: i, stepLength: 0.1, unit: 1e-3, bodies: [body(1, [x, 0, 0])] });
  for (let i = 0; i < 10; ++i) write(i, i);
  const { recording, store } = await read(writer.bytes());
  const resumed = new ReplayWriter();
  resumed.head(HEAD);
  for (let i = 4; i < 8; ++i) resumed.frame({ time: 0.1 * i, step: i, stepLength: 0.1, unit: 1e-3, bodies: [body(1, [100 + i, 0, 0])] });
  const asked = [store.get(9), store.get(6)];
  await recording.add(new PieceReader().push(resumed.bytes()));
  await assert.rejects(asked[0], FrameGoneError);
  assertNear([places(await asked[1]).get(1)[0], places(await store.get(6)).get(1)[0]], [106, 106], 1e-3, 'frame 6');
  await assert.rejects(store.get(recording.end), FrameGoneError);
});

test('a frame that is damaged within is a fault when it is asked for, and only then', async () => {
  const { bytes } = makeReplay({ floes: 5, frames: 12 });
  const { recording, store } = await read(bytes);
  recording.entry(5).packed = recording.entry(5).packed.map((byte, k) => k < 20 ? 255 - byte : byte);
  assert.equal((await store.get(3)).time, recording.entry(3).time);
  await assert.rejects(store.get(7));
  await assert.rejects(store.get(5));
  assert.equal((await store.get(4)).time, recording.entry(4).time);
});

test('the waves that can be drawn are the highest that the surface resolves', () => {
  const train = { start: 2, ramp: 4, edge: [0, 0], inward: [1, 0], components: [[1, 1, 1, 0, 0, 0], [2, 1, 0, 2, 0, 0], [0.5, 1, 8, 0, 0, 0]] };
  const drawn = drawnWaves({ trains: [train, { ...train, components: [[3, 1, 0, 0.5, 0, 0]] }] }, 1, 2);
  assert.deepEqual(drawn.map(({ amplitude }) => amplitude), [3, 2]);
  assert.equal(drawnWaves(null, 0, 9).length, 0);
  assert.ok(Math.abs(middleWaveLength({ trains: [train] }) - Math.PI) < 1e-12);
  assert.equal(middleWaveLength(null), Infinity);
  assert.deepEqual([0, 2, 4, 6, 9].map((t) => Math.round(1e6 * rampAt(train, t)) / 1e6), [0, 0, 0.5, 1, 1]);
  assert.equal(rampAt({ start: 0, ramp: 0 }, 0), 1);
});

test('of marks that would cover each other the strongest stay, and each has one near', async () => {
  const { spacedContacts } = await import('../src/scene/spaced.js'), random = randomNumbers(9), count = 3000;
  const point = Float64Array.from({ length: 3 * count }, () => 2 * random() - 1), force = Float32Array.from({ length: 3 * count }, random);
  const list = Array.from({ length: count / 2 }, (_, i) => 2 * i), size = (i) => Math.hypot(...force.subarray(3 * i, 3 * i + 3));
  const axes = [[0.6, 0.8, 0], [0, 0, 1]], along = (i, [x, y, z]) => x * point[3 * i] + y * point[3 * i + 1] + z * point[3 * i + 2];
  const apart = (i, j) => Math.hypot(...axes.map((axis) => along(i, axis) - along(j, axis)));
  const kept = spacedContacts({ point, force }, list, 0.3, axes);
  assert.ok(kept.length > 20 && kept.length < 100, `${kept.length} marks`);
  kept.forEach((i, k) => kept.slice(0, k).forEach((j) => assert.ok(apart(i, j) > 0.2999)));
  for (const i of list) assert.ok(kept.some((j) => i === j || (apart(i, j) < 0.3001 && size(j) >= size(i))), `contact ${i} has no mark`);
  assert.deepEqual(spacedContacts({ point, force }, list, 0, axes), list);
});
