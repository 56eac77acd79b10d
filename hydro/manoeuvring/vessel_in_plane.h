#pragma once
/// The vessel as seen from above.
#include "core/bodies/bodies.h"
#include "hydro/manoeuvring/planar_motion.h"

namespace nilas::hydro {

/// Where the vessel is and how it moves in the horizontal plane. Vectors are in G.
struct VesselInPlane {
  Vec2 ahead = Vec2::UnitX();   ///< horizontal direction of its x axis
  double yaw = 0;               ///< from X towards Y [rad]
  Vec3 arm = Vec3::Zero();      ///< from the centre of mass to the point amidships [m]
  Vec2 midship = Vec2::Zero();  ///< that point [m]
  PlanarMotion motion;          ///< its motion through the water

  Vec2 starboard() const { return {ahead.y(), -ahead.x()}; }
  double speed() const;  ///< through the water [m/s]
  double drift()
      const;  ///< drift angle atan(-v/u), positive where the flow comes from starboard's side of the bow [rad]
};

/// `vessel`: index of its hull. `midship`: x of the point amidships in body axes, from the centre of mass, at whose
/// height it lies [m]. `current`: velocity of the water [m/s].
VesselInPlane vessel_in_plane(const bodies::Bodies& bodies, int vessel, double midship, const Vec3& current);

}  // namespace nilas::hydro
