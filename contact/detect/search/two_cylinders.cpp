#include "contact/detect/search/two_cylinders.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace nilas::detect {

namespace {

Vec3 supporting_point(const RoundBody& body, const Vec3& n) {
  const double up = n.dot(body.axis);
  const Vec3 across = n - up * body.axis;
  const double length = std::max(across.norm(), 1e-12);
  return body.radius / length * across + (up < 0 ? -body.half_height : body.half_height) * body.axis;
}

/// Returns the second derivatives of the extent by n, for n not along the axis. The first derivatives are the
/// supporting point.
Mat3 curvature_of_extent(const RoundBody& body, const Vec3& n) {
  const Vec3 across = n - n.dot(body.axis) * body.axis;
  const double length = std::max(across.norm(), 1e-12);
  const Vec3 out = across / length;
  return body.radius / length * (Mat3::Identity() - out * out.transpose() - body.axis * body.axis.transpose());
}

/// The directions through a convex polygon on a face of the cube of side 2.
using Polygon = std::vector<Vec3>;

std::vector<Polygon> cube() {
  std::vector<Polygon> faces;
  for (const int up : {0, 1, 2})
    for (const double side : {1.0, -1.0}) {
      const Vec3 u = Vec3::Unit((up + 1) % 3), v = Vec3::Unit((up + 2) % 3), middle = side * Vec3::Unit(up);
      faces.push_back({middle - u - v, middle + u - v, middle + u + v, middle - u + v});
    }
  return faces;
}

/// Returns the centroid. Any line through it leaves at most 1 - 1/e = 63 % of the polygon on one side [Gruenbaum 1960].
Vec3 centroid(const Polygon& polygon) {
  Vec3 sum = Vec3::Zero();
  double area = 0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const Vec3 u = polygon[k] - polygon[0], v = polygon[k + 1] - polygon[0];
    const double weight = std::max(u.cross(v).norm(), std::numeric_limits<double>::min());
    sum += weight * (u + v);
    area += weight;
  }
  return polygon[0] + sum / (3 * area);
}

const Vec3& farthest_from(const Vec3& n, const Polygon& polygon) {
  return *std::min_element(polygon.begin(), polygon.end(),
                           [&](const Vec3& p, const Vec3& q) { return n.dot(p) * q.norm() < n.dot(q) * p.norm(); });
}

/// The part of the polygon where p . y > 0.
Polygon part_over(const Polygon& polygon, const Vec3& y) {
  Polygon part;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3 &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const double at_p = p.dot(y), at_q = q.dot(y);
    if (at_p > 0) part.push_back(p);
    if ((at_p > 0) != (at_q > 0)) part.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return part;
}

}  // namespace

// Cutting planes: let x be the difference between the supporting points along a direction m. No direction n separates
// by more than x does, s(n) <= n . x. To reach a level it needs n . x >= level = level |n|, and over a polygon around m
// |n| lies between n . m and n . m / cos(its largest angle to m), so that n . (x - level m) >= 0, with the level over
// that cosine when below 0. This cuts off m itself but where the polygon is wide and the depth near m about the least;
// there the polygon is halved. Tops as narrow as their directions are near to a cylinder's axis are not missed.
RoundAxis best_of_all_directions(const RoundBody& a, const RoundBody& b, const RoundAxis& start, double tolerance) {
  // More steps than this are taken only where many tops are of nearly the same height, around cylinders that lie
  // within each other.
  constexpr int k_most_steps = 3000;
  const Vec3 between = b.centre - a.centre;
  RoundAxis best = start;
  std::vector<Polygon> open = cube();
  for (int step = 0; step < k_most_steps && !open.empty(); ++step) {
    const Polygon polygon = std::move(open.back());
    open.pop_back();
    if (polygon.size() < 3) continue;
    const Vec3 m = centroid(polygon).normalized();
    const Vec3 x = between - supporting_point(a, m) - supporting_point(b, m);
    const double s = m.dot(x);
    if (s > best.s) best = {m, s};
    const Vec3& far = farthest_from(m, polygon);
    const double aim = best.s + tolerance, level = aim < 0 ? aim * far.norm() / far.dot(m) : aim;
    Polygon rest = part_over(polygon, x - level * m);
    if (s < level) {
      open.push_back(std::move(rest));
    } else {
      const Vec3 along = far - far.dot(m) * m;
      open.push_back(part_over(rest, along));
      open.push_back(part_over(rest, -along));
    }
  }
  return best;
}

RoundAxis climb_between_rims(const RoundBody& a, const RoundBody& b, const Vec3& n) {
  const Vec3 between = b.centre - a.centre;
  const auto separation = [&](const Vec3& x) { return x.dot(between) - a.extent(x) - b.extent(x); };
  RoundAxis at{n, separation(n)};
  constexpr int k_most_steps = 60;
  double reach = 0.1;  // [rad], how far a step may go
  for (int step = 0; step < k_most_steps && reach > 1e-9; ++step) {
    Eigen::Matrix<double, 3, 2> tangents;
    tangents.col(0) = at.n.unitOrthogonal();
    tangents.col(1) = at.n.cross(tangents.col(0));
    const Vec2 gradient = tangents.transpose() * (between - supporting_point(a, at.n) - supporting_point(b, at.n));
    const Eigen::Matrix2d curvature =
        -(tangents.transpose() * (curvature_of_extent(a, at.n) + curvature_of_extent(b, at.n)) * tangents) -
        at.s * Eigen::Matrix2d::Identity();
    Vec2 way = gradient;
    if (curvature(0, 0) < 0 && curvature.determinant() > 0) way = -curvature.inverse() * gradient;
    if (way.norm() > reach) way *= reach / way.norm();
    const Vec3 next = (at.n + tangents * way).normalized();
    const double s = separation(next);
    if (s > at.s) {
      at = {next, s};
      reach *= 2;
    } else {
      reach = 0.25 * std::min(reach, way.norm());
    }
  }
  return at;
}

}  // namespace nilas::detect
