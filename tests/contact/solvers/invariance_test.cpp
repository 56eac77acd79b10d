/// Changes of a problem that must not change the solution, for every solver of the registry and every law that it
/// supports.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

#include "contact/registry.h"
#include "core/base/error.h"
#include "tests/support/problems/problem_changes.h"
#include "tests/support/problems/problem_factory.h"
#include "tests/support/test_name.h"

namespace nilas::solvers {
namespace invariance_test {

constexpr double k_tolerance = 1e-10;
/// Velocities may differ by the tolerance times the condition of these problems [m/s].
constexpr double k_same = 1e-7;
constexpr int k_seeds = 3;

struct Subject {
  std::string solver;
  Law law;
};

std::ostream& operator<<(std::ostream& out, const Subject& subject) {
  return out << subject.solver << " " << contact::to_string(subject.law);
}

std::vector<Subject> subjects() {
  std::vector<Subject> all;
  for (const auto& entry : contact::solver_registry())
    for (const Law law : entry.laws) all.push_back({entry.name, law});
  return all;
}

std::string name_of(const testing::TestParamInfo<Subject>& info) {
  return test::test_name(info.param.solver + "_" + contact::to_string(info.param.law));
}

/// Four bodies with five contacts, few enough for brute force.
contact::ContactProblem heap(int seed, Law law) {
  contact::ContactProblem problem = test::random_heap(100 + static_cast<std::uint64_t>(seed), 4, 5, 0.3);
  problem.law = law;
  problem.facets = 6;
  return problem;
}

class Invariance : public testing::TestWithParam<Subject> {
 protected:
  contact::ContactProblem heap_of(int seed) const { return heap(seed, GetParam().law); }

  template <class Problem>
  contact::ContactSolution solve(const Problem& problem) const {
    const auto solver =
        contact::find_solver(GetParam().solver).make({.tolerance = k_tolerance, .max_iterations = 100000});
    contact::ContactSolution solution = solver->solve(problem, {});
    EXPECT_EQ(solution.status, contact::SolveStatus::converged) << solution.message;
    EXPECT_LE(contact::measure(problem, solution.r).law_map_m_s, k_tolerance);
    return solution;
  }

  void expect_same_motion(const contact::ContactProblem& one, const contact::ContactProblem& two) const {
    EXPECT_LT((solve(one).v - solve(two).v).cwiseAbs().maxCoeff(), k_same);
  }

