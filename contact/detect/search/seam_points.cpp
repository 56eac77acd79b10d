#include "contact/detect/search/seam_points.h"

#include <algorithm>
#include <cmath>

#include "contact/detect/broad/part.h"
#include "contact/detect/surface/point_reduction.h"
#include "contact/detect/surface/surface_patch.h"

namespace nilas::detect {

namespace {

/// Normals that differ by less belong to one plane [rad]: ten times the angle by which the rounding of STL files turns
/// a face.
constexpr double k_one_plane = 1e-5;
const double k_gentle_cosine = std::cos(2.0 * k_patch_angle);

bool same_parts(const ContactPoint& p, const ContactPoint& q) { return p.part_a == q.part_a && p.part_b == q.part_b; }

class SeamJoin {
 public:
  SeamJoin(const bodies::Bodies& bodies, double touching, double margin, ContactPoint* first, ContactPoint* last)
      : bodies_(bodies), touching_(touching), margin_(margin), first_(first), count_(last - first) {
    dropped_.assign(static_cast<std::size_t>(count_), 0);
  }

  const std::vector<char>& drop() {
    for (std::ptrdiff_t i = 0; i < count_; ++i) merge_coincident(i);
    std::vector<char> known = dropped_;
    for (std::ptrdiff_t i = 0; i < count_; ++i) {
      if (known[i] != 0) continue;
      std::vector<std::ptrdiff_t> plane;
      for (std::ptrdiff_t k = i; k < count_; ++k) {
        if (known[k] != 0 || (first_[k].n - first_[i].n).norm() > k_one_plane) continue;
        known[k] = 1;
        plane.push_back(k);
      }
      reduce(plane);
    }
    return dropped_;
  }

 private:
  void merge_coincident(std::ptrdiff_t i) {
    Vec3 sum = first_[i].n;
    for (std::ptrdiff_t k = i + 1; k < count_ && dropped_[i] == 0; ++k) {
      if (dropped_[k] != 0 || same_parts(first_[i], first_[k])) continue;
      if ((first_[i].p - first_[k].p).norm() > touching_ || first_[i].n.dot(first_[k].n) < k_gentle_cosine) continue;
      sum += first_[k].n;
      first_[i].gap = std::min(first_[i].gap, first_[k].gap);
      dropped_[k] = 1;
    }
    if (sum != first_[i].n) first_[i].n = sum.normalized();
  }

  void reduce(const std::vector<std::ptrdiff_t>& plane) {
    const auto of_first = [&](std::ptrdiff_t k) { return same_parts(first_[k], first_[plane.front()]); };
    if (std::all_of(plane.begin(), plane.end(), of_first)) return;
    const auto body = static_cast<std::size_t>(first_->a);
    const Mat3 to_a = bodies_.R_GB[body].transpose();
    const ContactPlane axes = contact_plane(to_a * first_[plane.front()].n);
    std::vector<OverlayPoint> points;
    for (const std::ptrdiff_t k : plane) {
      const Vec3 x = to_a * (first_[k].p - bodies_.p_GB[body]);
      points.push_back(
          {axes.t1.dot(x), axes.t2.dot(x), {FeatureKind::face, static_cast<int>(k), -1}, 0, first_[k].gap});
    }
    keep_spread_points(touching_, margin_, k_four_points_do, points);
    for (const std::ptrdiff_t k : plane)
      if (std::none_of(points.begin(), points.end(), [&](const OverlayPoint& p) { return p.feature.first == k; }))
        dropped_[k] = 1;
  }

  const bodies::Bodies& bodies_;
  double touching_, margin_;
  ContactPoint* first_;
  std::ptrdiff_t count_;
  std::vector<char> dropped_;
};

}  // namespace

void join_at_seams(const bodies::Bodies& bodies, double touching, double margin, std::size_t first,
                   std::vector<ContactPoint>& points) {
  if (points.size() < first + 2 || same_parts(points[first], points.back())) return;
  SeamJoin join(bodies, touching, margin, points.data() + first, points.data() + points.size());
  const std::vector<char>& dropped = join.drop();
  std::size_t place = 0;
  const auto start = points.begin() + static_cast<std::ptrdiff_t>(first);
  points.erase(std::remove_if(start, points.end(), [&](const ContactPoint&) { return dropped[place++] != 0; }),
               points.end());
}

}  // namespace nilas::detect
