#pragma once
/// The module that steers a vessel through a manoeuvre.
#include <memory>

#include "core/base/channels.h"
#include "core/bodies/module.h"
#include "hydro/manoeuvring/manoeuvre.h"

namespace nilas::hydro {

struct SteeringSettings {
  int vessel = 0;               ///< index of the hull among the bodies
  double midship = 0;           ///< x of the point amidships in body axes, from the centre of mass [m]
  Vec3 current = Vec3::Zero();  ///< [m/s]
  double start = 0;             ///< time at which the manoeuvre begins [s]; until then commands stay as they are
};

/// Sets the channels `rudder` and `propeller` at the end of each substep, so that they hold in the next one. Throws
/// InputError where there are no such channels.
std::unique_ptr<bodies::Module> make_steering(const SteeringSettings& settings, std::unique_ptr<Manoeuvre> manoeuvre,
                                              std::shared_ptr<Channels> commands);

}  // namespace nilas::hydro
