import { ContactStatus } from '../data/contacts.js';
import { BodyKind } from '../data/frame.js';
import { Dots } from './dots.js';
import { Rods } from './rods.js';
import { rampColour } from './colours.js';
import { COLOURS } from './shading.js';
import { spacedContacts } from './spaced.js';

const COLOUR_OF_STATUS = [COLOURS.open, COLOURS.stick, COLOURS.slip, COLOURS.crush];
const DOT = 5.5, CRUSH_RING = 15;
/** The camera is elsewhere where it came nearer or went farther by this factor, or where an axis has turned by 5 degrees. */
const OTHER_SCALE = 1.2, OTHER_TURN = Math.cos(5 * Math.PI / 180);
/** The most forces, normals and chains of a frame that are drawn. More cannot be told apart, and take seconds by software. */
const MOST_FORCES = 20000;

/** Contact points, normals, force arrows and force chains of a frame. */
export class ContactLayer {
  points = new Dots({ order: 11 });
  rings = new Dots({ order: 14 });
  normals = new Rods({ order: 12 });
  arrows = new Rods({ arrows: true, order: 13 });
  chains = new Rods({ order: 10 });
  /** The contacts whose forces are drawn, and how many there are. */
  drawn = [];
  count = 0;
  /** The contacts where ice is crushed, if they are marked. */
  crushed = [];
  #contacts = null;
  /** The camera for which rings were chosen. */
  #placedFor = null;

  get objects() { return this.layers.map((layer) => layer.object); }
  get layers() { return [this.points, this.rings, this.normals, this.arrows, this.chains]; }

  /**
   * @param {import('../data/frame.js').Frame} frame
   * @param {Float64Array} poses seven numbers a body
   * @param {{length: number, metresPerNewton: number}} scale
   * @param {Record<string, boolean>} shown which layers are drawn
   */
  update(frame, poses, scale, shown) {
    for (const layer of this.layers) layer.clear();
    const { count, status } = frame.contacts;
    this.#contacts = frame.contacts;
    this.crushed = [];
    this.#placedFor = null;
    for (let i = 0; i < count; ++i) {
      if (shown.contacts) this.#addPoint(frame.contacts, i);
      if (shown.crushed && status[i] === ContactStatus.crush) this.crushed.push(i);
    }
    this.count = count;
    this.drawn = strongest(frame.contacts);
    for (const i of this.drawn) {
      if (shown.normals) this.#addNormal(frame.contacts, i, scale.length);
      if (shown.arrows) this.#addArrow(frame, i, scale);
      if (shown.chains) this.#addChain(frame, poses, i, scale);
    }
    for (const layer of this.layers) layer.done();
  }

  #addPoint({ point, status }, i) {
    this.points.add(point[3 * i], point[3 * i + 1], point[3 * i + 2], DOT, COLOUR_OF_STATUS[status[i]] ?? COLOURS.open);
  }

  /**
   * Marks crushed contacts so that rings do not cover each other on the screen. Rings are chosen anew where the camera has
   * turned or gone nearer by much.
   * @param {number} pixel its size where the camera looks [m]
   * @param {number[][]} axes unit vectors to the right and up on the screen
   */
  placeRings(pixel, axes) {
    if (this.crushed.length === 0) return;
    const distance = CRUSH_RING * pixel, last = this.#placedFor;
    const isTurned = (k) => axes[k].reduce((sum, x, n) => sum + x * last.axes[k][n], 0) < OTHER_TURN;
    if (last && Math.max(distance / last.distance, last.distance / distance) < OTHER_SCALE && ![0, 1].some(isTurned)) return;
    this.#placedFor = { distance, axes };
    this.rings.clear();
    for (const i of spacedContacts(this.#contacts, this.crushed, distance, axes)) {
      this.rings.add(...this.#contacts.point.subarray(3 * i, 3 * i + 3), CRUSH_RING, COLOURS.crush);
    }
    this.rings.done();
  }

  #addNormal({ point, normal }, i, length) {
    const [x, y, z] = [0, 1, 2].map((k) => point[3 * i + k]), size = 0.03 * length;
    this.normals.add(x, y, z, x + size * normal[3 * i], y + size * normal[3 * i + 1], z + size * normal[3 * i + 2], 0, COLOURS.normal);
  }

  /** The tip of an arrow is at the contact, so that it stands outside of the body on which the force acts. */
  #addArrow(frame, i, { metresPerNewton, length }) {
    const { point, force } = frame.contacts, onVessel = isLoad(frame, i);
    const size = metresPerNewton * (actsOnSecond(frame, i) ? -1 : 1);
    const tip = [0, 1, 2].map((k) => point[3 * i + k]), along = [0, 1, 2].map((k) => size * force[3 * i + k]);
    this.arrows.add(tip[0] - along[0], tip[1] - along[1], tip[2] - along[2], ...tip, 0.006 * length,
                    onVessel ? COLOURS.forceOnVessel : COLOURS.forceOnFloe);
  }

  /** A chain joins the centres of floes. At other bodies it ends at the contact. */
  #addChain(frame, poses, i, { metresPerNewton, length }) {
    const { first, second, point, force } = frame.contacts;
    const size = Math.hypot(force[3 * i], force[3 * i + 1], force[3 * i + 2]) * metresPerNewton / (0.45 * length);
    if (!(size > 0)) return;
    const end = (b) => frame.bodies.kind[b] === BodyKind.floe ? poses.subarray(7 * b, 7 * b + 3) : point.subarray(3 * i, 3 * i + 3);
    const colour = rampColour(1 + Math.log10(size) / 3, [0, 0, 0]);
    const width = 0.02 * length * Math.min(1, Math.sqrt(size));
    this.chains.add(...end(first[i]), ...end(second[i]), width, (colour[0] << 16) | (colour[1] << 8) | colour[2]);
  }
}

/** The contacts of the largest forces, in the order of the frame; all where they are not too many. */
function strongest({ count, force }) {
  const all = Array.from({ length: count }, (_, i) => i);
  if (count <= MOST_FORCES) return all;
  const size = all.map((i) => Math.hypot(force[3 * i], force[3 * i + 1], force[3 * i + 2]));
  return all.sort((i, j) => size[j] - size[i] || i - j).slice(0, MOST_FORCES).sort((i, j) => i - j);
}

const isVessel = (kind) => kind === BodyKind.vessel || kind === BodyKind.part;

/** Whether the contact loads the vessel or a body that the scene holds. */
function isLoad({ bodies, contacts }, i) {
  return [contacts.first[i], contacts.second[i]].some((b) => isVessel(bodies.kind[b]) || bodies.fixed[b]);
}

/** Arrows show the force on the vessel, else on a fixed body, else on the first body. */
export function actsOnSecond({ bodies, contacts }, i) {
  const rank = (b) => isVessel(bodies.kind[b]) ? 2 : bodies.fixed[b] ? 1 : 0;
  return rank(contacts.second[i]) > rank(contacts.first[i]);
}
