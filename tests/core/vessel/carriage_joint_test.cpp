/// Free axes of the joint, prescribed paths, and the loads that the joint transmits.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "core/base/error.h"
#include "tests/core/vessel/example_vessel.h"

namespace nilas::vessel {
namespace carriage_joint_test {

constexpr double k_h = 0.01;
constexpr double k_g = 9.81;
const std::array<bool, 6> k_heave{false, false, true, false, false, false},
    k_pitch{false, false, false, false, true, false}, k_yaw{false, false, false, false, false, true},
    k_heave_roll_pitch{false, false, true, true, true, false};

const Wrench k_weight{{0, 0, -example::k_mass* k_g}, Vec3::Zero()};

TEST(CarriageJoint, NamesWhatWasBuilt) {
  const std::vector<std::string> expected{"vessel", "carriage", "force balance six-cells"};
  EXPECT_EQ(VesselSystem(example::carried(BalanceKind::six_cells), 0).built(), expected);
  EXPECT_EQ(VesselSystem(example::carried(BalanceKind::prismatic), 0).built().back(), "force balance prismatic");
  EXPECT_EQ(VesselSystem(example::carried(BalanceKind::rigid), 0).built().back(), "force balance rigid");
  EXPECT_TRUE(VesselSystem(example::carried(BalanceKind::rigid), 0).on_carriage());
}

TEST(CarriageJoint, StartsAtTheScenesPoseAndSpeed) {
  for (const BalanceKind balance : {BalanceKind::rigid, BalanceKind::six_cells, BalanceKind::prismatic}) {
    VesselModel model = example::vessel();
    model.pose_V.q =
        Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ())) * Quat(Eigen::AngleAxisd(0.1, Vec3(1, 2, 0).normalized()));
    model.carriage = example::carriage(model, {1.5, 0.1, 0.5});
    const Vec3 start = model.pose_V.p + model.pose_V.q * model.carriage->joint_V;
    model.carriage->motion = CarriageMotion::straight(start, 0.3, 0.7, 0.3, 0, 2);
    model.carriage->balance = balance;
    VesselSystem system(model, 2);
    EXPECT_LT((system.state().pose.p - (model.pose_V.p + model.pose_V.q * model.mass.com)).norm(), 1e-14);
    EXPECT_LT(system.state().pose.q.angularDistance(model.pose_V.q), 1e-14);
    EXPECT_LT((system.state().v - 0.7 * Vec3(std::cos(0.3), std::sin(0.3), 0)).norm(), 1e-15);
    EXPECT_EQ(system.state().w, Vec3::Zero());
  }
}

/// A run that begins in the middle of a path finds the vessel where the path has led it.
TEST(CarriageJoint, StartsInTheMiddleOfAPath) {
  const example::TemporaryFile track("t_s,x_m,y_m,yaw_deg\n0,0,0,0\n2,1,0,90\n");
  VesselModel model = example::vessel();
  model.carriage = example::carriage(model, {1.5, 0.1, 0.5});
  const Vec3 start = model.pose_V.p + model.pose_V.q * model.carriage->joint_V;
  model.carriage->motion = CarriageMotion::path(start, 0.3, track.path());
  const VesselSystem system(model, 1);
  const Quat q = Quat(Eigen::AngleAxisd(0.25 * k_pi, Vec3::UnitZ())) * model.pose_V.q;
  EXPECT_LT(system.state().pose.q.angularDistance(q), 1e-14);
  const Vec3 arm = q * (model.mass.com - model.carriage->joint_V);
  EXPECT_LT((system.state().pose.p - start - Vec3(0.5, 0, 0) - arm).norm(), 1e-14);
  EXPECT_LT((system.state().w - Vec3(0, 0, 0.25 * k_pi)).norm(), 1e-14);
  EXPECT_LT((system.state().v - Vec3(0.5, 0, 0) - Vec3(0, 0, 0.25 * k_pi).cross(arm)).norm(), 1e-14);
}

TEST(CarriageJoint, JointMustBeThePointOfTheCarriage) {
  VesselModel model = example::carried(BalanceKind::rigid);
  model.carriage->joint_V.x() += 1e-3;
  EXPECT_THROW(VesselSystem(model, 0), ContractError);
}

