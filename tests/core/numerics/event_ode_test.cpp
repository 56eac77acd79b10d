#include "core/numerics/event_ode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/base/error.h"

namespace event_ode_test {

using namespace nilas;
using namespace nilas::numerics;

EventOde oscillator() {
  return {[](double, const VecX& y, VecX& dy) { dy << y[1], -y[0]; }, 0, {}};
}

OdeSettings tight(Eigen::Index size) {
  OdeSettings settings;
  settings.relative = 1e-13;
  settings.absolute = VecX::Constant(size, 1e-15);
  return settings;
}

TEST(EventOde, AnOscillatorOverTenPeriods) {
  VecX y{{1.0, 0.0}};
  const double t = 62.5;
  OdeSolution solution(oscillator(), tight(2), 0, y);
  solution.follow(1.0, y);
  EXPECT_NEAR(y[0], std::cos(1.0), 1e-11);
  const OdeStop stop = solution.follow(t, y);
  EXPECT_EQ(stop.t, t);
  EXPECT_TRUE(stop.events.empty());
  EXPECT_NEAR(y[0], std::cos(t), 1e-9);
  EXPECT_NEAR(y[1], -std::sin(t), 1e-9);
}

/// cos t falls through zero at pi/2 and 5 pi/2; it rises in between, which is no event.
TEST(EventOde, StopsWhereAnEventFunctionFallsThroughZero) {
  EventOde ode = oscillator();
  ode.num_events = 2;
  ode.events = [](double, const VecX& y, VecX& g) { g << 5, y[0]; };
  VecX y{{1.0, 0.0}};
  OdeSolution solution(ode, tight(2), 0, y);
  const OdeStop first = solution.follow(10, y);
  EXPECT_EQ(first.events, std::vector<int>{1});
  EXPECT_NEAR(first.t, 0.5 * k_pi, 1e-11);
  OdeSolution on(ode, tight(2), first.t, y);
  EXPECT_TRUE(on.follow(2, y).events.empty());
  EXPECT_NEAR(on.follow(10, y).t, 2.5 * k_pi, 1e-10);
}

TEST(EventOde, AThrowFromTheEquationsComesThroughAndFailureIsSaid) {
  VecX y{{1.0}};
  OdeSolution throws({[](double, const VecX&, VecX&) { throw InputError("no"); }, 0, {}}, tight(1), 0, y);
  EXPECT_THROW(throws.follow(1, y), InputError);
  // y' = y^2 leaves every bound at t = 1
  VecX z{{1.0}};
  OdeSolution bursts({[](double, const VecX& x, VecX& dx) { dx = x.cwiseProduct(x); }, 0, {}}, tight(1), 0, z);
  EXPECT_THROW(bursts.follow(2, z), SimulationError);
  // a period needs more than one step
  VecX w{{1.0, 0.0}};
  OdeSettings few = tight(2);
  few.max_steps = 1;
  OdeSolution short_of_steps(oscillator(), few, 0, w);
  try {
    short_of_steps.follow(2 * k_pi, w);
    FAIL() << "one step was enough";
  } catch (const SimulationError& error) {
    EXPECT_NE(std::string(error.what()).find("more than 1 steps were needed"), std::string::npos) << error.what();
  }
}

}  // namespace event_ode_test
