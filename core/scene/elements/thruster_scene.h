#pragma once
/// Values of <thrusters> and <control>.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/math.h"
#include "core/choices/thruster_choices.h"

namespace nilas::scene {

struct ThrusterScene {
  std::string name;
  ThrusterKind kind = ThrusterKind::tunnel;
  Vec3 at = Vec3::Zero();                                                      ///< frame V [m]
  double max_thrust = 0;                                                       ///< [N]
  std::optional<double> max_astern;                                            ///< [N]; default: max_thrust
  double power = 0;                                                            ///< at max_thrust [W]
  double lag = 1;                                                              ///< [s]
  std::optional<double> rate;                                                  ///< [N/s]; default: no limit
  double turn_rate_deg = 12;                                                   ///< [deg/s]
  std::vector<double> forbidden_deg;                                           ///< from, to of each sector
  double loss = 0;                                                             ///< share of the thrust
  std::optional<double> free_speed;                                            ///< [m/s]
  std::string loss_table;                                                      ///< absolute path, or empty
  std::optional<double> fails_at;                                              ///< [s]
  double thrust = 0;                                                           ///< command at the start [N]
  double angle_deg = 0;                                                        ///< angle, and its command, at the start
  double rudder_area = 0, rudder_span = 0, rudder_distance = 0, diameter = 0;  ///< [m^2, m, m, m]
  double rudder_limit_deg = 35;
  int line = 0;

  bool operator==(const ThrusterScene&) const = default;
};

struct ControlScene {
  ControlMode mode = ControlMode::none;
  std::optional<Vec2> setpoint;       ///< [m]; default: the position at the start
  std::optional<double> heading_deg;  ///< default: the heading at the start
  std::string path;                   ///< absolute path, or empty
  Vec3 bandwidth{0.1, 0.1, 0.2};      ///< surge, sway, yaw [rad/s]
  double damping_ratio = 0.7;
  std::optional<Vec3> filter_bandwidth;    ///< default: bandwidth
  std::optional<Vec3> observer_bandwidth;  ///< default: k_observer_ratio times bandwidth
  std::optional<double> wave_period;       ///< [s]; default: no wave filter
  std::optional<Vec2> added_mass;          ///< surge, sway [kg]; default: as in <added_mass>
  std::optional<double> added_inertia;     ///< yaw [kg m^2]; default: as in <added_mass>
  Vec2 damping = Vec2::Zero();             ///< surge, sway [N s/m]
  double yaw_damping = 0;                  ///< [N m s]
  bool wind_feed_forward = true;
  std::optional<double> sensor_period;  ///< [s]; default: the step
  double sensor_delay = 0;              ///< [s]
  double position_noise = 0;            ///< [m]
  double heading_noise_deg = 0;
  std::optional<double> watch_circle;  ///< radius [m]
  std::optional<double> most_offset;   ///< [m]; default: the length of the hull

  /// Bandwidth of the observer over that of the control: well above, so that the estimate does not slow the loop.
  static constexpr double k_observer_ratio = 5;
  /// Length of the hull for which the bandwidth, the lag and the turn rate above are chosen [m]: the supply vessel of
  /// Fossen's toolbox. Other hulls scale them by Froude.
  static constexpr double k_length = 76.2;

  bool operator==(const ControlScene&) const = default;
};

}  // namespace nilas::scene
