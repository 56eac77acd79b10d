#include <algorithm>
#include <cmath>

#include "hydro/mesh_water.h"
#include "hydro/wetted.h"

namespace nilas::hydro {

Submerged submerged_mesh(const geometry::TriangleMesh& mesh, const Mat3& R, const Vec3& p, double level) {
  return MeshWater(mesh).submerged(R, p, level);
}

void wetted_faces(const geometry::TriangleMesh& mesh, const Mat3& R, const Vec3& p, double level,
                  std::vector<WettedFace>& out) {
  MeshWater(mesh).for_each_wet_face(water_plane(R, p, level),
                                    [&](double area, const Vec3& centroid, const Vec3& normal) {
                                      if (area > 0) out.push_back({area, p + R * centroid, R * normal});
                                    });
}

}  // namespace nilas::hydro
