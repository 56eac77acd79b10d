import { ByteReader } from './bytes.js';

export const ShapeType = { floe: 0, fluid: 1, collision: 2 };

/**
 * A surface of polygons in the frame of its body.
 * @typedef {object} Shape
 * @property {number} number
 * @property {number} type one of ShapeType
 * @property {number} parent the shape to which a collision piece belongs, else its own number
 * @property {Float32Array} points x, y, z of each point [m]
 * @property {Uint32Array} counts corners of each polygon
 * @property {Uint32Array} corners indices into the points, polygon by polygon, counter-clockwise from outside
 * @property {number} radius the largest distance of a point from the body's origin [m]
 */

/** The shapes of a piece. @param {Uint8Array} content @returns {Shape[]} */
export function decodeShapes(content) {
  const reader = new ByteReader(content);
  const shapes = [];
  while (!reader.isAtEnd) shapes.push(decodeShape(reader));
  return shapes;
}

function decodeShape(reader) {
  const number = reader.varint(), type = reader.byte(), parent = reader.varint();
  const points = reader.float32Array(3 * reader.varint());
  const counts = reader.varintArray(reader.varint());
  let total = 0;
  for (const count of counts) total += count;
  const corners = reader.varintArray(total);
  for (const corner of corners) {
    if (3 * corner >= points.length) throw new RangeError(`Shape ${number} has a corner without a point.`);
  }
  let radius = 0;
  for (let i = 0; i < points.length; i += 3) radius = Math.max(radius, Math.hypot(points[i], points[i + 1], points[i + 2]));
  return { number, type, parent, points, counts, corners, radius };
}

/** The indices of triangles that fill the polygons: fans, since the polygons are convex. */
export function trianglesOf(shape) {
  const indices = [];
  let at = 0;
  for (const count of shape.counts) {
    for (let k = 2; k < count; ++k) indices.push(shape.corners[at], shape.corners[at + k - 1], shape.corners[at + k]);
    at += count;
  }
  return indices;
}

/** Two polygons whose normals differ less make no edge: cos of 8 degrees. */
const FLAT_COSINE = 0.99;

/** The indices of the edges of a shape, each once. Lines within a flat face are left out. */
export function edgesOf(shape) {
  /** By edge: its ends and the first polygon that has it, then whether it is drawn. */
  const found = new Map(), normals = polygonNormals(shape);
  let at = 0;
  shape.counts.forEach((count, f) => {
    for (let k = 0; k < count; ++k) {
      const a = shape.corners[at + k], b = shape.corners[at + (k + 1) % count];
      const key = Math.min(a, b) * 4294967296 + Math.max(a, b), other = found.get(key);
      if (!other) found.set(key, { a, b, f, isDrawn: true });
      else if (dot(normals, other.f, f) > FLAT_COSINE) other.isDrawn = false;
    }
    at += count;
  });
  const edges = [];
  for (const { a, b, isDrawn } of found.values()) if (isDrawn) edges.push(a, b);
  return edges;
}

const dot = (v, i, k) => v[3 * i] * v[3 * k] + v[3 * i + 1] * v[3 * k + 1] + v[3 * i + 2] * v[3 * k + 2];

/** The unit normals of the polygons, by Newell's sums. */
function polygonNormals({ points, counts, corners }) {
  const normals = new Float64Array(3 * counts.length);
  for (let f = 0, at = 0; f < counts.length; at += counts[f++]) {
    for (let k = 0; k < counts[f]; ++k) {
      const a = 3 * corners[at + k], b = 3 * corners[at + (k + 1) % counts[f]];
      for (let i = 0; i < 3; ++i) {
        const y = (i + 1) % 3, z = (i + 2) % 3;
        normals[3 * f + i] += (points[a + y] - points[b + y]) * (points[a + z] + points[b + z]);
      }
    }
    const size = Math.hypot(...normals.subarray(3 * f, 3 * f + 3)) || 1;
    for (let i = 0; i < 3; ++i) normals[3 * f + i] /= size;
  }
  return normals;
}
