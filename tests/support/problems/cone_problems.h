#pragma once
/// Problems with closed-form solutions for solvers of exact cones.
#include <gtest/gtest.h>

#include "contact/problem/solution.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::test {

/// A particle above a fixed plane that has the velocity (u_N, u_T1, u_T2) [m/s] before contact.
inline contact::ContactProblem particle(Law law, double mass, double mu, const Vec3& before) {
  contact::ContactProblem problem;
  problem.law = law;
  problem.h = 0.01;
  problem.add_block(mass * Mat3::Identity());
  problem.f = mass * before;
  problem.add_contact(-1, MatX(3, 0), 0, Mat3::Identity(), 1);
  problem.mu[0] = problem.mu_static[0] = mu;
  return problem;
}

/// Expects that a solver of one contact has converged to the contact velocity `expected` [m/s].
inline void expect_velocity(const contact::ContactSolution& solution, const Vec3& expected, double tolerance) {
  EXPECT_EQ(solution.status, contact::SolveStatus::converged) << solution.message;
  EXPECT_LT((solution.u - expected).norm(), tolerance) << solution.u.transpose();
}

}  // namespace nilas::test
