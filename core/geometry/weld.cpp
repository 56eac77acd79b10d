#include "core/geometry/weld.h"

namespace nilas::geometry {

void Weld::add(const std::array<Vec3, 3>& corners) {
  mesh_.triangles.push_back({vertex(corners[0]), vertex(corners[1]), vertex(corners[2])});
}

int Weld::vertex(const Vec3& p) {
  const std::array<double, 3> key{p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};  // the sum turns -0 into 0
  const auto [found, fresh] = index_.try_emplace(key, static_cast<int>(mesh_.vertices.size()));
  if (fresh) mesh_.vertices.emplace_back(key[0], key[1], key[2]);
  return found->second;
}

}  // namespace nilas::geometry
