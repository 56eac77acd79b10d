#include "core/vessel/thrusters/allocation.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/random.h"
#include "tests/core/vessel/thrusters/example_thrusters.h"

namespace allocation_test {

using namespace nilas;
using test::supply_thrusters;
using test::thruster;
using vessel::Allocation;
using vessel::PlaneLoad;
using vessel::Thruster;
using vessel::ThrusterCommand;

std::vector<ThrusterCommand> at_rest(const Allocation& allocation) {
  return std::vector<ThrusterCommand>(allocation.thrusters().size());
}

// Without active limits the least sum w T^2 with B T = tau is T = W^-1 B^T (B W^-1 B^T)^-1 tau. The heavy weight on the
// shortfall leaves a difference of about a millionth.
TEST(Allocation, IsTheWeightedPseudoInverseWithinTheLimits) {
  const Allocation allocation(supply_thrusters(), Vec3::Zero());
  const std::size_t n = allocation.thrusters().size();
  MatX B(3, n), inverse = MatX::Zero(n, n);
  for (std::size_t k = 0; k < n; ++k) {
    const Thruster& t = allocation.thrusters()[k];
    B.col(static_cast<Eigen::Index>(k)) = allocation.unit_load(k, 0);
    inverse.diagonal()[static_cast<Eigen::Index>(k)] = t.most_ahead * t.most_ahead / t.power;
  }
  const PlaneLoad wanted(2e5, 1e5, -2e6);
  const VecX known = inverse * B.transpose() * (B * inverse * B.transpose()).inverse() * wanted;
  const auto found = allocation.allocate(wanted, at_rest(allocation), 1);
  for (std::size_t k = 0; k < n; ++k)
    EXPECT_NEAR(found.commands[k].thrust, known[static_cast<Eigen::Index>(k)], 3e-5 * known.norm()) << k;
  EXPECT_LT(found.shortfall.norm(), 1e-4 * wanted.norm());
  EXPECT_FALSE(found.saturated);
}

// Beyond the limits a grid over all thrusts of three thrusters finds no better cost, up to its spacing.
TEST(Allocation, FindsTheLeastCostOfAGridWhereLimitsAreActive) {
  std::vector<Thruster> three{thruster("bow", ThrusterKind::tunnel, 30, 0, 2e5, 1.5e6),
                              thruster("stern", ThrusterKind::tunnel, -25, 0, 1.5e5, 1.5e6),
                              thruster("main", ThrusterKind::propeller, -35, 2, 4e5, 3e6)};
  const Allocation allocation(three, Vec3::Zero());
  const auto cost = [&](const std::vector<ThrusterCommand>& c, const PlaneLoad& wanted) {
    const PlaneLoad s = wanted - allocation.load_of(c);
    const Vec2 scale = allocation.scales();
    double sum = 1e6 * (s.head<2>().squaredNorm() / scale.x() / scale.x() + s.z() * s.z() / scale.y() / scale.y());
    for (std::size_t k = 0; k < 3; ++k) sum += three[k].power / 6e6 * std::pow(c[k].thrust / three[k].most_ahead, 2);
    return sum;
  };
  RandomStream stream(1, "wanted loads");
  for (int trial = 0; trial < 6; ++trial) {
    const PlaneLoad wanted(stream.uniform(-6e5, 6e5), stream.uniform(-5e5, 5e5), stream.uniform(-1.5e7, 1.5e7));
    const auto found = allocation.allocate(wanted, at_rest(allocation), 1);
    const double least = cost(found.commands, wanted);
    constexpr int k_points = 41;
    auto c = at_rest(allocation);
    double best = 1e300;
    for (int i = 0; i < k_points; ++i)
      for (int j = 0; j < k_points; ++j)
        for (int k = 0; k < k_points; ++k) {
          c[0].thrust = 2e5 * (2.0 * i / (k_points - 1) - 1);
          c[1].thrust = 1.5e5 * (2.0 * j / (k_points - 1) - 1);
          c[2].thrust = 4e5 * (2.0 * k / (k_points - 1) - 1);
          best = std::min(best, cost(c, wanted));
        }
    EXPECT_LE(least, best * (1 + 1e-9)) << trial;
  }
}

TEST(Allocation, KeepsToRatesAndReportsTheShortfall) {
  auto all = supply_thrusters();
  for (Thruster& t : all) t.rate = 1e4;
  const Allocation allocation(all, Vec3::Zero());
  const auto found = allocation.allocate({0, 6e5, 0}, at_rest(allocation), 2);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(found.commands[k].thrust, 2e4, 1e-3);
  EXPECT_NEAR(found.shortfall.y(), 6e5 - 8e4, 1);
  EXPECT_TRUE(found.saturated);
}

TEST(Allocation, LeavesOutWhatDoesNotWork) {
  const Allocation allocation(supply_thrusters(), Vec3::Zero());
  auto present = at_rest(allocation);
  present[0].works = false;
  present[0].thrust = 1e5;
  const auto found = allocation.allocate({0, 3e5, 0}, present, 1);
  EXPECT_EQ(found.commands[0].thrust, 0);
  EXPECT_LT(found.shortfall.norm(), 1e-3 * 3e5) << "the other tunnels take over";
}

/// Two azimuths aft, as on a platform supply vessel, and a bow tunnel.
Allocation azimuths(double turn_rate) {
  std::vector<Thruster> all{thruster("bow", ThrusterKind::tunnel, 30, 0, 2e5, 1.5e6),
                            thruster("port", ThrusterKind::azimuth, -33, 6, 5e5, 3.5e6),
                            thruster("starboard", ThrusterKind::azimuth, -33, -6, 5e5, 3.5e6)};
  for (Thruster& t : all) t.turn_rate = turn_rate;
  return {all, Vec3::Zero()};
}

// Pure sway. The components of the force of each azimuth are unknowns of their own, so without active limits the answer
// is the weighted pseudo-inverse again: unknowns bow y, port x and y, starboard x and y.
TEST(Allocation, TurnsAzimuthsToTheWantedDirection) {
  const Allocation allocation = azimuths(12 * k_deg);
  Eigen::Matrix<double, 3, 5> B;
  B << 0, 1, 0, 1, 0,  //
      1, 0, 1, 0, 1,   //
      30, -6, -33, 6, -33;
  const double bow = 2e5 * 2e5 / 1.5e6, azimuth = 5e5 * 5e5 / 3.5e6;
  Eigen::Matrix<double, 5, 1> inverse;
  inverse << bow, azimuth, azimuth, azimuth, azimuth;
  const Eigen::Matrix<double, 5, 1> known = inverse.asDiagonal() * B.transpose() *
                                            (B * inverse.asDiagonal() * B.transpose()).inverse() *
                                            PlaneLoad(0, 2.1e5, 0);
  auto present = at_rest(allocation);
  vessel::AllocatedThrust found;
  for (int k = 0; k < 60; ++k) {
    found = allocation.allocate({0, 2.1e5, 0}, present, 0.5);
    for (std::size_t i = 1; i < 3; ++i) EXPECT_LE(std::abs(found.commands[i].angle - present[i].angle), 6.001 * k_deg);
    present = found.commands;
  }
  EXPECT_NEAR(present[0].thrust, known[0], 1e-3 * known.norm());
  for (std::size_t i = 1; i < 3; ++i) {
    const Vec2 force = present[i].thrust * direction_of(present[i].angle);
    EXPECT_LT((force - known.segment<2>(static_cast<Eigen::Index>(2 * i) - 1)).norm(), 1e-3 * known.norm()) << i;
  }
  EXPECT_FALSE(found.saturated);
}

// A load astern while the azimuths point ahead: they turn by half a circle within 15 s at 12 deg/s, and then give it.
TEST(Allocation, TurnsAzimuthsThatPointTheWrongWay) {
  std::vector<Thruster> all = azimuths(12 * k_deg).thrusters();
  for (Thruster& t : all)
    if (t.turns()) t.most_astern = 0;
  const Allocation allocation(all, Vec3::Zero());
  auto present = at_rest(allocation);
  vessel::AllocatedThrust found;
  for (int k = 0; k < 160; ++k) {
    found = allocation.allocate({-4e5, 0, 0}, present, 0.1);
    present = found.commands;
  }
  EXPECT_FALSE(found.saturated) << found.shortfall.transpose();
  EXPECT_LT(found.shortfall.norm(), 1e-3 * 4e5);
}

TEST(Allocation, GivesNoThrustFromAForbiddenSector) {
  std::vector<Thruster> all = azimuths(12 * k_deg).thrusters();
  for (Thruster& t : all)
    if (t.turns()) {
      t.forbidden = {{60 * k_deg, 120 * k_deg}};
      t.most_astern = 0;
    }
  const Allocation allocation(all, Vec3::Zero());
  auto present = at_rest(allocation);
  for (int k = 0; k < 200; ++k) {
    present = allocation.allocate({0, 2.1e5, 0}, present, 0.1).commands;
    for (std::size_t i = 1; i < 3; ++i) {
      const double angle = present[i].angle / k_deg;
      EXPECT_FALSE(present[i].thrust > 1 && angle > 61.3 && angle < 118.7)
          << angle << ", one turn beyond the edge at most";
    }
  }
}

// Azimuths that point to starboard would push to port by going astern: that force lies in the forbidden sector too.
TEST(Allocation, ForbidsTheDirectionOfTheForceAstern) {
  std::vector<Thruster> all = azimuths(12 * k_deg).thrusters();
  for (Thruster& t : all)
    if (t.turns()) t.forbidden = {{60 * k_deg, 120 * k_deg}};
  const Allocation allocation(all, Vec3::Zero());
  auto present = at_rest(allocation);
  for (ThrusterCommand& command : present) command.angle = -90 * k_deg;
  const auto first = allocation.allocate({0, 2.1e5, 0}, present, 0.1);
  for (std::size_t i = 1; i < 3; ++i) EXPECT_GE(first.commands[i].thrust, -1e-6) << "no force to port from astern";
  const auto away = allocation.allocate({0, -2.1e5, 0}, present, 0.1);
  EXPECT_GT(away.commands[1].thrust, 1e4) << "a force to starboard is allowed";
  for (ThrusterCommand& command : present) command.angle = 90 * k_deg;
  const auto astern = allocation.allocate({0, -2.1e5, 0}, present, 0.1);
  EXPECT_LT(astern.commands[1].thrust, -1e4) << "and so it is by going astern";
}

Allocation with_rudders() {
  std::vector<Thruster> all{thruster("bow", ThrusterKind::tunnel, 30, 0, 2e5, 1.5e6),
                            thruster("port", ThrusterKind::propeller_rudder, -35, 6, 6e5, 4e6),
                            thruster("starboard", ThrusterKind::propeller_rudder, -35, -6, 6e5, 4e6)};
  for (Thruster& t : all) {
    t.turn_rate = 5 * k_deg;
    t.rudder = {.area = 9, .span = 4, .behind = 2, .diameter = 3.6, .most_angle = 35 * k_deg, .water_density = 1025};
  }
  return {all, Vec3::Zero()};
}

// Without a stern tunnel, sway without yaw needs a force to port aft: a propeller ahead with its rudder over, the other
// astern.
TEST(Allocation, UsesOnePropellerAheadWithRudderAndTheOtherAstern) {
  const Allocation allocation = with_rudders();
  auto present = at_rest(allocation);
  vessel::AllocatedThrust found;
  for (int k = 0; k < 100; ++k) {
    found = allocation.allocate({0, 1e5, 0}, present, 0.5);
    present = found.commands;
  }
  EXPECT_FALSE(found.saturated) << found.shortfall.transpose();
  EXPECT_LT(present[1].thrust * present[2].thrust, 0);
}

TEST(Allocation, GivesTheSameBitsAgain) {
  const Allocation allocation = azimuths(12 * k_deg);
  const auto once = allocation.allocate({1e5, 2e5, 3e6}, at_rest(allocation), 1);
  const auto again = allocation.allocate({1e5, 2e5, 3e6}, at_rest(allocation), 1);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(once.commands[k].thrust, again.commands[k].thrust);
    EXPECT_EQ(once.commands[k].angle, again.commands[k].angle);
  }
}

}  // namespace allocation_test