/// Free heave: the vessel falls as a free body, the joint transmits nothing along Z, and the towing force is held.
TEST(CarriageJoint, HeaveFreeFallsAndTransmitsNothing) {
  for (const BalanceKind balance : {BalanceKind::rigid, BalanceKind::prismatic, BalanceKind::six_cells}) {
    VesselModel model = example::carried(balance, k_heave);
    VesselSystem system(model, 0);
    const double z = system.state().pose.p.z();
    Wrench load = k_weight;
    load.force.x() = -70;
    for (int i = 0; i < 100; ++i) {
      example::step(system, load, k_h);
      ASSERT_LT(std::abs(system.carriage_loads().about_joint.force.z()), 1e-9 * example::k_mass * k_g);
    }
    EXPECT_NEAR(system.state().v.z(), -k_g, 1e-10);
    EXPECT_NEAR(system.state().pose.p.z(), z - k_h * k_h * k_g * 5050, 1e-10);
    if (balance == BalanceKind::six_cells) {
      const auto& cells = system.carriage_loads().cells;
      EXPECT_NEAR(cells[3] + cells[4] + cells[5], 0, 1e-9 * example::k_mass * k_g);
    } else {
      EXPECT_NEAR(system.carriage_loads().about_joint.force.x(), 70, 1e-9);
    }
  }
}

/// Free heave on a hydrostatic spring is the semi-implicit Euler oscillator.
TEST(CarriageJoint, HeaveOnASpringIsTheOscillator) {
  const double k = 4e4;
  VesselSystem system(example::carried(BalanceKind::rigid, k_heave), 0);
  const double z0 = system.state().pose.p.z() - 0.05;
  double z = 0.05, v = 0;
  for (int i = 0; i < 1000; ++i) {
    v -= k_h * k / example::k_mass * z;
    z += k_h * v;
    example::step(system, {{0, 0, -k * (system.state().pose.p.z() - z0)}, Vec3::Zero()}, k_h);
    ASSERT_NEAR(system.state().pose.p.z() - z0, z, 1e-11);
    ASSERT_NEAR(system.state().v.z(), v, 1e-10);
  }
}

/// A prismatic joint moves in heave whatever `free` is.
TEST(CarriageJoint, PrismaticIsHeaveOnly) {
  VesselSystem a(example::carried(BalanceKind::prismatic), 0), b(example::carried(BalanceKind::rigid, k_heave), 0),
      c(example::carried(BalanceKind::prismatic, k_yaw), 0);
  const Wrench load{{30, 20, -10}, {5, 8, -6}};
  for (VesselSystem* system : {&a, &b, &c}) example::run(*system, load, k_h, 100);
  EXPECT_EQ(a.coordinates(), b.coordinates());
  EXPECT_EQ(a.coordinates(), c.coordinates());
  EXPECT_EQ(a.carriage_loads().about_com.torque, b.carriage_loads().about_com.torque);
}

/// A vessel hung above its centre of mass with free pitch is a physical pendulum: no pitch moment at the joint, the
/// period of small swings 2 pi / omega = 2 pi sqrt((I + m l^2) / (m g l)), energy that only falls, by h omega^2 per
/// second.
class CarriageJointPendulum : public testing::Test {
 protected:
  static constexpr double k_length = 1.2, k_inertia = 900 + example::k_mass * k_length * k_length;
  static constexpr double k_omega_squared = example::k_mass * k_g * k_length / k_inertia;

  struct Swing {
    double period = 0, energy_kept = 0, most_energy = 0, most_moment = 0;
  };
  static Swing swing(double amplitude, double h, double duration) {
    VesselModel model = example::vessel();
    model.mass.inertia = Vec3(60, 900, 930).asDiagonal();
    model.pose_V = {};
    const Vec3 joint = model.mass.com + Vec3(0, 0, k_length);
    model.carriage = example::carriage(model, joint);
    model.carriage->motion = CarriageMotion::straight(joint, 0, 0, 0, 0, 0);
    model.carriage->free = k_pitch;
    VesselSystem system(model, 0);
    // a blow that sets the wanted swing
    const double start = example::k_mass * k_g * k_length * (1 - std::cos(amplitude));
    example::step(system, k_weight, h, {Vec3::Zero(), {0, std::sqrt(2 * start * k_inertia), 0}});
    Swing result;
    double crossing = 0;
    int crossings = 0;
    while (system.time() < duration) {
      const double before = system.coordinates()[0];
      example::step(system, k_weight, h);
      const double after = system.coordinates()[0];
      if (before < 0 && after >= 0) {
        crossing = system.time() - h * after / (after - before);
        ++crossings;
      }
      const VesselState& s = system.state();
      result.energy_kept =
          (0.5 * k_inertia * s.w.y() * s.w.y() + example::k_mass * k_g * (s.pose.p.z() - model.mass.com.z())) / start;
      result.most_energy = std::max(result.most_energy, result.energy_kept);
      result.most_moment = std::max(result.most_moment, std::abs(system.carriage_loads().about_joint.torque.y()));
    }
    result.period = crossing / crossings;
    return result;
  }
};

