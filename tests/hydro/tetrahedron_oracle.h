#pragma once
/// An independent computation of the submerged volume. Any closed mesh is the signed sum of the tetrahedra from one
/// point over its triangles. The part of one tetrahedron below a plane is a tetrahedron, a wedge of three, or the
/// complement of one. The oracle uses long double and ground coordinates, and shares no code with hydro/.
#include <algorithm>
#include <array>

#include "core/geometry/mesh.h"

namespace nilas::water_test {

using Long3 = Eigen::Matrix<long double, 3, 1>;

struct LongSolid {
  long double volume = 0;
  Long3 moment = Long3::Zero();  ///< Volume times centre.
  void add(long double weight, const LongSolid& other) {
    volume += weight * other.volume;
    moment += weight * other.moment;
  }
};

inline LongSolid whole(const Long3& a, const Long3& b, const Long3& c, const Long3& d) {
  const long double volume = std::abs((b - a).cross(c - a).dot(d - a)) / 6;
  return {volume, volume / 4 * (a + b + c + d)};
}

/// The part of a tetrahedron below z = 0.
inline LongSolid below(std::array<Long3, 4> p) {
  std::sort(p.begin(), p.end(), [](const Long3& a, const Long3& b) { return a.z() < b.z(); });
  const auto cut = [&](std::size_t i, std::size_t j) -> Long3 {
    return p[i] + p[i].z() / (p[i].z() - p[j].z()) * (p[j] - p[i]);
  };
  LongSolid solid;
  if (p[0].z() >= 0) return solid;
  if (p[3].z() <= 0) return whole(p[0], p[1], p[2], p[3]);
  if (p[1].z() >= 0) return whole(p[0], cut(0, 1), cut(0, 2), cut(0, 3));
  if (p[2].z() < 0) {
    solid = whole(p[0], p[1], p[2], p[3]);
    solid.add(-1, whole(p[3], cut(0, 3), cut(1, 3), cut(2, 3)));
    return solid;
  }
  solid.add(1, whole(p[0], cut(0, 2), cut(0, 3), cut(1, 3)));
  solid.add(1, whole(p[0], cut(0, 2), cut(1, 2), cut(1, 3)));
  solid.add(1, whole(p[0], p[1], cut(1, 2), cut(1, 3)));
  return solid;
}

/// Submerged volume, and moment about the pose's origin.
inline LongSolid submerged_oracle(const geometry::TriangleMesh& mesh, const Mat3& R, const Vec3& p, double level) {
  const Long3 apex = mesh.vertices[0].cast<long double>();
  const auto ground = [&](const Long3& x) -> Long3 {
    return R.cast<long double>() * x + Long3(0, 0, static_cast<long double>(p.z()) - static_cast<long double>(level));
  };
  LongSolid sum;
  for (const auto& t : mesh.triangles) {
    std::array<Long3, 4> corner{apex, apex, apex, apex};
    for (std::size_t k = 0; k < 3; ++k) corner[k] = mesh.vertices[t[k]].cast<long double>();
    const long double sign = (corner[1] - corner[0]).cross(corner[2] - corner[0]).dot(corner[0] - apex) < 0 ? -1 : 1;
    for (auto& x : corner) x = ground(x);
    sum.add(sign, below(corner));
  }
  sum.moment -= sum.volume * Long3(0, 0, static_cast<long double>(p.z()) - static_cast<long double>(level));
  return sum;
}

}  // namespace nilas::water_test
