#include "core/vessel/control/reference_filter.h"

namespace nilas::vessel {

void ReferenceFilter::advance(const Vec3& target, const Vec3& target_rate, double h) {
  constexpr double k_poles = 3;
  for (int k = 0; k < 3; ++k) {
    const double w = bandwidth_[k], goal = target[k] + k_poles / w * target_rate[k];
    // The deviation from the goal is exp(-w t) (a + b t + c t^2).
    const double a = position_[k] - goal, b = velocity_[k] + w * a;
    const double c = 0.5 * (acceleration_[k] + 2 * w * velocity_[k] + w * w * a);
    const double decay = std::exp(-w * h), p = a + h * (b + h * c), dp = b + 2 * c * h;
    position_[k] = goal + decay * p;
    velocity_[k] = decay * (dp - w * p);
    acceleration_[k] = decay * (2 * c - 2 * w * dp + w * w * p);
  }
}

void ReferenceFilter::save(StateWriter out) const {
  out.add("position", position_);
  out.add("velocity", velocity_);
  out.add("acceleration", acceleration_);
}

void ReferenceFilter::restore(const StateReader& in) {
  in.get("position", position_);
  in.get("velocity", velocity_);
  in.get("acceleration", acceleration_);
}

}  // namespace nilas::vessel
