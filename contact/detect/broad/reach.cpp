#include "contact/detect/broad/reach.h"

#include <algorithm>

#include "core/base/order_free_sum.h"
#include "core/base/parallel.h"

namespace nilas::detect {

namespace {

Vec3 mean_free_velocity(const bodies::Bodies& bodies) {
  OrderFreeVectorSum sum;
  double free = 0;
  for (int b = 0; b < bodies.size(); ++b)
    if (bodies.is_free(b)) {
      sum.add(bodies.v_GB[b]);
      free += 1;
    }
  return sum.value() / std::max(free, 1.0);
}

/// The distances that bodies can reach by themselves and when others push them.
class Reach {
 public:
  Reach(const bodies::Bodies& bodies, const std::vector<double>& own) : bodies_(bodies), own_(own), pushed_(own) {}

  /// Hands reach on across a gap in both directions. Returns whether either body gained.
  bool hand_on(int a, int b, double gap) {
    const bool to_b = push(a, b, gap);
    return push(b, a, gap) || to_b;
  }
  /// Returns the gap from which on a gap between the two cannot close [m].
  double between(int a, int b) const {
    return std::max(pushed_[index(a)] + own_[index(b)], own_[index(a)] + pushed_[index(b)]);
  }

 private:
  static std::size_t index(int b) { return static_cast<std::size_t>(b); }

  bool push(int from, int to, double gap) {
    if (!bodies_.is_free(to)) return false;
    const double m = bodies_.mass[index(from)];
    const double share = bodies_.is_free(from) ? m / (m + bodies_.mass[index(to)]) : 1;
    const double pushed = share * (pushed_[index(from)] - gap);
    if (!(pushed > pushed_[index(to)])) return false;
    pushed_[index(to)] = pushed;
    return true;
  }

  const bodies::Bodies& bodies_;
  const std::vector<double>& own_;
  std::vector<double> pushed_;
};

}  // namespace

std::vector<double> own_reach(const bodies::Bodies& bodies, const bodies::Wrenches& loads, double h, double share) {
  const Vec3 mean = mean_free_velocity(bodies);
  std::vector<double> reach(static_cast<std::size_t>(bodies.size()));
  // the radii are read first, in a loop short enough that the reads of many shapes overlap
  for (std::size_t b = 0; b < reach.size(); ++b)
    reach[b] = bodies.motion[b] == bodies::Motion::fixed ? 0 : bodies.shape[b]->bounding_radius;
  for (std::size_t b = 0; b < reach.size(); ++b) {
    Vec3 v = bodies.v_GB[b] - mean, w = bodies.w_GB[b];
    if (bodies.motion[b] == bodies::Motion::free) {
      const Mat3& R = bodies.R_GB[b];
      v += h / bodies.mass[b] * loads[b].force;
      w += R * (bodies.inertia_inverse_B[b] * (R.transpose() * (h * loads[b].torque)));
    }
    reach[b] = share * h * (v.norm() + w.norm() * reach[b]);
  }
  return reach;
}

// The repeated relaxation ends in both functions below, because every transfer loses a share of the reach.

std::vector<double> pair_margins(const bodies::Bodies& bodies, const std::vector<double>& own,
                                 const std::vector<PartPair>& pairs, double least, double most, int threads) {
  Reach reach(bodies, own);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& pair : pairs) changed = reach.hand_on(pair.body_a, pair.body_b, 0) || changed;
  }
  std::vector<double> margins(pairs.size());
  parallel_chunks(static_cast<std::ptrdiff_t>(pairs.size()), k_chunk, threads,
                  [&](std::ptrdiff_t, std::ptrdiff_t first, std::ptrdiff_t last) {
                    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
                      margins[i] = std::clamp(reach.between(pairs[i].body_a, pairs[i].body_b), least, most);
                  });
  return margins;
}

void drop_out_of_reach(const bodies::Bodies& bodies, const std::vector<double>& own, std::vector<ContactPoint>& points,
                       double margin) {
  Reach reach(bodies, own);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& c : points) changed = reach.hand_on(c.a, c.b, std::max(c.gap, 0.0)) || changed;
  }
  std::erase_if(
      points, [&](const ContactPoint& c) { return c.gap > 0 && c.gap >= margin && c.gap >= reach.between(c.a, c.b); });
}

}  // namespace nilas::detect
