#pragma once
/// The velocities around one velocity step, for accounts of energy and momentum.
#include <vector>

#include "contact/assemble.h"
#include "contact/detect/broad/contact_point.h"
#include "core/bodies/bodies.h"
#include "core/bodies/module.h"

namespace nilas {

/// Linear and angular velocities of all bodies at the same instant, in G.
struct Velocities {
  std::vector<Vec3> v;  ///< of the centre of mass [m/s]
  std::vector<Vec3> w;  ///< [rad/s]
};

/// One velocity step at the pose where the contacts were found. Body k takes part when it moves.
struct StepMotion {
  double h = 0;              ///< [s]
  std::vector<Vec3> p;       ///< centres of mass where the contacts were found [m]
  std::vector<Mat3> R;       ///< attitudes R_GB there
  Velocities before, after;  ///< around the impulses, at that pose; of a vessel on a carriage: at both ends of the step
  std::vector<ContactPoint> points;
  std::vector<Vec3> impulses;         ///< per point, on body b, in G [N s]
  std::vector<Vec3> normal_impulses;  ///< the part of it along the normal
  std::vector<double> speed_asked;    ///< per point: u_N that the stabilisation asked of the velocity step [m/s]
  std::vector<Vec3> couples;          ///< per point, on body b, in G [N m s]; empty without rolling friction
};

/// Velocity of body B's point relative to body A's at a contact point.
Vec3 relative_velocity(const StepMotion& motion, const Velocities& velocities, std::size_t contact);

/// The contact points where the bodies' present poses have carried them: each body's point moves with it, the normal
/// with the mean of both, and the gap is what lies between.
std::vector<ContactPoint> carried_points(const StepMotion& motion, const Bodies& bodies);

/// Sum of the contact impulses on one body about its centre of mass at the pose of the step's contacts [N s, N m s].
Wrench contact_impulse_on(const StepMotion& motion, int body);

}  // namespace nilas
