#pragma once
/// Solids, poses and bodies for the water tests.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/shape.h"
#include "tests/support/about_centroid.h"
#include "tests/support/tetrahedron.h"

namespace nilas::water_test {

struct Solid {
  std::string name;
  geometry::TriangleMesh mesh;
  double size = 1;  ///< Half extent, for the range of heights [m].
};

/// An L-shaped outline about its centroid.
inline std::vector<Vec2> concave_outline() {
  return test::about_centroid({{0, 0}, {4, 0}, {4, 1}, {1.5, 1.5}, {1, 3}, {0, 3}});
}

/// A W-shaped outline: a level cut through its arms leaves three separate wet regions of each cap.
inline std::vector<Vec2> forked_outline() {
  return test::about_centroid({{0, 0}, {5, 0}, {5, 4}, {4, 4}, {3.5, 1}, {3, 4}, {2, 4}, {1.5, 1}, {1, 4}, {0, 4}});
}

/// A ship-like solid, not convex (hollow waterlines forward), exactly symmetric about y = 0. Each station along x is a
/// loop of points from the deck's middle down the port side to the keel and up the starboard side.
inline geometry::TriangleMesh lofted_hull() {
  constexpr int k_stations = 24, k_half = 8, k_loop = 2 * k_half;
  geometry::TriangleMesh mesh;
  for (int i = 0; i < k_stations; ++i) {
    const double s = static_cast<double>(i) / (k_stations - 1);
    const double breadth = 0.05 + 0.55 * std::pow(std::sin(0.5 * k_pi * std::min(1.0, 1.6 * (1 - s))), 2);
    for (int j = 0; j < k_loop; ++j) {
      const int level = std::min(j, k_loop - j);  // 0 deck, k_half keel
      const double side = level == 0 || level == k_half ? 0 : j < k_half ? 1 : -1, angle = k_pi * level / k_half;
      mesh.vertices.emplace_back(6 * s - 3, side * breadth * std::sin(angle), 0.4 * std::cos(angle) + 0.1 * s * s);
    }
  }
  const auto index = [](int i, int j) { return i * k_loop + j % k_loop; };
  const auto add_quad = [&](int i, int j) {
    const int a = index(i, j), b = index(i, j + 1), c = index(i + 1, j + 1), d = index(i + 1, j);
    const bool port = j < k_half;  // The diagonals are mirrored, too.
    mesh.triangles.push_back(port ? std::array{a, b, c} : std::array{a, b, d});
    mesh.triangles.push_back(port ? std::array{a, c, d} : std::array{b, c, d});
  };
  for (int i = 0; i + 1 < k_stations; ++i)
    for (int j = 0; j < k_loop; ++j) add_quad(i, j);
  for (int j = 1; j + 1 < k_loop; ++j) {
    mesh.triangles.push_back({index(0, 0), index(0, j + 1), index(0, j)});
    mesh.triangles.push_back({index(k_stations - 1, 0), index(k_stations - 1, j), index(k_stations - 1, j + 1)});
  }
  if (geometry::find_defects(mesh).inward)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

inline std::vector<Solid> solids() {
  geometry::TriangleMesh plate = geometry::box_shape({10, 8, 0.01}).surface;
  geometry::TriangleMesh far_plate = plate;
  for (auto& x : far_plate.vertices) x += Vec3(1000, -700, 400);
  return {{"box", geometry::box_shape({2, 3, 1}).surface, 1.8},
          {"concave prism", geometry::prism_shape(concave_outline(), 0.4).surface, 2.5},
          {"forked prism", geometry::prism_shape(forked_outline(), 0.4).surface, 3},
          {"tetrahedron", test::tetrahedron({0.1, 0.2, -0.5}, {1, 0, 0.3}, {-0.4, 0.9, 0.2}, {-0.3, -0.8, 0.7}), 1},
          {"hull", lofted_hull(), 2},
          {"thin plate", plate, 4},
          {"thin plate far from its origin", far_plate, 4}};
}

/// A shape of each kind that water acts on.
inline std::vector<geometry::Shape> shapes() {
  return {geometry::prism_shape(concave_outline(), 0.6),
          geometry::prism_shape(forked_outline(), 3),
          geometry::box_shape({2, 1, 0.5}),
          geometry::cylinder_shape(0.6, 1.5),
          geometry::sphere_shape(0.8),
          geometry::mesh_shape(lofted_hull(), {})};
}

/// A body with the mass properties of its surface at the given density (a sphere: its own).
inline int add_body(bodies::Bodies& bodies, const geometry::Shape& shape, const Pose& pose, double density = 900,
                    bodies::BodyKind kind = bodies::BodyKind::rigid, bodies::Motion motion = bodies::Motion::free) {
  bodies::BodySpec spec;
  spec.name = "body";
  spec.kind = kind;
  spec.motion = motion;
  spec.shape = std::make_shared<const geometry::Shape>(shape);
  const geometry::MassProperties properties =
      shape.kind == geometry::ShapeKind::sphere
          ? geometry::sphere_properties(shape.radius, density * 4 / 3 * k_pi * std::pow(shape.radius, 3))
          : geometry::mesh_properties(shape.surface, density);
  spec.mass = properties.mass;
  spec.inertia_B = properties.inertia;
  spec.pose = pose;
  return bodies.add(spec);
}

}  // namespace nilas::water_test
