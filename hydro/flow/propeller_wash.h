#pragma once
/// The module that keeps the jets of the vessel's propellers and thrusters at the present thrust and pose. It exerts no
/// load itself: floes take the drag of the water that a jet moves.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/channels.h"
#include "core/bodies/module.h"
#include "hydro/flow/propeller_jet.h"

namespace nilas::hydro {

/// One propeller or thruster. `position` is from the vessel's centre of mass, in the axes of V [m].
struct WashSource {
  std::shared_ptr<PropellerJet> jet;
  Vec3 position = Vec3::Zero();
  Vec3 direction = -Vec3::UnitX();  ///< the unit vector along which the jet leaves with positive thrust, in V
  double thrust = 0;                ///< constant thrust where no channel gives it [N]
  int thrust_channel = -1;          ///< the channel of the present thrust [N]; -1: none
  int angle_channel = -1;           ///< the channel of the angle that `push` takes [rad]; -1: `direction` holds
  /// Force of unit thrust at that angle in the vessel's x and y axes, of a thruster that turns or has a rudder: the jet
  /// carries away its momentum. `ahead`: whether the thrust is positive.
  std::function<Vec2(double angle, bool ahead)> push;
};

/// The names under which an actuator publishes its present state.
inline std::string thrust_channel_name(const std::string& actuator) { return actuator + ".thrust_actual"; }
inline std::string angle_channel_name(const std::string& actuator) { return actuator + ".angle_actual"; }

/// Makes the module. At the end of each substep it gives the jets the pose of `hull`, the index of the hull, and the
/// thrust of that time. They stay so during the next substep. `bodies`: at the start of the run.
std::unique_ptr<bodies::Module> make_propeller_wash(std::vector<WashSource> sources, int hull,
                                                    std::shared_ptr<const Channels> channels,
                                                    const bodies::Bodies& bodies);

}  // namespace nilas::hydro
