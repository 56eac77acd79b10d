import * as THREE from 'three';
import { LIGHT } from '../scene/shading.js';
import { Stage } from '../scene/stage.js';
import { el } from '../ui/dom.js';
import { loadColour, shareOf } from './load_colour.js';
import { styleOf } from './theme.js';

const BARE = [150, 163, 173], MOST_SPLITS = 7;

/** Splits triangles near loaded cells until their edges are short, so that colours follow the cells. */
function refined({ vertices, triangles, cells, width }) {
  const places = [], heights = cells.map((cell) => cell[4]);
  const low = Math.min(...heights) - 3 * width, high = Math.max(...heights) + 3 * width;
  const middle = (a, b) => a.map((value, i) => (value + b[i]) / 2);
  const length = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  const add = (a, b, c, left) => {
    const zs = [a[2], b[2], c[2]], sides = [length(a, b), length(b, c), length(c, a)], longest = Math.max(...sides);
    if (left === 0 || longest < 1.2 * width || Math.max(...zs) < low || Math.min(...zs) > high) {
      places.push(...a, ...b, ...c);
      return;
    }
    // Halved at the longest side: both parts keep the winding.
    if (longest === sides[0]) {
      const m = middle(a, b);
      add(a, m, c, left - 1);
      add(m, b, c, left - 1);
    } else if (longest === sides[1]) {
      const m = middle(b, c);
      add(a, b, m, left - 1);
      add(a, m, c, left - 1);
    } else {
      const m = middle(c, a);
      add(a, b, m, left - 1);
      add(m, b, c, left - 1);
    }
  };
  const corner = (i) => vertices.slice(3 * i, 3 * i + 3);
  for (let t = 0; t < triangles.length; t += 3) add(corner(triangles[t]), corner(triangles[t + 1]), corner(triangles[t + 2]), 2 * MOST_SPLITS);
  return places;
}

/** The impulse about a place: those of the cells, each spread over its width. */
class Spread {
  constructor({ cells, width }) {
    this.size = 3 * width;
    this.width = width;
    this.bins = new Map();
    for (const [, , x, y, z, impulse] of cells) {
      const key = keyOf(this.#bin(x), this.#bin(y), this.#bin(z));
      if (!this.bins.has(key)) this.bins.set(key, []);
      this.bins.get(key).push([x, y, z, impulse]);
    }
  }

  #bin(value) { return Math.floor(value / this.size); }

  at(x, y, z) {
    const i = this.#bin(x), j = this.#bin(y), k = this.#bin(z);
    let sum = 0;
    for (let n = 0; n < 27; ++n) {
      for (const [cx, cy, cz, impulse] of this.bins.get(keyOf(i + n % 3 - 1, j + Math.floor(n / 3) % 3 - 1, k + Math.floor(n / 9) - 1)) ?? []) {
        const far = ((x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2) / this.width ** 2;
        if (far < 9) sum += impulse * Math.exp(-far);
      }
    }
    return sum;
  }
}

/** One number for a bin. A hull has at most some hundred bins along each axis, so that numbers do not meet. */
function keyOf(i, j, k) { return ((i % 131072 + 65536) * 131072 + (j % 131072 + 65536)) * 131072 + (k % 131072 + 65536); }

/** The light of the viewer on faces of these colours. */
function faceMaterial() {
  return new THREE.ShaderMaterial({ side: THREE.DoubleSide,
    vertexShader: `attribute vec3 tint; varying vec3 v_tint; varying vec3 v_from;
void main() {
  v_tint = tint;
  v_from = position - cameraPosition;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}`,
    fragmentShader: `varying vec3 v_tint; varying vec3 v_from;
${LIGHT}
void main() { gl_FragColor = vec4(lit(v_tint, face_normal(v_from)), 1.0); }` });
}

function colouredMesh(hull) {
  const places = refined(hull), spread = new Spread(hull), values = [];
  for (let i = 0; i < places.length; i += 3) values.push(spread.at(places[i], places[i + 1], places[i + 2]));
  let largest = 0;
  for (const value of values) largest = Math.max(largest, value);
  const tints = new Uint8Array(places.length);
  values.forEach((value, i) => tints.set(shareOf(value, largest) > 0 ? loadColour(value, largest) : BARE, 3 * i));
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(places, 3));
  geometry.setAttribute('tint', new THREE.BufferAttribute(tints, 3, true));
  return new THREE.Mesh(geometry, faceMaterial());
}

/** Distances in lengths of the hull; the share of the picture that the hull may fill; angles of the camera. */
const LEAST_FAR = 0.5, MOST_FAR = 8, FARTHER = 1.05, MARGIN = 0.92, ELEVATION_DEG = 12, ASIDE_DEG = 33;

/** The heading of a camera that has most of the load in sight, a little from the side [deg]. */
function headingToLoad({ cells }, { x, y }) {
  const sum = cells.reduce(([a, b], [, , cx, cy, , impulse]) => [a + impulse * (cx - x), b + impulse * (cy - y)], [0, 0]);
  return 180 + ASIDE_DEG + Math.atan2(sum[1], sum[0]) * 180 / Math.PI;
}

/** The hull in 3-D, coloured by the impulse about each place. */
export class HullStage {
  constructor(box, hull) {
    this.box = box;
    this.stage = new Stage(box);
    const mesh = colouredMesh(hull);
    this.stage.scene.add(mesh);
    mesh.geometry.computeBoundingBox();
    const bounds = mesh.geometry.boundingBox, size = bounds.getSize(new THREE.Vector3());
    this.length = Math.max(size.x, size.y, size.z);
    this.place = bounds.getCenter(new THREE.Vector3());
    this.hull = hull;
    this.headingDeg = headingToLoad(hull, this.place);
    this.stage.camera.setLength(this.length);
    // Until the user turns it, the whole hull is in sight.
    let isMoved = false;
    this.stage.camera.controls.addEventListener('start', () => { isMoved = true; });
    new ResizeObserver(() => { if (!isMoved) this.#showAll(); }).observe(box);
    this.#showAll();
    this.repaint();
  }

  /** Looks at the hull from as near as shows all of it. */
  #showAll() {
    const { stage, length, place, headingDeg, hull: { vertices } } = this, { camera } = stage, corner = new THREE.Vector3();
    const isSeen = () => {
      for (let k = 0; k < vertices.length; k += 3) {
        const { x, y } = corner.fromArray(vertices, k).project(camera.camera);
        if (Math.abs(x) > MARGIN || Math.abs(y) > MARGIN) return false;
      }
      return true;
    };
    stage.resize();
    for (let far = LEAST_FAR; far < MOST_FAR; far *= FARTHER) {
      camera.look(place, headingDeg, ELEVATION_DEG, far * length);
      camera.fit();
      if (isSeen()) break;
    }
    stage.invalidate();
  }

  repaint() {
    this.stage.renderer.setClearColor(styleOf('wash'));
    this.stage.invalidate();
  }

  /** Puts a picture in the place of the canvas, which printers leave empty. */
  freeze() {
    this.thaw();
    this.picture = el('img', { src: this.stage.capture(), alt: 'Impulse by place on the hull' });
    this.box.append(this.picture);
  }

  thaw() {
    this.picture?.remove();
    this.picture = null;
  }
}
