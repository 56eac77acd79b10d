import * as THREE from 'three';
import { COLOURS, LIGHT } from './shading.js';
import { drawnWaves, middleWaveLength, rampAt } from './waves.js';

/** So many waves are drawn, the highest first; those too short for the cells of the surface are left out. */
export const MOST_WAVES = 64;
const MOST_CELLS = 180, CELLS_A_WAVE = 12, LEAST_CELLS_A_WAVE = 3;

// waves: wave number x and y, amplitude, phase now. cover: the decay of the amplitude across the ice edge, and there.
const VERTEX = /* glsl */`
precision highp float;
uniform int count;
uniform float level;
uniform vec4 waves[${MOST_WAVES}];
uniform vec3 cover[${MOST_WAVES}];
uniform vec2 centre;
uniform vec2 size;
varying vec3 v_place;
varying vec2 v_share;
void main() {
  vec2 p = centre + position.xy * size;
  float z = level;
  for (int k = 0; k < count; ++k) {
    float behind = max(0.0, dot(cover[k].xy, p) - cover[k].z);
    z += waves[k].z * exp(-behind) * cos(waves[k].w - dot(waves[k].xy, p));
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
  // Real slopes hardly change the light, so it falls on steeper ones.
  n = normalize(vec3(4.0 * n.xy, n.z));
  float edge = fades > 0.5 ? 1.0 - smoothstep(0.55, 1.0, length(v_share)) : 1.0;
  gl_FragColor = vec4(lit(colour, n.z < 0.0 ? -n : n) * 1.08, 0.6 * edge);
}`;

/** The surface of the water with its waves. In a tank it fills the tank, else it follows the vessel and fades away. */
export class Water {
  #waves = [];

  constructor() {
    this.material = new THREE.ShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, transparent: true, depthWrite: false,
      side: THREE.DoubleSide, uniforms: {
        count: { value: 0 }, level: { value: 0 }, centre: { value: new THREE.Vector2() },
        size: { value: new THREE.Vector2(1, 1) }, colour: { value: new THREE.Color(COLOURS.water) }, fades: { value: 0 },
        waves: { value: Array.from({ length: MOST_WAVES }, () => new THREE.Vector4()) },
        cover: { value: Array.from({ length: MOST_WAVES }, () => new THREE.Vector3()) } } });
    this.object = new THREE.Mesh(new THREE.PlaneGeometry(1, 1, 1, 1), this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 1;
    this.isThere = false;
  }

  /** The number of waves that are drawn. */
  get numWaves() { return this.#waves.length; }

  /** @param {object} head of the replay @param {{trains: import('./waves.js').Train[]}|null} seas @param {number} length of the scene [m] */
  setScene(head, seas, length) {
    const { uniforms } = this.material;
    this.isThere = head.water_level !== null && head.water_level !== undefined;
    uniforms.level.value = head.water_level ?? 0;
    const cell = this.#setGrid(head.tank, middleWaveLength(seas), length);
    this.#waves = drawnWaves(seas, LEAST_CELLS_A_WAVE * cell, MOST_WAVES);
    uniforms.count.value = this.#waves.length;
    this.#waves.forEach(({ decay, train }, k) => {
      const [x, y] = train.inward.map((c) => decay * c);
      uniforms.cover.value[k].set(x, y, x * train.edge[0] + y * train.edge[1]);
    });
  }

  /** Chooses the size of the surface and of its cells by the length of a middle wave. Returns the size of a cell [m]. */
  #setGrid(tank, wave, length) {
    const { uniforms } = this.material, widest = MOST_CELLS / CELLS_A_WAVE * wave;
    const open = Math.min(wave < Infinity ? Math.max(12 * length, 4 * wave) : 40 * length, widest);
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
    const { uniforms } = this.material;
    this.#waves.forEach(({ amplitude, frequency, number, phase, train }, k) => {
      // The graphics have 24 binary digits, so whole turns are taken off here.
      uniforms.waves.value[k].set(...number, amplitude * rampAt(train, time), (frequency * time + phase) % (2 * Math.PI));
    });
    if (this.follows) uniforms.centre.value.set(centre.x, centre.y);
  }
}
