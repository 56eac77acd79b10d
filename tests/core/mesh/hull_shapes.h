#pragma once
/// Hull-like solids with known volumes, sound and broken, in metres: x forward, y port, z up.
#include <cmath>
#include <functional>

#include "core/geometry/mesh.h"
#include "core/geometry/shape.h"
#include "core/geometry/weld.h"
#include "core/mesh/mend/polygon_soup.h"

namespace nilas::mesh {

/// Collects triangles and quadrilaterals; those that have collapsed are left out.
class SolidBuilder {
 public:
  void triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    if (a != b && b != c && c != a) weld_.add({a, b, c});
  }
  /// Cut along a-c.
  void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }
  geometry::TriangleMesh take() { return weld_.take(); }

 private:
  geometry::Weld weld_;
};

inline geometry::TriangleMesh shifted(geometry::TriangleMesh mesh, const Vec3& by) {
  for (auto& p : mesh.vertices) p += by;
  return mesh;
}

inline geometry::TriangleMesh box_mesh(const Vec3& low, const Vec3& high) {
  return shifted(geometry::box_shape(high - low).surface, 0.5 * (low + high));
}

/// Upright prism with n sides around the axis through `foot`.
inline geometry::TriangleMesh column_mesh(const Vec3& foot, double radius, double height, int n) {
  std::vector<Vec2> outline;
  for (int k = 0; k < n; ++k)
    outline.emplace_back(radius * std::cos(2 * k_pi * k / n), radius * std::sin(2 * k_pi * k / n));
  return shifted(geometry::prism_shape(outline, height).surface, foot + Vec3(0, 0, 0.5 * height));
}
inline double column_area(double radius, int n) { return 0.5 * n * radius * radius * std::sin(2 * k_pi / n); }

/// Upright sides that meet in a stem: x from 0 to 3, the bow from 2 on.
inline geometry::TriangleMesh wedge_mesh() {
  return shifted(geometry::prism_shape({{0, -0.5}, {2, -0.5}, {3, 0}, {2, 0.5}, {0, 0.5}}, 0.6).surface, {0, 0, 0.3});
}
constexpr double k_wedge_volume = (2.0 + 0.5) * 0.6;

/// Point down at the origin; n sides.
inline geometry::TriangleMesh cone_mesh(double radius, double height, int n) {
  SolidBuilder b;
  for (int k = 0; k < n; ++k) {
    const auto rim = [&](int i) {
      const double angle = 2 * k_pi * (i % n) / n;
      return Vec3(radius * std::cos(angle), radius * std::sin(angle), height);
    };
    b.triangle(Vec3::Zero(), rim(k + 1), rim(k));
    b.triangle({0, 0, height}, rim(k), rim(k + 1));
  }
  return b.take();
}

/// A barge with a rectangular well through it.
inline geometry::TriangleMesh moonpool_mesh() {
  const std::vector<Vec2> out{{0, -0.5}, {4, -0.5}, {4, 0.5}, {0, 0.5}},
      in{{1.5, -0.25}, {2.5, -0.25}, {2.5, 0.25}, {1.5, 0.25}};
  SolidBuilder b;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto at = [](const Vec2& p, double z) { return Vec3(p.x(), p.y(), z); };
    const Vec2 &o = out[k], &p = out[(k + 1) % 4], &i = in[k], &j = in[(k + 1) % 4];
    b.quad(at(o, 0), at(p, 0), at(p, 0.6), at(o, 0.6));
    b.quad(at(i, 0), at(i, 0.6), at(j, 0.6), at(j, 0));
    b.quad(at(o, 0.6), at(p, 0.6), at(j, 0.6), at(i, 0.6));
    b.quad(at(o, 0), at(i, 0), at(j, 0), at(p, 0));
  }
  return b.take();
}
constexpr double k_moonpool_volume = (4.0 * 1.0 - 1.0 * 0.5) * 0.6;

