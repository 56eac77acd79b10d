#!/usr/bin/env node
/**
 * Makes a replay of a ship that is towed through broken ice. It looks like a run and is none: floes are pushed aside by
 * a formula, and forces are made up.
 *
 * usage: node make_replay.mjs OUT [FLOES] [FRAMES]
 */
import { writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { ReplayWriter } from './replay_writer.mjs';
import { areaAndCentre, centred, cut, polygon, prism, randomNumbers, ship } from './shapes.mjs';

const SHIP = { length: 6, breadth: 1.3, depth: 0.75, draught: 0.35 };
const SHIP_ID = 1, SHIP_SHAPE = 1, FIRST_FLOE_ID = 10, FIRST_FLOE_SHAPE = 20, DENSITY = 920, EVERY = 0.1;
const CHANNELS = [['ice_resistance', 'N', 'load'], ['carriage_fx', 'N', 'load'], ['contact_fz', 'N', 'load'], ['cell1_tared', 'N', 'cell'],
                  ['x', 'm', 'motion'], ['contacts', '', 'solver'], ['kinetic', 'J', 'energy'], ['detection', 'ms', 'time'], ['contact', 'ms', 'time'],
                  ['water', 'ms', 'time'], ['output', 'ms', 'time']];

/** The waves: amplitude, frequency, wave number x, y, phase, decay under ice. */
const WAVES = [[0.012, 4.5, 2.1, 0, 0, 0.01], [0.004, 6.3, 3.6, 1.9, -1, 0.02], [0.003, 7.1, 4.9, -1.5, -2, 0.03]];
const TRAIN = { start: 0, ramp: 0, edge: [6, 0], inward: [1, 0], components: WAVES };

const elevation = (x, y, time) => WAVES.reduce((sum, [a, w, kx, ky, phase, decay]) =>
  sum + a * Math.exp(-decay * Math.max(0, x - TRAIN.edge[0])) * Math.cos(w * time - kx * x - ky * y + phase), 0);

/**
 * The ice of a scene.
 * @param {object} options floes, frames, seed, thickness, speed of the ship, and which things there are
 */
export class Scene {
  constructor(options = {}) {
    Object.assign(this, { floes: 100, frames: 60, seed: 3, thickness: 0.06, speed: 0.6, hasWaves: true, hasLines: true, breaks: true,
                          damage: true, tank: true, keyEvery: 64, ...options });
    this.random = randomNumbers(this.seed);
    this.nextId = FIRST_FLOE_ID;
    this.nextShape = FIRST_FLOE_SHAPE;
    this.writer = new ReplayWriter({ keyEvery: this.keyEvery });
    this.list = [];
    this.#fill();
  }

  /** Floes on a jittered grid in front of the ship. */
  #fill() {
    const cell = 0.55, columns = Math.ceil(Math.sqrt(this.floes * 2.2)), rows = Math.ceil(this.floes / columns);
    this.width = Math.max(rows * cell, 4) + 1;
    this.length = columns * cell + 9;
    this.unit = 0.8e-4 * 0.3;
    for (let k = 0; k < this.floes; ++k) {
      const x = 6.2 + (k % columns) * cell + 0.06 * (this.random() - 0.5), y = (Math.floor(k / columns) - (rows - 1) / 2) * cell + 0.06 * (this.random() - 0.5);
      this.#addFloe(polygon(0.5 * cell * (0.8 + 0.28 * this.random()), this.random), [x, y], 2 * Math.PI * this.random());
    }
  }

  #addFloe(corners, place, angle) {
    const { area } = areaAndCentre(corners), thickness = this.thickness * (0.6 + 0.8 * this.random());
    this.list.push({ id: this.nextId++, shape: this.nextShape++, corners, home: place, angle, thickness, mass: area * thickness * DENSITY,
                     spin: this.random() - 0.5, damage: 0.3 * this.random(), isNew: true });
  }

  head() {
    return {
      program: 'nilas 0.0.0', scene: 'synthetic', step: 0.01, every: EVERY, until: this.frames * EVERY, water_level: 0,
      tank: this.tank ? { length: this.length, width: this.width, depth: 2.2 } : null, view: null, contacts: 'hull', damage: this.damage,
      channels: CHANNELS.map(([name, unit, group]) => ({ name, unit, group })), hull: { length: SHIP.length },
    };
  }

  /** How far a floe is pushed aside by the ship [m], and how fast [m/s], by the way of the bow past it. */
  #push([x, y], bow) {
    const ahead = x - bow, reach = 0.62 - Math.min(Math.abs(y), 3) * 0.16;
    const share = Math.min(Math.max((0.9 - ahead) / 2.2, 0), 1), smooth = share * share * (3 - 2 * share);
    return reach <= 0 ? 0 : Math.sign(y || 1) * reach * smooth;
  }

  /** The bodies at a frame. */
  bodies(i) {
    const time = i * EVERY, x = 2.9 + this.speed * time, heave = 0.01 * Math.sin(1.7 * time), pitch = 0.008 * Math.sin(1.3 * time);
    this.shipX = x;
    const bodies = [{ id: SHIP_ID, kind: 1, shape: SHIP_SHAPE, fixed: false, mass: 1900, name: 'ship', p: [x, 0, heave],
                      q: [Math.cos(pitch / 2), 0, Math.sin(pitch / 2), 0], speed: this.speed, damage: 0 }];
    const bow = x + SHIP.length / 2;
    for (const floe of this.list) {
      const push = this.#push(floe.home, bow), before = this.#push(floe.home, bow - this.speed * EVERY);
      const half = (floe.angle + floe.spin * push) / 2, roll = 0.2 * push * Math.exp(-((floe.home[0] - bow) ** 2)) / 2;
      floe.y = floe.home[1] + push;
      const heaveOfIce = this.hasWaves ? elevation(floe.home[0], floe.y, time) : 0;
      bodies.push({ id: floe.id, kind: 0, shape: floe.shape, fixed: false, thickness: floe.thickness, mass: floe.mass,
                    p: [floe.home[0], floe.y, -0.4 * floe.thickness + heaveOfIce],
                    q: [Math.cos(half) * Math.cos(roll), Math.cos(half) * Math.sin(roll), Math.sin(half) * Math.sin(roll), Math.sin(half) * Math.cos(roll)],
                    speed: Math.abs(push - before) / EVERY, damage: floe.damage });
    }
    return bodies;
  }

  /** Contacts of floes at the bow with the ship, and of pushed floes with their outer neighbours. */
  contacts(bodies) {
    const contacts = [], bow = this.shipX + SHIP.length / 2;
    const moving = bodies.map((body, b) => ({ ...body, b })).filter(({ kind, speed }) => kind === 0 && speed > 0.004);
    for (const { b, p } of moving) {
      const side = Math.sign(p[1] || 1), size = 60 * (0.3 + this.random());
      if (Math.abs(p[1]) < 0.95 && p[0] < bow + 0.3 && p[0] > bow - 2.4) {
        const n = [-0.5, -0.82 * side, 0.28];
        contacts.push({ status: 1 + Math.floor(3 * this.random()), exact: true, stored: true, first: 0, second: b,
                        p: [p[0] - 0.1, p[1] - 0.2 * side, 0], n, force: n.map((x) => size * x) });
      }
      for (const other of moving) {
        const d = [other.p[0] - p[0], other.p[1] - p[1]], gap = Math.hypot(...d);
        if (other.b <= b || gap > 0.5 || gap === 0) continue;
        const n = [-d[0] / gap, -d[1] / gap, 0];
        contacts.push({ status: 1 + Math.floor(2 * this.random()), exact: false, stored: false, first: b, second: other.b,
                        p: [p[0] + d[0] / 2, p[1] + d[1] / 2, 0], n, force: n.map((x) => 0.5 * size * x) });
      }
    }
    for (const { first, second } of contacts) bodies[first].island = bodies[second].island = 1;
    return contacts;
  }

  /** Breaks a floe at the bow into pieces, and lets one piece vanish. */
  #breakFloe() {
    const bow = this.shipX + SHIP.length / 2;
    const k = this.list.findIndex(({ home, y, corners }) => Math.abs(home[0] - bow) < 0.5 && Math.abs(y) < 0.9 && areaAndCentre(corners).area > 0.06);
    if (k < 0) return;
    const [floe] = this.list.splice(k, 1), direction = Math.PI * this.random();
    for (const sign of [1, -1]) {
      const part = cut(floe.corners, [0, 0], [sign * Math.cos(direction), sign * Math.sin(direction)]), { centre } = areaAndCentre(part);
      const [c, s] = [Math.cos(floe.angle), Math.sin(floe.angle)];
      this.#addFloe(centred(part), [floe.home[0] + c * centre[0] - s * centre[1], floe.home[1] + s * centre[0] + c * centre[1]], floe.angle);
    }
    if (this.random() < 0.3) this.list.pop();
  }

  lines() {
    if (!this.hasLines) return [];
    const x = this.shipX, stem = [x + 2.6, 0, 0.45], line = Array.from({ length: 9 }, (_, k) => [x + 2.6 + 0.5 * k, 2 * k / 8, 0.4 - 1.5 * (k / 8) ** 0.6]);
    return [{ kind: 0, name: 'line', force: 40, points: line }, { kind: 1, name: 'rod', force: -12, points: [[x, 0, 0.5], [x, 0, 1.1]] },
            { kind: 2, name: 'azimuth', force: 55, points: [[x - 2.8, 0, -0.25], [x - 1.8, 0.2, -0.25]] },
            { kind: 3, name: 'carriage', force: 90, points: [[x, 0, 1.1], [x + 1, 0, 1.1]] },
            { kind: 5, name: 'path', force: 0, points: [[0, 0, 0.02], [x, 0, 0.02], stem] }];
  }

  channels(bodies, contacts) {
    const sum = (k) => contacts.filter(({ first }) => first === 0).reduce((total, { force }) => total + force[k], 0), fx = -sum(0);
    const about = (x, spread) => [x, x - spread * this.random(), x + spread * this.random()];
    return [about(fx, 40), about(fx + 20, 40), about(sum(2), 10), about(0.2 * fx, 8), about(bodies[0].p[0], 0), about(contacts.length, 0),
            about(340, 2), about(0.8, 0.2), about(1.9 + contacts.length / 20, 0.4), about(1.1, 0.1), about(0.2, 0.1)];
  }

  /** The next frame as the writer takes it. Shapes of floes that came are written before. */
  step(i) {
    if (this.breaks && i > 0 && i % 4 === 0) this.#breakFloe();
    const came = this.list.filter(({ isNew }) => isNew);
    if (came.length > 0) this.writer.shapes(came.map(({ shape, corners, thickness }) => prism(shape, corners, thickness)));
    for (const floe of came) floe.isNew = false;
    const bodies = this.bodies(i), contacts = this.contacts(bodies);
    const frame = { time: i * EVERY, step: 10 * i, stepLength: 0.01, unit: this.unit, bodies, contacts, lines: this.lines(),
                    islands: contacts.length > 0 ? [{ contacts: contacts.length, iterations: 7, residual: 3e-6 }] : [],
                    channels: this.channels(bodies, contacts) };
    return { frame, bytes: this.writer.frame(frame) };
  }
}

/** A whole replay, and its frames as they were before they were packed. */
export function makeReplay(options = {}) {
  const scene = new Scene(options), frames = [];
  scene.writer.head(scene.head());
  if (scene.hasWaves) {
    scene.writer.add('W', { trains: [TRAIN] });
  }
  scene.writer.shapes(ship(SHIP_SHAPE, SHIP));
  for (let i = 0; i < scene.frames; ++i) {
    const { frame } = scene.step(i);
    if (options.keepsFrames !== false) frames.push(frame);
  }
  scene.writer.add('E', { reason: 'The run reached its end.' });
  return { bytes: scene.writer.bytes(), frames, scene };
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [out, floes = '100', frames = '60'] = process.argv.slice(2);
  if (!out) throw new Error('usage: node make_replay.mjs OUT [FLOES] [FRAMES]');
  const { bytes } = makeReplay({ floes: Number(floes), frames: Number(frames), keepsFrames: false });
  writeFileSync(out, bytes);
  console.log(`${out}: ${bytes.length} bytes`);
}
