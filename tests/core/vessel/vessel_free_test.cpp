#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "tests/core/vessel/example_vessel.h"

namespace nilas::vessel {
namespace vessel_free_test {

constexpr double k_h = 0.01;

double spin_energy(const VesselModel& model, const VesselState& state) {
  return 0.5 * state.w.dot(example::angular_momentum(model, state));
}

TEST(VesselFree, StartsAsGiven) {
  VesselModel model = example::vessel();
  model.v = {1, 2, 3};
  model.w = {0.1, 0.2, 0.3};
  VesselSystem system(model, 7);
  EXPECT_EQ(system.time(), 7);
  EXPECT_FALSE(system.fixed());
  EXPECT_FALSE(system.on_carriage());
  EXPECT_EQ(system.built(), std::vector<std::string>{"vessel"});
  EXPECT_LT((system.state().pose.p - (model.pose_V.p + model.pose_V.q * model.mass.com)).norm(), 1e-15);
  EXPECT_EQ(system.state().v, model.v);
  EXPECT_EQ(system.state().w, model.w);
}

/// Semi-implicit Euler under weight: v_n = n h g, z_n = z_0 + h^2 g n (n + 1) / 2.
TEST(VesselFree, FallsAsTheFloesDo) {
  const VesselModel model = example::vessel();
  VesselSystem system(model, 0);
  const double z = system.state().pose.p.z(), g = -9.81;
  example::run(system, {{0, 0, example::k_mass * g}, Vec3::Zero()}, k_h, 100);
  EXPECT_NEAR(system.state().v.z(), g, 1e-12);
  EXPECT_NEAR(system.state().pose.p.z(), z + k_h * k_h * g * 5050, 1e-12);
  EXPECT_EQ(system.state().w, Vec3::Zero());
  EXPECT_NEAR(system.time(), 1, 1e-12);
}

/// Tumbling about the middle axis: angular momentum to rounding over 10^4 steps, energy without drift.
TEST(VesselFree, TorqueFreeRotationKeepsAngularMomentum) {
  VesselModel model = example::vessel();
  model.mass.inertia = Vec3(60, 900, 930).asDiagonal();
  model.w = model.pose_V.q * Vec3(0.02, 1.0, 0.05);
  VesselSystem system(model, 0);
  const Vec3 L = example::angular_momentum(model, system.state());
  const double energy = spin_energy(model, system.state());
  double worst_energy = 0, last_energy = 0, fastest = 0;
  for (int i = 0; i < 10000; ++i) {
    example::step(system, Wrench{}, k_h);
    ASSERT_LT((example::angular_momentum(model, system.state()) - L).norm(), 1e-12 * L.norm());
    last_energy = std::abs(spin_energy(model, system.state()) / energy - 1);
    worst_energy = std::max(worst_energy, last_energy);
    fastest = std::max(fastest, system.state().w.norm());
  }
  EXPECT_LT(fastest, 4.5);  // all energy about the axis of the least moment: sqrt(2 E / 60) = 3.9 rad/s
  EXPECT_LT(worst_energy, 1e-4);
}

/// The reference is a fine solution of Euler's equations: the attitude error falls with h^2.
TEST(VesselFree, RotationIsOfSecondOrder) {
  VesselModel model = example::vessel();
  model.w = {0.3, 0.8, -0.4};
  const auto attitude = [&](double h, int steps) {
    VesselSystem system(model, 0);
    example::run(system, {}, h, steps);
    return system.state().pose.q;
  };
  const Quat fine = attitude(2.0 / 16000, 16000);
  const double coarse_error = fine.angularDistance(attitude(0.02, 100));
  const double half_error = fine.angularDistance(attitude(0.01, 200));
  EXPECT_LT(half_error, 2e-4);
  EXPECT_NEAR(coarse_error / half_error, 4, 0.2);
}

TEST(VesselFree, WithoutGyroscopicTermTheAngularVelocityStays) {
  VesselModel model = example::vessel();
  model.gyroscopic = false;
  model.w = {0.3, 0.8, -0.4};
  VesselSystem system(model, 0);
  example::run(system, {}, k_h, 200);
  EXPECT_LT((system.state().w - model.w).norm(), 1e-13);
  const Quat turned = Quat(Eigen::AngleAxisd(2 * model.w.norm(), model.w.normalized())) * model.pose_V.q;
  EXPECT_LT(turned.angularDistance(system.state().pose.q), 1e-12);
}

/// Impulses change the momenta at the pose of the step's start, as the contact problem sees it.
TEST(VesselFree, VelocityAfterImpulsesIsThatOfTheContactProblem) {
  RandomStream random(4, "free");
  VesselModel model = example::vessel();
  model.v = example::random_vector(random, 1);
  model.w = example::random_vector(random, 1);
  VesselSystem system(model, 0);
  for (int i = 0; i < 50; ++i) {
    const VesselState before = system.state();
    const Wrench load = example::random_wrench(random, 500), impulse = example::random_wrench(random, 20);
    const VesselBlock block = system.begin(load, k_h);
    EXPECT_EQ(block.mass, block.mass.transpose());
    EXPECT_TRUE(block.hull.prescribed.isZero(0));
    Vec6 r;
    r << impulse.force, impulse.torque;
    const VecX speeds = block.mass.llt().solve(block.f + block.hull.jacobian.transpose() * r);
    system.finish(impulse);
    EXPECT_LT((block.hull.jacobian * speeds - system.velocity_after_impulses()).norm(), 1e-11);
    EXPECT_LT((system.state().pose.p - before.pose.p - k_h * system.velocity_after_impulses().head<3>()).norm(), 1e-14);
    const Vec3 L = example::angular_momentum(model, before) + k_h * load.torque + impulse.torque;
    EXPECT_LT((example::angular_momentum(model, system.state()) - L).norm(), 1e-12 * L.norm());
  }
}

TEST(VesselFree, DisplacementKeepsTheMomenta) { example::expect_displacement_keeps_momenta(example::vessel()); }

TEST(VesselFree, NonFiniteLoadsAreSimulationErrors) {
  VesselSystem system(example::vessel(), 0);
  system.begin({{0, std::nan(""), 0}, Vec3::Zero()}, k_h);
  EXPECT_THROW(system.finish({}), SimulationError);
}

TEST(VesselFixed, NeverMovesAndHasNoBlock) {
  VesselModel model = example::vessel();
  model.fixed = true;
  VesselSystem system(model, 0);
  EXPECT_TRUE(system.fixed());
  const VecX before = system.coordinates();
  const VesselBlock block = example::step(system, {{0, 0, -5000}, Vec3::Zero()}, k_h, {{10, 0, 0}, Vec3::Zero()});
  EXPECT_EQ(block.mass.size() + block.f.size() + block.hull.jacobian.size(), 0);
  EXPECT_EQ(block.hull.jacobian.rows(), 6);
  EXPECT_TRUE(block.hull.prescribed.isZero(0));
  EXPECT_TRUE(system.velocity_after_impulses().isZero(0));
  EXPECT_EQ(system.coordinates(), before);
}

TEST(VesselSystemContract, StepsBeginBeforeTheyFinish) {
  VesselSystem system(example::vessel(), 0);
  EXPECT_THROW(system.finish({}), ContractError);
  system.begin({}, k_h);
  EXPECT_THROW(system.begin({}, k_h), ContractError);
}

}  // namespace vessel_free_test
}  // namespace nilas::vessel
