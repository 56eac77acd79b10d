/** Leaves out marks that would cover each other. */

/**
 * Of the contacts in `list` those that keep a distance from each other, the strongest first. Each of the others has one of
 * them within that distance.
 * @param {{point: Float64Array, force: Float32Array}} contacts
 * @param {number[]} list
 * @param {number} distance [m]
 */
export function spacedContacts({ point, force }, list, distance) {
  if (!(distance > 0)) return list;
  const size = new Map(list.map((i) => [i, Math.hypot(force[3 * i], force[3 * i + 1], force[3 * i + 2])]));
  const cells = new Map(), kept = [];
  const cellOf = (i, k) => Math.floor(point[3 * i + k] / distance);
  const isFree = (i) => {
    const [x, y, z] = [0, 1, 2].map((k) => cellOf(i, k));
    for (let cell = 0; cell < 27; ++cell) {
      for (const j of cells.get(`${x + cell % 3 - 1} ${y + Math.floor(cell / 3) % 3 - 1} ${z + Math.floor(cell / 9) - 1}`) ?? []) {
        if (Math.hypot(point[3 * i] - point[3 * j], point[3 * i + 1] - point[3 * j + 1], point[3 * i + 2] - point[3 * j + 2]) < distance) return false;
      }
    }
    return true;
  };
  for (const i of [...list].sort((a, b) => size.get(b) - size.get(a) || a - b)) {
    if (!isFree(i)) continue;
    kept.push(i);
    const name = [0, 1, 2].map((k) => cellOf(i, k)).join(' ');
    cells.set(name, [...cells.get(name) ?? [], i]);
  }
  return kept;
}
