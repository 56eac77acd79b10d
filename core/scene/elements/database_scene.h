#pragma once
/// Values of <database>.
#include <optional>
#include <string>

#include "core/base/math.h"

namespace nilas::scene {

/// A hydrodynamic database of the vessel, and the place of its frame D in V.
struct DatabaseScene {
  std::string file;                                       ///< absolute path
  std::optional<double> length, density, gravity, depth;  ///< of its computation; see hydro::DatabaseSettings
  std::optional<Vec3> reference;                          ///< frame D [m]
  std::optional<Vec3> origin;                             ///< frame V [m]; default: in still water below or above V's
  double rotation_deg = 0;                                ///< of D about Z, from x of V towards y

  bool operator==(const DatabaseScene&) const = default;
};

}  // namespace nilas::scene
