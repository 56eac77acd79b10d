/** A vector turned by a quaternion (w, x, y, z), which need not have unit length. */
export function turned([w, x, y, z], a, b, c) {
  const scale = 2 / (w * w + x * x + y * y + z * z || 1);
  const s = scale * (y * c - z * b), t = scale * (z * a - x * c), u = scale * (x * b - y * a);
  return [a + w * s + y * u - z * t, b + w * t + z * s - x * u, c + w * u + x * t - y * s];
}
