#include "contact/solvers/shared/best_impulses.h"

#include <gtest/gtest.h>

#include "contact/solvers/shared/measured_loop.h"

namespace nilas::solvers {
namespace best_impulses_test {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_infinite = std::numeric_limits<double>::infinity();

VecX impulse(double r) { return VecX::Constant(3, r); }

TEST(Budget, StagesShareIterations) {
  const Budget budget(contact::SolverSettings{.max_iterations = 10});
  EXPECT_TRUE(budget.allows(9));
  EXPECT_FALSE(budget.allows(10));
  EXPECT_EQ(budget.after(4).iterations(), 6);
  EXPECT_EQ(budget.capped(3).iterations(), 3);
  EXPECT_EQ(budget.capped(30).iterations(), 10);
  EXPECT_FALSE(budget.after(12).allows(0));
}

TEST(Budget, StagesShareTheClock) {
  EXPECT_FALSE(Budget(contact::SolverSettings{}).is_out_of_time());
  EXPECT_FALSE(Budget(contact::SolverSettings{.max_seconds = 1000}).is_out_of_time());
  const Budget spent(contact::SolverSettings{.max_seconds = 1e-12});
  EXPECT_TRUE(spent.is_out_of_time());
  EXPECT_FALSE(spent.after(1).capped(5).allows(0));
}

TEST(StallRule, AFallToTheShareSetsTheNextMark) {
  StallRule rule(3, 0.5);
  EXPECT_FALSE(rule.has_stalled(8, 0));
  EXPECT_FALSE(rule.has_stalled(5, 2));    // not half of 8
  EXPECT_FALSE(rule.has_stalled(3.9, 2));  // the mark
  EXPECT_FALSE(rule.has_stalled(2, 4));
  EXPECT_EQ(rule.waited(4), 2);
  EXPECT_TRUE(rule.has_stalled(1.95, 5));
  EXPECT_TRUE(rule.has_stalled(k_nan, 6));
}

BestImpulses best_of_ten(int window = 100) {
  return {1e-3, Budget(contact::SolverSettings{.max_iterations = 10}), {window, 0.9}};
}

TEST(BestImpulses, KeepsTheLeastResidual) {
  BestImpulses best = best_of_ten();
  EXPECT_FALSE(best.has_any());
  EXPECT_FALSE(best.offer(impulse(9), k_nan));
  EXPECT_FALSE(best.offer(impulse(9), k_infinite));
  EXPECT_TRUE(best.offer(impulse(1), 2));
  EXPECT_FALSE(best.offer(impulse(2), 2));
  EXPECT_TRUE(best.offer(impulse(3), 1));
  best.spend(4);
  EXPECT_EQ(best.left().iterations(), 6);
  const contact::ContactSolution solution = std::move(best).solution();
  EXPECT_EQ(solution.r, impulse(3));
  EXPECT_EQ(solution.status, contact::SolveStatus::iteration_limit);
  EXPECT_EQ(solution.iterations, 4);
}

TEST(BestImpulses, ConvergedStays) {
  BestImpulses best = best_of_ten();
  best.offer(impulse(1), 1e-3);
  EXPECT_TRUE(best.has_converged());
  EXPECT_FALSE(best.goes_on());
  best.stall();
  best.fail("no");
  const contact::ContactSolution solution = std::move(best).solution();
  EXPECT_EQ(solution.status, contact::SolveStatus::converged);
  EXPECT_EQ(solution.message, "");
}

TEST(BestImpulses, StallsByItsRuleAndConvergesLater) {
  BestImpulses best = best_of_ten(2);
  best.offer(impulse(1), 1);
  best.spend(2);
  best.offer(impulse(1), 0.95);
  EXPECT_FALSE(best.goes_on());
  EXPECT_FALSE(best.is_running());
  best.offer(impulse(2), 1e-4);
  EXPECT_TRUE(best.has_converged());
}

TEST(BestImpulses, AFailureHasAReason) {
  BestImpulses best = best_of_ten();
  best.offer(impulse(1), 1);
  best.fail("singular");
  const contact::ContactSolution solution = std::move(best).solution();
  EXPECT_EQ(solution.status, contact::SolveStatus::numerical_error);
  EXPECT_EQ(solution.message, "singular");
  EXPECT_EQ(solution.r, impulse(1));
}

/// Residuals 1, 1/2, 1/4, ... measured exactly.
struct Halving {
  int measured = 0;
  double r = 1;

  contact::ContactSolution run(const contact::SolverSettings& shared) {
    MeasuredLoop loop(shared, Budget(shared), 100);
    const auto measure = [&] {
      ++measured;
      return r;
    };
    const auto impulses = [&] { return impulse(r); };
    for (double change = k_infinite; loop.goes_on(change, measure, impulses); change = r) r *= 0.5;
    return loop.solution(measure, impulses);
  }
};

TEST(MeasuredLoop, MeasuresWhereTheChangeIsSmall) {
  Halving halving;
  const contact::ContactSolution solution = halving.run({.tolerance = 1e-3});
  EXPECT_EQ(solution.status, contact::SolveStatus::converged);
  EXPECT_EQ(solution.iterations, 10);
  EXPECT_EQ(halving.measured, 1);
}

TEST(MeasuredLoop, WithToleranceZeroDoesAllWithoutMeasuring) {
  Halving halving;
  const contact::ContactSolution solution = halving.run({.tolerance = 0, .max_iterations = 30});
  EXPECT_EQ(solution.status, contact::SolveStatus::iteration_limit);
  EXPECT_EQ(solution.iterations, 30);
  EXPECT_EQ(solution.r, impulse(std::ldexp(1.0, -30)));
  EXPECT_EQ(halving.measured, 0);
}

TEST(MeasuredLoop, ImpulsesBeyondAllNumbersBecomeNone) {
  for (const double tolerance : {0.0, 1e-3}) {
    const contact::SolverSettings shared{.tolerance = tolerance, .max_iterations = 5};
    MeasuredLoop loop(shared, Budget(shared), 100);
    const auto measure = [] { return k_nan; };
    const auto impulses = [] { return impulse(k_infinite); };
    while (loop.goes_on(1, measure, impulses)) continue;
    const contact::ContactSolution solution = loop.solution(measure, impulses);
    EXPECT_EQ(solution.status, contact::SolveStatus::numerical_error);
    EXPECT_FALSE(solution.message.empty());
    EXPECT_EQ(solution.r, impulse(0));
  }
}

}  // namespace best_impulses_test
}  // namespace nilas::solvers
