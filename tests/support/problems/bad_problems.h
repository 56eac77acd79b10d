#pragma once
/// Local problems that no masses can produce, as solvers may meet them in broken files.
#include <limits>

#include "contact/problem/local_problem.h"

namespace nilas::test {

/// Two contacts that close at 1 m/s with W_aa = `diagonal` times the unit matrix, normals coupled by `coupling` [1/kg].
inline contact::LocalProblem coupled_pair(double coupling, double diagonal = 1) {
  contact::LocalProblem problem;
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) {
      problem.column.push_back(b);
      problem.block.push_back(a == b ? Mat3(diagonal * Mat3::Identity()) : Mat3(Mat3::Zero()));
      if (a != b) problem.block.back()(0, 0) = coupling;
    }
    problem.row_start.push_back(static_cast<int>(problem.column.size()));
    problem.mu.push_back(0.5);
    problem.mu_static.push_back(0.5);
    problem.force_limit.push_back(std::numeric_limits<double>::infinity());
    problem.compliance.push_back(0);
    problem.tangential_compliance.push_back(0);
    problem.key.push_back(static_cast<std::uint64_t>(a + 1));
  }
  problem.q = VecX::Zero(6);
  problem.q[0] = problem.q[3] = -1;
  return problem;
}

/// A pair whose solutions are zero impulses and normal impulses of 1 N s. Larger impulses grow by `factor` per visit of
/// a sweep.
inline contact::LocalProblem runaway_pair(double factor, double diagonal) {
  contact::LocalProblem problem = coupled_pair(-factor * diagonal, diagonal);
  problem.q[0] = problem.q[3] = (factor - 1) * diagonal;
  return problem;
}

}  // namespace nilas::test
