#pragma once
/// Axes of a mesh, and the rotation of a mesh to frame V.
#include <array>
#include <string>

#include "core/geometry/mesh.h"

namespace nilas::hull {

/// One of a mesh's coordinate axes, in either direction.
struct MeshAxis {
  int of = 0;    ///< 0: x, 1: y, 2: z
  int sign = 1;  ///< 1 or -1

  Vec3 unit() const { return sign * Vec3::Unit(of); }
  /// "x", "-y" ...
  std::string name() const {
    return std::array{"x", "y", "z", "-x", "-y", "-z"}[static_cast<std::size_t>(sign < 0 ? of + 3 : of)];
  }
  bool operator==(const MeshAxis&) const = default;
};

/// The axis of that name. Throws InputError naming what is allowed.
MeshAxis mesh_axis(const std::string& name);

/// The mesh axes that point forward and up; port follows from them. port() and to_vessel() throw ContractError unless
/// across().
struct MeshAxes {
  MeshAxis forward{0, 1}, up{2, 1};

  /// Whether the two axes are perpendicular.
  bool across() const { return forward.of != up.of; }
  MeshAxis port() const;
  /// Matrix from the mesh's coordinates to those of frame V.
  Mat3 to_vessel() const;
  bool operator==(const MeshAxes&) const = default;
};

/// The mesh in frame V. Throws ContractError where forward and up are along one axis.
geometry::TriangleMesh turned(geometry::TriangleMesh mesh, const MeshAxes& axes);

}  // namespace nilas::hull
