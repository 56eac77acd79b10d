#pragma once
/// The sensors of dynamic positioning: samples of position and heading with noise and delay.
#include <cstdint>
#include <vector>

#include "core/base/math.h"
#include "core/base/state.h"

namespace nilas::vessel {

struct SensorSettings {
  double period = 0;          ///< time between samples [s]
  double delay = 0;           ///< age of a sample when it arrives; rounded to whole periods [s]
  double position_noise = 0;  ///< standard deviation of x and of y [m]
  double heading_noise = 0;   ///< [rad]
  std::uint64_t seed = 0;
};

/// Noise is Gaussian and white, drawn for sample n from a stream of that number, so it depends on the seed and n alone.
class PositionSensors {
 public:
  /// `start`: x, y [m] and heading [rad], which arrive until the first sample is old enough.
  PositionSensors(const SensorSettings& settings, const Vec3& start);
  /// Takes a sample of the true position and returns the one that arrives now.
  Vec3 sample(const Vec3& position);
  long samples() const { return samples_; }

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  SensorSettings settings_;
  long samples_ = 0;
  std::vector<Vec3> under_way_;  ///< oldest first
};

}  // namespace nilas::vessel
