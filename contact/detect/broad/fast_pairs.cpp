#include "contact/detect/broad/fast_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace nilas::detect {

namespace {

/// The distance that a body's points move by its rotation [m]. A sphere that turns about its centre does not move its
/// surface.
double turning_way(const bodies::Bodies& bodies, const FastMotion& motion, std::size_t b) {
  const geometry::Shape& shape = *bodies.shape[b];
  if (bodies.motion[b] == bodies::Motion::fixed || shape.kind == geometry::ShapeKind::sphere) return 0;
  const double turn = motion.h * motion.w[b].norm();
  return turn > 0 ? turn * shape.bounding_radius : 0;
}

Vec3 way(const bodies::Bodies& bodies, const FastMotion& motion, std::size_t b) {
  return bodies.motion[b] == bodies::Motion::fixed ? Vec3(Vec3::Zero()) : Vec3(motion.h * motion.v[b]);
}

Vec3 mean_way(const bodies::Bodies& bodies, const FastMotion& motion) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (std::size_t b = 0; b < motion.v.size(); ++b)
    if (bodies.motion[b] != bodies::Motion::fixed) {
      sum += motion.h * motion.v[b];
      count += 1;
    }
  return sum / std::max(count, 1.0);
}

double relative_way(const bodies::Bodies& bodies, const FastMotion& motion, int a, int b) {
  const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  return (way(bodies, motion, j) - way(bodies, motion, i)).norm() + turning_way(bodies, motion, i) +
         turning_way(bodies, motion, j);
}

/// The box around a body's bounding ball along its path, relative to the mean motion of all bodies.
struct SweptBox {
  Vec3 low, high;
  int body = 0;
};

}  // namespace

std::vector<double> smallest_widths(const bodies::Bodies& bodies) {
  std::vector<double> widths;
  for (const auto& shape : bodies.shape) {
    double width = std::numeric_limits<double>::infinity();
    for (const auto& part : shape->parts) width = std::min(width, part.smallest_width);
    if (shape->radius > 0) width = 2 * shape->radius;
    if (shape->half_height > 0) width = std::min(width, 2 * shape->half_height);
    widths.push_back(width);
  }
  return widths;
}

bool any_fast(const bodies::Bodies& bodies, const FastMotion& motion, const std::vector<double>& widths, double share) {
  const Vec3 mean = mean_way(bodies, motion);
  double farthest = 0, second = 0, thinnest = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < widths.size(); ++b) {
    const double own = (way(bodies, motion, b) - mean).norm() + turning_way(bodies, motion, b);
    second = std::max(second, std::min(farthest, own));
    farthest = std::max(farthest, own);
    thinnest = std::min(thinnest, widths[b]);
  }
  return farthest + second > share * thinnest;
}

bool is_fast(const bodies::Bodies& bodies, const FastMotion& motion, const std::vector<double>& widths, double share,
             int a, int b) {
  const double width = std::min(widths[a], widths[b]);
  return relative_way(bodies, motion, a, b) > share * width;
}

std::vector<FastPair> fast_pairs(const bodies::Bodies& bodies, const FastMotion& motion,
                                 const std::vector<double>& widths, double share) {
  std::vector<FastPair> pairs;
  if (!any_fast(bodies, motion, widths, share)) return pairs;
  const Vec3 mean = mean_way(bodies, motion);
  std::vector<SweptBox> boxes;
  for (std::size_t b = 0; b < widths.size(); ++b) {
    const Vec3 relative = way(bodies, motion, b) - mean;
    const Vec3 ball = Vec3::Constant(bodies.shape[b]->bounding_radius);
    const Vec3& p = bodies.p_GB[b];
    boxes.push_back({p.cwiseMin(p + relative) - ball, p.cwiseMax(p + relative) + ball, static_cast<int>(b)});
  }
  std::sort(boxes.begin(), boxes.end(), [](const SweptBox& p, const SweptBox& q) {
    return std::pair(p.low.x(), p.body) < std::pair(q.low.x(), q.body);
  });
  const auto is_fixed = [&](int b) { return bodies.motion[b] == bodies::Motion::fixed; };
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size() && boxes[j].low.x() <= boxes[i].high.x(); ++j) {
      const SweptBox &p = boxes[i], &q = boxes[j];
      if ((p.low.array() > q.high.array()).any() || (q.low.array() > p.high.array()).any()) continue;
      if (is_fixed(p.body) && is_fixed(q.body)) continue;
      const auto [a, b] = std::minmax(p.body, q.body);
      if (!is_fast(bodies, motion, widths, share, a, b)) continue;
      const double width = std::min(widths[a], widths[b]);
      pairs.push_back({a, b, width, relative_way(bodies, motion, a, b)});
    }
  std::sort(pairs.begin(), pairs.end(),
            [](const FastPair& p, const FastPair& q) { return std::pair(p.a, p.b) < std::pair(q.a, q.b); });
  return pairs;
}

}  // namespace nilas::detect
