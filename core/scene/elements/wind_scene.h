#pragma once
/// Values of <wind>, of the vessel's <wind_area> and of <hydro><propeller_wash><jet>.
#include <optional>
#include <string>

#include "core/base/math.h"
#include "core/choices/wind_choices.h"

namespace nilas::scene {

struct WindScene {
  double speed = 0;          ///< mean at 10 m [m/s]
  double direction_deg = 0;  ///< towards which it blows, from X towards Y
  double density = defaults::k_air_density;
  WindProfileKind profile = WindProfileKind::uniform;
  double exponent = defaults::k_wind_exponent;
  GustSpectrum gusts = GustSpectrum::none;
  double floe_drag = defaults::k_floe_air_drag;

  bool operator==(const WindScene&) const = default;
};

struct WindAreaScene {
  WindAreaModel model = WindAreaModel::blendermann;
  std::optional<BlendermannShip> ship_type;
  std::string file;               ///< absolute path, or empty
  double frontal = 0;             ///< [m^2]
  double lateral = 0;             ///< [m^2]
  std::optional<double> length;   ///< [m]; default: that of the hull
  std::optional<double> midship;  ///< x in V [m]; default: the middle of the hull
  double lateral_centroid = 0;    ///< ahead of the midship section [m]
  std::optional<double> height;   ///< of the centroid above still water [m]; default: half the mean height of the area

  bool operator==(const WindAreaScene&) const = default;
};

struct JetScene {
  std::string thruster;           ///< name of the actuator; empty where the thrust is constant
  std::optional<double> thrust;   ///< [N]
  double diameter = 0;            ///< [m]
  Vec3 position = Vec3::Zero();   ///< frame V [m]
  std::optional<Vec3> direction;  ///< in V; default: against the thrust, or astern where it is constant
  int line = 0;

  bool operator==(const JetScene&) const = default;
};

}  // namespace nilas::scene
