#pragma once
/// What the breaking of a floe leaves: an event for the outputs, and the pieces in its place.
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/math.h"

namespace nilas {

/// A floe that broke.
struct FractureEvent {
  double t = 0;      ///< [s]
  std::string kind;  ///< name_of(FailureKind)
  std::int64_t floe = 0;
  Vec3 p_G = Vec3::Zero();           ///< of the edge where it began [m]
  double energy = 0;                 ///< that left the bodies: of brash; of a floe that was fixed, what its free pieces
                                     ///< bring in, below 0 [J]
  double length = 0;                 ///< of all cracks [m]
  double radius = 0;                 ///< of the circumferential crack, 0 where there is none [m]
  double ratio = 0;                  ///< load over what the ice bears; of crushing volume over clear_volume
  double brash = 0;                  ///< [kg]
  double extruded = 0;               ///< crushed ice that was cut out [kg]
  std::vector<std::int64_t> pieces;  ///< ids
};

/// A piece of a floe that broke, in whose place it came.
struct NewPiece {
  std::int64_t id = 0, floe = 0;
  Vec2 place = Vec2::Zero();  ///< of its centre in the floe's frame, to which its own is parallel [m]
};

}  // namespace nilas
