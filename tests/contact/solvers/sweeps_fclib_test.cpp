/// Tests of first-order solvers on recorded problems: our own, and the FCLIB collection if NILAS_FCLIB_DIR is set.
#include <gtest/gtest.h>

#include "contact/registry.h"
#include "tests/contact/fclib/recorded_problems.h"

namespace nilas::solvers {
namespace sweeps_fclib_test {

/// Checks the law's residual that a solver reaches within so many iterations, where it reports convergence. They bound
/// its work on any machine, which a time would not.
void expect_solved(const std::string& solver, const std::filesystem::path& file, int max_iterations) {
  const contact::FclibProblem read = contact::read_fclib(file);
  const contact::SolverSettings settings{.tolerance = 1e-8, .max_iterations = max_iterations};
  std::visit(
      [&](const auto& problem) {
        const contact::ContactSolution solution = contact::find_solver(solver).make(settings)->solve(problem, {});
        EXPECT_EQ(solution.status, contact::SolveStatus::converged) << solver << " " << file;
        EXPECT_LE(contact::measure(problem, solution.r).natural_map_m_s, 1e-8) << solver << " " << file;
      },
      read.problem);
}

/// Of our own problems the slowest takes 16500 iterations.
void expect_solved(const std::string& solver, const std::vector<std::string>& own,
                   const std::vector<std::string>& collected) {
  for (const std::string& name : own) expect_solved(solver, test::own_problem(name), 40000);
  for (const std::string& name : collected)
    for (const auto& file : test::collected_problem(name)) expect_solved(solver, file, 1000000);
}

TEST(RecordedProblems, BlockGaussSeidel) {
  expect_solved("nsgs", {"scene-towing", "scene-oblique-towing", "scene-level-ice"},
                {"Box_Stacks-i0035-31-0", "Confeti-ex13-Fc3D-SBM", "NESpheres_10_1", "NESpheres_30_1", "Rover1039",
                 "Rover1040", "Rover4144", "Rover4396", "Rover9770", "CubeH8", "arch-9",
                 "LMGC_100_PR_PerioBox-i00361-60-03000", "Spheres-i099-356-679"});
}

TEST(RecordedProblems, Extragradient) {
  expect_solved("eg", {"scene-towing", "scene-oblique-towing", "scene-presawn-b"},
                {"Box_Stacks-i0035-31-0", "Confeti-ex13-Fc3D-SBM", "OneObject-i100000-316", "boxstack-10", "arch-9",
                 "vessel-200", "Rover1039"});
}

TEST(RecordedProblems, AcceleratedProjectedGradient) {
  expect_solved("apgd", {"scene-towing", "scene-oblique-towing", "scene-presawn-b", "stack-10-1e6"},
                {"BoxesStack1-i100000-32", "OneObject-i100000-316", "boxstack-10", "boxstack-10-ratio1e6",
                 "local_problem_test", "arch-9", "vessel-200", "Rover4396"});
}

}  // namespace sweeps_fclib_test
}  // namespace nilas::solvers
