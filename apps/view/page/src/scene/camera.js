import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const FIELD_DEG = 32, RADIANS = Math.PI / 180;
/** Heading and elevation [deg] of the named views, against the vessel's heading. */
const NAMED = { bow: [205, 16], stern: [25, 18], side: [90, 4], top: [0, 89.9] };

/** The camera, and how the user moves it. z is up. */
export class Camera {
  constructor(element, onChange) {
    this.camera = new THREE.PerspectiveCamera(FIELD_DEG, 1, 0.1, 1000);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, element);
    this.controls.zoomToCursor = true;
    this.controls.screenSpacePanning = false;
    this.controls.addEventListener('change', onChange);
    this.last = null;
    this.setLength(1);
  }

  /** The size of the scene [m] bounds how near and how far the camera goes. */
  setLength(length) {
    this.length = length;
    this.controls.minDistance = 0.02 * length;
    this.controls.maxDistance = 200 * length;
  }

  resize(width, height) {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  /**
   * Looks at `target` from a distance, in the direction `heading` (from X towards Y), `elevation` above the horizon.
   * An upright picture is narrow, so the camera stands farther off.
   */
  look(target, headingDeg, elevationDeg, distance) {
    const heading = headingDeg * RADIANS, elevation = Math.min(Math.max(elevationDeg, -89.9), 89.9) * RADIANS;
    const far = distance * Math.max(1, 1.25 / Math.max(this.camera.aspect, 0.3));
    this.controls.target.copy(target);
    this.camera.position.set(target.x - far * Math.cos(heading) * Math.cos(elevation),
                             target.y - far * Math.sin(heading) * Math.cos(elevation), target.z + far * Math.sin(elevation));
    this.controls.update();
  }

  /** The view of the scene's <view>, or one of the named ones. `vessel`: {place, headingDeg, length}. */
  show(name, view, vessel) {
    if (name === 'scene' && view) {
      const [x, y, z] = targetOf(view);
      this.look(new THREE.Vector3(x, y, z), Number(view.camera_heading_deg ?? 200), Number(view.camera_elevation_deg ?? 25),
                Number(view.camera_distance ?? 12));
      return;
    }
    const [heading, elevation] = name === 'scene' ? [215, 28] : NAMED[name];
    const wide = name === 'top' ? 3 : name === 'scene' ? 2.6 : 2.2;
    this.look(vessel.place, heading + vessel.headingDeg, elevation, wide * vessel.length);
  }

  /** Moves along with a body that is now at `place`; null ends it. */
  follow(place) {
    if (place && this.last) {
      const step = place.clone().sub(this.last);
      this.camera.position.add(step);
      this.controls.target.add(step);
      this.controls.update();
    }
    this.last = place ? place.clone() : null;
  }

  /** Planes in front and behind that suit the distance. To be called before each picture. */
  fit() {
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = Math.max(0.02 * distance, 1e-4 * this.length);
    this.camera.far = distance + 60 * this.length;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }
}

/** The target as numbers, whether it is a list or a text. */
function targetOf(view) {
  const { target } = view;
  if (Array.isArray(target)) return target.map(Number);
  return String(target ?? '0 0 0').trim().split(/\s+/).map(Number);
}
