#include "hydro/waves/wave_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/mirror_order.h"
#include "core/base/order_free_sum.h"
#include "hydro/water_plane.h"

namespace nilas::hydro {

namespace {

using Triangle = std::array<int, 3>;

/// Halves the edges of triangles. Triangles that share an edge share its middle. The parts do not depend on the corner
/// with which a triangle begins, nor on the axes: the parts of a turned or mirrored triangle are turned or mirrored.
class EdgeHalving {
 public:
  EdgeHalving(std::vector<Vec3>& vertices, double longest) : vertices_(vertices), longest_(longest) {}

  /// Appends the parts of a triangle, none with an edge that is too long.
  void add(const Triangle& triangle, std::vector<Triangle>& out) {
    std::array<int, 3> middle{};  // opposite of corner k
    int cuts = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      middle[k] = middle_of(triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
      if (middle[k] >= 0) ++cuts;
    }
    if (cuts == 0) {
      out.push_back(triangle);
      return;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = triangle[k], b = triangle[(k + 1) % 3], c = triangle[(k + 2) % 3];
      const int ab = middle[(k + 2) % 3], bc = middle[k], ca = middle[(k + 1) % 3];
      if (cuts == 3) {
        add({a, ab, ca}, out);
        if (k == 2) add({ab, bc, ca}, out);
      } else if (cuts == 1 && bc >= 0) {
        add({a, b, bc}, out);
        add({a, bc, c}, out);
      } else if (cuts == 2 && bc < 0) {
        add({a, ab, ca}, out);
        add_quadrangle({ab, b, c, ca}, out);
      }
    }
  }

 private:
  /// Appends the parts of the rest of a triangle of which two edges were halved, about its middle: diagonals of equal
  /// length would leave the choice between them to rounding. The pairs that are summed first are each other's image
  /// where the triangle is mirrored.
  void add_quadrangle(const std::array<int, 4>& corners, std::vector<Triangle>& out) {
    const int middle = static_cast<int>(vertices_.size());
    const Vec3 cut = vertices_[corners[0]] + vertices_[corners[3]],
               whole = vertices_[corners[1]] + vertices_[corners[2]];
    vertices_.push_back(0.25 * (cut + whole));
    for (std::size_t k = 0; k < 4; ++k) add({corners[k], corners[(k + 1) % 4], middle}, out);
  }
  /// The vertex in the middle of an edge that is too long; -1 for another edge.
  int middle_of(int a, int b) {
    if (!((vertices_[a] - vertices_[b]).norm() > longest_)) return -1;
    const auto [place, is_new] = middles_.try_emplace({std::min(a, b), std::max(a, b)}, 0);
    if (is_new) {
      place->second = static_cast<int>(vertices_.size());
      vertices_.push_back(0.5 * (vertices_[a] + vertices_[b]));
    }
    return place->second;
  }

  std::vector<Vec3>& vertices_;
  double longest_;
  std::map<std::pair<int, int>, int> middles_;
};

/// The share of a triangle's area that each of the three points has at which an integral over it is evaluated.
constexpr double k_point_share = 1.0 / 3.0;

using Corners = std::array<Vec3, 3>;
using Heights = std::array<double, 3>;

/// Calls visit(area, point) for the points at which an integral over a triangle is evaluated.
template <class Visit>
void visit_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal, double share, const Visit& visit) {
  const double area = share * k_point_share * 0.5 * normal.dot((b - a).cross(c - a));
  if (!(area > 0)) return;
  visit(area, 0.5 * (a + b));
  visit(area, 0.5 * (b + c));
  visit(area, 0.5 * (c + a));
}

/// The same for the part of a triangle where the height is below 0.
template <class Visit>
void visit_wet_part(const Corners& x, const Heights& height, const Vec3& normal, const Visit& visit) {
  const auto wet = [&](std::size_t k) { return height[k] < 0; };
  const int count = wet(0) + wet(1) + wet(2);
  if (count == 0) return;
  if (count == 3) return visit_triangle(x[0], x[1], x[2], normal, 1, visit);
  const bool lone_is_wet = count == 1;
  const std::size_t lone = wet(0) == lone_is_wet ? 0 : wet(1) == lone_is_wet ? 1 : 2;
  const std::size_t next = (lone + 1) % 3, last = (lone + 2) % 3;
  const auto cut = [&](std::size_t other) {
    return lone_is_wet ? leaves_water(x[lone], height[lone], x[other], height[other])
                       : leaves_water(x[other], height[other], x[lone], height[lone]);
  };
  const Vec3 next_cut = cut(next), last_cut = cut(last);
  if (lone_is_wet) return visit_triangle(x[lone], next_cut, last_cut, normal, 1, visit);
  // The mean over both diagonals of the quadrangle does not depend on the corner with which the triangle begins.
  visit_triangle(next_cut, x[next], x[last], normal, 0.5, visit);
  visit_triangle(next_cut, x[last], last_cut, normal, 0.5, visit);
  visit_triangle(last_cut, next_cut, x[next], normal, 0.5, visit);
  visit_triangle(last_cut, x[next], x[last], normal, 0.5, visit);
}

/// The load of pressures over rho g on a surface, about a point.
class PressureSum {
 public:
  explicit PressureSum(const Vec3& about) : about_(about) {}
  void add(double head, const Vec3& point, const Vec3& normal, double area) {
    const Vec3 force = -head * area * normal;
    force_.add(force);
    torque_.add((point - about_).cross(force));
  }
  Wrench load(double weight) const { return {weight * force_.value(), weight * torque_.value()}; }

