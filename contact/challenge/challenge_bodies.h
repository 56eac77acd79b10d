#pragma once
/// Building blocks of hand-made contact problems: rigid bodies and the contacts between them.
#include <vector>

#include "contact/problem/problem.h"
#include "core/base/random.h"

namespace nilas::challenge {

/// A free rigid body of a hand-built problem.
struct RigidBody {
  double mass = 1;
  Mat3 inertia = Mat3::Identity();  ///< inertia about the centre of mass, in G
  Vec3 p = Vec3::Zero();            ///< centre of mass
  Vec3 v = Vec3::Zero();            ///< velocities without contact, v [m/s] and w [rad/s]
  Vec3 w = Vec3::Zero();
};

Mat6 mass_matrix(const RigidBody& body);

/// Adds the body's block and its momentum without contact. Returns the index of the block.
int add_body(contact::ContactProblem& problem, const RigidBody& body);

/// Returns a contact frame with the given unit normal; `turn` rotates the tangents [rad].
Mat3 frame_of(const Vec3& n, double turn = 0);

/// Returns the rows of u = sign C^T (v + w x (point - p)).
MatX body_rows(const Mat3& frame, const Vec3& point, const Vec3& p, double sign);

/// Adds a contact between bodies a and b (-1: fixed). Each body's block has the index of the body in `bodies`.
int add_contact(contact::ContactProblem& problem, const std::vector<RigidBody>& bodies, int a, int b, const Vec3& point,
                const Mat3& frame, double mu);

Vec3 random_vector(RandomStream& random);

}  // namespace nilas::challenge
