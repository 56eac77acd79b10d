#include "contact/reach.h"

#include <algorithm>

namespace nilas {

std::vector<double> own_reach(const Bodies& bodies, double h, double share, double gravity) {
  const auto n = static_cast<std::size_t>(bodies.size());
  Vec3 mean = Vec3::Zero();
  double free = 0;
  for (std::size_t b = 0; b < n; ++b)
    if (bodies.motion[b] == Motion::free) {
      mean += bodies.v_GB[b];
      free += 1;
    }
  if (free > 0) mean /= free;
  std::vector<double> reach(n);
  for (std::size_t b = 0; b < n; ++b) {
    const bool fixed = bodies.motion[b] == Motion::fixed;
    const double speed =
        fixed ? mean.norm() : (bodies.v_GB[b] - mean).norm() + bodies.w_GB[b].norm() * bodies.shape[b]->bounding_radius;
    reach[b] = share * h * (speed + (fixed ? 0 : h * gravity));
  }
  return reach;
}

void drop_out_of_reach(std::vector<ContactPoint>& points, std::vector<double> reach) {
  // longest reach along chains: repeated relaxation, which ends because a reach only grows and gaps are paid on the way
  const auto at = [&](int b) -> double& { return reach[static_cast<std::size_t>(b)]; };
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& c : points) {
      const double gap = std::max(c.gap, 0.0), from_a = at(c.a) - gap, from_b = at(c.b) - gap;
      if (from_a > at(c.b)) {
        at(c.b) = from_a;
        changed = true;
      } else if (from_b > at(c.a)) {
        at(c.a) = from_b;
        changed = true;
      }
    }
  }
  std::erase_if(points, [&](const ContactPoint& c) { return c.gap >= at(c.a) + at(c.b); });
}

}  // namespace nilas