 private:
  Vec3 about_;
  OrderFreeVectorSum force_, torque_;
};

enum class Wet { no, partly, wholly };

/// Whether a triangle is below, at or above all waves.
Wet wet_of(const Heights& height, double greatest) {
  const auto [low, high] = std::minmax({height[0], height[1], height[2]});
  if (low > greatest) return Wet::no;
  return high < -greatest ? Wet::wholly : Wet::partly;
}

}  // namespace

double longest_wet_edge(const geometry::TriangleMesh& mesh, const Mat3& R, const Vec3& p, double level) {
  const WaterPlane plane = water_plane(R, p, level);
  double longest = 0;
  for (const auto& triangle : mesh.triangles) {
    const bool wet =
        std::any_of(triangle.begin(), triangle.end(), [&](int v) { return plane.height(mesh.vertices[v]) < 0; });
    for (std::size_t k = 0; k < 3 && wet; ++k)
      longest = std::max(longest, (mesh.vertices[triangle[k]] - mesh.vertices[triangle[(k + 1) % 3]]).norm());
  }
  return longest;
}

WaveSurface::WaveSurface(const geometry::TriangleMesh& surface, double longest_edge) : vertices_(surface.vertices) {
  if (surface.triangles.empty()) throw InputError("waves do not act on a mesh without triangles");
  NILAS_DEMAND(longest_edge > 0);
  std::vector<Triangle> triangles;
  EdgeHalving halving(vertices_, longest_edge);
  for (const auto& triangle : surface.triangles) halving.add(from_first(triangle, surface.vertices), triangles);
  std::map<std::pair<int, int>, int> edge_of;
  for (const Triangle& corners : triangles) {
    Face& face = faces_.emplace_back();
    face.corners = corners;
    const Vec3& a = vertices_[corners[0]];
    const Vec3 doubled = (vertices_[corners[1]] - a).cross(vertices_[corners[2]] - a);
    const double length = doubled.norm();
    if (length > 0) face.normal = doubled / length;  // a face without area carries no force
    face.area = 0.5 * length;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::pair<int, int> ends = std::minmax(corners[k], corners[(k + 1) % 3]);
      const auto [place, is_new] = edge_of.try_emplace(ends, static_cast<int>(edges_.size()));
      if (is_new) edges_.push_back(ends);
      face.edges[k] = place->second;
    }
  }
}

Wrench WaveSurface::load(const Mat3& R, const Vec3& p, const Water& water, const WaveField& field, double t) const {
  std::vector<Vec3> points(vertices_.size());
  std::vector<double> still(vertices_.size());  // heights above still water
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    points[v] = p + R * vertices_[v];
    still[v] = points[v].z() - water.level;
  }
  // Heights above the waves, and wave pressures in the middle of edges, are found where a face asks for them first.
  std::vector<std::optional<double>> actual(vertices_.size()), heads(edges_.size());
  const auto height_of = [&](int v) {
    if (!actual[v]) actual[v] = still[v] - field.elevation(points[v].head<2>(), t);
    return *actual[v];
  };
  const auto head_at = [&](const Vec3& x) {
    return WaveColumn(field, x.head<2>(), t).pressure_head(x.z() - water.level);
  };
  const auto middle_of = [&](int e) { return Vec3(0.5 * (points[edges_[e].first] + points[edges_[e].second])); };
  PressureSum sum(p);
  const auto below = [](double z) { return z < 0; };
  for (const Face& face : faces_) {
    const auto& [a, b, c] = face.corners;
    const Heights flat{still[a], still[b], still[c]};
    const Wet wet = wet_of(flat, field.greatest_elevation());
    if (wet == Wet::no) continue;
    const Heights height = wet == Wet::wholly ? flat : Heights{height_of(a), height_of(b), height_of(c)};
    const Vec3 normal = R * face.normal;
    if (std::all_of(height.begin(), height.end(), below) && std::all_of(flat.begin(), flat.end(), below)) {
      for (const int e : face.edges) {
        const Vec3 middle = middle_of(e);
        if (!heads[e]) heads[e] = head_at(middle);
        sum.add(*heads[e], middle, normal, k_point_share * face.area);
      }
      continue;
    }
    const Corners corners{points[a], points[b], points[c]};
    visit_wet_part(corners, height, normal,
                   [&](double area, const Vec3& x) { sum.add(head_at(x) - (x.z() - water.level), x, normal, area); });
    visit_wet_part(corners, flat, normal,
                   [&](double area, const Vec3& x) { sum.add(x.z() - water.level, x, normal, area); });
  }
  return sum.load(water.density * water.gravity);
}

ComplexVec6 WaveSurface::linear_load(const Mat3& R, const Vec3& p, const Water& water, const Vec2& direction,
                                     double number, double depth) const {
  ComplexVec6 sum = ComplexVec6::Zero();
  const double twice = std::exp(-2 * number * depth);
  for (const Face& face : faces_) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = p + R * vertices_[face.corners[k]];
    const Vec3 normal = R * face.normal;
    visit_wet_part(corners, {corners[0].z(), corners[1].z(), corners[2].z()}, normal, [&](double area, const Vec3& x) {
      const double profile = (std::exp(number * x.z()) + std::exp(-number * (x.z() + 2 * depth))) / (1 + twice);
      const auto head = std::polar(area * profile, -number * x.head<2>().dot(direction));
      Vec6 faced;
      faced << normal, x.cross(normal);
      sum -= head * faced.cast<std::complex<double>>();
    });
  }
  return water.density * water.gravity * sum;
}

}  // namespace nilas::hydro
