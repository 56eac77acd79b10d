import * as THREE from 'three';
import { edgesOf, trianglesOf } from '../data/shapes.js';
import { COLOURS, EDGES_NEARER, LIGHT, TURN } from './shading.js';

/** Texels in a row of the textures. */
const ROW = 1024;
const SPARE = 1.5;

const VERTEX = /* glsl */`
precision highp float;
precision highp int;
uniform highp sampler2D poses;
uniform sampler2D colours;
uniform float nearer;
attribute float slot;
varying vec3 v_place;
varying vec4 v_colour;
${TURN}
void main() {
  int s = int(slot + 0.5);
  ivec2 texel = ivec2((2 * s) % ${ROW}, (2 * s) / ${ROW});
  vec4 place = texelFetch(poses, texel, 0);
  vec4 q = texelFetch(poses, texel + ivec2(1, 0), 0);
  v_colour = texelFetch(colours, ivec2(s % ${ROW}, s / ${ROW}), 0);
  vec3 world = place.xyz + turned(q, position);
  v_place = world - cameraPosition;
  // A body that went lies outside of the picture.
  vec3 view = (viewMatrix * vec4(world, 1.0)).xyz;
  gl_Position = place.w > 0.5 ? projectionMatrix * vec4(nearer * view, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}`;

const FILL = /* glsl */`
precision highp float;
uniform float opacity;
varying vec3 v_place;
varying vec4 v_colour;
${LIGHT}
void main() { gl_FragColor = vec4(lit(v_colour.rgb, face_normal(v_place)), opacity); }`;

const EDGE = /* glsl */`
precision highp float;
uniform vec3 colour;
uniform float opacity;
void main() { gl_FragColor = vec4(colour, opacity); }`;

/**
 * Many bodies in two draw calls, one of faces and one of edges. All vertices lie in one buffer, each with the slot of
 * its body; a texture has the pose of each slot. A body that comes takes new vertices and a new slot, one that goes is
 * hidden. When half of the vertices are hidden, the buffer is packed anew.
 */
export class BodyPool {
  #slots = new Map();
  #shapes;
  #used = { vertices: 0, indices: 0, edges: 0, slots: 0 };
  #deadVertices = 0;

