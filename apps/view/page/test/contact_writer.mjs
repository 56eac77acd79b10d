/** Writes the contacts of a frame, as docs/reference/replay-file.md says. It knows nothing of the page. */
import { NO_PAST } from './number_writer.mjs';

const CIRCLE = 128, FORCE_CIRCLE = 64, FORCE_STEPS = 20, LEAST_FORCE = 1e-12;

/** A vector in the frame of a body that is turned by the unit quaternion (w, x, y, z). */
function inBody([w, x, y, z], [a, b, c]) {
  const rows = [[1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)], [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
                [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]];
  return rows.map(([p, q, r]) => p * a + q * b + r * c);
}

/** The angle about z and the angle above the plane of x and y. */
function angles([x, y, z]) {
  const size = Math.hypot(x, y, z) || 1;
  return [Math.atan2(y, x), Math.asin(Math.min(1, Math.max(-1, z / size)))];
}

/** Equal to `a` but for whole circles, and nearest to 0. */
const wrapped = (a, circle) => ((a + circle / 2) % circle + circle) % circle - circle / 2;

export class ContactWriter {
  /** Pairs of the frame before by the identities of their bodies: {numbers, digits, status}. */
  #pairs = new Map();

  /** Contacts are {status, exact, stored, first, second, p, n, force}, with places in the list of bodies. */
  writeExact(out, contacts, stored) {
    out.varint(contacts.length);
    for (const { status, stored: isStored } of contacts) out.byte(status + (isStored ? 64 : 0));
    let last = 0;
    for (const { first } of contacts) {
      out.signed(first - last);
      last = first;
    }
    for (const { second } of contacts) out.varint(second);
    for (let k = 0; k < 3; ++k) {
      for (const { p, first } of contacts) out.signed(Math.round((Math.round(p[k] / stored[first].unit) - stored[first].now[k]) / 4));
    }
    for (let k = 0; k < 3; ++k) for (const { n } of contacts) out.byte(Math.round(127 * n[k]));
    for (const { force } of contacts) for (const f of force) out.float32(f);
  }

  writePairs(out, contacts, bodies, stored, isKey) {
    const key = ({ first, second }) => `${bodies[first].id} ${bodies[second].id}`, now = new Map(contacts.map((c) => [key(c), c]));
    const there = new Set(bodies.map(({ id }) => String(id))), old = new Map();
    for (const [name, pair] of isKey ? [] : this.#pairs) {
      if (!name.split(' ').every((id) => there.has(id))) continue;
      out.add('parting', 0, pair.status, now.has(name) ? 0 : 1);
      if (now.has(name)) old.set(name, pair);
    }
    const added = contacts.filter((c) => !old.has(key(c)));
    out.add('newPairs', 0, NO_PAST, added.length);
    let last = 0;
    for (const { first, second } of added) {
      out.add('first', 0, NO_PAST, first - last);
      out.add('second', 0, NO_PAST, second - first);
      last = first;
    }
    const list = [...[...old.keys()].map((name) => now.get(name)), ...added];
    for (const c of list) out.add('status', 0, old.get(key(c))?.status ?? NO_PAST, c.status);
    this.#pairs = new Map(list.map((c) => [key(c), { numbers: numbersOf(c, bodies[c.first], stored[c.first].unit), digits: [], status: c.status }]));
    for (let k = 0; k < 8; ++k) {
      for (const [name, pair] of this.#pairs) {
        const before = old.get(name), difference = pair.numbers[k] - (before?.numbers[k] ?? 0);
        const x = k === 0 ? wrapped(difference, CIRCLE) : k === 7 ? wrapped(difference, FORCE_CIRCLE) : difference;
        pair.digits[k] = out.add('pair', k, before?.digits[k] ?? NO_PAST, x);
      }
    }
  }
}

function numbersOf({ p, n, force }, { p: place, q }, unit) {
  const point = inBody(q, p.map((x, k) => x - place[k])).map((x) => Math.round(x / (256 * unit)));
  const step = 2 * Math.PI / CIRCLE, normal = angles(inBody(q, n)).map((angle) => Math.round(angle / step));
  const pull = angles(inBody(q, force)).map((angle, k) => Math.round((angle - step * normal[k]) * FORCE_CIRCLE / (2 * Math.PI)));
  const size = Math.max(Math.hypot(...force), LEAST_FORCE);
  return [...normal, pull[1], ...point, Math.round(FORCE_STEPS * Math.log10(size)), wrapped(pull[0], FORCE_CIRCLE)];
}
