#pragma once
/// Values of <manoeuvring> and <manoeuvre>.
#include <optional>
#include <string>

#include "core/choices/manoeuvring_choices.h"

namespace nilas::scene {

struct ManoeuvringScene {
  ManoeuvringModel model = ManoeuvringModel::mmg;
  std::optional<ManoeuvringPreset> preset;
  std::optional<double> length;                            ///< of the preset [m]; default: as published
  std::string file;                                        ///< absolute path, or empty
  PropulsionKind propulsion = PropulsionKind::open_water;  ///< of the file
  std::optional<double> midship;                           ///< x in V [m]; default: the middle of the hull
  double rudder_rate_deg_s = 2.34, max_rudder_deg = 35;
  std::optional<double> propeller;       ///< at the start [1/s]; default: holds the initial speed
  std::optional<double> propeller_rate;  ///< [1/s^2]

  bool operator==(const ManoeuvringScene&) const = default;
};

struct ManoeuvreScene {
  ManoeuvreKind kind = ManoeuvreKind::straight;
  std::optional<double> start;        ///< [s]; default: that of the scene
  std::optional<double> angle_deg;    ///< of the rudder, positive to starboard
  std::optional<double> heading_deg;  ///< change of heading (zigzag), or heading (course)
  std::optional<double> speed;        ///< [m/s]
  std::string file;                   ///< absolute path, or empty
  double heading_gain = 2, speed_gain = 2;
  std::optional<double> yaw_rate_gain, heading_time, speed_time;  ///< [s]

  bool operator==(const ManoeuvreScene&) const = default;
};

/// The rudder angles of a manoeuvre that gives none.
constexpr double k_circle_rudder_deg = 35, k_zigzag_rudder_deg = 10;

}  // namespace nilas::scene
