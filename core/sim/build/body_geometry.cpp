#include "core/sim/build/body_geometry.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/hull/hull.h"

namespace nilas::sim {

namespace {

struct BodyGeometry {
  geometry::Shape shape;
  geometry::MassProperties unit;  ///< mass properties for density 1 kg/m^3, centre of mass in the element's frame
};

/// Shape and mass of a mesh file, which is scaled. The meshes are shifted so that the centre of mass is the origin.
BodyGeometry mesh_geometry(const scene::MeshScene& mesh, double scale) {
  BodyGeometry g;
  hull::Hull hull = hull::read_hull(mesh.file, scale);
  g.unit = geometry::mesh_properties(hull.fluid, 1.0);
  if (mesh.cog) {
    const Vec3 arm = g.unit.com - *mesh.cog;
    g.unit.inertia += g.unit.mass * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
    g.unit.com = *mesh.cog;
  }
  double size = 0;
  for (auto& p : hull.fluid.vertices) size = std::max(size, (p -= g.unit.com).norm());
  std::vector<geometry::ConvexPolytope> parts;
  for (auto& part : hull.parts) {
    for (auto& p : part.vertices) p -= g.unit.com;
    constexpr double k_float_rounding = 1e-5;  // share of the size: STL files hold float32 coordinates
    parts.push_back(geometry::make_polytope(part, k_float_rounding * size));
  }
  g.shape = geometry::mesh_shape(hull.fluid, std::move(parts));
  return g;
}

BodyGeometry geometry(const scene::SolidShape& shape, double file_scale) {
  return std::visit(
      Overloaded{
          [](const scene::BoxScene& box) {
            return BodyGeometry{geometry::box_shape(box.size), geometry::box_properties(box.size, box.size.prod())};
          },
          [](const scene::SphereScene& sphere) {
            const double r = sphere.radius;
            return BodyGeometry{geometry::sphere_shape(r),
                                geometry::sphere_properties(r, 4.0 / 3.0 * k_pi * r * r * r)};
          },
          [](const scene::CylinderScene& cylinder) {
            const double r = cylinder.radius, h = cylinder.height;
            return BodyGeometry{geometry::cylinder_shape(r, h), geometry::cylinder_properties(r, h, k_pi * r * r * h)};
          },
          [&](const scene::MeshScene& mesh) { return mesh_geometry(mesh, file_scale); },
          [](const scene::PlaneScene&) {
            BodyGeometry plane{geometry::plane_shape(), {}};
            plane.unit.mass = 1;
            plane.unit.inertia = Mat3::Identity();
            return plane;
          }},
      shape);
}

}  // namespace

Solid build_solid(const scene::SolidScene& scene, double file_scale) {
  BodyGeometry g = geometry(scene.shape, file_scale);
  NILAS_DEMAND(!scene.mass || !scene.density);
  Solid solid;
  solid.mass = g.unit;
  solid.mass.mass = scene.mass.value_or(scene.density.value_or(scene::SolidScene::k_density) * g.unit.mass);
  solid.mass.inertia = g.unit.inertia * (solid.mass.mass / g.unit.mass);
  if (scene.inertia) {
    const Vec6& i = *scene.inertia;
    solid.mass.inertia << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
  }
  solid.shape = std::make_shared<const geometry::Shape>(std::move(g.shape));
  return solid;
}

Quat attitude_of(const Vec3& yaw_pitch_roll_deg) {
  return Quat(Eigen::AngleAxisd(yaw_pitch_roll_deg[0] * k_deg, Vec3::UnitZ()) *
              Eigen::AngleAxisd(yaw_pitch_roll_deg[1] * k_deg, Vec3::UnitY()) *
              Eigen::AngleAxisd(yaw_pitch_roll_deg[2] * k_deg, Vec3::UnitX()));
}

}  // namespace nilas::sim
