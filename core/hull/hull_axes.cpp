#include "core/hull/hull_axes.h"

#include "core/base/error.h"

namespace nilas::hull {

MeshAxis mesh_axis(const std::string& name) {
  for (int of = 0; of < 3; ++of)
    for (const int sign : {1, -1})
      if (const MeshAxis axis{of, sign}; axis.name() == name) return axis;
  throw InputError("axis: found '" + name + "'; allowed: x, -x, y, -y, z, -z");
}

MeshAxis MeshAxes::port() const {
  NILAS_DEMAND(across());
  const Vec3 port = up.unit().cross(forward.unit());
  const int of = 3 - forward.of - up.of;
  return {of, port[of] < 0 ? -1 : 1};
}

Mat3 MeshAxes::to_vessel() const {
  Mat3 R;
  R << forward.unit().transpose(), port().unit().transpose(), up.unit().transpose();
  return R;
}

geometry::TriangleMesh turned(geometry::TriangleMesh mesh, const MeshAxes& axes) {
  const Mat3 R = axes.to_vessel();
  for (auto& p : mesh.vertices) p = R * p;
  return mesh;
}

}  // namespace nilas::hull
