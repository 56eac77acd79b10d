#pragma once
/// Dynamic positioning as a module: sensors, observer, reference, control law and thrust allocation.
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "core/base/channels.h"
#include "core/bodies/module.h"
#include "core/vessel/control/observer.h"
#include "core/vessel/control/position_controller.h"
#include "core/vessel/control/position_sensors.h"
#include "core/vessel/control/positioning_plan.h"
#include "core/vessel/thrusters/allocation.h"

namespace nilas::vessel {

/// A load on the hull that is known without measuring motions, about its centre of mass in G.
using KnownLoad = std::function<Wrench(const bodies::Bodies&, double t)>;

struct DpSettings {
  PositioningPlan plan;
  SensorSettings sensors;
  ObserverSettings observer;
  ControllerSettings controller;
  Vec3 filter_bandwidth = Vec3::Ones();  ///< of the reference filter [rad/s]
  std::optional<double> watch_circle;    ///< radius [m]
  double most_offset = 0;                ///< from the reference, beyond which the run ends [m]
  std::array<double, 2> window{};        ///< of the statistics: from, to [s]
  KnownLoad known_load;                  ///< the thrusters cancel it; may be empty
  int hull = 0;                          ///< index of the hull's body
  double start = 0;                      ///< time at the start [s]
  Vec3 position = Vec3::Zero();          ///< at the start: centre of mass x, y [m], heading [rad]
  Vec3 velocity = Vec3::Zero();          ///< at the start: surge, sway [m/s], yaw rate [rad/s]
};

/// x, y [m] of a body's centre of mass and its heading, the angle of its x axis from X [rad].
Vec3 plane_position(const bodies::Bodies& bodies, int body);
/// Velocity of the centre of mass along the vessel's horizontal axes [m/s] and rate of turn about Z [rad/s].
Vec3 plane_velocity(const bodies::Bodies& bodies, int body);

/// The module `control`. At the first substep's end of each sensor period it
///   1. samples position and heading,
///   2. advances the observer by the measured thrusts of the period, and corrects it,
///   3. advances the reference filter towards the plan,
///   4. computes the wanted load, allocates it to the thrusters that work, and sets their commands,
///   5. advances the integral by the allocation's shortfall.
/// Between samples the commands stay. Columns: dp_offset_m, dp_heading_error_deg (from the plan), dp_estimate_error_m
/// (of the observer's position), dp_wanted_fx_N, dp_wanted_fy_N, dp_wanted_mz_Nm, dp_shortfall_N, dp_shortfall_Nm and
/// dp_outside_1, at the end of the step. Sums: station_statistics.h. The thrusters' channels must exist in `channels`.
/// Throws InputError where the observer does not converge at the sensor period. end_substep() throws SimulationError
/// where the vessel is further than `most_offset` from the reference or half a turn from its heading, or where a value
/// is not finite.
std::unique_ptr<bodies::Module> make_dp(const DpSettings& settings, Allocation allocation,
                                        const std::shared_ptr<Channels>& channels);

}  // namespace nilas::vessel
