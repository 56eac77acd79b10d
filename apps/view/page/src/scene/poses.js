import { readPose } from '../data/frame.js';

/**
 * Position and unit quaternion (x, y, z, w) of all bodies of `frame`, seven numbers each, moved by `share` towards the
 * next frame. A body that is not in the next frame stays.
 * @param {import('../data/frame.js').Frame} frame
 * @param {import('../data/frame.js').Frame|null} next
 * @returns {Float64Array}
 */
export function posesBetween(frame, next, share) {
  const count = frame.bodies.id.length, poses = new Float64Array(7 * count), later = new Float64Array(7);
  const placeOf = next && share > 0 ? placesIn(frame.bodies, next.bodies) : null;
  for (let b = 0; b < count; ++b) {
    const at = 7 * b;
    readPose(frame, b, poses, at);
    const place = placeOf ? placeOf(b) : -1;
    if (place < 0) continue;
    readPose(next, place, later);
    for (let k = 0; k < 3; ++k) poses[at + k] += share * (later[k] - poses[at + k]);
    let along = 0, size = 0;
    for (let k = 3; k < 7; ++k) along += poses[at + k] * later[k];
    const sign = along < 0 ? -1 : 1;
    for (let k = 3; k < 7; ++k) {
      poses[at + k] += share * (sign * later[k] - poses[at + k]);
      size += poses[at + k] ** 2;
    }
    for (let k = 3; k < 7; ++k) poses[at + k] /= Math.sqrt(size);
  }
  return poses;
}

/** A function that gives the place in list `to` of a body of list `from`, -1 if it is not there. */
export function placesIn(from, to) {
  if (from === to) return (b) => b;
  const places = new Map();
  for (let b = 0; b < to.id.length; ++b) places.set(to.id[b], b);
  return (b) => places.get(from.id[b]) ?? -1;
}
