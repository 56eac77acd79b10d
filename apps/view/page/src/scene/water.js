import * as THREE from 'three';
import { COLOURS, LIGHT } from './shading.js';

/** So many components are drawn, the largest first; those too short for the cells of the surface are left out. */
export const MAX_COMPONENTS = 64;
const MOST_CELLS = 180, CELLS_A_WAVE = 12, LEAST_CELLS_A_WAVE = 3;

const VERTEX = /* glsl */`
precision highp float;
uniform int count;
uniform float time;
uniform float level;
uniform vec4 waves[${MAX_COMPONENTS}];
uniform float phases[${MAX_COMPONENTS}];
uniform vec2 centre;
uniform vec2 size;
varying vec3 v_place;
varying vec2 v_share;
void main() {
  vec2 p = centre + position.xy * size;
  float z = level;
  for (int k = 0; k < count; ++k) {
    z += waves[k].x * cos(waves[k].z * p.x + waves[k].w * p.y - waves[k].y * time + phases[k]);
  }
  vec4 world = vec4(p, z, 1.0);
  v_place = world.xyz - cameraPosition;
  v_share = position.xy * 2.0;
  gl_Position = projectionMatrix * viewMatrix * world;
}`;

const FRAGMENT = /* glsl */`
precision highp float;
uniform vec3 colour;
uniform float fades;
varying vec3 v_place;
varying vec2 v_share;
${LIGHT}
void main() {
  vec3 n = face_normal(v_place);
  float edge = fades > 0.5 ? 1.0 - smoothstep(0.55, 1.0, length(v_share)) : 1.0;
  gl_FragColor = vec4(lit(colour, n.z < 0.0 ? -n : n) * 1.08, 0.6 * edge);
}`;

/** The surface of the water with its waves. In a tank it fills the tank, else it follows the vessel and fades away. */
export class Water {
  constructor() {
    this.material = new THREE.ShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, transparent: true, depthWrite: false,
      side: THREE.DoubleSide, uniforms: {
        count: { value: 0 }, time: { value: 0 }, level: { value: 0 }, centre: { value: new THREE.Vector2() },
        size: { value: new THREE.Vector2(1, 1) }, colour: { value: new THREE.Color(COLOURS.water) }, fades: { value: 0 },
        waves: { value: Array.from({ length: MAX_COMPONENTS }, () => new THREE.Vector4()) },
        phases: { value: new Array(MAX_COMPONENTS).fill(0) } } });
    this.object = new THREE.Mesh(new THREE.PlaneGeometry(1, 1, 1, 1), this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 1;
    this.isThere = false;
  }

  /** @param {object} head of the replay @param {number} length of the scene [m] */
  setScene(head, waves, length) {
    const { uniforms } = this.material;
    this.isThere = head.water_level !== null && head.water_level !== undefined;
    uniforms.level.value = head.water_level ?? 0;
    const components = [...(waves?.components ?? [])].sort((a, b) => b[0] - a[0]);
    const cell = this.#setGrid(head.tank, components, length);
    const drawn = components.filter((wave) => wavelength(wave) >= LEAST_CELLS_A_WAVE * cell).slice(0, MAX_COMPONENTS);
    uniforms.count.value = drawn.length;
    drawn.forEach(([amplitude, frequency, kx, ky, phase], k) => {
      uniforms.waves.value[k].set(amplitude, frequency, kx, ky);
      uniforms.phases.value[k] = phase;
    });
  }

  /** Chooses the size of the surface and of its cells by the highest wave. Returns the size of a cell [m]. */
  #setGrid(tank, components, length) {
    const { uniforms } = this.material, wave = components.length > 0 ? wavelength(components[0]) : Infinity;
    const widest = MOST_CELLS / CELLS_A_WAVE * wave, open = Math.min(wave < Infinity ? Math.max(12 * length, 4 * wave) : 40 * length, widest);
    const size = tank ? [tank.length, tank.width] : [open, open];
    const cell = Math.max(wave / CELLS_A_WAVE, Math.max(...size) / MOST_CELLS);
    this.follows = !tank;
    uniforms.fades.value = tank ? 0 : 1;
    uniforms.size.value.set(...size);
    if (tank) uniforms.centre.value.set(tank.length / 2, 0);
    this.object.geometry.dispose();
    this.object.geometry = new THREE.PlaneGeometry(1, 1, ...size.map((s) => wave < Infinity ? Math.ceil(s / cell) : 1));
    return cell;
  }

  update(time, centre) {
    this.material.uniforms.time.value = time;
    if (this.follows) this.material.uniforms.centre.value.set(centre.x, centre.y);
  }
}

/** The length of a component [m]. */
function wavelength([, , kx, ky]) { return 2 * Math.PI / Math.max(Math.hypot(kx, ky), 1e-12); }
