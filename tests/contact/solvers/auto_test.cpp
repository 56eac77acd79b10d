#include "contact/solvers/auto.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "contact/problem/islands.h"
#include "contact/problem/row_of.h"
#include "contact/solvers/body_ladder.h"
#include "contact/solvers/nsgs.h"
#include "tests/contact/fclib/recorded_problems.h"
#include "tests/support/problems/bad_problems.h"
#include "tests/support/problems/cone_problems.h"
#include "tests/support/problems/problem_factory.h"

namespace nilas::solvers {
namespace auto_test {

template <class Problem>
contact::ContactSolution solve(const Problem& problem, const VecX& guess = {}, double tolerance = 1e-10) {
  return AutoSolver({.shared = {.tolerance = tolerance}}).solve(problem, guess);
}

TEST(Auto, EveryLawOnRandomHeaps) {
  for (const Law law : {Law::coulomb, Law::ccp, Law::pyramid, Law::pyramid_k, Law::frictionless})
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      contact::ContactProblem problem = test::random_heap(seed, 8, 16, 0.3);
      problem.law = law;
      const contact::ContactSolution solution = solve(problem);
      EXPECT_EQ(solution.status, contact::SolveStatus::converged) << static_cast<int>(law) << " " << seed;
      EXPECT_LE(contact::measure(problem, solution.r).law_map_m_s, 1e-10 * (1 + 1e-9));
    }
}

TEST(Auto, SaysWhatItUsed) {
  const contact::ContactSolution solution = solve(test::raft(6, 0.3, 1, 1));
  EXPECT_NE(solution.message.find("nsgs 20 sweeps"), std::string::npos) << solution.message;
  EXPECT_NE(solution.message.find("newton"), std::string::npos) << solution.message;
  EXPECT_EQ(solve(test::raft(6, 0.3, 1, 1), solution.r).message, "guess");
}

/// Sweeps hardly move tall stacks, where all contacts stick; most of a raft slips. A guess of zeros carries no
/// information. A local problem has no bodies to work on.
TEST(Auto, TakesAdmmForStiffStacksFromCold) {
  const contact::LocalProblem stack = contact::reduce(test::box_stack(std::vector<double>(12, 5.0), 0.4));
  const contact::ContactSolution cold = solve(stack);
  EXPECT_EQ(cold.status, contact::SolveStatus::converged);
  EXPECT_NE(cold.message.find("admm"), std::string::npos) << cold.message;
  EXPECT_EQ(cold.message.find("newton"), std::string::npos) << cold.message;
  EXPECT_EQ(solve(stack, VecX::Zero(cold.r.size())).message, cold.message);
  const contact::ContactSolution raft = solve(contact::reduce(test::raft(6, 0.3, 1, 1)));
  EXPECT_EQ(raft.message.find("admm"), std::string::npos) << raft.message;
}

TEST(Auto, GoesToTheBodiesWhereSweepsDoNotSuffice) {
  const contact::ContactSolution stack = solve(test::box_stack(std::vector<double>(12, 5.0), 0.4));
  EXPECT_EQ(stack.status, contact::SolveStatus::converged);
  EXPECT_NE(stack.message.find("interior point"), std::string::npos) << stack.message;
}

/// Rungs on W would find the steps of the bodies again, at several times their cost. No solve reaches a tolerance of
/// zero, so every rung that is left gets its turn.
TEST(Auto, LeavesLargeIslandsToTheBodies) {
  const contact::ContactProblem raft = test::raft(20, 0.3, 1, 1);
  ASSERT_GE(raft.num_contacts(), AutoSettings{}.jam_contacts);
  const contact::ContactSolution found =
      AutoSolver({.shared = {.tolerance = 0, .max_iterations = 400}}).solve(raft, VecX());
  EXPECT_EQ(found.status, contact::SolveStatus::iteration_limit);
  EXPECT_LE(contact::measure(raft, found.r).law_map_m_s, 1e-6);
  EXPECT_NE(found.message.find("newton on bodies"), std::string::npos) << found.message;
  for (const char* rung : {"more nsgs", "wary newton", "friction continuation", "ipm"})
    EXPECT_EQ(found.message.find(rung), std::string::npos) << found.message;
}

/// No solve reaches a tolerance of zero: sweeps with it go on to their limit, and Newton for long. Each leaves
/// iterations to the rungs after it.
TEST(Auto, LeavesIterationsToTheRungsAfterSweeps) {
  const contact::LocalProblem raft = contact::reduce(test::raft(6, 0.3, 1, 1));
  const contact::ContactSolution found =
      AutoSolver({.shared = {.tolerance = 0, .max_iterations = 500}}).solve(raft, VecX());
  for (const char* rung : {"more nsgs", "wary newton", "friction continuation", "ipm"})
    EXPECT_NE(found.message.find(rung), std::string::npos) << rung << ": " << found.message;
  EXPECT_LE(found.iterations, 500);
}

/// Of 250 iterations 20 are sweeps and 200 those of newton on W, so the bodies have 30: the interior point takes 6, and
/// newton the other 24.
TEST(Auto, LeavesIterationsToNewtonAfterTheBodies) {
  const contact::ContactProblem stack = test::box_stack(std::vector<double>(12, 5.0), 0.4);
  const AutoSettings settings{.shared = {.tolerance = 0, .max_iterations = 250}, .body_iterations = 20};
  const std::string used = AutoSolver(settings).solve(stack, {}).message;
  EXPECT_NE(used.find("newton on bodies 24 factorisations, newton 200 "), std::string::npos) << used;
}

/// From 1e-5 m/s on the interior point reaches 1e-6 m/s itself in the time of a few factorisations of Newton. Tighter
/// tolerances need Newton.
TEST(Auto, LeavesLargeIslandsToTheInteriorPointAtLooseTolerances) {
  const contact::ContactProblem raft = test::raft(17, 0.1, 0.7, 1);
  ASSERT_GE(raft.num_contacts(), k_large_on_bodies);
  const contact::ContactSolution loose = solve(raft, {}, 1e-6), tight = solve(raft, {}, 1e-8);
  EXPECT_EQ(loose.status, contact::SolveStatus::converged);
  EXPECT_EQ(loose.message.find("newton"), std::string::npos) << loose.message;
  EXPECT_EQ(tight.status, contact::SolveStatus::converged);
  EXPECT_NE(tight.message.find("newton on bodies"), std::string::npos) << tight.message;
}

/// To a loose tolerance sweeps finish what the interior point began, on any number of threads.
TEST(Auto, FinishesLooseJamsBySweeps) {
  const contact::ContactProblem raft = test::raft(17, 0.3, 0.7, 1);
  ASSERT_GE(raft.num_contacts(), k_large_on_bodies);
  const auto with = [&](int threads) {
    return AutoSolver({.shared = {.tolerance = 1e-4, .threads = threads}}).solve(raft, VecX());
  };
  const contact::ContactSolution one = with(1), two = with(2);
  EXPECT_EQ(one.status, contact::SolveStatus::converged);
  EXPECT_LE(contact::measure(raft, one.r).law_map_m_s, 1e-4);
  EXPECT_NE(one.message.find("interior point"), std::string::npos) << one.message;
  EXPECT_NE(one.message.find("sweeps after it"), std::string::npos) << one.message;
  EXPECT_EQ(one.message.find("newton"), std::string::npos) << one.message;
  EXPECT_EQ(one.r, two.r);
}

/// Where sweeps do not finish a way, a short search by Newton spares the other ways.
TEST(Auto, TriesNewtonShortlyInLooseJams) {
  const contact::ContactProblem raft = test::raft(12, 0.3, 1, 1);
  const contact::ContactSolution found = solve(raft, {}, 1e-4);
  EXPECT_EQ(found.status, contact::SolveStatus::converged);
  EXPECT_NE(found.message.find("newton on bodies"), std::string::npos) << found.message;
  EXPECT_LE(found.iterations, 200) << found.message;
}

TEST(Auto, SameBitsWithTwoThreads) {
  const contact::ContactProblem heap = test::random_heap(3, 200, 160, 0.3);
  ASSERT_GT(contact::find_islands(heap).size(), 5u);
  const auto with = [&](int threads) {
    return AutoSolver({.shared = {.tolerance = 1e-9, .threads = threads}}).solve(heap, VecX());
  };
  const contact::ContactSolution one = with(1), two = with(2);
  EXPECT_NE(one.message.find("bodies"), std::string::npos) << one.message;
  EXPECT_EQ(one.message, two.message);
  EXPECT_EQ(one.r, two.r);
}

/// Islands do not pay for each other: many alike cost the iterations of one.
TEST(Auto, EveryIslandHasTheWholeBudget) {
  const contact::ContactProblem stack = test::box_stack(std::vector<double>(12, 5.0), 0.4);
  contact::ContactProblem many;
  many.h = stack.h;
  for (int copy = 0; copy < 40; ++copy) {
    const int first = many.num_blocks();
    for (int k = 0; k < stack.num_blocks(); ++k) {
      many.add_block(stack.mass(k));
      many.f.tail<6>() = stack.f.segment<6>(stack.block_offset[k]);
    }
    const auto placed = [&](int block) { return block < 0 ? -1 : first + block; };
    for (int c = 0; c < stack.num_contacts(); ++c) {
      many.add_contact(placed(stack.pairs[c].a), MatX(stack.jacobian_a(c)), placed(stack.pairs[c].b),
                       MatX(stack.jacobian_b(c)), static_cast<std::uint64_t>(1000 * copy + c));
      many.mu.back() = many.mu_static.back() = stack.mu[c];
      many.w.tail<3>() = stack.w.segment<3>(contact::row_of(c));
    }
  }
  const contact::ContactSolution one = solve(stack, {}, 1e-8);
  const AutoSettings settings{.shared = {.tolerance = 1e-8, .max_iterations = one.iterations + 1}};
  const contact::ContactSolution all = AutoSolver(settings).solve(many, {});
  EXPECT_EQ(all.status, contact::SolveStatus::converged) << all.message;
  EXPECT_EQ(all.iterations, one.iterations);
}

TEST(Auto, StartsFromItsOwnSolutionWithoutAnIteration) {
  const contact::ContactProblem problem = test::raft(6, 0.3, 0.8, 1);
  const contact::ContactSolution first = solve(problem), again = solve(problem, first.r);
  ASSERT_EQ(first.status, contact::SolveStatus::converged);
  EXPECT_EQ(again.status, contact::SolveStatus::converged);
  EXPECT_EQ(again.iterations, 0);
  EXPECT_EQ(again.r, first.r);
  EXPECT_LT((again.v - first.v).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Auto, WarmStartSavesIterations) {
  contact::LocalProblem problem = contact::reduce(test::raft(10, 0.3, 0.9, 3));
  const VecX r = solve(problem, {}, 1e-8).r;
  problem.q *= 1.001;
  EXPECT_LT(solve(problem, r, 1e-8).iterations, solve(problem, {}, 1e-8).iterations);
}

TEST(Auto, SameBitsTwice) {
  const contact::ContactProblem problem = test::raft(8, 0.3, 0.9, 2);
  EXPECT_EQ(solve(problem).r, solve(problem).r);
}

TEST(Auto, StopsAtItsLimits) {
  const contact::ContactSolution solution =
      AutoSolver({.shared = {.tolerance = 1e-12, .max_iterations = 22}}).solve(test::raft(8, 0.3, 1, 2), {});
  EXPECT_EQ(solution.status, contact::SolveStatus::iteration_limit);
  EXPECT_LE(solution.iterations, 22);
}

TEST(Auto, NamesWhatIsNotFinite) {
  contact::ContactProblem problem = test::random_heap(1, 4, 6, 0.3);
  problem.f[0] = std::numeric_limits<double>::quiet_NaN();
  const contact::ContactSolution solution = solve(problem);
  EXPECT_EQ(solution.status, contact::SolveStatus::numerical_error);
  EXPECT_NE(solution.message.find("finite"), std::string::npos) << solution.message;
}

/// Sweeps diverge from a solution that Newton's method finds: each multiplies the distance by ten, and at sweep 303 the
/// velocities overflow.
TEST(Auto, GoesOnWhereSweepsLeaveAllNumbers) {
  const contact::LocalProblem problem = test::runaway_pair(std::sqrt(10.0), 1e8);
  const VecX guess = VecX::Constant(6, 5);
  const contact::ContactSolution swept = NsgsSolver({.shared = {.tolerance = 1e-6}}).solve(problem, guess);
  EXPECT_EQ(swept.status, contact::SolveStatus::numerical_error);
  EXPECT_TRUE(swept.r.allFinite());
  EXPECT_FALSE(swept.message.empty());
  const AutoSettings settings{.shared = {.tolerance = 1e-6, .max_iterations = 5000}, .first_sweeps = 1000};
  const contact::ContactSolution solution = AutoSolver(settings).solve(problem, guess);
  EXPECT_EQ(solution.status, contact::SolveStatus::converged) << solution.message;
  EXPECT_NE(solution.message.find("newton"), std::string::npos) << solution.message;
}

TEST(Auto, EndsAtAContactThatNothingCanMove) {
  contact::ContactProblem problem;
  problem.add_contact(-1, MatX(3, 0), -1, MatX(3, 0), 77);
  problem.w[0] = -1;
  const contact::ContactSolution solution = solve(problem);
  EXPECT_EQ(solution.status, contact::SolveStatus::numerical_error);
  EXPECT_NE(solution.message.find("77"), std::string::npos) << solution.message;
  EXPECT_EQ(solution.message.find("more nsgs"), std::string::npos) << solution.message;
}

TEST(Auto, NoContacts) {
  EXPECT_EQ(solve(contact::ContactProblem{}).status, contact::SolveStatus::converged);
  EXPECT_EQ(solve(contact::LocalProblem{}).status, contact::SolveStatus::converged);
}

/// The same problem with contacts in another order.
contact::LocalProblem shuffled(const contact::LocalProblem& problem) {
  const int nc = problem.num_contacts();
  std::vector<int> place(static_cast<std::size_t>(nc));
  std::iota(place.begin(), place.end(), 0);
  RandomStream random(11, "order");
  for (std::size_t k = place.size(); k > 1; --k) std::swap(place[k - 1], place[random.bits() % k]);
  contact::LocalProblem out = problem;
  std::vector<std::vector<std::pair<int, Mat3>>> rows(place.size());
  for (std::size_t a = 0; a < place.size(); ++a) {
    const auto to = static_cast<std::size_t>(place[a]);
    for (int k = problem.row_start[a]; k < problem.row_start[a + 1]; ++k) {
      const auto i = static_cast<std::size_t>(k);
      rows[to].emplace_back(place[problem.column[i]], problem.block[i]);
    }
    out.q.segment<3>(3 * place[a]) = problem.q.segment<3>(contact::row_of(a));
    out.mu[to] = problem.mu[a];
    out.mu_static[to] = problem.mu_static[a];
    out.key[to] = problem.key[a];
  }
  out.row_start = {0};
  out.column.clear();
  out.block.clear();
  for (auto& row : rows) {
    std::sort(row.begin(), row.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    for (const auto& [column, block] : row) {
      out.column.push_back(column);
      out.block.push_back(block);
    }
    out.row_start.push_back(static_cast<int>(out.column.size()));
  }
  return out;
}

/// The same problem with tangents turned by an angle of each contact's own, and all masses multiplied by `factor`.
contact::LocalProblem turned_and_scaled(const contact::LocalProblem& problem, double factor) {
  contact::LocalProblem out = problem;
  const auto turn = [](int c) {
    Mat3 R = Mat3::Identity();
    R.bottomRightCorner<2, 2>() = Eigen::Rotation2Dd(1.7 * c).toRotationMatrix();
    return R;
  };
  for (int a = 0; a < problem.num_contacts(); ++a) {
    out.q.segment<3>(3 * a) = turn(a) * problem.q.segment<3>(3 * a);
    for (int k = problem.row_start[a]; k < problem.row_start[static_cast<std::size_t>(a) + 1]; ++k) {
      const auto i = static_cast<std::size_t>(k);
      out.block[i] = turn(a) * problem.block[i] * turn(problem.column[i]).transpose() / factor;
    }
  }
  return out;
}

/// Recorded problems in local form, without the two hardest of the collection.
std::vector<std::pair<std::string, contact::LocalProblem>> recorded() {
  std::vector<std::pair<std::string, contact::LocalProblem>> problems;
  for (const auto& path : test::recorded_problems()) {
    const std::string name = path.stem().string();
    if (name == "RockPile_tob1" || name == "spherepile-10x5") continue;
    problems.emplace_back(name, test::local_form(contact::read_fclib(path)));
  }
  return problems;
}

TEST(Files, AreSolvedAsTheyAre) {
  for (const auto& [name, problem] : recorded()) {
    const contact::ContactSolution solution = solve(problem);
    EXPECT_EQ(solution.status, contact::SolveStatus::converged) << name << ": " << solution.message;
    EXPECT_LE(contact::measure(problem, solution.r).natural_map_m_s, 1e-10) << name;
  }
}

/// The rock pile of the collection needs continuation in friction. Our own stack replaces it in a run without the
/// collection.
TEST(Files, TheHardestAreSolvedWithinAMinute) {
  std::vector<std::filesystem::path> hardest = test::collected_problem("RockPile_tob1");
  hardest.push_back(test::own_problem("stack-10-1e6"));
  for (const auto& path : hardest) {
    const contact::LocalProblem problem = test::local_form(contact::read_fclib(path));
    const contact::ContactSolution solution =
        AutoSolver({.shared = {.tolerance = 1e-10, .max_iterations = 100000, .max_seconds = 60}}).solve(problem, {});
    EXPECT_EQ(solution.status, contact::SolveStatus::converged) << path << ": " << solution.message;
    EXPECT_LE(contact::measure(problem, solution.r).natural_map_m_s, 1e-10) << path;
  }
}

TEST(Files, AreSolvedShuffledTurnedAndScaled) {
  for (const auto& [name, problem] : recorded()) {
    EXPECT_EQ(solve(shuffled(problem)).status, contact::SolveStatus::converged) << name;
    for (const double factor : {1e-4, 30.0})
      EXPECT_EQ(solve(turned_and_scaled(problem, factor)).status, contact::SolveStatus::converged)
          << name << " " << factor;
  }
}

}  // namespace auto_test
}  // namespace nilas::solvers
