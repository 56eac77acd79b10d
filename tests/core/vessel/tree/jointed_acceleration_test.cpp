/// A vessel of several bodies on an accelerating carriage: joints and cells that bear its inertia deflect as in
/// statics.
#include <cmath>
#include <tuple>

#include "tests/core/vessel/tree/jointed_example.h"

namespace nilas::vessel {
namespace jointed_acceleration_test {

constexpr double k_h = 0.01;
constexpr double k_acceleration = 0.8;  ///< Acceleration of the carriage along its own x [m/s^2].
constexpr double k_ramp = 10;           ///< [s]
constexpr double k_ratio = 0.3;         ///< damping ratio of the modes
constexpr double k_rounding = 1e-14;    ///< Rounding of the difference of two positions some 10 m from the origin [m].

/// Six cells whose longitudinal mode has w h = `wh` under the mass that hangs on them, and a carriage that gains speed.
VesselModel sped_up(std::optional<double> theta, double wh, double mass) {
  VesselModel model = example::carried(BalanceKind::six_cells);
  model.theta = theta;
  const double omega = wh / k_h;
  CarriageModel& carriage = *model.carriage;
  carriage.stiffness = omega * omega * mass;
  carriage.damping = 2 * k_ratio / omega * carriage.stiffness;
  const Vec3 start = model.pose_V.p + model.pose_V.q * model.mass.com;
  carriage.motion = CarriageMotion::straight(start, 0.3, k_ramp * k_acceleration, 0.3, k_ramp, 0);
  return model;
}

PartModel at_the_centre(const VesselModel& model, JointKind joint, double mass) {
  PartModel part;
  part.joint = joint;
  part.mass = mass;
  part.inertia_B = model.mass.inertia;
  part.axis_V = Vec3::UnitX();
  part.point_V = part.in_V.p = model.mass.com;
  return part;
}

/// How far the hull is from where the carriage would hold it rigidly, along the carriage's axes.
Vec3 deflection(const VesselModel& model, const VesselSystem& system) {
  const Quat to_carriage(Eigen::AngleAxisd(-0.3, Vec3::UnitZ()));
  return to_carriage * (system.state().pose.p - model.carriage->motion.at(system.time()).p);
}

class JointedAcceleration : public testing::TestWithParam<std::tuple<std::optional<double>, double>> {
 protected:
  std::optional<double> theta() const { return std::get<0>(GetParam()); }
  double wh() const { return std::get<1>(GetParam()); }
};

TEST_P(JointedAcceleration, DeflectsCellsByTheInertiaOverTheirStiffness) {
  const double mass = 2 * example::k_mass;
  VesselModel model = sped_up(theta(), wh(), mass);
  model.parts = {at_the_centre(model, JointKind::weld, example::k_mass)};
  VesselSystem system(model, 0);
  for (int k = 0; k < 600; ++k) example::step(system, std::vector<Wrench>(2), k_h);
  const double expected = -mass * k_acceleration / model.carriage->stiffness;
  const Vec3 found = deflection(model, system);
  EXPECT_NEAR(found.x(), expected, 1e-9 * std::abs(expected) + k_rounding);
  EXPECT_NEAR(found.tail<2>().norm(), 0, 1e-9 * std::abs(expected) + k_rounding);
  EXPECT_NEAR(system.carriage_loads().cells[0], mass * k_acceleration, 1e-9 * mass);
}

TEST_P(JointedAcceleration, DeflectsAPartsSpringByItsInertiaOverItsStiffness) {
  const double mass = 200, whole = mass + example::k_mass;
  VesselModel model = sped_up(theta(), 0.5, whole);
  PartModel part = at_the_centre(model, JointKind::slider, mass);
  const double omega = wh() / k_h;
  part.stiffness = omega * omega * mass;
  part.damping = 2 * k_ratio / omega * part.stiffness;
  model.parts = {part};
  VesselSystem system(model, 0);
  for (int k = 0; k < 900; ++k) example::step(system, std::vector<Wrench>(2), k_h);
  EXPECT_NEAR(system.parts()[0].coordinates[0] / (-mass * k_acceleration / part.stiffness), 1, 1e-9);
  EXPECT_NEAR(deflection(model, system).x() / (-whole * k_acceleration / model.carriage->stiffness), 1, 1e-9);
}

/// The reference has one body in place of the hull and its welded part, from the first step on.
TEST_P(JointedAcceleration, ReadsWithAWeldedPartWhatOneBodyReads) {
  VesselModel model = sped_up(theta(), wh(), 2 * example::k_mass);
  VesselModel whole = model;
  whole.mass.mass *= 2;
  whole.mass.inertia *= 2;
  model.parts = {at_the_centre(model, JointKind::weld, example::k_mass)};
  VesselSystem two(model, 0), one(whole, 0);
  const double scale = 2 * example::k_mass * k_acceleration;
  for (int k = 0; k < 100; ++k) {
    const Wrench load{Vec3(0.1 * scale * std::sin(20 * k * k_h), 0, 0), Vec3::Zero()};
    example::step(two, {load, {}}, k_h);
    example::step(one, load, k_h);
    ASSERT_NEAR(two.carriage_loads().cells[0], one.carriage_loads().cells[0], 1e-9 * scale) << k;
    ASSERT_NEAR((two.state().pose.p - one.state().pose.p).norm(), 0, 1e-9 * scale / model.carriage->stiffness) << k;
  }
}

/// A long rod holds a slider across the course. The rod's influence while the vessel moves is small: 1e-6 of the
/// inertia.
TEST_P(JointedAcceleration, DeflectsCellsByTheInertiaBesideARod) {
  const double mass = 200, whole = mass + example::k_mass;
  VesselModel model = sped_up(theta(), wh(), whole);
  PartModel part = at_the_centre(model, JointKind::slider, mass);
  part.axis_V = Vec3::UnitY();
  model.parts = {part};
  const Vec3 across = Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ())) * Vec3(0, 200, 0);
  model.rods.push_back({"tie", 0, model.mass.com, model.carriage->motion.at(0).p + across, std::nullopt});
  VesselSystem system(model, 0);
  for (int k = 0; k < 150; ++k) example::step(system, std::vector<Wrench>(2), k_h);
  EXPECT_GT(std::abs(system.joint_account().rods[0]), 0.1);
  EXPECT_NEAR(deflection(model, system).x() / (-whole * k_acceleration / model.carriage->stiffness), 1, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Steps, JointedAcceleration,
                         testing::Combine(testing::Values(std::optional<double>(), std::optional<double>(0.5),
                                                          std::optional<double>(0.8)),
                                          testing::Values(0.3, 1.0, 4.5, 30.0)));

/// The account of the works holds while cells, springs and loose joints bear the changes of the carriage's speed.
TEST(JointedAccelerationWork, IsWhatTheBodiesGain) {
  for (const std::optional<double> theta : {std::optional<double>(), std::optional<double>(0.5)}) {
    VesselModel model = sped_up(theta, 4.5, example::k_mass);
    model.parts = example::chain().parts;
    model.parts[0].stiffness = 50;
    VesselSystem system(model, 0);
    const std::vector<Wrench> nothing(model.parts.size() + 1);
    double last = example::totals(model, system).kinetic, worst = 0, largest = 0;
    for (int k = 0; k < 100; ++k) {
      example::step(system, nothing, k_h);
      const double now = example::totals(model, system).kinetic;
      const JointAccount& account = system.joint_account();
      const double works = account.spring_work + account.carriage_work + account.before.carriage +
                           account.before.springs + account.after.carriage + account.after.springs;
      worst = std::max(worst, std::abs(now - last - works));
      largest = std::max(largest, std::abs(now - last));
      last = now;
    }
    EXPECT_GT(largest, 1);
    EXPECT_LT(worst, 1e-6 * largest);
  }
}

}  // namespace jointed_acceleration_test
}  // namespace nilas::vessel
