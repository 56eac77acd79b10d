#pragma once
/// Linear hydrostatics of the vessel from a hydrodynamic database.
#include <memory>

#include "core/base/log.h"
#include "core/bodies/module.h"
#include "hydro/database/database.h"

namespace nilas::hydro {

/// The hull, its weight and the frame D of the database on it.
struct RestoredHull {
  int body = -1;                    ///< index of the hull
  Pose D_in_B;                      ///< frame D in the body frame of the hull (origin at the centre of mass, axes of V)
  double mass = 0;                  ///< of the whole vessel [kg]
  double gravity = 0;               ///< [m/s^2]
  double level = 0;                 ///< z of still water [m]
  double lift = 0;                  ///< buoyancy where the plane z = 0 of D is the still water [N]
  Vec2 lift_centre = Vec2::Zero();  ///< where it acts, x and y in D [m]
};

/// The hydrostatic stiffness of a database, which must have one, for a vessel of this weight [N] whose centre of mass
/// lies at `com_D` in frame D: the weight's part -m g z_g in roll and pitch is replaced. A database that does not state
/// its centre of gravity is taken to have been computed with that of the vessel. The part of the water is taken times
/// `specific_weight`, density times gravity of the water around the vessel [N/m^3], over that of the database, so that
/// lift and stiffness are those of one water.
Mat6 restoring_with_weight_at(const Database& database, double specific_weight, double weight, const Vec3& com_D);

/// The hydrostatic load of a hull that heaves, rolls and pitches a little about the place at which the plane z = 0 of D
/// is the still water. It derives from the potential
///   U = -L (s - x_b theta + y_b phi) + 1/2 q C q,   q = (s, phi, theta),
/// with s the height of D's origin above still water and phi, theta the angles of D about X and Y (yaw before pitch
/// before roll). L is the lift at (x_b, y_b), and C the stiffness of the water alone: that of the database without its
/// weight term -m g z_g in roll and pitch [Newman 1977, 6.16]. Where the lift is not the weight, the vessel rests a
/// little above or below. The load acts at the attitude of the vessel and has no part in surge, sway and yaw.
/// `restoring`: 6 x 6 about the origin of D, with the weight of the vessel at its centre of mass [N/m, N, N m].
std::unique_ptr<bodies::ForceModule> make_restoring(const RestoredHull& hull, const Mat6& restoring);

/// Up to this angle from the upright the loads of a database are those of small angles within some per cent [rad]:
/// sine and tangent of 20 degrees differ from the angle by 2 and 4 %.
inline constexpr double k_small_tilt = 20 * k_deg;

/// Makes the module `database_tilt`, which exerts no loads. It warns once in a run, with time and angle, where the
/// vertical axis of the hull first leans over by more than k_small_tilt. `warnings` must outlive it.
std::unique_ptr<bodies::Module> make_tilt_watch(int hull, WarningCounts& warnings);

}  // namespace nilas::hydro
