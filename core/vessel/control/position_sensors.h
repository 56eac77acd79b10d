#pragma once
/// The sensors of dynamic positioning: samples of position and heading with noise and delay.
#include <cstdint>
#include <vector>

#include "core/base/math.h"
#include "core/base/state.h"

namespace nilas::vessel {

struct SensorSettings {
  double period = 0;          ///< time between samples [s]
  double delay = 0;           ///< age of a sample when it arrives [s]
  double position_noise = 0;  ///< standard deviation of x and of y [m]
  double heading_noise = 0;   ///< [rad]
  std::uint64_t seed = 0;
};

/// Noise is Gaussian and white, drawn for the n-th sample that arrives from a stream of that number, so it depends on
/// the seed and n alone.
class PositionSensors {
 public:
  /// `t`: time at the start [s]; `position`: x, y [m] and heading [rad] then and, for the sensors, before.
  PositionSensors(const SensorSettings& settings, double t, const Vec3& position);
  /// Notes the true position at a time after all noted before. The heading is continuous.
  void note(double t, const Vec3& position);
  /// The sample that arrives at the time noted last: the position one delay ago, linear between noted ones, with noise.
  Vec3 sample();

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  SensorSettings settings_;
  long samples_ = 0;
  /// Noted times [s] and positions, oldest first, from the last that is at least one delay old.
  std::vector<double> times_;
  std::vector<Vec3> positions_;
};

}  // namespace nilas::vessel