  bool isotropic() const { return GetParam().law != Law::pyramid && GetParam().law != Law::pyramid_k; }
};

TEST_P(Invariance, OrderOfContacts) {
  for (int seed = 0; seed < k_seeds; ++seed)
    expect_same_motion(heap_of(seed), test::with_order(heap_of(seed), {4, 1, 0, 3, 2}));
}

TEST_P(Invariance, SwapOfTheTwoSides) {
  for (int seed = 0; seed < k_seeds; ++seed) expect_same_motion(heap_of(seed), test::with_swapped_sides(heap_of(seed)));
}

TEST_P(Invariance, TurnOfTheTangents) {
  // A quarter turn maps the box pyramid onto itself, a turn of sixty degrees this hexagon.
  const double angle = isotropic() ? 0.7 : GetParam().law == Law::pyramid ? k_pi / 2 : k_pi / 3;
  for (int seed = 0; seed < k_seeds; ++seed)
    expect_same_motion(heap_of(seed), test::with_turned_tangents(heap_of(seed), angle));
}

TEST_P(Invariance, ScaleOfAllMasses) {
  for (int seed = 0; seed < k_seeds; ++seed)
    for (const double factor : {1e-3, 1e7}) {
      const contact::ContactSolution one = solve(heap_of(seed)),
                                     two = solve(test::with_mass_scale(heap_of(seed), factor));
      EXPECT_LT((one.v - two.v).cwiseAbs().maxCoeff(), k_same);
      EXPECT_LT((factor * one.r - two.r).norm(), 1e-6 * factor * (1 + one.r.norm()));
    }
}

TEST_P(Invariance, ScaleOfAllSpeeds) {
  for (int seed = 0; seed < k_seeds; ++seed)
    EXPECT_LT((16 * solve(heap_of(seed)).v - solve(test::with_speed_scale(heap_of(seed), 16)).v).cwiseAbs().maxCoeff(),
              20 * k_same);
}

TEST_P(Invariance, LocalAndGlobalForm) {
  for (int seed = 0; seed < k_seeds; ++seed) {
    const contact::ContactProblem problem = heap_of(seed);
    const contact::ContactSolution local = solve(contact::reduce(problem));
    EXPECT_LT((solve(problem).v - contact::velocities(problem, local.r)).cwiseAbs().maxCoeff(), k_same);
  }
}

TEST_P(Invariance, DuplicateContacts) {
  for (int seed = 0; seed < k_seeds; ++seed) {
    const contact::ContactProblem one = test::with_order(heap_of(seed), {0, 1, 2});
    expect_same_motion(one, test::with_duplicates(one));
  }
}

TEST_P(Invariance, SameArgumentsSameBits) {
  const contact::ContactProblem problem = heap_of(1);
  EXPECT_EQ(solve(problem).r, solve(problem).r);
}

TEST_P(Invariance, ConvergedMeansWhatMeasureSays) {
  for (const double tolerance : {1e-2, 1e-5, 1e-8})
    for (int seed = 0; seed < k_seeds; ++seed) {
      const contact::ContactProblem problem = heap_of(seed);
      const auto solver = contact::find_solver(GetParam().solver).make({.tolerance = tolerance, .max_iterations = 30});
      const contact::ContactSolution solution = solver->solve(problem, {});
      const double law_map = contact::measure(problem, solution.r).law_map_m_s;
      if (solution.status == contact::SolveStatus::converged)
        EXPECT_LE(law_map, tolerance);
      else
        EXPECT_GT(law_map, tolerance);
      EXPECT_NE(solution.status, contact::SolveStatus::numerical_error) << solution.message;
    }
}

TEST_P(Invariance, LimitsAndComplianceAreKept) {
  for (int seed = 0; seed < k_seeds; ++seed) {
    contact::ContactProblem problem = test::with_order(heap_of(seed), {0, 1, 2, 3});
    problem.force_limit = {0.2, 0, 1, std::numeric_limits<double>::infinity()};
    problem.compliance = {0, 0.1, 0.3, 0.2};
    problem.tangential_compliance = {0.2, 0, 0.4, 0.2};
    problem.mu[2] = problem.mu_static[2] = 0;
    const contact::ContactSolution solution = solve(problem);
    for (int c = 0; c < 3; ++c) EXPECT_LE(solution.r[3 * c], problem.force_limit[c] + 1e-9);
    expect_same_motion(problem, test::with_mass_scale(problem, 1e4));
  }
}

/// A compliance is one more entry on the diagonal of W.
TEST_P(Invariance, ComplianceIsPartOfW) {
  for (int seed = 0; seed < k_seeds; ++seed) {
    contact::ContactProblem problem = heap_of(seed);
    for (int c = 0; c < problem.num_contacts(); ++c) {
      problem.compliance[c] = 0.05 * (c + 1);
      problem.tangential_compliance[c] = 0.12 * (c + 1);
    }
    contact::LocalProblem folded = contact::reduce(problem);
    for (int c = 0; c < problem.num_contacts(); ++c)
      for (int k = folded.row_start[c]; k < folded.row_start[c + 1]; ++k)
        if (folded.column[k] == c)
          folded.block[k].diagonal() +=
              Vec3(problem.compliance[c], problem.tangential_compliance[c], problem.tangential_compliance[c]);
    folded.compliance.assign(folded.compliance.size(), 0);
    folded.tangential_compliance = folded.compliance;
    const contact::ContactSolution solution = solve(problem);
    EXPECT_EQ(solution.status, contact::SolveStatus::converged);
    EXPECT_LE(contact::measure(folded, solution.r).law_map_m_s, 10 * k_tolerance);
    EXPECT_LE(contact::measure(contact::reduce(problem), solution.r).law_map_m_s, 10 * k_tolerance);
  }
}

/// A spring of k = 1/(c h^2) along the tangent: the particle sticks, and its velocity winds the spring.
TEST_P(Invariance, TangentialComplianceYields) {
  if (GetParam().law == Law::frictionless) return;
  const double m = 2, v = 3, w = 0.6, c = 0.25;
  contact::ContactProblem problem;
  problem.law = GetParam().law;
  problem.facets = 8;
  problem.add_block(m * Mat3::Identity());
  problem.f << -m * v, m * w, 0;
  problem.add_contact(-1, MatX(3, 0), 0, Mat3::Identity(), 1);
  problem.mu.back() = problem.mu_static.back() = 0.5;
  problem.tangential_compliance.back() = c;
  const double held = w / (1 / m + c);
  EXPECT_LT((solve(problem).r - Vec3(m * v, -held, 0)).norm(), 100 * k_tolerance);
  EXPECT_LT((solve(problem).v - Vec3(0, c * held, 0)).norm(), 10 * k_tolerance);
}

/// A particle of mass m has velocity (-v, w, 0) before contact: the closed forms of the laws differ.
TEST_P(Invariance, ObliqueImpactOfAParticle) {
  for (const double v : {1.0, 0.2, 0.0})
    for (const double w : {3.0, 0.1})
      for (const double mu : {0.0, 0.5, 1.5}) {
        const double m = 7, left = std::max(0.0, w - mu * v);
        contact::ContactProblem problem;
        problem.law = GetParam().law;
        problem.facets = 8;
        problem.add_block(m * Mat3::Identity());
        problem.f << -m * v, m * w, 0;
        problem.add_contact(-1, MatX(3, 0), 0, Mat3::Identity(), 1);
        problem.mu.back() = problem.mu_static.back() = mu;
        Vec3 expected(0, left, 0);  // corners of the polygon and sides of the box lie along the slip
        if (problem.law == Law::frictionless) expected[1] = w;
        if (problem.law == Law::ccp) expected = left / (1 + mu * mu) * Vec3(mu, 1, 0);
        EXPECT_LT((solve(problem).v - expected).norm(), 10 * k_tolerance) << v << " " << w << " " << mu;
      }
}

/// Slip along phi against a k-sided pyramid: friction between mu cos(pi/k) and mu, the box up to sqrt(2) mu.
TEST_P(Invariance, FrictionOfAParticleInEveryDirection) {
  const double mu = 0.4, v = 1;
  for (const double phi : {0.0, 0.2, k_pi / 6, k_pi / 4, 1.0}) {
    contact::ContactProblem problem;
    problem.law = GetParam().law;
    problem.facets = 6;
    problem.add_block(Mat3::Identity());
    problem.f << -v, 5 * std::cos(phi), 5 * std::sin(phi);
    problem.add_contact(-1, MatX(3, 0), 0, Mat3::Identity(), 1);
    problem.mu.back() = problem.mu_static.back() = mu;
    const contact::ContactSolution s = solve(problem);
    const double ratio = s.r.tail<2>().norm() / s.r[0];
    double low = mu, high = mu;
    if (problem.law == Law::frictionless) low = high = 0;
    if (problem.law == Law::pyramid_k) low = mu * std::cos(k_pi / 6);
    if (problem.law == Law::pyramid) high = std::sqrt(2) * mu;
    EXPECT_GE(ratio, low - 1e-9) << phi;
    EXPECT_LE(ratio, high + 1e-9) << phi;
  }
}

TEST_P(Invariance, InputThatIsNotFiniteIsANumericalError) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const auto solver = contact::find_solver(GetParam().solver).make({.tolerance = k_tolerance, .max_iterations = 100});
  const auto expect_refused = [&](const auto& problem, const VecX& guess) {
    const contact::ContactSolution solution = solver->solve(problem, guess);
    EXPECT_EQ(solution.status, contact::SolveStatus::numerical_error);
    EXPECT_FALSE(solution.message.empty());
    EXPECT_EQ(solution.r, VecX::Zero(solution.r.size()));
  };
  for (const double bad : {nan, infinite}) {
    std::vector<contact::ContactProblem> spoilt(6, heap_of(0));
    spoilt[0].w[4] = bad;
    spoilt[1].f[2] = bad;
    spoilt[2].jacobian_data[7] = bad;
    spoilt[3].mass_data[35] = bad;
    spoilt[4].compliance[1] = bad;
    spoilt[5].tangential_compliance[1] = bad;
    for (std::size_t k = 0; k < spoilt.size(); ++k) {
      SCOPED_TRACE(k);
      expect_refused(spoilt[k], {});
    }
    contact::LocalProblem local = contact::reduce(heap_of(0));
    local.q[1] = bad;
    expect_refused(local, {});
  }
  contact::ContactProblem indefinite = heap_of(0);
  indefinite.mass_data[0] = -1;
  expect_refused(indefinite, {});
  contact::LocalProblem negative = contact::reduce(heap_of(0));
  for (Mat3& block : negative.block) block = -block;
  expect_refused(negative, {});
}

TEST_P(Invariance, GuessesOfTheWrongSizeAreRefused) {
  const auto solver = contact::find_solver(GetParam().solver).make({});
  EXPECT_THROW(solver->solve(heap_of(0), VecX::Zero(4)), ContractError);
  EXPECT_THROW(solver->solve(contact::reduce(heap_of(0)), VecX::Zero(4)), ContractError);
}

TEST_P(Invariance, NoContactsAreNothingToDo) {
  contact::ContactProblem problem = test::without_contacts(heap_of(0));
  const contact::ContactSolution solution = solve(problem);
  EXPECT_EQ(solution.r.size(), 0);
  EXPECT_LT((solution.v - contact::velocities(problem, VecX())).cwiseAbs().maxCoeff(), 1e-15);
}

/// Neither side can move. The impulse is the force limit, and a contact without a limit is named. Other contacts are
/// solved.
TEST_P(Invariance, ImmovableContactsTakeTheirLimitOrAreNamed) {
  contact::ContactProblem problem = test::with_order(heap_of(0), {0, 1, 2});
  problem.add_contact(-1, MatX(3, 0), -1, MatX(3, 0), 987);
  problem.w.tail<3>() << -0.3, 0, 0;
  problem.force_limit.back() = 8;
  EXPECT_NEAR(solve(problem).r[9], 8, 1e-12);
  EXPECT_NEAR(solve(contact::reduce(problem)).r[9], 8, 1e-12);
  problem.force_limit.back() = std::numeric_limits<double>::infinity();
  const auto solver =
      contact::find_solver(GetParam().solver).make({.tolerance = k_tolerance, .max_iterations = 100000});
  const contact::ContactSolution global = solver->solve(problem, {}),
                                 local = solver->solve(contact::reduce(problem), {});
  for (const contact::ContactSolution& solution : {global, local}) {
    EXPECT_EQ(solution.status, contact::SolveStatus::numerical_error);
    EXPECT_NE(solution.message.find("987"), std::string::npos) << solution.message;
    EXPECT_EQ(solution.r[9], 0);
    EXPECT_LE(contact::measure(test::with_order(problem, {0, 1, 2}), solution.r.head(9)).law_map_m_s, k_tolerance);
  }
}

/// The mass of a file may be slightly asymmetric, and is used as stored.
TEST_P(Invariance, AsymmetricMassesAreSolvedAsStored) {
  contact::ContactProblem problem = heap_of(1);
  const double inertia = problem.mass_data[21];
  problem.mass_data[22] += 1e-3 * inertia;  // (4, 3) of block 0, not (3, 4)
  const contact::ContactSolution solution = solve(problem);
  EXPECT_GT((solution.v - solve(heap_of(1)).v).norm(), 1e-6);
}

TEST_P(Invariance, ToleranceZeroEnds) {
  const auto solver = contact::find_solver(GetParam().solver).make({.tolerance = 0, .max_iterations = 200});
  const contact::ContactSolution solution = solver->solve(heap_of(2), {});
  EXPECT_NE(solution.status, contact::SolveStatus::numerical_error) << solution.message;
  EXPECT_TRUE(solution.r.allFinite());
}

/// The budget holds for the whole solve, not for each island.
TEST_P(Invariance, ManyIslandsShareTheWallTime) {
  const contact::ContactProblem one = heap_of(0);
  contact::ContactProblem many = test::without_contacts(one);
  for (int copy = 1; copy < 200; ++copy)
    for (int k = 0; k < one.num_blocks(); ++k) many.add_block(one.mass(k));
  for (int copy = 0; copy < 200; ++copy) {
    const int first = copy * one.num_blocks();
    many.f.segment(6 * first, one.f.size()) = one.f;
    for (int c = 0; c < one.num_contacts(); ++c) {
      const auto& pair = one.pairs[c];
      many.add_contact(pair.a < 0 ? -1 : first + pair.a, one.jacobian_a(c), pair.b < 0 ? -1 : first + pair.b,
                       one.jacobian_b(c), static_cast<std::uint64_t>(many.pairs.size()) + 1);
      many.mu.back() = many.mu_static.back() = one.mu[c];
    }
  }
  constexpr double k_budget = 0.02, k_enough = 1;  // [s]; without a shared clock some would take 200 budgets
  const auto solver = contact::find_solver(GetParam().solver)
                          .make({.tolerance = 1e-30, .max_iterations = 100000000, .max_seconds = k_budget});
  const auto start = std::chrono::steady_clock::now();
  solver->solve(many, {});
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_LT(took, GetParam().solver == "enumerate" ? HUGE_VAL : k_enough);  // Brute force tries all combinations.
}

INSTANTIATE_TEST_SUITE_P(AllSolvers, Invariance, testing::ValuesIn(subjects()), name_of);

}  // namespace invariance_test
}  // namespace nilas::solvers
