#pragma once
/// The lines of control from outside: JSON objects.
#include <string>

#include "core/base/channels.h"
#include "core/base/math.h"

namespace nilas::vessel {

/// What the other program is told.
struct Measured {
  double time = 0;        ///< [s]
  long step = 0;          ///< steps that are done
  Vec3 p = Vec3::Zero();  ///< centre of mass, frame G [m]
  Quat q = Quat::Identity();
  Vec3 v = Vec3::Zero();  ///< velocity of the centre of mass, frame G [m/s]
  Vec3 w = Vec3::Zero();  ///< angular velocity, frame G [rad/s]
};

/// The line of a state: time_s, step, position_m, yaw_rad, pitch_rad, roll_rad (turns about z, the new y, the new x),
/// velocity_m_s in the ground frame, speeds_m_s (surge, sway, heave) and rates_rad_s (roll, pitch, yaw) in the vessel's
/// axes, commands by name, and what actuators measure of themselves, by name. Numbers read back as the same double.
std::string line_of(const Measured& state, const Channels& channels);

/// Sets the commands of an answer: {"commands": {"rudder": 0.1}}; an empty object keeps all. Returns the fault of a
/// line that is no such object, that names an unknown or a measured channel, or that has a value that is no finite
/// number; then nothing is set. Empty: there is none.
std::string obey(const std::string& line, Channels& commands);

}  // namespace nilas::vessel
