/// `nilas solve` as a user meets it: results, exit codes, and residuals that follow from the file it writes.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "contact/fclib/fclib_io.h"
#include "contact/measure/measure.h"
#include "tests/support/mentions.h"
#include "tests/support/program.h"

namespace solve_test {

using namespace nilas;
using nilas_test::mentions;
using nilas_test::run_nilas;
using nilas_test::ScratchFolder;

/// A particle of 2 kg that meets the ground at -1 m/s while moving along it at 3 m/s, mu = 0.5.
contact::ContactProblem oblique_particle() {
  contact::ContactProblem problem;
  const MatX none(3, 0);
  problem.add_block(2 * MatX::Identity(3, 3));
  problem.f = VecX{{-2, 6, 0}};
  problem.add_contact(-1, none, 0, MatX::Identity(3, 3), 1);
  problem.mu[0] = problem.mu_static[0] = 0.5;
  return problem;
}

TEST(Solve, AParticleSlidesByExactCoulombFriction) {
  const ScratchFolder folder;
  contact::write_fclib(folder.path() / "particle.hdf5", oblique_particle(), nullptr);
  const auto run = run_nilas("solve particle.hdf5 --json --repeat 3 --write out.hdf5", folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto result = nlohmann::json::parse(run.out);
  EXPECT_EQ(result["problem"], "particle");
  EXPECT_EQ(result["nc"], 1);
  EXPECT_EQ(result["ndof"], 3);
  EXPECT_EQ(result["law"], "coulomb");
  EXPECT_EQ(result["status"], "converged");
  EXPECT_EQ(result["claimed"], "converged");
  EXPECT_EQ(result["open"], 0);
  EXPECT_EQ(result["sticking"], 0);
  EXPECT_EQ(result["sliding"], 1);
  for (const char* name : {"solver", "used", "message", "iterations", "seconds", "asymmetry"})
    EXPECT_TRUE(result.contains(name));
  const auto written = contact::read_fclib(folder.path() / "out.hdf5");
  const auto& problem = std::get<contact::ContactProblem>(written.problem);
  const VecX v = contact::velocities(problem, written.solution.value());
  EXPECT_LT((v - VecX{{0, 2.5, 0}}).norm(), 1e-8);
  const contact::Residuals again = contact::measure(problem, *written.solution);
  for (const auto& column : contact::residual_columns())
    EXPECT_NEAR(result[column.name].get<double>(), again.*column.member, 1e-3 * std::abs(again.*column.member) + 1e-13)
        << column.name;
}

TEST(Solve, TheTableNamesEveryResidual) {
  const ScratchFolder folder;
  contact::write_fclib(folder.path() / "particle.hdf5", nilas::contact::reduce(oblique_particle()), nullptr);
  const auto run = run_nilas("solve particle.hdf5 --solver pgs --law pyramid", folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  for (const auto& column : contact::residual_columns()) EXPECT_TRUE(mentions(run.out, column.name)) << column.name;
  EXPECT_TRUE(mentions(run.out, "converged"));
}

TEST(Solve, ExitCodesTellWhatWentWrong) {
  const ScratchFolder folder;
  contact::write_fclib(folder.path() / "particle.hdf5", oblique_particle(), nullptr);
  EXPECT_EQ(run_nilas("solve none.hdf5", folder.path()).exit_code, 4);
  EXPECT_EQ(run_nilas("solve particle.hdf5 --write none/out.hdf5", folder.path()).exit_code, 4);
  contact::ContactProblem skew = oblique_particle();
  skew.mass_data[1] = skew.mass_data[3] = 0.5;  // one sweep over single rows cannot solve it
  contact::write_fclib(folder.path() / "skew.hdf5", skew, nullptr);
  const auto cut_short = run_nilas("solve skew.hdf5 --solver pgs --max-iterations 1 --json", folder.path());
  EXPECT_EQ(cut_short.exit_code, 3);
  EXPECT_EQ(nlohmann::json::parse(cut_short.out)["status"], "iteration_limit");
  folder.write("text.hdf5", "no problem");
  for (const char* arguments : {"text.hdf5", "particle.hdf5 --solver magic", "particle.hdf5 --law magic",
                                "particle.hdf5 --solver pgs --law ccp", "particle.hdf5 --tolerance -1"}) {
    const auto run = run_nilas(std::string("solve ") + arguments, folder.path());
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_FALSE(run.err.empty()) << arguments;
    EXPECT_TRUE(run.out.empty()) << arguments;
  }
}

TEST(Solve, DamagedFilesExitWithTwo) {
  const ScratchFolder folder;
  contact::write_fclib(folder.path() / "particle.hdf5", oblique_particle(), nullptr);
  const std::string good = nilas_test::read_text(folder.path() / "particle.hdf5");
  for (const std::size_t length : {std::size_t{0}, std::size_t{100}, good.size() / 2, good.size() - 1}) {
    folder.write("cut.hdf5", good.substr(0, length));
    const auto run = run_nilas("solve cut.hdf5", folder.path());
    EXPECT_EQ(run.exit_code, 2) << length;
    EXPECT_TRUE(mentions(run.err, "cut.hdf5")) << run.err;
  }
}

}  // namespace solve_test
