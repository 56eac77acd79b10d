#include "core/vessel/control/position_sensors.h"

#include "core/base/random.h"

namespace nilas::vessel {

PositionSensors::PositionSensors(const SensorSettings& settings, const Vec3& start)
    : settings_(settings), under_way_(static_cast<std::size_t>(std::lround(settings.delay / settings.period)), start) {}

Vec3 PositionSensors::sample(const Vec3& position) {
  RandomStream noise(settings_.seed, "position sensors " + std::to_string(samples_++));
  const double x = noise.normal(), y = noise.normal(), heading = noise.normal();
  const double p = settings_.position_noise;
  under_way_.push_back(position + Vec3(p * x, p * y, settings_.heading_noise * heading));
  const Vec3 arrived = under_way_.front();
  under_way_.erase(under_way_.begin());
  return arrived;
}

void PositionSensors::save(StateWriter out) const {
  out.add("samples", samples_);
  out.add("under_way", under_way_);
}

void PositionSensors::restore(const StateReader& in) {
  in.get("samples", samples_);
  in.get("under_way", under_way_, under_way_.size());
}

}  // namespace nilas::vessel
