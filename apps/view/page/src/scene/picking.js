import * as THREE from 'three';
import { indicesOf } from './body_pool.js';

/**
 * The body that a ray meets first, -1 for none.
 * @param {THREE.Ray} ray in the ground frame
 * @param {import('../data/frame.js').Frame} frame
 * @param {Float64Array} poses seven numbers a body
 * @param {Map<number, import('../data/shapes.js').Shape>} shapes
 * @param {(kind: number) => boolean} isShown
 */
export function pickBody(ray, frame, poses, shapes, isShown) {
  const { bodies } = frame, centre = new THREE.Vector3();
  let best = -1, nearest = Infinity;
  for (let b = 0; b < bodies.id.length; ++b) {
    const shape = shapes.get(bodies.shape[b]);
    if (!shape || !isShown(bodies.kind[b])) continue;
    centre.fromArray(poses, 7 * b);
    if (ray.distanceSqToPoint(centre) > shape.radius ** 2) continue;
    const distance = distanceTo(ray, shape, poses, b);
    if (distance < nearest) {
      nearest = distance;
      best = b;
    }
  }
  return best;
}

/** How far along the ray the surface of a body is met; infinite if it is missed. */
function distanceTo(ray, shape, poses, b) {
  const back = new THREE.Quaternion().fromArray(poses, 7 * b + 3).conjugate();
  const local = new THREE.Ray(ray.origin.clone().sub(new THREE.Vector3().fromArray(poses, 7 * b)).applyQuaternion(back),
                              ray.direction.clone().applyQuaternion(back));
  const corners = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()], hit = new THREE.Vector3();
  const { triangles } = indicesOf(shape);
  let nearest = Infinity;
  for (let t = 0; t < triangles.length; t += 3) {
    corners.forEach((corner, k) => corner.fromArray(shape.points, 3 * triangles[t + k]));
    if (local.intersectTriangle(...corners, false, hit)) nearest = Math.min(nearest, hit.distanceTo(local.origin));
  }
  return nearest;
}
