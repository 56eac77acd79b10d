#pragma once
/// The velocities around one velocity step, for accounts of energy and momentum.
#include <vector>

#include "contact/assemble.h"
#include "contact/detect/broad/contact_point.h"
#include "core/bodies/bodies.h"
#include "core/bodies/module.h"

namespace nilas::contact {

/// Linear and angular velocities of all bodies at the same instant, in G.
struct Velocities {
  std::vector<Vec3> v;  ///< velocities of the centres of mass [m/s]
  std::vector<Vec3> w;  ///< [rad/s]
};

/// One velocity step at the pose where the contacts were found. Body k takes part where it can move.
struct StepMotion {
  double h = 0;         ///< [s]
  std::vector<Vec3> p;  ///< centres of mass where the contacts were found [m]
  std::vector<Mat3> R;  ///< attitudes R_GB there
  Velocities before,
      after;  ///< velocities before and after the impulses, at that pose; for a vessel on a carriage: at both ends of
              ///< the step
  std::vector<detect::ContactPoint> points;
  std::vector<Vec3> impulses;         ///< impulses at the points, on body b, in G [N s]
  std::vector<Vec3> normal_impulses;  ///< their components along the normal
  std::vector<double> speed_asked;    ///< u_N that the stabilisation asked of the velocity step at each point [m/s]
  std::vector<SpringStep> springs;    ///< of the points; empty where no contact is elastic
  std::vector<Vec3> couples;  ///< couples at the points, on body b, in G [N m s]; empty without rolling friction
};

/// The velocity of body B relative to body A at a contact point, in G [m/s].
Vec3 relative_velocity(const StepMotion& motion, const Velocities& velocities, std::size_t contact);

/// The contact points, carried along with the bodies to their present poses. Each body's point moves with the body, the
/// normal turns with the mean of both bodies, and the gap is the distance along it.
std::vector<detect::ContactPoint> carried_points(const StepMotion& motion, const bodies::Bodies& bodies);

/// The sum of the contact impulses on one body, about its centre of mass at the pose of the step's contacts [N s, N m
/// s].
Wrench contact_impulse_on(const StepMotion& motion, int body);

}  // namespace nilas::contact
