/** Leaves out marks that would cover each other. */

/**
 * Of the contacts in `list` those that keep a distance from each other on the screen, the strongest first. Each of the others
 * has one of them within that distance.
 * @param {{point: Float64Array, force: Float32Array}} contacts
 * @param {number[]} list
 * @param {number} distance [m]
 * @param {number[][]} axes two unit vectors along the screen
 */
export function spacedContacts({ point, force }, list, distance, axes) {
  if (!(distance > 0)) return list;
  const size = new Map(list.map((i) => [i, Math.hypot(force[3 * i], force[3 * i + 1], force[3 * i + 2])]));
  const cells = new Map(), kept = [];
  for (const i of [...list].sort((a, b) => size.get(b) - size.get(a) || a - b)) {
    const [u, v] = axes.map(([x, y, z]) => (x * point[3 * i] + y * point[3 * i + 1] + z * point[3 * i + 2]) / distance);
    const cell = (right, up) => `${Math.floor(u) + right} ${Math.floor(v) + up}`;
    const isCovered = (right, up) => cells.get(cell(right, up))?.some((other) => Math.hypot(u - other[0], v - other[1]) < 1) ?? false;
    if ([-1, 0, 1].some((right) => [-1, 0, 1].some((up) => isCovered(right, up)))) continue;
    kept.push(i);
    cells.set(cell(0, 0), [...cells.get(cell(0, 0)) ?? [], [u, v]]);
  }
  return kept;
}
