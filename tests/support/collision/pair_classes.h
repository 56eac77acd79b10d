#pragma once
/// Classes of pairs of bodies of convex pieces, as test cases for contact search.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/geometry/shape.h"
#include "tests/contact/detect/bodies_of_tests.h"

namespace nilas::pairs {

/// How B comes to A. From any side: both at any attitude, afloat (tilted by up to 0.02) or flat, the latter two from
/// around or from above and below. By a feature of each: faces, edges, a vertex on a face. Or B is A's image in one of
/// A's sides, or lies exactly where A is.
enum class Meeting { any_attitude, afloat, flat, faces, edges, vertex_on_face, mirrored, same_place };

using MakeShape = std::function<geometry::Shape(RandomStream&)>;

struct PairClass {
  const char* name;
  MakeShape a, b;
  Meeting meeting;
  double size;          ///< Size of the smaller body [m].
  double deepest;       ///< Largest overlap and widest gap over the size; both are log-uniform.
  double offset;        ///< Distance of both bodies from the origin in x and in y [m].
  double place = 1e-9;  ///< Largest distance of a contact point from either surface over the size.
};

/// The contact point on a rim is the flat maximum of a search: it is known to the square root of the rounding error.
constexpr double k_place_of_rims = 1e-7;
inline bool has_cylinder(const PairClass& c) { return c.place == k_place_of_rims; }

inline double log_uniform(RandomStream& random, double low, double high) {
  return std::exp(random.uniform(std::log(low), std::log(high)));
}

inline MakeShape plate(double radius, double thickness) {
  return [=](RandomStream& random) { return detect::floe_shape(detect::random_outline(random, radius), thickness); };
}

inline MakeShape box(double size) {
  return [=](RandomStream& random) {
    return geometry::box_shape(size * Vec3(random.uniform(0.2, 1), random.uniform(0.2, 1), random.uniform(0.2, 1)));
  };
}

inline MakeShape cylinder(double size) {
  return [=](RandomStream& random) {
    return geometry::cylinder_shape(size * random.uniform(0.1, 0.5), size * random.uniform(0.2, 1));
  };
}

/// A needle whose length is up to 1e5 times its width.
inline MakeShape needle() {
  return [](RandomStream& random) {
    const double width = log_uniform(random, 1e-5, 1e-2);
    std::vector<Vec2> outline{{-1, -width * random.uniform(0.1, 1)}, {1, -width * random.uniform(0.1, 1)}};
    outline.emplace_back(random.uniform(-0.9, 0.9), width);
    return detect::floe_shape(outline, log_uniform(random, 1e-3, 0.3));
  };
}

/// A plate with a corner that an edge of 1e-9 to 1e-2 radii cuts off.
inline MakeShape plate_with_a_tiny_edge() {
  return [](RandomStream& random) {
    std::vector<Vec2> outline = detect::random_outline(random, 1);
    const double edge = log_uniform(random, 1e-9, 1e-2);
    const Vec2 corner = outline[0];
    const Vec2 before = (outline.back() - corner).normalized(), after = (outline[1] - corner).normalized();
    outline[0] = corner + edge * after;
    outline.push_back(corner + edge * random.uniform(0.3, 1) * before);
    return detect::floe_shape(outline, random.uniform(0.1, 0.5));
  };
}

/// A star of alternating radii: it is concave, and so it has several convex pieces.
inline MakeShape star() {
  return [](RandomStream& random) {
    const int corners = 2 * (3 + static_cast<int>(random.uniform(0, 3)));
    std::vector<Vec2> outline;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * k_pi * (k + random.uniform(-0.2, 0.2)) / corners;
      const double r = k % 2 == 0 ? random.uniform(0.8, 1) : random.uniform(0.3, 0.6);
      outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    return detect::floe_shape(outline, 0.2);
  };
}

/// An ellipsoid of facets, in rings between two poles. With its many long facets it resembles a convex piece of a hull.
inline geometry::ConvexPolytope faceted_ellipsoid(RandomStream& random, const Vec3& half_axes) {
  const int around = 10 + static_cast<int>(random.uniform(0, 15)), rings = 5 + static_cast<int>(random.uniform(0, 8));
  geometry::ConvexPolytope hull;
  std::vector<double> angles;
  for (int k = 0; k < around; ++k) angles.push_back(2 * k_pi * (k + random.uniform(-0.3, 0.3)) / around);
  hull.vertices.emplace_back(-half_axes.x(), 0, 0);
  for (int ring = 1; ring <= rings; ++ring) {
    const double latitude = k_pi * (ring + random.uniform(-0.3, 0.3)) / (rings + 1);
    for (const double angle : angles)
      hull.vertices.push_back(half_axes.cwiseProduct(
          Vec3(-std::cos(latitude), std::sin(latitude) * std::cos(angle), std::sin(latitude) * std::sin(angle))));
  }
  hull.vertices.emplace_back(half_axes.x(), 0, 0);
  const auto at = [around](int ring, int k) { return 1 + ring * around + k % around; };
  const int last = static_cast<int>(hull.vertices.size()) - 1;
  for (int k = 0; k < around; ++k) {
    hull.faces.push_back({0, at(0, k + 1), at(0, k)});
    for (int ring = 0; ring + 1 < rings; ++ring)
      hull.faces.push_back({at(ring, k), at(ring, k + 1), at(ring + 1, k + 1), at(ring + 1, k)});
    hull.faces.push_back({at(rings - 1, k), at(rings - 1, k + 1), last});
  }
  geometry::complete(hull);
  return hull;
}

inline MakeShape hull_part(const Vec3& half_axes) {
  return [=](RandomStream& random) { return geometry::mesh_shape({}, {faceted_ellipsoid(random, half_axes)}); };
}

inline std::vector<PairClass> all_classes() {
  using enum Meeting;
  constexpr double k_shallow = 1e-3;
  const MakeShape block = plate(1, 0.8), floe = plate(1, 0.3), thin = plate(1, 1e-3);
  return {
      {"face_on_face", block, block, faces, 1, k_shallow, 0},
      {"edge_on_edge", block, block, edges, 1, k_shallow, 0},
      {"vertex_on_face", block, block, vertex_on_face, 1, k_shallow, 0},
      {"blocks_any_attitude", block, block, any_attitude, 1, k_shallow, 0},
      {"floes_afloat", floe, floe, afloat, 1, k_shallow, 0},
      {"plates_1000_flat", thin, thin, flat, 1, k_shallow, 0},
      {"plates_1000_afloat", thin, thin, afloat, 1, k_shallow, 0},
      {"plates_1000_any_attitude", thin, thin, any_attitude, 1, k_shallow, 0},
      {"plates_1000_faces", thin, thin, faces, 1, k_shallow, 0},
      {"size_1e-6_m", plate(1e-6, 3e-7), plate(1e-6, 3e-7), afloat, 1e-6, k_shallow, 0},
      {"size_1e-6_m_any_attitude", plate(1e-6, 8e-7), plate(1e-6, 8e-7), any_attitude, 1e-6, k_shallow, 0},
      {"size_1e4_m", plate(1e4, 3e3), plate(1e4, 3e3), afloat, 1e4, k_shallow, 0},
      {"size_1e4_m_plates", plate(1e4, 10), plate(1e4, 10), any_attitude, 1e4, k_shallow, 0},
      {"size_ratio_1e4", plate(1e4, 10), floe, any_attitude, 1, k_shallow, 0},
      {"offset_1e6_m", floe, floe, afloat, 1, k_shallow, 1e6},
      {"offset_1e6_m_any_attitude", block, block, any_attitude, 1, k_shallow, 1e6},
      {"deep", floe, floe, any_attitude, 1, 0.3, 0},
      {"deep_plates", plate(1, 0.01), plate(1, 0.01), afloat, 1, 0.05, 0},
      {"mirrored", floe, floe, mirrored, 1, k_shallow, 0},
      {"same_place", floe, floe, same_place, 1, k_shallow, 0},
      {"needles", needle(), needle(), any_attitude, 1, k_shallow, 0},
      {"needles_afloat", needle(), floe, afloat, 1, k_shallow, 0},
      {"tiny_edges", plate_with_a_tiny_edge(), plate_with_a_tiny_edge(), afloat, 1, k_shallow, 0},
      {"tiny_edges_any_attitude", plate_with_a_tiny_edge(), plate_with_a_tiny_edge(), any_attitude, 1, k_shallow, 0},
      {"hull_and_floe", hull_part({6, 1, 0.8}), plate(1, 0.1), afloat, 1, k_shallow, 0},
      {"hull_and_floe_deep", hull_part({6, 1, 0.8}), plate(1, 0.1), any_attitude, 1, 0.1, 0},
      {"boxes", box(1), box(1), any_attitude, 1, 0.01, 0},
      {"cylinder_and_box", cylinder(1), box(1), any_attitude, 1, 0.01, 0, k_place_of_rims},
      {"cylinder_and_floe", cylinder(1), floe, afloat, 1, 0.01, 0, k_place_of_rims},
      {"cylinders", cylinder(1), cylinder(1), any_attitude, 1, 0.01, 0, k_place_of_rims},
      {"concave_floes", star(), star(), afloat, 1, k_shallow, 0},
  };
}

}  // namespace nilas::pairs