  /** @param {Map<number, import('../data/shapes.js').Shape>} shapes */
  constructor(shapes, { opacity = 1 } = {}) {
    this.#shapes = shapes;
    const uniforms = { poses: { value: null }, colours: { value: null }, opacity: { value: opacity }, nearer: { value: 1 } };
    const edgeUniforms = { ...uniforms, nearer: { value: EDGES_NEARER }, opacity: { value: 0.8 }, colour: { value: new THREE.Color(COLOURS.iceEdge) } };
    this.faces = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FILL, uniforms, transparent: opacity < 1, depthWrite: opacity === 1 }));
    this.edges = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: EDGE, uniforms: edgeUniforms, transparent: true, depthWrite: false }));
    this.faces.frustumCulled = this.edges.frustumCulled = false;
    this.#allocate(1024, 6144, 4096, 64);
  }

  get count() { return this.#slots.size; }
  get objects() { return [this.faces, this.edges]; }
  set edgeOpacity(value) { this.edges.material.uniforms.opacity.value = value; }

  /**
   * Takes over which bodies there are.
   * @param {import('../data/frame.js').BodyList} bodies
   * @param {number[]} members the places of those that belong to this pool
   */
  setBodies(bodies, members) {
    const wanted = new Set();
    for (const b of members) if (this.#shapes.has(bodies.shape[b])) wanted.add(bodies.id[b]);
    for (const [id, body] of this.#slots) if (!wanted.has(id)) this.#remove(id, body);
    const came = [];
    for (const b of members) {
      const shape = this.#shapes.get(bodies.shape[b]), id = bodies.id[b];
      if (!shape) continue;
      const known = this.#slots.get(id);
      if (known && known.shape === shape) continue;
      if (known) this.#remove(id, known);
      came.push([id, shape]);
    }
    if (came.length > 0) this.#addAll(came);
  }

  /** The slot of a body; undefined if it is not here. */
  slotOf(id) { return this.#slots.get(id)?.slot; }

  /** Sets position and turn (x, y, z, w) of a slot from `pose`, at `at`. */
  setPose(slot, pose, at = 0) {
    const to = 8 * slot, { poses } = this;
    poses[to] = pose[at];
    poses[to + 1] = pose[at + 1];
    poses[to + 2] = pose[at + 2];
    poses[to + 3] = 1;
    for (let k = 0; k < 4; ++k) poses[to + 4 + k] = pose[at + 3 + k];
  }

  setColour(slot, red, green, blue) {
    const to = 4 * slot, { colours } = this;
    colours[to] = red;
    colours[to + 1] = green;
    colours[to + 2] = blue;
    colours[to + 3] = 255;
  }

  posesChanged() { this.#poseTexture.needsUpdate = true; }
  coloursChanged() { this.#colourTexture.needsUpdate = true; }

  #poseTexture;
  #colourTexture;

  #remove(id, body) {
    this.#slots.delete(id);
    this.poses[8 * body.slot + 3] = 0;
    this.#deadVertices += body.shape.points.length / 3;
    this.posesChanged();
  }

  #addAll(came) {
    const need = { vertices: 0, indices: 0, edges: 0, slots: came.length };
    for (const [, shape] of came) {
      const { triangles, edges } = indicesOf(shape);
      need.vertices += shape.points.length / 3;
      need.indices += triangles.length;
      need.edges += edges.length;
    }
    const used = this.#used, fits = used.vertices + need.vertices <= this.slot.length && used.slots + need.slots <= this.maxSlots &&
      used.indices + need.indices <= this.index.length && used.edges + need.edges <= this.edgeIndex.length;
    if (!fits || this.#deadVertices > 0.5 * used.vertices + 2000) this.#pack(need);
    for (const [id, shape] of came) this.#append(id, shape);
    this.#upload();
  }

  /** Writes all bodies anew into buffers that have room for `need` more. */
  #pack(need) {
    const old = [...this.#slots], poses = this.poses, colours = this.colours;
    const total = { ...need };
    for (const [, { shape }] of old) {
      const { triangles, edges } = indicesOf(shape);
      total.vertices += shape.points.length / 3;
      total.indices += triangles.length;
      total.edges += edges.length;
      total.slots += 1;
    }
    this.#allocate(...[total.vertices, total.indices, total.edges, total.slots].map((n) => Math.ceil(SPARE * n) + 64));
    for (const [id, body] of old) {
      const slot = this.#append(id, body.shape);
      this.poses.set(poses.subarray(8 * body.slot, 8 * body.slot + 8), 8 * slot);
      this.colours.set(colours.subarray(4 * body.slot, 4 * body.slot + 4), 4 * slot);
    }
  }

  #append(id, shape) {
    const used = this.#used, { triangles, edges } = indicesOf(shape), slot = used.slots++, base = used.vertices;
    const count = shape.points.length / 3;
    this.position.set(shape.points, 3 * base);
    this.slot.fill(slot, base, base + count);
    for (let k = 0; k < triangles.length; ++k) this.index[used.indices + k] = base + triangles[k];
    for (let k = 0; k < edges.length; ++k) this.edgeIndex[used.edges + k] = base + edges[k];
    used.vertices += count;
    used.indices += triangles.length;
    used.edges += edges.length;
    this.#slots.set(id, { slot, shape });
    return slot;
  }

  #upload() {
    const from = this.#uploaded, used = this.#used;
    const changed = (attribute, start, end) => {
      attribute.addUpdateRange(start, end - start);
      attribute.needsUpdate = true;
    };
    const { position, slot } = this.faces.geometry.attributes;
    changed(position, 3 * from.vertices, 3 * used.vertices);
    changed(slot, from.vertices, used.vertices);
    changed(this.faces.geometry.index, from.indices, used.indices);
    changed(this.edges.geometry.index, from.edges, used.edges);
    this.faces.geometry.setDrawRange(0, used.indices);
    this.edges.geometry.setDrawRange(0, used.edges);
    this.#uploaded = { ...used };
    this.posesChanged();
    this.coloursChanged();
  }

  #uploaded = { ...this.#used };

  #allocate(vertices, indices, edges, slots) {
    this.#slots.clear();
    this.#used = { vertices: 0, indices: 0, edges: 0, slots: 0 };
    this.#uploaded = { ...this.#used };
    this.#deadVertices = 0;
    this.position = new Float32Array(3 * vertices);
    this.slot = new Float32Array(vertices);
    this.index = new Uint32Array(indices);
    this.edgeIndex = new Uint32Array(edges);
    const position = new THREE.BufferAttribute(this.position, 3), slot = new THREE.BufferAttribute(this.slot, 1);
    for (const [object, index] of [[this.faces, this.index], [this.edges, this.edgeIndex]]) {
      object.geometry.dispose();
      object.geometry = new THREE.BufferGeometry();
      object.geometry.setAttribute('position', position);
      object.geometry.setAttribute('slot', slot);
      object.geometry.setIndex(new THREE.BufferAttribute(index, 1));
      object.geometry.setDrawRange(0, 0);
    }
    this.#allocateTextures(slots);
  }

  #allocateTextures(slots) {
    const poseRows = Math.ceil(2 * slots / ROW), colourRows = Math.ceil(slots / ROW);
    this.maxSlots = slots;
    this.poses = new Float32Array(4 * ROW * poseRows);
    this.colours = new Uint8Array(4 * ROW * colourRows);
    this.#poseTexture?.dispose();
    this.#colourTexture?.dispose();
    this.#poseTexture = new THREE.DataTexture(this.poses, ROW, poseRows, THREE.RGBAFormat, THREE.FloatType);
    this.#colourTexture = new THREE.DataTexture(this.colours, ROW, colourRows, THREE.RGBAFormat, THREE.UnsignedByteType);
    for (const object of [this.faces, this.edges]) {
      object.material.uniforms.poses.value = this.#poseTexture;
      object.material.uniforms.colours.value = this.#colourTexture;
    }
    this.posesChanged();
    this.coloursChanged();
  }
}

const indicesCache = new WeakMap();

/** The triangles and edges of a shape, found once. */
export function indicesOf(shape) {
  let found = indicesCache.get(shape);
  if (!found) {
    found = { triangles: trianglesOf(shape), edges: edgesOf(shape) };
    indicesCache.set(shape, found);
  }
  return found;
}
