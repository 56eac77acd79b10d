import * as THREE from 'three';
import { Layer } from './layer.js';
import { bytesOfColour } from './shading.js';

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
  if (ring && r < 0.7) discard;
  gl_FragColor = vec4(r > 0.78 && !ring ? vec3(1.0) : v_tint, 1.0);
}`;

const COLUMNS = { position: { Type: Float32Array, size: 3 }, size: { Type: Float32Array, size: 1 }, tint: { Type: Uint8Array, size: 3 } };

/** Many dots of a size in pixels, in one draw call. Those above 10 pixels are rings. */
export class Dots extends Layer {
  constructor({ order = 0 } = {}) {
    super(new THREE.Points(new THREE.BufferGeometry(), new THREE.ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms: { ratio: { value: 1 } } })), COLUMNS, order);
  }

  set ratio(value) { this.object.material.uniforms.ratio.value = value; }

  add(x, y, z, size, colour) {
    const i = this.addRow(), { values } = this;
    values.position.set([x, y, z], 3 * i);
    values.size[i] = size;
    values.tint.set(bytesOfColour(colour), 3 * i);
  }
}