TEST_F(CarriageJointPendulum, SmallSwingsKeepThePeriod) {
  const Swing coarse = swing(1e-3, 0.01, 40), fine = swing(1e-3, 0.005, 40);
  const double period = 2 * k_pi / std::sqrt(k_omega_squared);
  EXPECT_NEAR(coarse.period / period, 1, 3e-4);
  EXPECT_NEAR(std::log(coarse.energy_kept) / (-0.01 * k_omega_squared * 40), 1, 0.03);
  EXPECT_NEAR(std::log(fine.energy_kept) / (-0.005 * k_omega_squared * 40), 1, 0.03);
  EXPECT_LT(coarse.most_energy, 1.02);
  EXPECT_LT(coarse.most_moment, 1e-9 * example::k_mass * k_g * k_length);
}

TEST_F(CarriageJointPendulum, LargeSwingsOnlyLoseEnergy) {
  const Swing coarse = swing(1.2, 0.01, 20), fine = swing(1.2, 0.0025, 20);
  EXPECT_LT(coarse.most_energy, 1.02);
  EXPECT_LT(coarse.most_moment, 1e-8 * example::k_mass * k_g * k_length);
  EXPECT_GT(fine.energy_kept, 1 - 0.0025 * 2 * k_omega_squared * 20);
}

/// The joint turns at a constant rate, the centre of mass runs on a circle: centripetal force m w^2 r, torque w x I w,
/// both to second order in the step.
TEST(CarriageJoint, TurningCarriageGivesCentripetalLoad) {
  const example::TemporaryFile track("t_s,x_m,y_m,yaw_deg\n0,0,0,0\n10,0,0,360\n");
  const double w = 2 * k_pi / 10;
  for (const BalanceKind balance : {BalanceKind::rigid, BalanceKind::six_cells}) {
    VesselModel model = example::vessel();
    const Vec3 joint_V = model.mass.com + Vec3(-1.4, 0, 0.3);
    model.carriage = example::carriage(model, joint_V);
    model.carriage->balance = balance;
    model.carriage->stiffness = 1e9;
    model.carriage->damping = 1e6;
    const Vec3 start = model.pose_V.p + model.pose_V.q * joint_V;
    model.carriage->motion = CarriageMotion::path(start, 0.3, track.path());
    const auto errors = [&](double h) {
      VesselSystem system(model, 0);
      example::run(system, {}, h, static_cast<int>(std::lround(5 / h)));
      const Quat q = system.state().pose.q;
      const Vec3 spin(0, 0, w);
      const Vec3 centripetal = example::k_mass * spin.cross(spin.cross(q * Vec3(1.4, 0, 0)));
      const Vec3 gyroscopic = spin.cross(q * (model.mass.inertia * (q.conjugate() * spin)));
      // a step's mean load belongs to the middle of the step, half a turn h w / 2 before its end
      const Quat back(Eigen::AngleAxisd(-0.5 * h * w, Vec3::UnitZ()));
      const auto& loads = system.carriage_loads().about_com;
      return Vec2((loads.force - back * centripetal).norm() / centripetal.norm(),
                  (loads.torque - back * gyroscopic).norm() / gyroscopic.norm());
    };
    const Vec2 coarse = errors(0.02), fine = errors(0.01);
    if (balance == BalanceKind::rigid) {
      EXPECT_LT(fine.maxCoeff(), 1e-5);
      EXPECT_NEAR(coarse[0] / fine[0], 4, 0.1);
      EXPECT_NEAR(coarse[1] / fine[1], 4, 0.1);
    } else {
      EXPECT_LT(fine.maxCoeff(), 1e-3);
    }
  }
}

