/// The library's contact problems and solvers.
#include "nilas/solve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

int solve_a_stack();

namespace solve_test {

using nilas::Error;
using nilas::ErrorKind;
using nilas::Problem;
using nilas::Solution;
using Numbers = std::vector<double>;

const Numbers k_identity{1, 0, 0, 0, 1, 0, 0, 0, 1};

/// A unit mass that falls onto the ground with 9.81 m/s and slides with `slide` m/s.
Problem sliding_mass(double slide, double mu) {
  Problem problem;
  problem.add_body(k_identity, Numbers{-9.81, slide, 0});
  problem.add_contact(-1, {}, 0, k_identity, Numbers{0, 0, 0}, mu);
  return problem;
}

template <class Call>
ErrorKind kind_of(const Call& call, const std::string& part) {
  try {
    call();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
    return e.kind();
  }
  ADD_FAILURE() << "nothing was thrown";
  return ErrorKind::defect;
}

TEST(Solve, TheExampleRuns) { EXPECT_EQ(solve_a_stack(), 0); }

TEST(Solve, AMassSticksOrSlides) {
  const Solution sticks = nilas::solve(sliding_mass(1, 0.2));
  EXPECT_TRUE(sticks.converged);
  EXPECT_EQ(sticks.status, "converged");
  EXPECT_NEAR(sticks.impulses[0], 9.81, 1e-8);
  EXPECT_NEAR(sticks.impulses[1], -1, 1e-8);
  const Solution slides = nilas::solve(sliding_mass(10, 0.2));
  EXPECT_NEAR(slides.impulses[1], -0.2 * 9.81, 1e-7);
  EXPECT_NEAR(slides.velocities[1], 10 - 0.2 * 9.81, 1e-7);
  EXPECT_NEAR(slides.contact_velocities[1], slides.velocities[1], 1e-12);
}

TEST(Solve, LocalAndGlobalFormAgree) {
  const Problem global = sliding_mass(3, 0.4);
  const Problem local = Problem::local(global.delassus(), global.q(), global.mu());
  EXPECT_TRUE(local.is_local());
  EXPECT_EQ(local.num_velocities(), 0);
  const Numbers a = nilas::solve(global).impulses, b = nilas::solve(local).impulses;
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-8);
}

TEST(Solve, ResidualsAreThoseOfTheLaw) {
  const Problem problem = sliding_mass(0, 0.5);
  EXPECT_NEAR(nilas::measure(problem, Numbers{0, 0, 0}).law_map_m_s, 9.81, 1e-12);
  EXPECT_NEAR(nilas::measure(problem, Numbers{9.81, 0, 0}).natural_map_m_s, 0, 1e-12);
  EXPECT_NEAR(nilas::measure(problem, Numbers{0, 0, 0}, "frictionless").law_map_m_s, 9.81, 1e-12);
}

TEST(Solve, AGuessThatSolvesCostsNothing) {
  const Problem problem = sliding_mass(1, 0.2);
  const Solution first = nilas::solve(problem);
  const Solution again = nilas::solve(problem, {}, first.impulses);
  EXPECT_EQ(again.iterations, 0);
  EXPECT_EQ(again.impulses, first.impulses);
}

TEST(Solve, FilesKeepProblemAndSolution) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "nilas_library_solve_test.hdf5";
  const Problem problem = sliding_mass(10, 0.2);
  const Solution solution = nilas::solve(problem);
  problem.write(file, solution.impulses);
  const Problem stored = Problem::read(file);
  std::filesystem::remove(file);
  EXPECT_EQ(stored.num_contacts(), 1);
  EXPECT_EQ(stored.solution(), solution.impulses);
  EXPECT_TRUE(stored.guess().empty());
  EXPECT_EQ(stored.q(), problem.q());
}

TEST(Solve, FaultsSayWhatIsAllowed) {
  Problem problem = sliding_mass(1, 0.2);
  EXPECT_EQ(kind_of([&] { nilas::solve(problem, {.solver = "newtn"}); }, "newton"), ErrorKind::input);
  EXPECT_EQ(kind_of([&] { nilas::solve(problem, {.law = "coulom"}); }, "coulomb"), ErrorKind::input);
  EXPECT_EQ(kind_of([&] { nilas::solve(problem, {.solver = "admm", .law = "pyramid"}); }, "coulomb"), ErrorKind::input);
  EXPECT_EQ(kind_of([&] { nilas::solve(problem, {}, Numbers{1}); }, "allowed: 3"), ErrorKind::input);
  EXPECT_EQ(kind_of([&] { nilas::solve(problem, {.threads = 0}); }, "at least 1"), ErrorKind::input);
  EXPECT_EQ(kind_of([&] { nilas::measure(problem, Numbers{NAN, 0, 0}); }, "not finite"), ErrorKind::input);
  EXPECT_EQ(kind_of([&] { problem.add_contact(0, {}, 0, {}, {}, 0.1); }, "allowed: 9"), ErrorKind::input);
  EXPECT_EQ(kind_of(
                [&] {
                  problem.add_contact(-1, {}, 1, k_identity, Numbers{0, 0, 0}, 0.1);
                },
                "no body 1"),
            ErrorKind::input);
  EXPECT_EQ(kind_of([&] { problem.add_body(Numbers{-1}, Numbers{0}); }, "positive definite"), ErrorKind::input);
  EXPECT_EQ(kind_of(
                [] {
                  Problem::local(Numbers{1, 2}, Numbers{1, 2, 3}, Numbers{0.1});
                },
                "allowed: 9"),
            ErrorKind::input);
  const Numbers W(36), q(6);
  EXPECT_EQ(kind_of([&] { Problem::local(W, q, Numbers{0.1}); }, "mu has 1 numbers; allowed: 2"), ErrorKind::input);
  EXPECT_EQ(kind_of([&] { Problem::local(W, Numbers(9), Numbers(2)); }, "q has 9 numbers; allowed: 6"),
            ErrorKind::input);
  EXPECT_EQ(kind_of([&] { Problem::local(Numbers(81), q, Numbers(2)); }, "W has 81 numbers; allowed: 36"),
            ErrorKind::input);
  EXPECT_EQ(kind_of([] { Problem::read("/no/such/file.hdf5"); }, "/no/such/file.hdf5"), ErrorKind::file);
  EXPECT_EQ(problem.num_contacts(), 1) << "what was refused must leave the problem as it was";
}

TEST(Solve, EverySolverIsListed) {
  const auto all = nilas::solver_list();
  ASSERT_GT(all.size(), 5u);
  for (const nilas::SolverInfo& info : all) {
    EXPECT_FALSE(info.summary.empty());
    EXPECT_FALSE(info.laws.empty());
  }
}

TEST(Solve, HistoryIsKeptOnRequest) {
  const Problem problem = sliding_mass(10, 0.2);
  EXPECT_TRUE(nilas::solve(problem, {.solver = "nsgs"}).history.empty());
  EXPECT_FALSE(nilas::solve(problem, {.solver = "nsgs", .keep_history = true}).history.empty());
}

}  // namespace solve_test
