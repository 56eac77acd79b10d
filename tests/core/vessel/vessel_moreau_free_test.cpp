/// A free vessel that is moved (1 - theta) h before the impulses and theta h after them.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/bodies/free_rotation.h"
#include "tests/core/vessel/example_vessel.h"

namespace nilas::vessel {
namespace vessel_moreau_free_test {

constexpr double k_h = 0.01;

VesselModel vessel(double theta) {
  VesselModel model = example::vessel();
  model.theta = theta;
  return model;
}

TEST(VesselMoreauFree, FreeFallIsExact) {
  VesselSystem system(vessel(0.5), 0);
  const double z = system.state().pose.p.z(), g = -9.81;
  for (int i = 1; i <= 100; ++i) {
    example::step(system, {{0, 0, example::k_mass * g}, Vec3::Zero()}, k_h);
    const double t = k_h * i;
    ASSERT_NEAR(system.state().v.z(), g * t, 1e-12);
    ASSERT_NEAR(system.state().pose.p.z(), z + 0.5 * g * t * t, 1e-12);
  }
}

/// Loads act at the middle pose; the velocity there is still the old one, turned with the body.
TEST(VesselMoreauFree, MovesItsShareBeforeTheImpulses) {
  VesselModel model = vessel(0.7);
  model.v = {1, 2, 3};
  model.w = {0.3, 0.8, -0.4};
  VesselSystem system(model, 0);
  const VesselState start = system.state();
  system.move_before_impulses(k_h);
  EXPECT_LT((system.state().pose.p - start.pose.p - 0.3 * k_h * model.v).norm(), 1e-15);
  EXPECT_EQ(system.state().v, model.v);
  Quat q = start.pose.q;
  Vec3 w = model.w;
  bodies::turn_freely(q, w, model.mass.inertia, model.mass.inertia.inverse(), (1 - 0.7) * k_h);
  EXPECT_EQ(system.state().pose.q.coeffs(), q.coeffs());
  EXPECT_EQ(system.state().w, w);
}

/// The asymmetric body keeps momentum and energy to rounding for a million steps at 1 rad/s.
TEST(VesselMoreauFree, TorqueFreeRotationKeepsAngularMomentumAndEnergy) {
  VesselModel model = vessel(0.5);
  model.w = Vec3(0.5, 0.8, -0.4).normalized();
  VesselSystem system(model, 0);
  const Vec3 L = example::angular_momentum(model, system.state());
  const double energy = 0.5 * model.w.dot(L);
  double worst_momentum = 0, worst_energy = 0;
  for (int i = 0; i < 1000000; ++i) {
    example::step(system, Wrench{}, k_h);
    const VesselState& state = system.state();
    const Vec3 now = example::angular_momentum(model, state);
    worst_momentum = std::max(worst_momentum, (now - L).norm() / L.norm());
    worst_energy = std::max(worst_energy, std::abs(0.5 * state.w.dot(now) / energy - 1));
  }
  EXPECT_LT(worst_momentum, 1e-10);
  EXPECT_LT(worst_energy, 1e-10);
}

/// Linear springs on heave and roll: the motion of theta 1/2 is of second order, that of any other theta of first.
TEST(VesselMoreauFree, HeaveAndRollOnSpringsConverge) {
  const double heave = 4e4, roll = 3e3;  // [N/m], [N m/rad]
  const auto errors = [&](double theta, double h) {
    VesselModel model = vessel(theta);
    model.mass.inertia = Vec3(60, 900, 930).asDiagonal();
    model.pose_V.q = Quat::Identity();
    model.v = {0, 0, 0.1};
    model.w = {0.05, 0, 0};
    VesselSystem system(model, 0);
    const double z0 = system.state().pose.p.z();
    const auto angle = [](const VesselState& s) { return 2 * std::atan2(s.pose.q.x(), s.pose.q.w()); };
    for (int i = 0; i < static_cast<int>(std::lround(2 / h)); ++i)
      example::step_under(
          system,
          [&](const VesselState& s) {
            return Wrench{{0, 0, -heave * (s.pose.p.z() - z0)}, {-roll * angle(s), 0, 0}};
          },
          h);
    const double a = std::sqrt(heave / example::k_mass), b = std::sqrt(roll / 60);
    return Vec2(std::abs(system.state().v.z() - 0.1 * std::cos(2 * a)),
                std::abs(system.state().w.x() - 0.05 * std::cos(2 * b)));
  };
  for (const double theta : {0.5, 1.0, 0.7}) {
    const Vec2 coarse = errors(theta, 0.002), fine = errors(theta, 0.001);
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(std::log2(coarse[i] / fine[i]), theta == 0.5 ? 2 : 1, 0.1) << theta;
  }
}

/// Attitude and momenta under torques that turn with the body, against a fine solution.
TEST(VesselMoreauFree, TumblingUnderLoadsIsOfSecondOrder) {
  VesselModel model = vessel(0.5);
  model.v = {0.2, -0.1, 0.3};
  model.w = {0.3, 0.8, -0.4};
  const auto end = [&](double h) {
    VesselSystem system(model, 0);
    for (int i = 0; i < static_cast<int>(std::lround(2 / h)); ++i)
      example::step_under(
          system,
          [](const VesselState& s) {
            return Wrench{s.pose.q * Vec3(30, 20, -10), s.pose.q * Vec3(5, 100, 60) - 20 * s.pose.p};
          },
          h);
    return system.state();
  };
  const VesselState fine = end(2.5e-4), coarse = end(0.02), half = end(0.01);
  EXPECT_NEAR((coarse.pose.p - fine.pose.p).norm() / (half.pose.p - fine.pose.p).norm(), 4, 0.3);
  EXPECT_NEAR(coarse.pose.q.angularDistance(fine.pose.q) / half.pose.q.angularDistance(fine.pose.q), 4, 0.3);
  EXPECT_NEAR((coarse.w - fine.w).norm() / (half.w - fine.w).norm(), 4, 0.3);
}

/// Impulses change the momenta at the middle pose, as the contact problem sees it.
TEST(VesselMoreauFree, VelocityAfterImpulsesIsThatOfTheContactProblem) {
  RandomStream random(4, "free");
  for (const double theta : {0.5, 1.0, 0.7}) {
    VesselModel model = vessel(theta);
    model.v = example::random_vector(random, 1);
    model.w = example::random_vector(random, 1);
    VesselSystem system(model, 0);
    for (int i = 0; i < 50; ++i) {
      const Vec3 L_before = example::angular_momentum(model, system.state());
      const Wrench load = example::random_wrench(random, 500), impulse = example::random_wrench(random, 20);
      system.move_before_impulses(k_h);
      const Vec3 middle = system.state().pose.p;
      const VesselBlock block = system.begin(load, k_h);
      EXPECT_EQ(block.mass, block.mass.transpose());
      Vec6 r;
      r << impulse.force, impulse.torque;
      const VecX speeds = block.mass.llt().solve(block.f + block.hull.jacobian.transpose() * r);
      system.finish(impulse);
      const Vec6 after = system.velocity_after_impulses();
      EXPECT_LT((block.hull.jacobian * speeds - after).norm(), 1e-11);
      EXPECT_LT((system.state().pose.p - middle - theta * k_h * after.head<3>()).norm(), 1e-14);
      const Vec3 L = L_before + k_h * load.torque + impulse.torque;
      EXPECT_LT((example::angular_momentum(model, system.state()) - L).norm(), 1e-12 * L.norm());
    }
  }
}

/// The vessel with theta 1 moves as with semi-implicit Euler, except for the mean angular velocity by which it turns.
TEST(VesselMoreauFree, ThetaOneIsSemiImplicitEuler) {
  VesselModel moreau = vessel(1), euler = example::vessel();
  for (VesselModel* model : {&moreau, &euler}) {
    model->v = {0.2, -0.1, 0.3};
    model->w = {0.3, 0.8, -0.4};
  }
  const auto distance = [&](double h) {
    VesselSystem a(moreau, 0), b(euler, 0);
    for (int i = 0; i < static_cast<int>(std::lround(1 / h)); ++i) {
      const Wrench load{{30, 20, -10}, {5, 100, 60}};
      example::step(a, load, h);
      example::step(b, load, h);
      EXPECT_LT((a.state().pose.p - b.state().pose.p).norm(), 1e-13);
      EXPECT_LT((a.state().v - b.state().v).norm(), 1e-13);
      const Vec3 L = example::angular_momentum(euler, b.state());
      EXPECT_LT((example::angular_momentum(moreau, a.state()) - L).norm(), 1e-12 * L.norm());
    }
    return a.state().pose.q.angularDistance(b.state().pose.q);
  };
  const double coarse = distance(0.02), fine = distance(0.01);
  EXPECT_LT(fine, 1e-4);
  EXPECT_NEAR(coarse / fine, 4, 0.2);
}

/// The same motion in a turned ground frame is the turned motion.
TEST(VesselMoreauFree, ATurnedFrameGivesTheTurnedMotion) {
  const Quat turn(Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()));
  VesselModel model = vessel(0.5);
  model.v = {0.2, -0.1, 0.3};
  model.w = {0.3, 0.8, -0.4};
  VesselModel turned = model;
  turned.pose_V = {turn * model.pose_V.q, turn * model.pose_V.p};
  turned.v = turn * model.v;
  turned.w = turn * model.w;
  VesselSystem a(model, 0), b(turned, 0);
  RandomStream random(9, "frame");
  for (int i = 0; i < 200; ++i) {
    const Wrench load = example::random_wrench(random, 100), impulse = example::random_wrench(random, 1);
    example::step(a, load, k_h, impulse);
    example::step(b, {turn * load.force, turn * load.torque}, k_h, {turn * impulse.force, turn * impulse.torque});
    ASSERT_LT((turn * a.state().pose.p - b.state().pose.p).norm(), 1e-12);
    ASSERT_LT((turn * a.state().pose.q).angularDistance(b.state().pose.q), 1e-12);
    ASSERT_LT((turn * a.state().v - b.state().v).norm(), 1e-12);
    ASSERT_LT((turn * a.state().w - b.state().w).norm(), 1e-11);
  }
}

TEST(VesselMoreauFree, WithoutGyroscopicTermTheAngularVelocityStays) {
  VesselModel model = vessel(0.5);
  model.gyroscopic = false;
  model.w = {0.3, 0.8, -0.4};
  VesselSystem system(model, 0);
  example::run(system, {}, k_h, 200);
  EXPECT_EQ(system.state().w, model.w);
  const Quat turned = Quat(Eigen::AngleAxisd(2 * model.w.norm(), model.w.normalized())) * model.pose_V.q;
  EXPECT_LT(turned.angularDistance(system.state().pose.q), 1e-12);
}

TEST(VesselMoreauFree, DisplacementKeepsTheMomenta) { example::expect_displacement_keeps_momenta(vessel(0.5)); }

TEST(VesselMoreauFree, StepsMoveBeforeTheyBegin) {
  VesselSystem system(vessel(0.5), 0);
  EXPECT_THROW(system.begin({}, k_h), ContractError);
  system.move_before_impulses(k_h);
  EXPECT_THROW(system.move_before_impulses(k_h), ContractError);
  EXPECT_THROW(system.begin({}, 2 * k_h), ContractError);
  VesselModel wrong = vessel(1.5);
  EXPECT_THROW(VesselSystem(wrong, 0), ContractError);
}

}  // namespace vessel_moreau_free_test
}  // namespace nilas::vessel
