#pragma once
/// Extent of a mesh.
#include "core/geometry/mesh.h"

namespace nilas::geometry {

/// Box around all vertices, whether triangles use them or not; empty for a mesh without any.
inline Eigen::AlignedBox3d box_of(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& p : mesh.vertices) box.extend(p);
  return box;
}

}  // namespace nilas::geometry
