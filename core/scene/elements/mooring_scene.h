#pragma once
/// Values of <vessel><mooring>.
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/choices/mooring_choices.h"

namespace nilas::scene {

/// What lines of all kinds have.
struct MooringLineScene {
  std::string name;
  Vec3 fairlead = Vec3::Zero();  ///< frame V [m]
  Vec3 anchor = Vec3::Zero();    ///< frame G [m]
  double length = 0;             ///< unstretched [m]
  double damping = 0;            ///< [N s/m]
  std::optional<double> break_load, break_time;
  bool turret = false;
  int line = 0;  ///< of the scene file, for messages

  bool operator==(const MooringLineScene&) const = default;
};
/// <line>: a catenary.
struct CatenaryScene : MooringLineScene {
  double weight = 0;     ///< in water [N/m]
  double stiffness = 0;  ///< EA [N]
  double bed_friction = 0;
  double diameter = 0;  ///< its axis lies half of it above the bed [m]

  bool operator==(const CatenaryScene&) const = default;
};
/// <spring_line>
struct SpringLineScene : MooringLineScene {
  std::optional<double> stiffness, second_stiffness, knee;  ///< [N/m, N/m, m]
  std::string table;                                        ///< absolute path, or empty

  bool operator==(const SpringLineScene&) const = default;
};
struct TurretScene {
  Vec3 at = Vec3::Zero();  ///< frame V [m]
  double friction = 0;     ///< [N m]

  bool operator==(const TurretScene&) const = default;
};
struct MooringScene {
  MooringKind model = MooringKind::quasi_static;
  MooringStart start = MooringStart::equilibrium;
  std::string file;             ///< absolute path of MoorDyn's input, or empty
  std::optional<double> depth;  ///< of the bed below still water [m]; empty: no bed, or the tank's floor
  std::vector<CatenaryScene> lines;
  std::vector<SpringLineScene> springs;
  std::optional<TurretScene> turret;

  bool operator==(const MooringScene&) const = default;
};

}  // namespace nilas::scene
