#pragma once
/// Hulls of many kinds as they should lie, in metres: x forward, y port, z up.
#include <functional>
#include <string>
#include <vector>

#include "core/hull/hull.h"
#include "tests/core/mesh/hull_shapes.h"

namespace nilas_test {

using nilas::Vec3;
using nilas::geometry::TriangleMesh;

/// Port side as a grid of points, u from aft to fore and w from keel to deck, each 0 to 1, with its image to starboard,
/// bottom, deck and ends.
inline TriangleMesh lofted(const std::function<Vec3(double, double)>& port, int nu = 40, int nw = 12) {
  const auto at = [&](int i, int j, double side) {
    Vec3 p = port(static_cast<double>(i) / nu, static_cast<double>(j) / nw);
    p.y() = std::abs(p.y()) < 1e-9 ? 0 : side * p.y();
    return p;
  };
  nilas::mesh::SolidBuilder b;
  for (int i = 0; i < nu; ++i) {
    for (int j = 0; j < nw; ++j) {
      b.quad(at(i, j, 1), at(i, j + 1, 1), at(i + 1, j + 1, 1), at(i + 1, j, 1));
      b.quad(at(i, j, -1), at(i + 1, j, -1), at(i + 1, j + 1, -1), at(i, j + 1, -1));
    }
    b.quad(at(i, nw, 1), at(i, nw, -1), at(i + 1, nw, -1), at(i + 1, nw, 1));
    b.quad(at(i, 0, -1), at(i, 0, 1), at(i + 1, 0, 1), at(i + 1, 0, -1));
  }
  for (int j = 0; j < nw; ++j) {
    b.quad(at(0, j, 1), at(0, j, -1), at(0, j + 1, -1), at(0, j + 1, 1));
    b.quad(at(nu, j, -1), at(nu, j, 1), at(nu, j + 1, 1), at(nu, j + 1, -1));
  }
  return b.take();
}

/// Shells side by side or overlapping, as one list of triangles.
inline TriangleMesh together(const std::vector<TriangleMesh>& shells) {
  TriangleMesh all;
  for (const auto& shell : shells) {
    const int first = static_cast<int>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), shell.vertices.begin(), shell.vertices.end());
    for (const auto& t : shell.triangles) all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return all;
}

/// Reduction of the half breadth at height z by a quarter circle of radius `bilge` [m].
inline double bilge_off(double z, double bilge) {
  const double down = std::max(0.0, bilge - z);
  return bilge - std::sqrt(bilge * bilge - down * down);
}

/// Half breadth of a waterline: a run to `transom` (of the beam) over `run` of the length, a bow of a power over `bow`.
inline double line(double u, double transom, double run, double bow, double power) {
  const double aft = std::max(0.0, 1 - u / run), fore = std::max(0.0, 1 - (1 - u) / bow);
  return (1 - (1 - transom) * aft * aft) * (1 - std::pow(fore, power));
}

/// 100 x 20 x 9 m: flat bottom, raked stem, transom.
inline TriangleMesh coaster() {
  return lofted([](double u, double w) {
    const double z = 9 * w, x = u * (92 + 8 * w);
    return Vec3(x, 10 * line(u, 0.55, 0.2, 0.22, 2) - (u < 1 ? std::min(bilge_off(z, 1.5), 9.0 * (1 - u)) : 0), z);
  });
}

/// 180 x 30 x 16 m: a round bow, a stern that is round in plan too.
inline TriangleMesh bulk_carrier() {
  return lofted([](double u, double w) {
    const double fore = std::max(0.0, 1 - (1 - u) / 0.12), aft = std::max(0.0, 1 - u / 0.25);
    const double round = std::sqrt(1 - fore * fore) * std::sqrt(1 - std::pow(aft, 2 + 3 * w));
    return Vec3(180 * u, std::max(0.0, 15 * round - bilge_off(16 * w, 2) * round), 16 * w);
  });
}

/// Both ends alike and sharp: Wigley's parabolic lines.
inline TriangleMesh double_ender() {
  return lofted([](double u, double w) { return Vec3(40 * u, 4 * 4 * u * (1 - u) * (1 - (1 - w) * (1 - w)), 4 * w); });
}

/// 60 x 15 x 4 m, bottom raked at both ends.
inline TriangleMesh raked_barge() {
  return lofted([](double u, double w) {
    const double x = 60 * u, rake = 8 * (1 - w);
    return Vec3(rake + x * (60 - 2 * rake) / 60, 7.5, 4 * w);
  });
}

