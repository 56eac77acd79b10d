/// Compares Simbody's reaction of the carriage with the one from the momenta.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "tests/core/vessel/example_vessel.h"

namespace nilas::vessel {
namespace carriage_reaction_test {

struct Largest {
  double apart = 0, load = 0;  ///< force plus torque [N, N m]
};

/// A vessel that is towed on a turning and accelerating path, under a load that swings and blows at the times of a
/// fixed grid.
Largest towed(VesselModel model, double h, double blow) {
  const example::TemporaryFile track("t_s,x_m,y_m,yaw_deg\n0,0,0,0\n1,0.3,0.05,10\n2,1.1,0.5,40\n3,1.3,0.6,20\n");
  model.carriage->motion =
      CarriageMotion::path(model.pose_V.p + model.pose_V.q * model.carriage->joint_V, 0.3, track.path());
  VesselSystem system(model, 0);
  Largest largest;
  constexpr double k_between_blows = 0.32;
  const auto every = std::lround(k_between_blows / h);
  for (long i = 0; i < std::lround(2.56 / h); ++i) {
    const double t = static_cast<double>(i) * h;
    const Wrench load{Vec3(50 * std::sin(3 * t), 20, 30 * std::cos(4 * t)), Vec3(10, 20 * std::cos(5 * t), 5)};
    const Wrench impulse{Vec3(0, blow, 0.5 * blow), Vec3(0.2 * blow, 0, 0)};
    example::step(system, load, h, i % every == 1 ? impulse : Wrench{});
    const CarriageLoads& read = system.carriage_loads();
    if (!read.disagreement) return {-1, 0};
    largest.apart = std::max(largest.apart, read.disagreement->force.norm() + read.disagreement->torque.norm());
    largest.load = std::max(largest.load, read.about_com.force.norm() + read.about_com.torque.norm());
  }
  return largest;
}

VesselModel model_of(BalanceKind balance, const std::array<bool, 6>& free, std::optional<double> theta) {
  VesselModel model = example::vessel();
  model.carriage = example::carriage(model, {1.5, 0.1, 0.5});
  model.carriage->balance = balance;
  model.carriage->free = free;
  model.theta = theta;
  return model;
}

const std::array<bool, 6> k_none{}, k_heave_roll_pitch{false, false, true, true, true, false};

/// Both are means over the step: to second order with theta 1/2 however the vessel hangs, and without theta where the
/// joint lets nothing turn; else to the order of the scheme. Blows change the order of none.
TEST(CarriageReaction, AgreesWithTheMomenta) {
  for (const std::optional<double> theta : {std::optional<double>(), std::optional<double>(0.5)})
    for (const BalanceKind balance : {BalanceKind::rigid, BalanceKind::six_cells, BalanceKind::prismatic})
      for (const auto& free : {k_none, k_heave_roll_pitch})
        for (const double blow : {0.0, 3.0}) {
          const VesselModel model = model_of(balance, free, theta);
          const Largest coarse = towed(model, 0.01, blow), fine = towed(model, 0.005, blow);
          const bool turns = balance == BalanceKind::six_cells || (balance == BalanceKind::rigid && free[3]);
          const bool second_order = theta.has_value() || !turns;
          const auto told = std::to_string(static_cast<int>(balance)) + (free[3] ? " free " : " held ") +
                            std::to_string(theta.value_or(1)) + " " + std::to_string(blow);
          EXPECT_GT(fine.apart, 0) << told;
          EXPECT_GT(coarse.apart / fine.apart, second_order ? 3.4 : 1.2) << told;
          EXPECT_LT(coarse.apart, (second_order ? 3e-5 : 7e-3) * coarse.load) << told;
        }
}

/// Where nothing turns there is nothing to resolve.
TEST(CarriageReaction, IsTheSameToRoundingOnAStraightCourse) {
  for (const std::optional<double> theta : {std::optional<double>(), std::optional<double>(0.5)}) {
    VesselModel model = model_of(BalanceKind::prismatic, k_none, theta);
    const Vec3 start = model.pose_V.p + model.pose_V.q * model.carriage->joint_V;
    model.carriage->motion = CarriageMotion::straight(start, 0.3, 0.7, 0.5, 1, 0);
    VesselSystem system(model, 0);
    RandomStream random(7, "reaction");
    for (int i = 0; i < 200; ++i) {
      const Wrench impulse = i % 20 == 0 ? example::random_wrench(random, 30) : Wrench{};
      example::step(system, example::random_wrench(random, 200), 0.01, impulse);
      const CarriageLoads& read = system.carriage_loads();
      const double load = read.about_com.force.norm() + read.about_com.torque.norm();
      ASSERT_TRUE(read.disagreement.has_value());
      ASSERT_LT(read.disagreement->force.norm() + read.disagreement->torque.norm(), 1e-11 * load) << i;
    }
  }
}

/// The next step does not depend on a query of Simbody's reaction: the tree keeps its state.
TEST(CarriageReaction, LeavesTheVesselWhereItWas) {
  for (const std::optional<double> theta : {std::optional<double>(), std::optional<double>(0.5)}) {
    VesselModel model = model_of(BalanceKind::six_cells, k_heave_roll_pitch, theta);
    VesselSystem whole(model, 0), second(model, 0);
    RandomStream random(8, "reaction");
    for (int i = 0; i < 10; ++i) example::step(whole, example::random_wrench(random, 100), 0.01);
    State state;
    whole.save(StateWriter(state));
    second.restore(StateReader(state));
    const Wrench load = example::random_wrench(random, 100);
    example::step(whole, load, 0.01);
    example::step(second, load, 0.01);
    EXPECT_EQ(whole.coordinates(), second.coordinates());
    EXPECT_EQ(whole.carriage_loads().disagreement->torque, second.carriage_loads().disagreement->torque);
  }
}

}  // namespace carriage_reaction_test
}  // namespace nilas::vessel
