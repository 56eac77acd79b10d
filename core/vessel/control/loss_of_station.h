#pragma once
/// Why dynamic positioning lost a vessel, as far as the loads tell that it wanted.
#include <string>

#include "core/base/math.h"
#include "core/base/state.h"

namespace nilas::vessel {

/// What the thrusters gave less of than the control wanted; where it is both, that of which more is missing.
enum class Shortfall { none, force, moment };

/// Keeps for how long the thrusters fell short, and whether the load that was wanted then pointed one way or swung to
/// and fro. A load of the surroundings that is too strong makes the first, a control loop that diverges the second.
class LossOfStation {
 public:
  /// Adds h [s] under a wanted force in G [N] and a moment about Z [N m].
  void add(const Vec2& force, double moment, Shortfall shortfall, double h);
  /// Sentences of a message: what was seen, and what to change in the scene.
  std::string text() const;
  /// The same of a vessel that is not lost, where the thrusters fell short most of the time under a load that swung to
  /// and fro: the limits of the thrusters alone bound its swings. Empty for any other.
  std::string swinging() const;

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  double short_share() const { return time_ > 0 ? (force_time_ + moment_time_) / time_ : 0; }
  bool one_way() const;
  std::string seen() const;

  double time_ = 0;  ///< [s]
  // Over the time in which it fell short: that time, the impulse of the wanted load, and the integral of its magnitude.
  double force_time_ = 0, force_size_ = 0, moment_time_ = 0, moment_size_ = 0, moment_ = 0;
  Vec2 force_ = Vec2::Zero();
};

}  // namespace nilas::vessel
