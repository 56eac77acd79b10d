#pragma once
/// The motion of the water that bodies meet, undisturbed by them.
#include <memory>
#include <vector>

#include "core/base/math.h"

namespace nilas::hydro {

/// One part of that motion: a current, waves, the jet of a propeller. The parts add up.
class Flow {
 public:
  virtual ~Flow() = default;
  /// The velocity of the water at p_G [m] and time t [s], frame G [m/s]. Called from several threads.
  virtual Vec3 velocity(const Vec3& p_G, double t) const = 0;
  /// False where the drag of the vessel leaves this part out, since other loads on the vessel hold its effect: the jet
  /// of the vessel's own propeller.
  virtual bool acts_on_vessel() const { return true; }
};

using Flows = std::vector<std::shared_ptr<const Flow>>;

}  // namespace nilas::hydro
