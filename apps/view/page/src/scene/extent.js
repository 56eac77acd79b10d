import * as THREE from 'three';
import { BodyKind, readPose } from '../data/frame.js';

/** The place of the vessel in the list, -1 without one. */
export function findVessel(bodies) { return bodies.kind.indexOf(BodyKind.vessel); }

/**
 * The length that stands for the scene [m], its middle, and the size of a floe [m]. The length is that of the vessel, else a
 * part of the width over which bodies are spread.
 */
export function extentOf(recording, frame) {
  const box = new THREE.Box3(), pose = new Float64Array(7), place = new THREE.Vector3();
  const radii = [];
  let vesselRadius = 0;
  for (let b = 0; b < frame.bodies.id.length; ++b) {
    const kind = frame.bodies.kind[b], shape = recording.shapes.get(frame.bodies.shape[b]);
    if (!shape || kind === BodyKind.wall) continue;
    readPose(frame, b, pose);
    place.fromArray(pose);
    box.expandByPoint(place.clone().addScalar(shape.radius)).expandByPoint(place.clone().addScalar(-shape.radius));
    if (kind === BodyKind.vessel) vesselRadius = shape.radius;
    else radii.push(shape.radius);
  }
  if (box.isEmpty()) box.set(new THREE.Vector3(-1, -1, -1), new THREE.Vector3(1, 1, 1));
  const size = box.getSize(new THREE.Vector3());
  const length = recording.head.hull?.length || 2 * vesselRadius || 0.35 * Math.hypot(size.x, size.y, size.z);
  radii.sort((a, b) => a - b);
  return { length, centre: box.getCenter(new THREE.Vector3()), floeSize: radii.length > 0 ? 2 * radii[radii.length >> 1] : length };
}