/// 90 x 24 x 8 m with a flat raked bow over the whole beam and a transom.
inline TriangleMesh pram_icebreaker() {
  return lofted(
      [](double u, double w) { return Vec3(90 * u * (1 - 0.25 * (1 - w)), 12 - bilge_off(8 * w, 1), 8 * w); });
}

/// 12 x 3.6 m: V bottom, transom.
inline TriangleMesh planing_boat() {
  return lofted([](double u, double w) {
    const double b = 1.8 * line(u, 0.9, 0.3, 0.5, 2.2);
    return Vec3(12 * u, b * std::min(1.0, w / 0.5), 1.6 * w + 0.4 * u * u * (1 - w));
  });
}

/// Full body of revolution ahead, a cone astern, a sail on top.
inline TriangleMesh submarine() {
  const TriangleMesh body = lofted([](double u, double w) {
    const double fore = std::max(0.0, 1 - (1 - u) / 0.1), aft = std::max(0.0, 1 - u / 0.35);
    const double r = 4 * std::sqrt(1 - fore * fore) * (1 - aft * aft * aft);
    return Vec3(75 * u, r * std::sin(nilas::k_pi * w), -r * std::cos(nilas::k_pi * w));
  });
  return together({body, nilas::mesh::box_mesh({45, -1, 3}, {55, 1, 8})});
}

inline TriangleMesh catamaran() {
  std::vector<TriangleMesh> shells;
  for (const double y : {-5.0, 5.0})
    shells.push_back(nilas::mesh::shifted(lofted([](double u, double w) {
                                            return Vec3(38 * u, 1.4 * line(u, 0.8, 0.2, 0.45, 2) * std::sqrt(w),
                                                        3.5 * w);
                                          }),
                                          {0, y, 0}));
  shells.push_back(nilas::mesh::box_mesh({1, -6.4, 2.8}, {33, 6.4, 4.5}));
  return together(shells);
}

/// A bulb ahead of the stem, a deckhouse aft.
inline TriangleMesh with_bulb_and_deckhouse() {
  return together({coaster(), nilas::mesh::bulb_mesh({92, 0, 2}, {5, 1.5, 1.8}, 10),
                   nilas::mesh::box_mesh({6, -8, 8.9}, {22, 8, 22})});
}

inline TriangleMesh yacht() {
  const TriangleMesh body = lofted([](double u, double w) {
    return Vec3(11 * u, 1.7 * line(u, 0.6, 0.4, 0.6, 1.8) * std::pow(w, 0.6),
                0.5 * (2 * u - 1) * (2 * u - 1) * (1 - w) + 1.6 * w);
  });
  return together({body, nilas::mesh::box_mesh({4.5, -0.1, -1.5}, {6, 0.1, 0.4})});
}

/// Upright prism over a plan.
inline TriangleMesh prism(const std::vector<nilas::Vec2>& plan, double height) {
  return nilas::mesh::shifted(nilas::geometry::prism_shape(plan, height).surface, {0, 0, 0.5 * height});
}

/// Round, wide at the foot.
inline TriangleMesh cone_foundation(double foot, double head, double height) {
  constexpr int k_sides = 48;
  nilas::mesh::SolidBuilder b;
  const auto at = [&](int k, bool up) {
    const double turn = 2 * nilas::k_pi * (k % k_sides) / k_sides, r = up ? head : foot;
    return Vec3(r * std::cos(turn), r * std::sin(turn), up ? height : 0);
  };
  for (int k = 0; k < k_sides; ++k) {
    b.quad(at(k, false), at(k + 1, false), at(k + 1, true), at(k, true));
    b.triangle({0, 0, height}, at(k, true), at(k + 1, true));
    b.triangle({0, 0, 0}, at(k + 1, false), at(k, false));
  }
  return b.take();
}

inline TriangleMesh semisubmersible() { return together(nilas::mesh::semisubmersible_shells(24)); }

/// A deck as wide as the pontoons are long, no box on top: pontoons and columns alone.
inline TriangleMesh pontoons_and_columns() {
  auto shells = nilas::mesh::semisubmersible_shells(24);
  shells.pop_back();
  return together(shells);
}

inline TriangleMesh port_half(TriangleMesh mesh) {
  for (auto& p : mesh.vertices) p.y() = std::max(0.0, p.y());
  return mesh;
}

inline TriangleMesh generated(const std::string& kind, std::map<std::string, double> parameters = {}) {
  parameters.emplace("triangles", 1500);
  return nilas::hull::generate_hull(nilas::hull::hull_form(kind, parameters)).fluid;
}

}  // namespace nilas_test
