#pragma once
/// Contact problems by hand: rigid bodies and the contacts between them.
#include <vector>

#include "contact/problem/problem.h"
#include "core/base/random.h"

namespace nilas::challenge {

/// A free rigid body of a hand-built problem.
struct RigidBody {
  double mass = 1;
  Mat3 inertia = Mat3::Identity();  ///< in G, about the centre of mass
  Vec3 p = Vec3::Zero();            ///< centre of mass
  Vec3 v = Vec3::Zero();            ///< free velocities, before contact
  Vec3 w = Vec3::Zero();
};

Mat6 mass_matrix(const RigidBody& body);

/// Adds the block and its free momentum.
int add_body(ContactProblem& problem, const RigidBody& body);

/// A frame with the given unit normal; `turn` rotates the tangents [rad].
Mat3 frame_of(const Vec3& n, double turn = 0);

/// Rows of u = +-C^T (v + w x (point - p)).
MatX body_rows(const Mat3& frame, const Vec3& point, const Vec3& p, double sign);

/// A contact between bodies a and b (-1: fixed), both listed in `bodies` with their block equal to their index.
int add_contact(ContactProblem& problem, const std::vector<RigidBody>& bodies, int a, int b, const Vec3& point,
                const Mat3& frame, double mu);

Vec3 random_vector(RandomStream& random);

}  // namespace nilas::challenge
