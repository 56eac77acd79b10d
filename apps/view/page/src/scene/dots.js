import * as THREE from 'three';

const VERTEX = /* glsl */`
precision highp float;
attribute vec3 tint;
attribute float size;
varying vec3 v_tint;
varying float v_size;
uniform float ratio;
void main() {
  v_tint = tint;
  v_size = size;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
  gl_PointSize = size * ratio;
}`;

const FRAGMENT = /* glsl */`
precision highp float;
varying vec3 v_tint;
varying float v_size;
void main() {
  vec2 p = 2.0 * gl_PointCoord - 1.0;
  float r = length(p);
  if (r > 1.0) discard;
  // A white rim keeps dots apart from what lies behind. The large ones are rings.
  bool ring = v_size > 10.0;
  if (ring && r < 0.45) discard;
  gl_FragColor = vec4(r > 0.78 && !ring ? vec3(1.0) : v_tint, 1.0);
}`;

/** Many dots of a size in pixels, in one draw call. Those above 10 pixels are rings. */
export class Dots {
  #capacity = 0;
  count = 0;

  constructor({ order = 0 } = {}) {
    this.object = new THREE.Points(new THREE.BufferGeometry(), new THREE.ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms: { ratio: { value: 1 } } }));
    this.object.frustumCulled = false;
    this.object.renderOrder = order;
    this.#grow(64);
  }

  set isHidden(value) {
    this.object.material.depthTest = value;
    this.object.material.transparent = !value;
  }

  set ratio(value) { this.object.material.uniforms.ratio.value = value; }

  clear() { this.count = 0; }

  add(x, y, z, size, colour) {
    if (this.count === this.#capacity) this.#grow(2 * this.#capacity);
    const i = this.count++;
    this.places.set([x, y, z], 3 * i);
    this.sizes[i] = size;
    this.tints.set([colour >> 16, (colour >> 8) & 255, colour & 255], 3 * i);
  }

  done() {
    const { geometry } = this.object;
    geometry.setDrawRange(0, this.count);
    for (const name of ['position', 'size', 'tint']) geometry.attributes[name].needsUpdate = true;
  }

  #grow(capacity) {
    const grown = (old, Type, size) => {
      const values = new Type(size * capacity);
      if (old) values.set(old);
      return values;
    };
    this.places = grown(this.places, Float32Array, 3);
    this.sizes = grown(this.sizes, Float32Array, 1);
    this.tints = grown(this.tints, Uint8Array, 3);
    this.#capacity = capacity;
    const old = this.object.geometry, geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(this.places, 3));
    geometry.setAttribute('size', new THREE.BufferAttribute(this.sizes, 1));
    geometry.setAttribute('tint', new THREE.BufferAttribute(this.tints, 3, true));
    geometry.setDrawRange(0, this.count);
    this.object.geometry = geometry;
    old.dispose();
  }
}
