/// The force balance with theta: its middle poses are those of the exact step, at any stiffness and length of step.
#include <gtest/gtest.h>

#include <cmath>

#include "core/vessel/model/cells.h"
#include "core/vessel/tree/exponential_mode.h"
#include "tests/core/vessel/example_vessel.h"

namespace nilas::vessel {
namespace vessel_moreau_cells_test {

constexpr double k_h = 0.01;
constexpr int k_surge = 3;  ///< Index of surge among the coordinates.

/// Surge alone is one cell: omega = sqrt(k / m).
VesselModel one_cell(double h_omega, double zeta, double theta) {
  VesselModel model = example::carried(BalanceKind::six_cells);
  const double omega = h_omega / k_h;
  model.carriage->stiffness = example::k_mass * omega * omega;
  model.carriage->damping = 2 * zeta * omega * example::k_mass;
  model.theta = theta;
  return model;
}

Vec3 ahead(double size) { return Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ())) * Vec3(size, 0, 0); }

/// The middle poses after a blow follow x'' + 2 zeta omega x' + omega^2 x = 0 without error: the exponentials of the
/// exact solution give the next of two successive ones.
TEST(VesselMoreauCells, MiddlePosesFollowTheExactMotion) {
  for (const double theta : {0.0, 0.5, 0.7, 1.0})
    for (const double a : {0.05, 0.5, 1.5})
      for (const double zeta : {0.0, 0.05, 0.7}) {
        VesselSystem system(one_cell(a, zeta, theta), 0);
        example::step(system, Wrench{}, k_h, {ahead(2), Vec3::Zero()});
        const double fall = std::exp(-zeta * a), turn = std::cos(a * std::sqrt(1 - zeta * zeta));
        double x = 0, before = 0, largest = 0;
        for (int i = 0; i < 300; ++i) {
          system.move_before_impulses(k_h);
          const double now = system.coordinates()[k_surge];
          if (i >= 2) {
            ASSERT_NEAR(now, 2 * fall * turn * x - fall * fall * before, 1e-12 * largest) << theta << a;
          }
          before = x;
          x = now;
          largest = std::max(largest, std::abs(x));
          system.begin({}, k_h);
          system.finish({});
        }
      }
}

/// The cells rest at load / stiffness under a constant load, for any stiffness, step and theta.
TEST(VesselMoreauCells, AConstantLoadRestsExactly) {
  for (const double theta : {0.5, 0.7, 1.0})
    for (const double a : {0.045, 0.45, 4.5, 45.0, 450.0}) {
      const VesselModel model = one_cell(a, 0.2, theta);
      VesselSystem system(model, 0);
      const Wrench load{ahead(120), Vec3::Zero()};
      example::run(system, load, k_h, a < 0.1 ? 5000 : 500);
      EXPECT_NEAR(system.coordinates()[k_surge] * model.carriage->stiffness, 120, 1e-9 * 120) << theta << " " << a;
      EXPECT_NEAR(system.carriage_loads().cells[0], -120, 1e-9 * 120) << theta << " " << a;
      EXPECT_LT(system.state().v.norm(), 1e-9 * std::abs(system.coordinates()[k_surge]) / k_h);
    }
}

/// While it swings, the reading is the cells' law averaged over two steps about the step's middle.
TEST(VesselMoreauCells, SwingingReactionIsTheAveragedLaw) {
  VesselSystem system(one_cell(0.45, 0, 0.5), 0);
  const double stiffness = example::k_mass * 45 * 45, average = std::pow(std::sin(0.225) / 0.225, 2);
  example::step(system, Wrench{}, k_h, {ahead(2), Vec3::Zero()});
  for (int i = 0; i < 300; ++i) {
    system.move_before_impulses(k_h);
    const double x = system.coordinates()[k_surge];
    system.begin({}, k_h);
    system.finish({});
    ASSERT_NEAR(system.carriage_loads().cells[0], -stiffness * average * x, 1e-7);
  }
}

TEST(VesselMoreauCells, AreStableAtAnyStiffnessAndStep) {
  for (const double theta : {0.5, 1.0})
    for (const bool heave_free : {false, true})
      for (double k = 1e3; k <= 1e12; k *= 10)
        for (const double h : {1e-4, 1e-2, 1.0})
          for (const double damping_time : {0.0, 1e-3}) {
            VesselModel model =
                example::carried(BalanceKind::six_cells, {false, false, heave_free, false, false, false});
            model.carriage->stiffness = k;
            model.carriage->damping = damping_time * k;
            model.theta = theta;
            VesselSystem system(model, 0);
            RandomStream random(5, "stability");
            for (int i = 0; i < 200; ++i) {
              // the same impulses, whatever the step
              example::step(system, Wrench{}, h, example::random_wrench(random, 1));
              ASSERT_LT(system.state().v.norm() + system.state().w.norm(), 5) << k << " " << h << " " << damping_time;
            }
          }
}

/// Towed from rest by a ramp that ends: cell 1 reads m (a + x''), the spring's own motion included,
///   x'' + 2 zeta omega x' + omega^2 x = -a,  to second order where the step resolves it, and m a at any stiffness.
class VesselMoreauRamp : public testing::Test {
 protected:
  static constexpr double k_speed = 0.6, k_ramp = 2;

