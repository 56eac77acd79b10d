/// A stack of two blocks on the ground, solved by two solvers.
#include <iostream>
#include <vector>

#include "nilas/solve.h"

int solve_a_stack() {
  // Each block has the velocities (x, y, z). Its momentum without contacts is that of 1 s of gravity and a push.
  const std::vector<double> mass{2, 0, 0, 0, 2, 0, 0, 0, 2};
  nilas::Problem problem;
  const int lower = problem.add_body(mass, std::vector<double>{0, 0, -19.62});
  const int upper = problem.add_body(mass, std::vector<double>{1.5, 0, -19.62});

  // Rows of a contact: normal (up), then two tangents. They turn (x, y, z) into (z, x, y).
  const std::vector<double> of_b{0, 0, 1, 1, 0, 0, 0, 1, 0}, of_a{0, 0, -1, -1, 0, 0, 0, -1, 0};
  const std::vector<double> none, still{0, 0, 0};
  problem.add_contact(-1, none, lower, of_b, still, 0.3);
  problem.add_contact(lower, of_a, upper, of_b, still, 0.05);

  for (const char* solver : {"nsgs", "newton"}) {
    const nilas::Solution solution = nilas::solve(problem, {.solver = solver, .tolerance = 1e-10});
    std::cout << solver << ": " << solution.status << " after " << solution.iterations << " iterations, residual "
              << solution.residuals.natural_map_m_s << " m/s\n"
              << "  the ground carries " << solution.impulses[0] << " N s, friction between the blocks is "
              << solution.impulses[4] << " N s\n";
    if (!solution.converged) return 1;
  }
  return 0;
}
