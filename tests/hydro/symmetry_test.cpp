/// Mirror and frame symmetry of the water forces, on which equal port and starboard sides of a scene depend.
#include <gtest/gtest.h>

#include <algorithm>

#include "hydro/modules.h"
#include "tests/hydro/solids.h"
#include "tests/support/mirrored.h"
#include "tests/support/random_vectors.h"

namespace nilas::water_test {

namespace symmetry_test {

using test::mirrored;
using test::mirrored_axial;

geometry::TriangleMesh mirrored(geometry::TriangleMesh mesh) {
  // The mesh is mirrored, its vertices are numbered in reverse, and every triangle begins at another corner.
  for (auto& x : mesh.vertices) x.y() = -x.y();
  std::reverse(mesh.vertices.begin(), mesh.vertices.end());
  const int last = static_cast<int>(mesh.vertices.size()) - 1;
  std::size_t k = 0;
  for (auto& t : mesh.triangles) {
    t = {last - t[0], last - t[2], last - t[1]};
    std::rotate(t.begin(), t.begin() + k++ % 3, t.end());
  }
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  return mesh;
}

struct Pair {
  bodies::Bodies left, right;
};

Pair mirror_pair(const geometry::Shape& left, const geometry::Shape& right, RandomStream& random) {
  Pair pair;
  const Pose pose{test::random_attitude(random), Vec3(1, 2, 0.4 * random.uniform(-1, 1))};
  add_body(pair.left, left, pose);
  add_body(pair.right, right, {mirrored(pose.q), mirrored(pose.p)});
  pair.left.v_GB[0] = test::random_vector(random);
  pair.left.w_GB[0] = test::random_vector(random);
  pair.right.v_GB[0] = mirrored(pair.left.v_GB[0]);
  pair.right.w_GB[0] = mirrored_axial(pair.left.w_GB[0]);
  return pair;
}

Wrench wrench_on(const bodies::Bodies& bodies, bodies::ForceModule& module) {
  bodies::Wrenches out(1);
  module.add_forces(bodies, 0, out);
  return out[0];
}

/// Mirrored outline or mesh, pose and motion give the mirrored wrench to the last bit, although the sums have the
/// reverse order.
TEST(Symmetry, MirroredFloesAndMeshes) {
  std::vector<std::pair<geometry::Shape, geometry::Shape>> shapes;
  for (const auto& outline : {concave_outline(), forked_outline()})
    shapes.emplace_back(geometry::prism_shape(outline, 0.5), geometry::prism_shape(mirrored(outline, 2), 0.5));
  shapes.emplace_back(geometry::mesh_shape(lofted_hull(), {}), geometry::mesh_shape(mirrored(lofted_hull()), {}));
  // These are their own images.
  shapes.emplace_back(geometry::box_shape({1.2, 0.7, 0.5}), geometry::box_shape({1.2, 0.7, 0.5}));
  shapes.emplace_back(geometry::cylinder_shape(0.4, 0.7), geometry::cylinder_shape(0.4, 0.7));
  hydro::Water water;
  water.current = {0.3, 0, 0};
  const auto buoyancy = hydro::make_buoyancy(water, 1), drag = hydro::make_drag(water, {}, 1, true);
  for (const auto& [left, right] : shapes) {
    RandomStream random(30, std::to_string(left.outline.size()));
    for (int k = 0; k < 100; ++k) {
      const Pair pair = mirror_pair(left, right, random);
      for (bodies::ForceModule* module : {buoyancy.get(), drag.get()}) {
        const Wrench a = wrench_on(pair.left, *module), b = wrench_on(pair.right, *module);
        EXPECT_EQ(mirrored(a.force), b.force);
        EXPECT_EQ(mirrored_axial(a.torque), b.torque);
      }
    }
  }
}

/// Drag on a body that spins about its axis does not depend on the sense of the spin, to the last bit.
TEST(Symmetry, DragOnASpinningCylinderHasNoSense) {
  const auto drag = hydro::make_drag({}, {}, 1, true);
  for (const double lean : {0.0, 0.3}) {
    const auto torque = [&](double rate) {
      bodies::Bodies bodies;
      const Quat q(Eigen::AngleAxisd(lean, Vec3::UnitX()));
      add_body(bodies, geometry::cylinder_shape(0.4, 0.7), {q, {0, 0, 0.1}});
      bodies.w_GB[0] = rate * (q * Vec3::UnitZ());
      return wrench_on(bodies, *drag).torque;
    };
    const Vec3 one = torque(2), other = torque(-2);
    EXPECT_LT(one.z(), 0);
    EXPECT_EQ(one.z(), -other.z());
  }
}

/// A hull that moves in its centre plane has no side force, and no roll or yaw moment.
TEST(Symmetry, SymmetricHullAheadHasNoSideLoads) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::mesh_shape(lofted_hull(), {}), {Quat(Eigen::AngleAxisd(0.02, Vec3::UnitY())), {0, 0, 0}},
           500, bodies::BodyKind::vessel, bodies::Motion::articulated);
  bodies.v_GB[0] = {1, 0, 0.1};
  bodies.w_GB[0] = {0, 0.2, 0};
  for (const auto& module : {hydro::make_buoyancy({}, 1), hydro::make_drag({}, {}, 1, true)}) {
    const Wrench wrench = wrench_on(bodies, *module);
    EXPECT_EQ(wrench.force.y(), 0);
    EXPECT_EQ(wrench.torque.x(), 0);
    EXPECT_EQ(wrench.torque.z(), 0);
  }
}

/// Buoyancy turned about z agrees to 1e-13 relative.
TEST(Symmetry, BuoyancyTurnsWithTheFrame) {
  const auto module = hydro::make_buoyancy({}, 1);
  const Quat turn(Eigen::AngleAxisd(-2.1, Vec3::UnitZ()));
  RandomStream random(31, "turn");
  for (const geometry::Shape& shape :
       {geometry::prism_shape(concave_outline(), 0.6), geometry::mesh_shape(lofted_hull(), {})})
    for (int k = 0; k < 50; ++k) {
      bodies::Bodies bodies;
      add_body(bodies, shape, {test::random_attitude(random), Vec3(1, 2, 0.4 * random.uniform(-1, 1))});
      const Wrench a = wrench_on(bodies, *module);
      bodies.set_pose(0, turn * bodies.p_GB[0], turn * bodies.q_GB[0]);
      const Wrench b = wrench_on(bodies, *module);
      EXPECT_LE((turn * a.force - b.force).norm(), 1e-13 * a.force.norm());
      EXPECT_LE((turn * a.torque - b.torque).norm(), 1e-13 * a.force.norm() * shape.bounding_radius);
    }
}

}  // namespace symmetry_test

}  // namespace nilas::water_test
