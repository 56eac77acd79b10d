#pragma once
/// The reference filter of dynamic positioning: it turns set-points and paths into motions that the vessel can follow.
#include "core/base/math.h"
#include "core/base/state.h"

namespace nilas::vessel {

/// x''' + 3 w x'' + 3 w^2 x' + w^3 x = w^3 (r + 3/w r')  for x, y and heading, the third-order filter of Fossen (2011,
/// 10.2.1) with critical damping: three poles at -w. A jump of r gives  1 - exp(-w t) (1 + w t + (w t)^2 / 2), without
/// overshoot; the rate r' of a path keeps the filter from lagging behind a steady motion. Exact over steps of any size
/// in which r + 3/w r' is constant.
class ReferenceFilter {
 public:
  /// At rest at `start`: x, y [m] and heading [rad]. `bandwidth`: w of each [rad/s].
  ReferenceFilter(const Vec3& bandwidth, const Vec3& start) : bandwidth_(bandwidth), position_(start) {}

  void advance(const Vec3& target, const Vec3& target_rate, double h);
  const Vec3& position() const { return position_; }
  const Vec3& velocity() const { return velocity_; }
  const Vec3& acceleration() const { return acceleration_; }

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  Vec3 bandwidth_, position_;
  Vec3 velocity_ = Vec3::Zero(), acceleration_ = Vec3::Zero();
};

}  // namespace nilas::vessel
