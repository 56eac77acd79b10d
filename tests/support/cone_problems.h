#pragma once
/// Problems with closed-form solutions for solvers of exact cones.
#include "tests/support/problem_factory.h"

namespace nilas::test {

/// A particle above a fixed plane that has the velocity (u_N, u_T1, u_T2) [m/s] before contact.
inline ContactProblem particle(Law law, double mass, double mu, const Vec3& before) {
  ContactProblem problem;
  problem.law = law;
  problem.h = 0.01;
  problem.add_block(mass * Mat3::Identity());
  problem.f = mass * before;
  problem.add_contact(-1, MatX(3, 0), 0, Mat3::Identity(), 1);
  problem.mu[0] = problem.mu_static[0] = mu;
  return problem;
}

}  // namespace nilas::test
