#pragma once
/// Problems with closed forms, and hard ones, for solvers of exact cones.
#include <string>

#include "tests/support/problem_factory.h"

namespace nilas::test {

/// A particle above a fixed plane with velocity (u_N, u_T1, u_T2) before contact.
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

/// Unit cubes of the given masses from the ground up, four contacts per face, falling for one step. W has two thirds
/// of full rank; nothing moves in the exact solution.
inline ContactProblem box_stack(const std::vector<double>& masses, double mu, double h = 0.01, double g = 9.81) {
  ContactProblem problem;
  problem.h = h;
  std::vector<TestBody> bodies;
  for (std::size_t k = 0; k < masses.size(); ++k) {
    TestBody body{masses[k], masses[k] / 6 * Mat3::Identity(), Vec3(0, 0, static_cast<double>(k) + 0.5)};
    body.v.z() = -h * g;
    bodies.push_back(body);
    add_body(problem, body);
  }
  for (std::size_t k = 0; k < masses.size(); ++k)
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        add_contact(problem, bodies, static_cast<int>(k) - 1, static_cast<int>(k), Vec3(x, y, static_cast<double>(k)),
                    frame_of(Vec3::UnitZ()), mu);
  return problem;
}

/// Masses growing from 1 kg to `ratio` kg.
inline std::vector<double> growing_masses(int count, double ratio) {
  std::vector<double> masses;
  for (int k = 0; k < count; ++k) masses.push_back(std::pow(ratio, static_cast<double>(k) / (count - 1)));
  return masses;
}

}  // namespace nilas::test
