import * as THREE from 'three';
import { toCreasedNormals } from 'three/addons/utils/BufferGeometryUtils.js';
import { ShapeType } from '../data/shapes.js';
import { BodyKind } from '../data/frame.js';
import { indicesOf } from './body_pool.js';
import { withAttributes } from './layer.js';
import { COLOURS, LIGHT, bytesOfColour, edgeMaterial } from './shading.js';

const CREASE_RAD = 0.6, EDGE_ANGLE_DEG = 28;
const SEED_OF_PART_COLOURS = 20260;

const VERTEX = /* glsl */`
precision highp float;
attribute vec3 tint;
varying vec3 v_normal;
varying vec3 v_tint;
varying float v_height;
void main() {
  v_normal = mat3(modelMatrix) * normal;
  v_tint = tint;
  v_height = position.z;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const FRAGMENT = /* glsl */`
precision highp float;
uniform vec3 above;
uniform vec3 below;
uniform float waterline;
uniform float tinted;
uniform float picked;
varying vec3 v_normal;
varying vec3 v_tint;
varying float v_height;
${LIGHT}
void main() {
  vec3 base = tinted > 0.5 ? v_tint : (v_height < waterline ? below : above);
  base = mix(base, vec3(1.0, 0.62, 0.18), 0.45 * picked);
  vec3 n = normalize(gl_FrontFacing ? v_normal : -v_normal);
  gl_FragColor = vec4(lit(base, n), 1.0);
}`;

/** A fixed sequence of pleasant colours, the same on every machine. */
function* partColours() {
  for (let state = SEED_OF_PART_COLOURS;;) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    const colour = new THREE.Color().setHSL(state / 4294967296, 0.45, 0.62);
    yield [255 * colour.r, 255 * colour.g, 255 * colour.b];
  }
}

/** The hull and the vessel's parts: their surface as the water sees it, or the convex pieces that meet the ice. */
export class Vessel {
  object = new THREE.Group();
  #bodies = new Map();
  #recording;

  constructor(recording) { this.#recording = recording; }

  /** Shows the poses of a frame. @param {Float64Array} poses seven numbers a body */
  update(frame, poses) {
    const seen = new Set();
    const { bodies } = frame;
    for (let b = 0; b < bodies.id.length; ++b) {
      if (bodies.kind[b] !== BodyKind.vessel && bodies.kind[b] !== BodyKind.part) continue;
      const drawn = this.#bodyFor(bodies, b, poses);
      if (!drawn) continue;
      seen.add(bodies.id[b]);
      drawn.group.position.fromArray(poses, 7 * b);
      drawn.group.quaternion.fromArray(poses, 7 * b + 3);
      drawn.group.updateMatrixWorld();
    }
    for (const [id, drawn] of this.#bodies) {
      if (seen.has(id)) continue;
      this.object.remove(drawn.group);
      drawn.group.traverse((child) => child.geometry?.dispose());
      this.#bodies.delete(id);
    }
  }

  /** The number of bodies drawn. */
  get count() { return this.#bodies.size; }

  pick(id) {
    for (const [key, drawn] of this.#bodies) for (const m of drawn.materials) m.uniforms.picked.value = key === id ? 1 : 0;
  }

  /** @param {{hull: string, wireframe: boolean, facenormals: boolean}} look */
  setLook(look) {
    this.look = look;
    for (const drawn of this.#bodies.values()) this.#applyLook(drawn);
  }

  #applyLook({ fluid, edges, pieces, normals, materials }) {
    const { hull, wireframe, facenormals } = this.look;
    const showsPieces = hull === 'collision' && pieces;
    fluid.visible = hull !== 'none' && !showsPieces;
    edges.visible = fluid.visible && !wireframe;
    if (pieces) pieces.visible = Boolean(showsPieces);
    normals.visible = facenormals && hull !== 'none';
    for (const material of materials) material.wireframe = wireframe;
  }

  #bodyFor(bodies, b, poses) {
    const id = bodies.id[b], shape = this.#recording.shapes.get(bodies.shape[b]);
    const known = this.#bodies.get(id);
    if (known && known.shape === shape) return known;
    if (!shape) return null;
    const level = this.#recording.head.water_level;
    // Paint ends where still water stands in the first picture.
    const waterline = level === null || level === undefined ? -1e9 : level - poses[7 * b + 2];
    const drawn = this.#make(shape, bodies.kind[b] === BodyKind.part, waterline);
    this.#bodies.set(id, drawn);
    this.object.add(drawn.group);
    if (this.look) this.#applyLook(drawn);
    return drawn;
  }

  #make(shape, isPart, waterline) {
    const group = new THREE.Group(), materials = [];
    const mesh = (geometry, tinted) => {
      const material = new THREE.ShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, side: THREE.DoubleSide, uniforms: {
          above: { value: new THREE.Color(isPart ? COLOURS.part : COLOURS.hull) },
          below: { value: new THREE.Color(COLOURS.hullBelow) },
          waterline: { value: waterline }, tinted: { value: tinted ? 1 : 0 }, picked: { value: 0 } } });
      materials.push(material);
      const object = new THREE.Mesh(geometry, material);
      group.add(object);
      return object;
    };
    const plain = geometryOf([shape], null);
    const fluid = mesh(toCreasedNormals(plain, CREASE_RAD), false);
    const edges = new THREE.LineSegments(new THREE.EdgesGeometry(plain, EDGE_ANGLE_DEG), edgeMaterial(COLOURS.hullEdge, 0.45));
    const normals = new THREE.LineSegments(normalsOf(shape), edgeMaterial(COLOURS.normal, 1));
    group.add(edges, normals);
    const parts = [...this.#recording.shapes.values()].filter((s) => s.type === ShapeType.collision && s.parent === shape.number);
    const pieces = parts.length > 0 ? mesh(geometryOf(parts, partColours()), true) : null;
    if (pieces) pieces.geometry.computeVertexNormals();
    return { shape, group, fluid, edges, pieces, normals, materials };
  }
}

/** Triangles of shapes in one geometry without shared corners; a colour a shape. */
function geometryOf(shapes, colours) {
  const position = [], tint = [];
  for (const shape of shapes) {
    const colour = colours ? colours.next().value : bytesOfColour(COLOURS.hull);
    for (const k of indicesOf(shape).triangles) {
      position.push(shape.points[3 * k], shape.points[3 * k + 1], shape.points[3 * k + 2]);
      tint.push(...colour);
    }
  }
  const geometry = withAttributes(new THREE.BufferGeometry(), { position: [position, 3] });
  geometry.setAttribute('tint', new THREE.BufferAttribute(new Uint8Array(tint), 3, true));
  return geometry;
}

/** A short line out of the middle of each polygon. */
function normalsOf(shape) {
  const position = [], a = new THREE.Vector3(), b = new THREE.Vector3(), sum = new THREE.Vector3(), middle = new THREE.Vector3();
  for (let f = 0, at = 0; f < shape.counts.length; at += shape.counts[f++]) {
    const count = shape.counts[f];
    const corner = (k, to) => to.fromArray(shape.points, 3 * shape.corners[at + k % count]);
    sum.set(0, 0, 0);
    middle.set(0, 0, 0);
    for (let k = 0; k < count; ++k) {
      corner(k, a);
      sum.add(corner(k + 1, b).cross(a).negate());
      middle.add(a.divideScalar(count));
    }
    const tip = sum.clone().normalize().multiplyScalar(0.03 * shape.radius).add(middle);
    position.push(...middle.toArray(), ...tip.toArray());
  }
  return withAttributes(new THREE.BufferGeometry(), { position: [position, 3] });
}
