/** Surfaces for synthetic replays. */

/** Numbers from 0 to 1, the same for the same seed. */
export function randomNumbers(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 4294967296;
  };
}

/** A convex polygon of about the given radius, counter-clockwise, with its centre at the origin. */
export function polygon(radius, random) {
  const count = 5 + Math.floor(4 * random()), corners = [];
  for (let k = 0; k < count; ++k) {
    const angle = 2 * Math.PI * (k + 0.55 * random()) / count;
    corners.push([radius * Math.cos(angle), radius * Math.sin(angle)]);
  }
  return centred(corners);
}

/** The area and centre of a polygon. */
export function areaAndCentre(corners) {
  let area = 0, x = 0, y = 0;
  corners.forEach(([x0, y0], k) => {
    const [x1, y1] = corners[(k + 1) % corners.length], cross = x0 * y1 - x1 * y0;
    area += cross / 2;
    x += (x0 + x1) * cross / 6;
    y += (y0 + y1) * cross / 6;
  });
  return { area, centre: [x / area, y / area] };
}

export function centred(corners) {
  const { centre } = areaAndCentre(corners);
  return corners.map(([x, y]) => [x - centre[0], y - centre[1]]);
}

/** The part of a convex polygon where n . (x - p) <= 0. */
export function cut(corners, p, n) {
  const kept = [], side = ([x, y]) => n[0] * (x - p[0]) + n[1] * (y - p[1]);
  corners.forEach((a, k) => {
    const b = corners[(k + 1) % corners.length], da = side(a), db = side(b);
    if (da <= 0) kept.push(a);
    if (da * db < 0) kept.push([a[0] + (b[0] - a[0]) * da / (da - db), a[1] + (b[1] - a[1]) * da / (da - db)]);
  });
  return kept;
}

/** A plate: the polygon as a prism. */
export function prism(number, corners, thickness) {
  const n = corners.length, half = thickness / 2;
  const points = [...corners.map(([x, y]) => [x, y, -half]), ...corners.map(([x, y]) => [x, y, half])];
  const polygons = [corners.map((_, k) => n - 1 - k), corners.map((_, k) => n + k)];
  for (let k = 0; k < n; ++k) polygons.push([k, (k + 1) % n, n + (k + 1) % n, n + k]);
  return { number, type: 0, parent: number, points, polygons };
}

/** Half the breadth of a ship at a share of its length (-0.5 stern, 0.5 bow) and of its height (0 keel, 1 deck). */
function halfBreadth(share, height) {
  const full = 1 - Math.max(0, (share - 0.1) / 0.4) ** 2, stern = 1 - Math.max(0, (-share - 0.32) / 0.26) ** 2;
  return full * stern * (0.55 + 0.45 * height ** 0.4);
}

/** Where a section lies [share of the length]: stem and stern are raked. */
const sectionAt = (share, height) => share * (1 - (share > 0 ? 0.3 : 0.12) * (1 - height) * 2 * Math.abs(share));

/** A simple ship: its hull, and boxes along it as collision pieces. z = 0 is the centre of mass. */
export function ship(number, { length, breadth, depth, draught }) {
  const sections = 36, rows = 9, points = [], polygons = [];
  for (let i = 0; i <= sections; ++i) {
    for (let j = 0; j < 2 * rows - 1; ++j) {
      const side = j < rows ? 1 : -1, height = Math.abs(rows - 1 - j) / (rows - 1), share = i / sections - 0.5;
      points.push([sectionAt(share, height) * length, side * halfBreadth(share, height) * breadth / 2, height * depth - draught]);
    }
  }
  const width = 2 * rows - 1;
  for (let i = 0; i < sections; ++i) {
    for (let j = 0; j + 1 < width; ++j) {
      const a = i * width + j;
      polygons.push([a, a + 1, a + width + 1, a + width]);
    }
    polygons.push([i * width, (i + 1) * width, (i + 2) * width - 1, (i + 1) * width - 1]);
  }
  return [{ number, type: 1, parent: number, points, polygons }, ...collisionPieces(number, { length, breadth, depth, draught })];
}

function collisionPieces(parent, { length, breadth, depth, draught }) {
  const count = 9, pieces = [];
  for (let i = 0; i < count; ++i) {
    const ends = [i / count - 0.5, (i + 1) / count - 0.5], points = [];
    for (const height of [0, 1]) {
      for (const share of ends) {
        const half = Math.max(0.02, halfBreadth(share, height)) * breadth / 2;
        const x = sectionAt(share, height) * length, z = height * depth - draught;
        points.push([x, -half, z], [x, half, z]);
      }
    }
    const polygons = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 2, 6, 4], [1, 5, 7, 3], [0, 4, 5, 1], [2, 3, 7, 6]];
    pieces.push({ number: parent + 1 + i, type: 2, parent, points, polygons });
  }
  return pieces;
}
