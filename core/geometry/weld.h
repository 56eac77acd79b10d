#pragma once
/// Joins triangles given by their corner points into an indexed mesh.
#include <array>
#include <map>
#include <utility>

#include "core/geometry/mesh.h"

namespace nilas::geometry {

/// Bit-equal points become one vertex (-0 counts as 0); vertices are numbered in order of first appearance.
class Weld {
 public:
  void add(const std::array<Vec3, 3>& corners);
  TriangleMesh take() { return std::move(mesh_); }

 private:
  int vertex(const Vec3& p);

  TriangleMesh mesh_;
  std::map<std::array<double, 3>, int> index_;
};

}  // namespace nilas::geometry
