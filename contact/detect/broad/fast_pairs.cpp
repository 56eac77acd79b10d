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

/// A bound on the distance that a point of the body moves against the mean motion of all bodies [m].
double own_way(const bodies::Bodies& bodies, const FastMotion& motion, const Vec3& mean, std::size_t b) {
  return (way(bodies, motion, b) - mean).norm() + turning_way(bodies, motion, b);
}

/// The box around a body's bounding ball along its path, relative to the mean motion of all bodies.
struct SweptBox {
  Vec3 low, high;
  int body = 0;
  bool quick = false;  ///< false: only quick bodies move fast against it
};

/// The axis along which the bodies are spread most.
Eigen::Index longest_axis(const bodies::Bodies& bodies) {
  Vec3 sum = Vec3::Zero(), squares = Vec3::Zero();
  for (const Vec3& p : bodies.p_GB) sum += p;
  const Vec3 centre = sum / std::max(static_cast<double>(bodies.p_GB.size()), 1.0);
  for (const Vec3& p : bodies.p_GB) squares += (p - centre).cwiseAbs2();
  Eigen::Index axis = 0;
  squares.maxCoeff(&axis);
  return axis;
}

/// The boxes in rising order of their low ends along an axis.
std::vector<SweptBox> swept_boxes(const bodies::Bodies& bodies, const FastMotion& motion,
                                  const std::vector<double>& widths, double share, Eigen::Index axis) {
  const Vec3 mean = mean_way(bodies, motion);
  // The way of a pair is at most the sum of both own ways, so one of the two has more than half of what makes it fast.
  constexpr double k_less_rounding = 1 - 1e-9;
  const double thinnest = *std::min_element(widths.begin(), widths.end());
  const double quick_way = 0.5 * share * thinnest * k_less_rounding;
  std::vector<SweptBox> boxes;
  for (std::size_t b = 0; b < widths.size(); ++b) {
    const Vec3 relative = way(bodies, motion, b) - mean;
    const Vec3 ball = Vec3::Constant(bodies.shape[b]->bounding_radius);
    const Vec3& p = bodies.p_GB[b];
    boxes.push_back({p.cwiseMin(p + relative) - ball, p.cwiseMax(p + relative) + ball, static_cast<int>(b),
                     own_way(bodies, motion, mean, b) > quick_way});
  }
  std::sort(boxes.begin(), boxes.end(), [axis](const SweptBox& p, const SweptBox& q) {
    return std::pair(p.low[axis], p.body) < std::pair(q.low[axis], q.body);
  });
  return boxes;
}

/// Calls visit(one, other) once for every two boxes that overlap along the axis and of which one is quick.
template <class Visit>
void visit_quick_pairs(const std::vector<SweptBox>& boxes, Eigen::Index axis, const Visit& visit) {
  std::vector<std::size_t> quick;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (boxes[i].quick) quick.push_back(i);
  auto next_quick = quick.begin();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto meets = [&](std::size_t j) { return boxes[j].low[axis] <= boxes[i].high[axis]; };
    if (boxes[i].quick) {
      ++next_quick;
      for (std::size_t j = i + 1; j < boxes.size() && meets(j); ++j) visit(boxes[i], boxes[j]);
    } else {
      for (auto j = next_quick; j != quick.end() && meets(*j); ++j) visit(boxes[i], boxes[*j]);
    }
  }
}

}  // namespace

std::vector<double> smallest_widths(const bodies::Bodies& bodies) {
  std::vector<double> widths;
  for (const auto& shape : bodies.shape) widths.push_back(shape->smallest_width);
  return widths;
}

bool any_fast(const bodies::Bodies& bodies, const FastMotion& motion, const std::vector<double>& widths, double share) {
  const Vec3 mean = mean_way(bodies, motion);
  double farthest = 0, second = 0, thinnest = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < widths.size(); ++b) {
    const double own = own_way(bodies, motion, mean, b);
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
  const Eigen::Index axis = longest_axis(bodies);
  const auto is_fixed = [&](int b) { return bodies.motion[b] == bodies::Motion::fixed; };
  visit_quick_pairs(swept_boxes(bodies, motion, widths, share, axis), axis, [&](const SweptBox& p, const SweptBox& q) {
    if ((p.low.array() > q.high.array()).any() || (q.low.array() > p.high.array()).any()) return;
    if (is_fixed(p.body) && is_fixed(q.body)) return;
    const auto [a, b] = std::minmax(p.body, q.body);
    if (!is_fast(bodies, motion, widths, share, a, b)) return;
    const double width = std::min(widths[a], widths[b]);
    pairs.push_back({a, b, width, relative_way(bodies, motion, a, b)});
  });
  std::sort(pairs.begin(), pairs.end(),
            [](const FastPair& p, const FastPair& q) { return std::pair(p.a, p.b) < std::pair(q.a, q.b); });
  return pairs;
}

}  // namespace nilas::detect
