#include "contact/reach.h"

#include <algorithm>

namespace nilas {

namespace {

Vec3 mean_free_velocity(const Bodies& bodies) {
  Vec3 sum = Vec3::Zero();
  double free = 0;
  for (int b = 0; b < bodies.size(); ++b)
    if (bodies.is_free(b)) {
      sum += bodies.v_GB[static_cast<std::size_t>(b)];
      free += 1;
    }
  return free > 0 ? Vec3(sum / free) : sum;
}

}  // namespace

std::vector<double> own_reach(const Bodies& bodies, const Wrenches& loads, double h, double share) {
  const Vec3 mean = mean_free_velocity(bodies);
  std::vector<double> reach(static_cast<std::size_t>(bodies.size()));
  for (std::size_t b = 0; b < reach.size(); ++b) {
    Vec3 v = bodies.v_GB[b] - mean, w = bodies.w_GB[b];
    if (bodies.motion[b] == Motion::free) {
      const Mat3& R = bodies.R_GB[b];
      v += h / bodies.mass[b] * loads[b].force;
      w += R * (bodies.inertia_inverse_B[b] * (R.transpose() * (h * loads[b].torque)));
    }
    const double radius = bodies.motion[b] == Motion::fixed ? 0 : bodies.shape[b]->bounding_radius;
    reach[b] = share * h * (v.norm() + w.norm() * radius);
  }
  return reach;
}

void drop_out_of_reach(const Bodies& bodies, const std::vector<double>& own, std::vector<ContactPoint>& points) {
  std::vector<double> reach = own;
  const auto index = [](int b) { return static_cast<std::size_t>(b); };
  /// Hands on what a body of index `from` can reach; true when that is more than `to` could by itself.
  const auto push = [&](std::size_t from, std::size_t to, double gap) {
    if (!bodies.is_free(static_cast<int>(to))) return false;
    const double share =
        bodies.is_free(static_cast<int>(from)) ? bodies.mass[from] / (bodies.mass[from] + bodies.mass[to]) : 1;
    const double pushed = share * (reach[from] - gap);
    if (pushed <= reach[to]) return false;
    reach[to] = pushed;
    return true;
  };
  // repeated relaxation ends, because every hop loses a share of the reach
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& c : points) {
      const double gap = std::max(c.gap, 0.0);
      changed = push(index(c.a), index(c.b), gap) || changed;
      changed = push(index(c.b), index(c.a), gap) || changed;
    }
  }
  std::erase_if(points, [&](const ContactPoint& c) {
    const std::size_t a = index(c.a), b = index(c.b);
    return c.gap > 0 && c.gap >= std::max(reach[a] + own[b], own[a] + reach[b]);
  });
}

}  // namespace nilas
