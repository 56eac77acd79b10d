import * as THREE from 'three';
import { BodyKind } from '../data/frame.js';
import { BodyPool } from './body_pool.js';
import { Colours } from './colours.js';
import { ContactLayer, actsOnSecond } from './contacts.js';
import { ForceScale } from './force_scale.js';
import { LineLayer } from './lines.js';
import { posesBetween } from './poses.js';
import { extentOf, findVessel } from './extent.js';
import { COLOURS, bytesOfColour } from './shading.js';
import { Tank } from './tank.js';
import { Vessel } from './vessel.js';
import { Water } from './water.js';

/** Everything that is drawn of a frame. */
export class World {
  /** The frame that is drawn. */
  frame = null;
  poses = new Float64Array(0);
  picked = null;
  colours = new Colours();

  /**
   * @param {import('./stage.js').Stage} stage
   * @param {import('../data/recording.js').Recording} recording
   * @param {import('../options.js').Options} options
   */
  constructor(stage, recording, options) {
    this.stage = stage;
    this.recording = recording;
    this.options = options;
    this.floes = new BodyPool(recording.shapes);
    this.walls = new BodyPool(recording.shapes, { opacity: 0.07 });
    this.vessel = new Vessel(recording);
    this.contacts = new ContactLayer();
    this.lines = new LineLayer();
    this.water = new Water();
    this.tank = new Tank();
    this.forceScale = new ForceScale(recording);
    this.extent = { length: 1, centre: new THREE.Vector3(), floeSize: 1 };
    stage.scene.add(...this.floes.objects, ...this.walls.objects, this.vessel.object, this.tank.object, this.water.object,
                    ...this.contacts.objects, ...this.lines.objects);
    this.walls.edgeOpacity = 0.35;
    stage.beforePicture = () => this.#fitToPixels();
    recording.addEventListener('waves', () => this.#setSurroundings());
    recording.addEventListener('head', () => this.#setSurroundings());
  }

  /** Finds the size of the scene from its first frame. */
  setFirst(frame) {
    this.extent = extentOf(this.recording, frame);
    this.stage.camera.setLength(this.extent.length);
    this.#setSurroundings();
  }

  #setSurroundings() {
    if (!this.recording.head) return;
    this.water.setScene(this.recording.head, this.recording.waves, this.extent.length);
    this.tank.setScene(this.recording.head);
    this.applyOptions();
  }

  /** Draws a frame, moved by `share` towards the next one. */
  show(frame, next = null, share = 0) {
    const isOther = this.frame !== frame;
    this.frame = frame;
    this.poses = posesBetween(frame, next, share);
    this.#placeBodies(isOther);
    this.#refreshForces();
    const vessel = this.vesselPose();
    this.water.update(next ? frame.time + share * (next.time - frame.time) : frame.time, vessel.place);
    if (this.options.get('follow')) this.stage.camera.follow(vessel.place);
    this.stage.invalidate();
  }

  #placeBodies(isOther) {
    const { frame, poses } = this, { bodies } = frame;
    if (this.bodies !== bodies) {
      this.bodies = bodies;
      const floes = [], walls = [];
      for (let b = 0; b < bodies.id.length; ++b) {
        if (bodies.kind[b] === BodyKind.wall) walls.push(b);
        else if (bodies.kind[b] === BodyKind.floe || bodies.kind[b] === BodyKind.rigid) floes.push(b);
      }
      this.floes.setBodies(bodies, floes);
      this.walls.setBodies(bodies, walls);
      this.slots = Int32Array.from(bodies.id, (id) => this.floes.slotOf(id) ?? -1);
      this.wallSlots = walls.map((b) => [b, this.walls.slotOf(bodies.id[b])]).filter(([, slot]) => slot !== undefined);
    }
    for (let b = 0; b < bodies.id.length; ++b) if (this.slots[b] >= 0) this.floes.setPose(this.slots[b], poses, 7 * b);
    for (const [b, slot] of this.wallSlots) this.walls.setPose(slot, poses, 7 * b);
    this.floes.posesChanged();
    this.walls.posesChanged();
    this.vessel.update(frame, poses);
    if (isOther) this.recolour();
  }

  /** Gives all bodies their colours. */
  recolour() {
    const { frame } = this;
    if (!frame) return;
    const colourOf = this.colours.of(frame), rigid = bytesOfColour(COLOURS.rigid), picked = bytesOfColour(COLOURS.picked);
    for (let b = 0; b < frame.bodies.id.length; ++b) {
      const slot = this.slots[b];
      if (slot < 0) continue;
      const colour = frame.bodies.id[b] === this.picked ? picked : frame.bodies.kind[b] === BodyKind.rigid ? rigid : colourOf(b);
      this.floes.setColour(slot, colour[0], colour[1], colour[2]);
    }
    for (const [, slot] of this.wallSlots) this.walls.setColour(slot, ...bytesOfColour(COLOURS.wall));
    this.floes.coloursChanged();
    this.walls.coloursChanged();
    this.stage.invalidate();
  }

