#include "contact/detect/round_pair.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace nilas::detect {

namespace {

/// A contact farther away than this share of the radius is another one, such as that of the opposite rim.
constexpr double k_next_to = 0.25;
/// Normals that differ by more belong to another contact (cosine of 25 degrees).
constexpr double k_like_normal = 0.906;
/// Distance that the points may have gained unnoticed, as a share of the radius.
constexpr double k_gained_share = 0.05;

double radius_of(const Part& part) {
  const bool round = part.kind == PartKind::sphere || part.kind == PartKind::cylinder;
  return round ? part.radius : std::numeric_limits<double>::infinity();
}

/// The index of the point nearest to p.
std::size_t place_nearest_to(const Vec3& p, std::span<const ContactPoint> points) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if ((points[i].p - p).squaredNorm() < (points[nearest].p - p).squaredNorm()) nearest = i;
  return nearest;
}

}  // namespace

bool is_round(const geometry::Shape& shape) {
  return shape.kind == geometry::ShapeKind::sphere || shape.kind == geometry::ShapeKind::cylinder;
}

void measure_round_pair(const bodies::Bodies& bodies, const Part& a, const Part& b, const PairSearch& search,
                        AxisSearchRoom& room, PairMemory memory, std::span<ContactPoint> points) {
  const double radius = std::min(radius_of(a), radius_of(b));
  double margin = 0;
  for (const ContactPoint& point : points) margin = std::max(margin, point.gap);
  std::vector<ContactPoint> found;
  find_pair_contacts(bodies, a, b, margin + k_gained_share * radius, search, room, memory, found);
  if (found.empty()) return;
  const std::vector<ContactPoint> carried(points.begin(), points.end());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ContactPoint& present = found[place_nearest_to(carried[i].p, found)];
    const bool same = place_nearest_to(present.p, carried) == i && present.n.dot(carried[i].n) > k_like_normal &&
                      (present.p - carried[i].p).norm() <= k_next_to * radius;
    if (!same) continue;
    points[i].p = present.p;
    points[i].n = present.n;
    points[i].gap = present.gap;
  }
}

}  // namespace nilas::detect
