#pragma once
/// The thrusters of a vessel as a force module.
#include <functional>
#include <memory>
#include <vector>

#include "core/base/channels.h"
#include "core/bodies/module.h"
#include "core/vessel/thrusters/thruster.h"

namespace nilas::vessel {

/// Names of a thruster's channels. Commands: thrust [N], and angle [rad] of azimuths and rudders. Measurements, set at
/// the end of each substep: thrust and angle as they are, without losses, and whether it works (1 or 0).
std::string thrust_channel(const Thruster& thruster);
std::string angle_channel(const Thruster& thruster);
std::string actual_thrust_channel(const Thruster& thruster);
std::string actual_angle_channel(const Thruster& thruster);
std::string works_channel(const Thruster& thruster);

/// Sum over the run: energy that the thrusters took [J].
inline constexpr std::string_view k_thruster_energy = "thruster_energy";

struct ThrusterSettings {
  std::vector<Thruster> thrusters;
  std::vector<ThrusterState> commands;  ///< at the start, one per thruster; the thrust itself starts at zero
  Vec3 com_V = Vec3::Zero();            ///< centre of mass of the hull, frame V [m]
  int hull = 0;                         ///< index of the hull's body
  double start = 0;                     ///< time at the start [s]
  /// Velocity of the undisturbed water at a point [m] and time [s], frame G [m/s]; empty: at rest.
  std::function<Vec3(const Vec3&, double)> water_velocity;
};

/// The module `thruster`. Each thruster exerts thruster_force() at its point, in the x-y plane of the vessel's own
/// axes, by its thrust at the start of the substep. At the substep's end it follows its commands by advanced(). Adds
/// its channels to `channels`, which it keeps. Columns: thruster_<name>_N (without losses), thruster_<name>_deg where
/// it turns, thruster_<name>_saturation_1 and thruster_power_W, at the end of the step. Figures: energy_J, and
/// at_limit_<name>_1, the share of the time time_s in which a thruster that works was asked for all that it gives.
std::unique_ptr<bodies::ForceModule> make_thrusters(const ThrusterSettings& settings,
                                                    const std::shared_ptr<Channels>& channels);

}  // namespace nilas::vessel
