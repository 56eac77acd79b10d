#include "apps/report/figures/waterline_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/report/hull_lines.h"
#include "core/base/error.h"
#include "core/geometry/polygon.h"

namespace nilas::report {

WaterlineOutline::WaterlineOutline(const geometry::TriangleMesh& mesh, double level, const Vec2& ahead) {
  std::vector<Vec2> points;
  for (const Segment& line : waterline(mesh, level))
    for (const Vec3& end : line) points.emplace_back(end.head<2>());
  constexpr std::size_t k_triangle = 3;
  if (points.size() < k_triangle)
    for (const Vec3& vertex : mesh.vertices) points.emplace_back(vertex.head<2>());
  corners_ = geometry::convex_hull(points);
  if (corners_.size() < k_triangle) throw InputError("the body has no area seen from above");
  for (std::size_t k = 0; k < corners_.size(); ++k) {
    begins_.push_back(length_);
    length_ += (corners_[(k + 1) % corners_.size()] - corners_[k]).norm();
  }
  // A transverse edge, such as that of a barge, is foremost as a whole: its middle counts.
  double farthest = -std::numeric_limits<double>::infinity();
  for (const Vec2& corner : corners_) farthest = std::max(farthest, corner.dot(ahead));
  Vec2 sum = Vec2::Zero();
  double count = 0;
  constexpr double k_level = 1e-6;
  for (const Vec2& corner : corners_)
    if (corner.dot(ahead) > farthest - k_level * length_) {
      sum += corner;
      ++count;
    }
  zero_ = from_first_corner(sum / count);
}

double WaterlineOutline::from_first_corner(const Vec2& p) const {
  double best = std::numeric_limits<double>::infinity(), at = 0;
  for (std::size_t k = 0; k < corners_.size(); ++k) {
    const Vec2 edge = corners_[(k + 1) % corners_.size()] - corners_[k];
    const double share = std::clamp((p - corners_[k]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    const double distance = (p - corners_[k] - share * edge).squaredNorm();
    if (distance >= best) continue;
    best = distance;
    at = begins_[k] + share * edge.norm();
  }
  return at;
}

double WaterlineOutline::along(const Vec2& p) const { return std::remainder(from_first_corner(p) - zero_, length_); }

}  // namespace nilas::report