  static VesselModel towed(double stiffness, double damping, double theta) {
    VesselModel model = example::carried(BalanceKind::six_cells);
    model.carriage->stiffness = stiffness;
    model.carriage->damping = damping;
    model.theta = theta;
    const Vec3 start = model.pose_V.p + model.pose_V.q * model.carriage->joint_V;
    model.carriage->motion = CarriageMotion::straight(start, 0.3, k_speed, 0.3, k_ramp, 0);
    return model;
  }
};

TEST_F(VesselMoreauRamp, CellForceIsTheClosedForm) {
  const double omega = 12, zeta = 0.1, a = k_speed / k_ramp, damped = omega * std::sqrt(1 - zeta * zeta);
  // force after the acceleration has stepped from 0 to a at t = 0
  const auto after_step = [&](double t) {
    if (t < 0) return 0.0;
    const double fall = std::exp(-zeta * omega * t), s = std::sin(damped * t), c = std::cos(damped * t);
    const double x = -a / (omega * omega) * (1 - fall * (c + zeta * omega / damped * s)), v = -a * fall * s / damped;
    return -example::k_mass * (omega * omega * x + 2 * zeta * omega * v);
  };
  const auto error = [&](double theta, double h) {
    const double m = example::k_mass;
    VesselSystem system(towed(m * omega * omega, 2 * zeta * omega * m, theta), 0);
    double largest = 0;
    for (int i = 0; i < static_cast<int>(std::lround(3 / h)); ++i) {
      example::step(system, Wrench{}, h);
      const double t = system.time() - 0.5 * h;
      largest = std::max(largest, std::abs(system.carriage_loads().cells[0] - after_step(t) + after_step(t - k_ramp)));
    }
    return largest;
  };
  const double coarse = error(0.5, 0.02), half = error(0.5, 0.01), fine = error(0.5, 0.005);
  EXPECT_LT(fine, 1e-3 * example::k_mass * a);
  EXPECT_NEAR(std::log2(coarse / half), 2, 0.15);
  EXPECT_NEAR(std::log2(half / fine), 2, 0.15);
}

TEST_F(VesselMoreauRamp, LoadIsMassTimesAccelerationAtAnyStiffness) {
  const double wanted = example::k_mass * k_speed / k_ramp;
  const Vec3 along(std::cos(0.3), std::sin(0.3), 0);
  for (const double theta : {0.5, 0.7, 1.0})
    for (double k = 1e6; k <= 1e12; k *= 10) {
      VesselSystem system(towed(k, 1e-3 * k + 2e4, theta), 0);
      for (int i = 0; i < 200; ++i) {
        const Vec3 before = system.state().v;
        example::step(system, Wrench{}, k_h);
        const CarriageLoads& read = system.carriage_loads();
        const Vec3 own = example::k_mass * (system.state().v - before) / k_h;
        ASSERT_LT((read.about_com.force - own).norm(), 1e-9 * wanted);
        ASSERT_NEAR(read.cells[0], read.about_joint.force.dot(along), 1e-9 * wanted);
      }
      EXPECT_NEAR(system.carriage_loads().cells[0], wanted, 1e-6 * wanted) << k;
      example::run(system, {}, k_h, 300);
      EXPECT_LT(system.carriage_loads().about_com.force.norm(), 1e-6 * wanted) << k;
      EXPECT_LT((system.state().v - k_speed * along).norm(), 1e-9) << k;
    }
}

/// The mean tow force at constant speed is that of the drag law.
TEST_F(VesselMoreauRamp, TowForceIsTheDrag) {
  for (const double theta : {0.5, 0.7, 1.0}) {
    VesselSystem system(towed(1e7, 1e4, theta), 0);
    const double drag = 37;  // [N s^2/m^2]
    for (int i = 0; i < 2000; ++i)
      example::step_under(
          system,
          [&](const VesselState& s) {
            return Wrench{-drag * s.v.norm() * s.v, Vec3::Zero()};
          },
          k_h);
    EXPECT_NEAR(system.carriage_loads().cells[0], drag * k_speed * k_speed, 1e-9 * drag);
  }
}

/// The joint transmits nothing along its free axes halfway through the step, also while everything swings.
TEST(VesselMoreauCells, TransmitNothingOnFreeAxes) {
  for (const double theta : {0.5, 0.7, 1.0}) {
    VesselModel model = example::carried(BalanceKind::six_cells, {false, false, true, true, true, false});
    model.theta = theta;
    VesselSystem system(model, 0);
    RandomStream random(6, "joint");
    const Quat to_carriage(Eigen::AngleAxisd(-0.3, Vec3::UnitZ()));
    for (int i = 0; i < 300; ++i) {
      const VecX before = system.coordinates();
      example::step(system, example::random_wrench(random, 50), k_h, example::random_wrench(random, 1));
      const VecX q = 0.5 * (before + system.coordinates());
      const Wrench& read = system.carriage_loads().about_joint;
      ASSERT_LT(std::abs(read.force.z()), 1e-9);
      // roll turns about the carriage's x axis, through the vessel's joint point
      const Vec3 force = to_carriage * read.force, torque = to_carriage * read.torque - q.segment<3>(3).cross(force);
      ASSERT_LT(std::abs(torque.x()), 1e-8);
      ASSERT_LT(std::abs(torque.dot(Vec3(0, std::cos(q[0]), std::sin(q[0])))), 1e-8);
    }
  }
}

}  // namespace vessel_moreau_cells_test
}  // namespace nilas::vessel
