import * as THREE from 'three';
import { Layer, withAttributes } from './layer.js';
import { bytesOfColour } from './shading.js';

/** The least width on the screen [pixels]. */
const LEAST_PIXELS = 1.6;
const SIDES = 6;

const VERTEX = /* glsl */`
precision highp float;
attribute float back;
attribute vec3 start;
attribute vec3 end;
attribute float width;
attribute vec3 tint;
uniform float pixel;
uniform float head;
varying vec3 v_tint;
varying float v_side;
void main() {
  vec3 along = end - start;
  float size = length(along);
  vec3 axis = size > 0.0 ? along / size : vec3(0.0, 0.0, 1.0);
  vec3 across = normalize(abs(axis.z) < 0.9 ? cross(axis, vec3(0.0, 0.0, 1.0)) : cross(axis, vec3(1.0, 0.0, 0.0)));
  vec3 third = cross(axis, across);
  float w = max(width, ${LEAST_PIXELS} * pixel * distance(cameraPosition, end));
  // The head is 5 widths long, but at most half of the arrow.
  float head_length = min(5.0 * w, 0.5 * size) * head;
  float shrink = head > 0.5 ? min(1.0, size / (6.0 * w)) : 1.0;
  float t = position.z * size - back * head_length;
  vec3 world = start + axis * t + shrink * w * (across * position.x + third * position.y);
  v_tint = tint;
  v_side = dot(normalize(across * position.x + third * position.y + 1e-6 * axis), vec3(-0.3, -0.3, 0.9));
  gl_Position = size > 0.0 ? projectionMatrix * viewMatrix * vec4(world, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}`;

const FRAGMENT = /* glsl */`
precision highp float;
varying vec3 v_tint;
varying float v_side;
void main() { gl_FragColor = vec4(v_tint * (0.86 + 0.14 * v_side), 1.0); }`;

const COLUMNS = { start: { Type: Float32Array, size: 3 }, end: { Type: Float32Array, size: 3 }, width: { Type: Float32Array, size: 1 },
                  tint: { Type: Uint8Array, size: 3 } };

/** Many rods, or arrows, in one draw call. Each has a start, an end, a width and a colour. */
export class Rods extends Layer {
  constructor({ arrows = false, order = 0 } = {}) {
    const material = new THREE.ShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, side: THREE.DoubleSide,
      uniforms: { pixel: { value: 0.001 }, head: { value: arrows ? 1 : 0 } } });
    super(new THREE.Mesh(arrows ? arrowGeometry() : rodGeometry(), material), COLUMNS, order);
  }

  /** `pixel`: the size of a pixel at unit distance. */
  set pixel(value) { this.object.material.uniforms.pixel.value = value; }

  add(x0, y0, z0, x1, y1, z1, width, colour) {
    const i = this.addRow(), { values } = this;
    values.start.set([x0, y0, z0], 3 * i);
    values.end.set([x1, y1, z1], 3 * i);
    values.width[i] = width;
    values.tint.set(bytesOfColour(colour), 3 * i);
  }
}

/** Rings of points: (radius, z of 0 start or 1 end, 1 where the head's length is taken off). */
function lathe(rings) {
  const position = [], back = [], index = [];
  for (const [radius, z, isBack] of rings) {
    for (let k = 0; k < SIDES; ++k) {
      const angle = 2 * Math.PI * k / SIDES;
      position.push(radius * Math.cos(angle), radius * Math.sin(angle), z);
      back.push(isBack);
    }
  }
  for (let ring = 0; ring + 1 < rings.length; ++ring) {
    for (let k = 0; k < SIDES; ++k) {
      const a = ring * SIDES + k, b = ring * SIDES + (k + 1) % SIDES;
      index.push(a, b, a + SIDES, b, b + SIDES, a + SIDES);
    }
  }
  const geometry = withAttributes(new THREE.InstancedBufferGeometry(), { position: [position, 3], back: [back, 1] });
  geometry.setIndex(index);
  return geometry;
}

const rodGeometry = () => lathe([[0.5, 0, 0], [0.5, 1, 0]]);
const arrowGeometry = () => lathe([[0.5, 0, 0], [0.5, 1, 1], [1.7, 1, 1], [0, 1, 0]]);
