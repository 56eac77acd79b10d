#pragma once
/// How contacts of the reference integrator move with their bodies.
#include <cstdint>
#include <functional>
#include <vector>

#include "contact/detect/broad/contact_point.h"
#include "core/bodies/bodies.h"

namespace nilas::sim {

/// Position of a contact, the relative velocity of its points, and the part of their relative acceleration that is
/// independent of the bodies' accelerations.
struct ContactKinematics {
  bool found = false;
  detect::ContactPoint point;
  Mat3 frame = Mat3::Identity();  ///< columns n, t1, t2
  Vec3 velocity = Vec3::Zero();   ///< velocity of B's point relative to A's, frame G [m/s]
  Vec3 bias = Vec3::Zero();       ///< rate of (u_N, u_T) at zero acceleration, along `frame` [m/s^2]
};

/// The contact points of bodies in their present poses.
using FindContacts = std::function<std::vector<detect::ContactPoint>(const bodies::Bodies&)>;

/// Velocity of B's point relative to A's, frame G [m/s].
Vec3 velocity_between(const bodies::Bodies& bodies, const detect::ContactPoint& c);

/// The contacts with these keys. Their bias is a difference along the motion, of second order or, where a point moves
/// much faster than the bodies, of fourth: central, or to the one side where the contact lasts. It is zero where it
/// lasts on neither. Poses change meanwhile, and are put back.
std::vector<ContactKinematics> follow_contacts(bodies::Bodies& bodies, const std::vector<std::uint64_t>& keys,
                                               const FindContacts& detect);

}  // namespace nilas::sim
