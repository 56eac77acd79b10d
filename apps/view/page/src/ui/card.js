import { BodyKind, coordinate } from '../data/frame.js';
import { placesIn } from '../scene/poses.js';
import { el } from './dom.js';
import { formatLength, formatMass, formatValue } from './format.js';

const KIND = { [BodyKind.floe]: 'Floe', [BodyKind.vessel]: 'Vessel', [BodyKind.rigid]: 'Rigid body', [BodyKind.wall]: 'Wall',
               [BodyKind.part]: 'Part of the vessel' };
const STATUS = ['open', 'stick', 'slip', 'crush'];
const MOST_CONTACTS = 8;

/**
 * What is known of a body in a frame.
 * @param {import('../data/frame.js').Frame} frame
 * @param {import('../data/frame.js').Frame|null} before the frame before, for the velocity
 */
export function describeBody(frame, before, id) {
  const b = frame.bodies.id.indexOf(id);
  if (b < 0) return null;
  const { bodies } = frame, kind = bodies.kind[b];
  const velocity = before ? velocityOf(frame, before, b) : null;
  return {
    id, kind: KIND[kind] ?? 'Body', name: bodies.names.get(id) ?? '', mass: bodies.mass[b], thickness: bodies.thickness[b],
    isFixed: bodies.fixed[b] === 1, velocity, speed: velocity ? Math.hypot(...velocity) : null,
    island: frame.island[b], residual: frame.islands[frame.island[b] - 1]?.residual ?? null,
    damage: frame.damage ? frame.damage[b] / 255 : null, contacts: contactsOf(frame, b),
  };
}

/** The mean velocity since the frame before [m/s]. */
function velocityOf(frame, before, b) {
  const place = placesIn(frame.bodies, before.bodies)(b), step = frame.time - before.time;
  if (place < 0 || !(step > 0)) return null;
  return [0, 1, 2].map((k) => (coordinate(frame, b, k) - coordinate(before, place, k)) / step);
}

/** The contacts of a body, the strongest first. Forces are those on it [N]. */
function contactsOf({ bodies, contacts }, b) {
  const found = [];
  for (let i = 0; i < contacts.count; ++i) {
    const isFirst = contacts.first[i] === b;
    if (!isFirst && contacts.second[i] !== b) continue;
    const sign = isFirst ? 1 : -1, other = isFirst ? contacts.second[i] : contacts.first[i];
    const force = [0, 1, 2].map((k) => sign * contacts.force[3 * i + k]);
    found.push({ with: bodies.id[other], withKind: bodies.kind[other], withName: bodies.names.get(bodies.id[other]) ?? '', force,
                 size: Math.hypot(...force), status: STATUS[contacts.status[i]] ?? '' });
  }
  return found.sort((a, c) => c.size - a.size);
}

/** The card of the body that was picked. */
export class Card {
  #box;
  #onClose;

  constructor(box, onClose) {
    this.#box = box;
    this.#onClose = onClose;
  }

  hide() { this.#box.hidden = true; }

  /** @param {ReturnType<typeof describeBody>} body null if it is not in this frame */
  show(body, id) {
    this.#box.hidden = false;
    const close = el('button', { type: 'button', class: 'close', 'aria-label': 'Close', click: this.#onClose }, '✕');
    if (!body) {
      this.#box.replaceChildren(close, el('h2', {}, `Body ${id}`), 'It is not there at this time.');
      return;
    }
    const rows = el('dl');
    const row = (label, value) => rows.append(el('div', {}, el('dt', {}, label), el('dd', {}, value)));
    row('Mass', body.isFixed ? 'fixed' : formatMass(body.mass));
    if (body.thickness > 0) row('Thickness', formatLength(body.thickness));
    row('Speed', body.speed === null ? '–' : formatValue(body.speed, 'm_s'));
    if (body.velocity) row('Velocity [m/s]', body.velocity.map((v) => (Math.abs(v) < 5e-4 ? 0 : v).toFixed(3)).join('  '));
    if (body.island > 0) row('Island', `${body.island}${body.residual === null ? '' : `, residual ${formatValue(body.residual, 'm_s')}`}`);
    if (body.damage !== null) row('Largest damage', body.damage.toFixed(2));
    const title = body.name ? `${body.kind} “${body.name}”` : `${body.kind} ${body.id}`;
    this.#box.replaceChildren(close, el('h2', {}, title), rows, contactTable(body.contacts));
  }
}

function contactTable(contacts) {
  if (contacts.length === 0) return el('p', {}, 'It touches nothing now.');
  const name = (c) => c.withName || (c.withKind === BodyKind.floe ? `floe ${c.with}` : `${(KIND[c.withKind] ?? 'body').toLowerCase()} ${c.with}`);
  const table = el('table', {}, el('tr', {}, el('th', {}, `${contacts.length} contact${contacts.length > 1 ? 's' : ''}, with`),
                                   el('th', {}, 'state'), el('th', {}, 'force on it')));
  for (const c of contacts.slice(0, MOST_CONTACTS)) {
    table.append(el('tr', {}, el('td', {}, name(c)), el('td', {}, c.status), el('td', {}, formatValue(c.size, 'N'))));
  }
  if (contacts.length > MOST_CONTACTS) table.append(el('tr', {}, el('td', {}, `and ${contacts.length - MOST_CONTACTS} weaker ones`), el('td'), el('td')));
  return table;
}