/// Half breadth of a ship of 6 m by 1.2 m by 0.6 m with hollow entrance and flared bow.
inline double ship_half_breadth(double x, double z) {
  constexpr double k_length = 6, k_half_beam = 0.6, k_depth = 0.6, k_shoulder = 3.4, k_run = 1.2, k_transom = 0.7;
  const double t = std::clamp((x - k_shoulder) / (k_length - k_shoulder), 0.0, 1.0);
  const double aft = std::clamp(1 - x / k_run, 0.0, 1.0);
  const double line = std::pow(1 - t * t, 1.5) * (1 - (1 - k_transom) * aft * aft);
  const double power = 0.25 + 1.2 * t * t;  // of the section: full amidships, flared and hollow forward
  return k_half_beam * line * std::pow(z / k_depth, power);
}

/// 4 nx nz + 2 nx + 2 nz triangles, less the collapsed ones at keel and stem; mirror-symmetric to the bit.
inline geometry::TriangleMesh ship_mesh(int nx, int nz) {
  constexpr double k_length = 6, k_depth = 0.6;
  const auto at = [&](int i, int j, double side) {
    const double x = k_length * i / nx, share = static_cast<double>(j) / nz, z = k_depth * share * share;
    return Vec3(x, i == nx || j == 0 ? 0 : side * ship_half_breadth(x, z), z);
  };
  SolidBuilder b;
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < nz; ++j) {
      if (i + 1 == nx && j == 0) {  // the forefoot: the rest of the cell lies in the centre plane
        b.triangle(at(i, 0, 1), at(i, 1, 1), at(nx, 1, 1));
        b.triangle(at(i, 0, -1), at(nx, 1, -1), at(i, 1, -1));
        continue;
      }
      b.quad(at(i, j, 1), at(i, j + 1, 1), at(i + 1, j + 1, 1), at(i + 1, j, 1));
      b.quad(at(i, j, -1), at(i + 1, j, -1), at(i + 1, j + 1, -1), at(i, j + 1, -1));
    }
    b.quad(at(i, nz, 1), at(i, nz, -1), at(i + 1, nz, -1), at(i + 1, nz, 1));
  }
  for (int j = 0; j < nz; ++j) b.quad(at(0, j, 1), at(0, j, -1), at(0, j + 1, -1), at(0, j + 1, 1));
  return b.take();
}

/// Ellipsoid about a centre, n rings of 2n facets.
inline geometry::TriangleMesh bulb_mesh(const Vec3& centre, const Vec3& radii, int n) {
  SolidBuilder b;
  const auto at = [&](int i, int j) -> Vec3 {
    const double u = k_pi * i / n, v = k_pi * (j % (2 * n)) / n;
    const Vec3 unit(std::cos(u), i % n == 0 ? 0 : std::sin(u) * std::cos(v),
                    i % n == 0 ? 0 : std::sin(u) * std::sin(v));
    return centre + radii.cwiseProduct(unit);
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) b.quad(at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
  geometry::TriangleMesh mesh = b.take();
  if (geometry::signed_volume(mesh) < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

inline PolygonSoup soup_of(const std::vector<geometry::TriangleMesh>& shells) {
  PolygonSoup soup;
  for (const auto& shell : shells) {
    const int first = static_cast<int>(soup.points.size());
    soup.points.insert(soup.points.end(), shell.vertices.begin(), shell.vertices.end());
    for (const auto& t : shell.triangles) soup.polygons.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return soup;
}

/// Two pontoons, four columns, a deck: seven closed shells that overlap, as a drawing program leaves them.
inline std::vector<geometry::TriangleMesh> semisubmersible_shells(int n) {
  std::vector<geometry::TriangleMesh> shells;
  for (const double y : {-1.0, 1.0}) shells.push_back(box_mesh({-1.5, y - 0.3, 0}, {1.5, y + 0.3, 0.3}));
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) shells.push_back(column_mesh({x, y, 0.2}, 0.22, 0.9, n));
  shells.push_back(box_mesh({-1.4, -1.4, 1.0}, {1.4, 1.4, 1.2}));
  return shells;
}
inline double semisubmersible_volume(int n) {
  return 2 * 3.0 * 0.6 * 0.3 + 4 * column_area(0.22, n) * 0.7 + 2.8 * 2.8 * 0.2;
}

}  // namespace nilas::mesh
