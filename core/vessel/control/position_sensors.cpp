#include "core/vessel/control/position_sensors.h"

#include <algorithm>
#include <string>

#include "core/base/error.h"
#include "core/base/random.h"

namespace nilas::vessel {

PositionSensors::PositionSensors(const SensorSettings& settings, double t, const Vec3& position)
    : settings_(settings), times_{t}, positions_{position} {}

void PositionSensors::note(double t, const Vec3& position) {
  NILAS_DEMAND(t > times_.back());
  times_.push_back(t);
  positions_.push_back(position);
  // All before the last that is old enough are needed no more.
  const auto young = std::upper_bound(times_.begin(), times_.end(), t - settings_.delay);
  const auto old = std::max<std::ptrdiff_t>(young - times_.begin() - 1, 0);
  times_.erase(times_.begin(), times_.begin() + old);
  positions_.erase(positions_.begin(), positions_.begin() + old);
}

Vec3 PositionSensors::sample() {
  RandomStream noise(settings_.seed, "position sensors " + std::to_string(samples_++));
  const double x = noise.normal(), y = noise.normal(), heading = noise.normal();
  const double p = settings_.position_noise;
  Vec3 seen = positions_.front();
  if (const double late = times_.back() - settings_.delay - times_.front(); late > 0)
    seen += late / (times_[1] - times_[0]) * (positions_[1] - positions_[0]);
  return seen + Vec3(p * x, p * y, settings_.heading_noise * heading);
}

void PositionSensors::save(StateWriter out) const {
  out.add("samples", samples_);
  out.add("times", times_);
  out.add("positions", positions_);
}

void PositionSensors::restore(const StateReader& in) {
  in.get("samples", samples_);
  in.get("times", times_);
  in.get("positions", positions_, times_.size());
}

}  // namespace nilas::vessel