/// Speeds by Simbody's equations of motion at the step's start and speeds by the momenta at its end differ by O(h^2) on
/// a turning, accelerating carriage: inertia forces of the carriage, Coriolis terms and Jacobians fit together.
TEST(CarriageJoint, EquationsOfMotionAndMomentaAgree) {
  const example::TemporaryFile track("t_s,x_m,y_m,yaw_deg\n0,0,0,0\n1,0.5,0.1,30\n2,1.5,1.2,-20\n3,1.0,1.3,10\n");
  for (const auto& free : {k_heave_roll_pitch, k_pitch, k_yaw}) {
    VesselModel model = example::vessel();
    model.carriage = example::carriage(model, {1.5, 0.1, 0.5});
    model.carriage->free = free;
    const Vec3 start = model.pose_V.p + model.pose_V.q * model.carriage->joint_V;
    model.carriage->motion = CarriageMotion::path(start, 0.3, track.path());
    const auto largest_difference = [&](double h) {
      VesselSystem system(model, 0);
      double largest = 0;
      const int steps = static_cast<int>(std::lround(2.5 / h));
      for (int i = 0; i < steps; ++i) {
        const double t = system.time();
        const Wrench load{{20, -10, 30 * std::sin(t)}, {40 * std::cos(t), -30, 10}};
        const VesselBlock block = example::step(system, load, h);
        const VecX by_forces = block.mass.llt().solve(block.f);
        largest = std::max(largest, (by_forces - system.coordinates().tail(by_forces.size())).norm());
      }
      return largest;
    };
    const double coarse = largest_difference(0.01), fine = largest_difference(0.005);
    EXPECT_NEAR(coarse / fine, 4, 0.5);
    EXPECT_LT(fine, 1e-3);
  }
}

/// The whole motion converges on a fine solution, in first order as semi-implicit Euler does.
TEST(CarriageJoint, FreeAxesConverge) {
  const example::TemporaryFile track("t_s,x_m,y_m,yaw_deg\n0,0,0,0\n1,0.5,0.1,30\n2,1.5,1.2,-20\n3,1.0,1.3,10\n");
  VesselModel model = example::vessel();
  model.carriage = example::carriage(model, {1.5, 0.1, 0.5});
  model.carriage->free = k_heave_roll_pitch;
  const Vec3 start = model.pose_V.p + model.pose_V.q * model.carriage->joint_V;
  model.carriage->motion = CarriageMotion::path(start, 0.3, track.path());
  const auto end = [&](double h) {
    VesselSystem system(model, 0);
    example::run(system, {{20, -10, 30}, {40, -30, 10}}, h, static_cast<int>(std::lround(2 / h)));
    return system.state().pose;
  };
  const Pose fine = end(2e-4);
  const Pose coarse = end(0.02), half = end(0.01);
  EXPECT_NEAR((coarse.p - fine.p).norm() / (half.p - fine.p).norm(), 2, 0.1);
  EXPECT_NEAR(coarse.q.angularDistance(fine.q) / half.q.angularDistance(fine.q), 2, 0.1);
}

/// The joint on six cells transmits nothing along its free axes, also while everything swings.
TEST(CarriageJoint, CellsTransmitNothingOnFreeAxes) {
  VesselModel model = example::carried(BalanceKind::six_cells, k_heave_roll_pitch);
  VesselSystem system(model, 0);
  RandomStream random(6, "joint");
  const Quat to_carriage(Eigen::AngleAxisd(-0.3, Vec3::UnitZ()));
  for (int i = 0; i < 300; ++i) {
    example::step(system, example::random_wrench(random, 50), k_h, example::random_wrench(random, 1));
    const Wrench& read = system.carriage_loads().about_joint;
    ASSERT_LT(std::abs(read.force.z()), 1e-9);
    // roll turns about the carriage's x axis, through the vessel's joint point
    const VecX q = system.coordinates();
    const Vec3 force = to_carriage * read.force, torque = to_carriage * read.torque - q.segment<3>(3).cross(force);
    ASSERT_LT(std::abs(torque.x()), 1e-8);
    const Vec3 pitch_axis(0, std::cos(q[0]), std::sin(q[0]));
    ASSERT_LT(std::abs(torque.dot(pitch_axis)), 1e-8);
  }
}

TEST(CarriageJoint, GimbalLockIsASimulationError) {
  VesselModel model = example::carried(BalanceKind::six_cells, k_pitch);
  VesselSystem system(model, 0);
  const auto tip = [&] {
    for (int i = 0; i < 100; ++i) {
      const double away = 0.5 * k_pi - system.coordinates()[1];
      // a blow that turns the pitch to 90 degrees within the step
      const double rate = system.coordinates()[7];
      example::step(
          system, {}, k_h,
          {Vec3::Zero(), Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ())) * Vec3(0, 900 * (0.5 * away / k_h - rate), 0)});
    }
  };
  EXPECT_THROW(tip(), SimulationError);
}

}  // namespace carriage_joint_test
}  // namespace nilas::vessel
