/// First-order solvers on recorded problems, read from the folder NILAS_FCLIB_DIR.
#include <gtest/gtest.h>

#include <cstdlib>

#include "contact/fclib/fclib_io.h"
#include "contact/registry.h"

namespace nilas {
namespace {

/// law_map that a solver reaches within two seconds, where it says so itself.
void expect_solved(const std::string& solver, const std::string& file) {
  const char* const folder = std::getenv("NILAS_FCLIB_DIR");
  const FclibProblem read = read_fclib(std::filesystem::path(folder) / (file + ".hdf5"));
  const SolverSettings settings{.tolerance = 1e-8, .max_iterations = 1000000, .max_seconds = 2};
  std::visit(
      [&](const auto& problem) {
        const ContactSolution solution = find_solver(solver).make(settings)->solve(problem, {});
        EXPECT_EQ(solution.status, SolveStatus::converged) << solver << " " << file;
        EXPECT_LE(measure(problem, solution.r).natural_map_m_s, 1e-8) << solver << " " << file;
      },
      read.problem);
}

class RecordedProblems : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("NILAS_FCLIB_DIR") == nullptr) GTEST_SKIP() << "NILAS_FCLIB_DIR names no folder of FCLIB files";
  }
};

TEST_F(RecordedProblems, BlockGaussSeidel) {
  for (const char* const file : {"Box_Stacks-i0035-31-0", "Confeti-ex13-Fc3D-SBM", "NESpheres_10_1", "NESpheres_30_1",
                                 "Rover1039", "Rover1040", "Rover4144", "Rover4396", "Rover9770", "CubeH8", "arch-9",
                                 "LMGC_100_PR_PerioBox-i00361-60-03000", "Spheres-i099-356-679"})
    expect_solved("nsgs", file);
}

TEST_F(RecordedProblems, Extragradient) {
  for (const char* const file : {"Box_Stacks-i0035-31-0", "Confeti-ex13-Fc3D-SBM", "OneObject-i100000-316",
                                 "boxstack-10", "arch-9", "vessel-200", "Rover1039"})
    expect_solved("eg", file);
}

TEST_F(RecordedProblems, AcceleratedProjectedGradient) {
  for (const char* const file : {"BoxesStack1-i100000-32", "OneObject-i100000-316", "boxstack-10",
                                 "boxstack-10-ratio1e6", "local_problem_test", "arch-9", "vessel-200", "Rover4396"})
    expect_solved("apgd", file);
}

}  // namespace
}  // namespace nilas