  #refreshForces() {
    const { options, frame } = this, { length } = this.extent;
    const scale = { length, metresPerNewton: this.forceScale.metresPerNewton(frame, length, options.get('scale')) };
    this.metresPerNewton = scale.metresPerNewton;
    const shown = Object.fromEntries(['contacts', 'normals', 'arrows', 'chains', 'crushed'].map((name) => [name, options.get(name)]));
    this.contacts.update(frame, this.poses, scale, shown);
    this.lines.update(frame.lines, scale, options.get('lines'), this.recording.head.water_level);
  }

  /** Takes over all options that change what is drawn. */
  applyOptions() {
    const { options } = this;
    const isShown = options.get('floes');
    this.floes.faces.visible = isShown;
    this.floes.edges.visible = isShown && options.get('edges');
    for (const object of this.walls.objects) object.visible = options.get('tank');
    this.tank.object.visible = options.get('tank');
    this.water.object.visible = this.water.isThere && options.get('water');
    this.vessel.setLook({ hull: options.get('hull'), wireframe: options.get('wireframe'), facenormals: options.get('facenormals') });
    for (const layer of [...this.contacts.layers, this.lines.arrows, this.lines.dots]) layer.isHidden = !options.get('through');
    this.lines.rods.isHidden = true;
    if (this.frame) this.#refreshForces();
    this.stage.invalidate();
  }

  /** Highlights a body; null for none. */
  pick(id) {
    this.picked = id;
    this.vessel.pick(id);
    this.recolour();
  }

  /** Place, heading and length of the vessel, or of the middle of the scene. */
  vesselPose() {
    const b = this.frame ? findVessel(this.frame.bodies) : -1, { length } = this.extent;
    if (b < 0) return { place: this.extent.centre, headingDeg: 0, length };
    const [x, y, z, w] = this.poses.subarray(7 * b + 3, 7 * b + 7);
    const heading = Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
    return { place: new THREE.Vector3().fromArray(this.poses, 7 * b), headingDeg: heading * 180 / Math.PI, length };
  }

  /** Lines and dots keep their size on the screen; edges of floes fade where floes are small there. */
  #fitToPixels() {
    const { pixel } = this.stage, { camera, controls } = this.stage.camera;
    for (const rods of [this.contacts.normals, this.contacts.arrows, this.contacts.chains, this.lines.rods, this.lines.arrows]) {
      rods.pixel = pixel;
    }
    for (const dots of [this.contacts.points, this.contacts.rings, this.lines.dots]) dots.ratio = this.stage.renderer.getPixelRatio();
    const distance = Math.max(camera.position.distanceTo(controls.target), 1e-9);
    const size = this.extent.floeSize / (pixel * distance);
    this.contacts.placeRings(pixel * distance, [0, 1].map((k) => new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, k).toArray()));
    this.floes.edgeOpacity = Math.min(Math.max((size - 2) / 24, 0.06), 0.85);
  }

  /** What is drawn, for tests and scripts. Forces are those on the body `on` [N]. */
  state() {
    const { frame } = this, { bodies, contacts } = frame;
    const arrows = [];
    for (const i of this.contacts.drawn.slice(0, this.contacts.arrows.count)) {
      const second = actsOnSecond(frame, i), sign = second ? -1 : 1;
      arrows.push({
        on: bodies.id[second ? contacts.second[i] : contacts.first[i]], by: bodies.id[second ? contacts.first[i] : contacts.second[i]],
        position: Array.from(contacts.point.subarray(3 * i, 3 * i + 3)),
        force: Array.from(contacts.force.subarray(3 * i, 3 * i + 3), (f) => sign * f),
        status: contacts.status[i], exact: contacts.exact[i] === 1, stored: contacts.stored[i] === 1,
      });
    }
    return {
      bodies: this.floes.count + this.walls.count + this.vessel.count, bodiesInFrame: bodies.id.length,
      contacts: this.contacts.points.count, contactsInFrame: contacts.count, crushed: this.contacts.crushed.length, rings: this.contacts.rings.count,
      normals: this.contacts.normals.count, chains: this.contacts.chains.count, lines: frame.lines.length, waves: this.water.numWaves, arrows,
      picked: this.picked, legend: this.colours.legend, metresPerNewton: this.metresPerNewton,
    };
  }
}
