#pragma once
/// The result of the breaking of a floe: an event for the outputs, and the pieces in its place.
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/math.h"

namespace nilas::fracture {

/// A floe that broke.
struct FractureEvent {
  double t = 0;      ///< [s]
  std::string kind;  ///< name_of(FailureKind)
  std::int64_t floe = 0;
  Vec3 p_G = Vec3::Zero();  ///< Start of the break; for crushing the centroid of the ice that leaves; in G [m].
  /// The energy that left the bodies with brash and crushed ice [J]. It is below 0 where free pieces of a fixed floe
  /// bring energy in.
  double energy = 0;
  double length = 0;  ///< Length of all cracks [m].
  /// Largest radius of the circumferential crack [m]. For splitting by `geometric` R_bending of its rule, 0 for `lefm`
  /// and crushing.
  double radius = 0;
  double ratio = 0;                  ///< Load over the load that the ice bears; for crushing volume over clear_volume.
  double brash = 0;                  ///< Mass of brash [kg].
  double extruded = 0;               ///< Mass of crushed ice that was cut out [kg].
  std::vector<std::int64_t> pieces;  ///< Ids of the pieces.
};

/// A piece of a floe that broke.
struct NewPiece {
  std::int64_t id = 0, floe = 0;
  Vec2 place = Vec2::Zero();  ///< Its centre in the floe's frame [m]; both frames are parallel.
};

}  // namespace nilas::fracture
