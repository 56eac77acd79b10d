#include "hydro/radiation/radiation.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/geometry/shape.h"
#include "hydro/radiation/memory_force.h"
#include "tests/hydro/radiation/radiation_cases.h"

namespace nilas::hydro::radiation_test {

using radiation_cases::closed_database;
using radiation_cases::sphere_database;

constexpr double k_step = 0.02;

bodies::Bodies one_vessel() {
  bodies::BodySpec spec;
  spec.name = "ship";
  spec.kind = bodies::BodyKind::vessel;
  spec.motion = bodies::Motion::articulated;
  spec.shape = std::make_shared<const geometry::Shape>(geometry::sphere_shape(1));
  spec.mass = 3000;
  spec.inertia_B = 2000 * Mat3::Identity();
  bodies::Bodies bodies;
  bodies.add(spec);
  return bodies;
}

RadiatingBody radiating(const Vec3& origin, const Vec3& current = Vec3::Zero()) {
  RadiatingBody body;
  body.origin_B = origin;
  body.mass_B.diagonal() << 3000, 3000, 3000, 2000, 2000, 2000;
  body.current = current;
  body.step = k_step;
  return body;
}

/// Moves body 0 with a surge and pitch that oscillate, on a steady course of 30 degrees that turns with `turn` and in
/// water that moves with `drift`. Returns the last wrench and adds up its work relative to the water.
Wrench last_load(bodies::ForceModule& module, double turn, const Vec3& drift, int steps, double* work = nullptr) {
  bodies::Bodies bodies = one_vessel();
  Wrench last;
  for (int k = 0; k < steps; ++k) {
    const double t = k * k_step;
    const Quat q(Eigen::AngleAxisd(turn, Vec3::UnitZ()));
    bodies.set_pose(0, Vec3::Zero(), q);
    bodies.v_GB[0] = q * Vec3(std::sin(1.1 * t), 0, std::cos(0.8 * t) - 1) + drift;
    bodies.w_GB[0] = q * Vec3(0, 0.2 * std::sin(0.7 * t), 0);
    if (k > 0) module.end_substep(bodies, t, k_step);
    bodies::Wrenches out(1);
    module.add_forces(bodies, t, out);
    bodies::Wrenches again(1);
    module.add_forces(bodies, t, again);
    EXPECT_EQ(out[0].force, again[0].force);
    last = out[0];
    if (work) *work += k_step * (last.force.dot(bodies.v_GB[0] - drift) + last.torque.dot(bodies.w_GB[0]));
  }
  return last;
}

/// A hull that starts on a steady motion in all six modes, at an attitude that is not upright, has no load until its
/// motion changes. Its origin of D moves by the angular velocity times the lever of this attitude.
TEST(Radiation, BeginsWithTheWholeVelocityOfTheStart) {
  for (const RadiationModel model : {RadiationModel::state_space, RadiationModel::convolution}) {
    RadiationSettings settings;
    settings.model = model;
    RadiatingBody moving = radiating({0.5, -0.2, 2});
    const Quat attitude = Quat(Eigen::AngleAxisd(0.7, Vec3::UnitZ())) * Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY()));
    moving.attitude = attitude.toRotationMatrix();
    moving.velocity = Vec3(2, -0.5, 0.4);
    moving.angular_velocity = Vec3(0.1, 0.2, -0.3);
    bodies::Bodies bodies = one_vessel();
    bodies.set_pose(0, Vec3::Zero(), attitude);
    bodies.v_GB[0] = moving.velocity;
    bodies.w_GB[0] = moving.angular_velocity;
    const auto load = [&](const RadiatingBody& body) {
      const auto built = make_radiation(closed_database(), settings, body);
      bodies::Wrenches out(1);
      built.module->add_forces(bodies, 0.1, out);
      return out[0].force.norm() + out[0].torque.norm();
    };
    const double from_rest = load(radiating(moving.origin_B));
    EXPECT_GT(from_rest, 50);
    EXPECT_LT(load(moving), 1e-9 * from_rest);
  }
}

/// The same motion in a turned scene and in water that drifts: loads turn with the body, and the drift has no effect.
TEST(Radiation, TurnsWithTheVesselAndMovesWithTheWater) {
  for (const RadiationModel model : {RadiationModel::state_space, RadiationModel::convolution}) {
    RadiationSettings settings;
    settings.model = model;
    const Vec3 origin(0.5, 0, 0.3), drift(0.4, -0.2, 0);
    RadiatingBody straight = radiating(origin), turned = radiating(origin, drift);
    turned.attitude = Eigen::AngleAxisd(2.1, Vec3::UnitZ()).toRotationMatrix();
    turned.velocity = drift;
    const auto first = make_radiation(closed_database(), settings, straight);
    const auto second = make_radiation(closed_database(), settings, turned);
    const Wrench one = last_load(*first.module, 0, Vec3::Zero(), 500);
    const Wrench two = last_load(*second.module, 2.1, drift, 500);
    const Mat3 R = Eigen::AngleAxisd(2.1, Vec3::UnitZ()).toRotationMatrix();
    EXPECT_LT((two.force - R * one.force).norm(), 1e-9 * one.force.norm());
    EXPECT_LT((two.torque - R * one.torque).norm(), 1e-9 * one.torque.norm());
    EXPECT_GT(one.force.norm(), 100);
  }
}

/// A database whose bow points at negative X, turned by 180 degrees: that turn leaves the coupled entries of surge and
/// pitch as they are, so the load is the same.
TEST(Radiation, TakesADatabaseWithOtherAxes) {
  RadiatingBody turned = radiating({0.5, 0, 0.3});
  turned.rotation = k_pi;
  const auto first = make_radiation(closed_database(), {}, radiating({0.5, 0, 0.3}));
  const auto second = make_radiation(closed_database(), {}, turned);
  const Wrench one = last_load(*first.module, 0, Vec3::Zero(), 300),
               two = last_load(*second.module, 0, Vec3::Zero(), 300);
  EXPECT_LT((two.force - one.force).norm(), 1e-9 * one.force.norm());
  EXPECT_LT((two.torque - one.torque).norm(), 1e-9 * one.torque.norm());
}

/// Pitch w about the centre of mass moves the origin of D, at height z above it, by w z in surge. Loads at that origin,
/// taken to the centre of mass, give a moment z F. So with the velocities of the closed form, the load is that of
/// MemoryForce for surge v + w z and pitch w.
TEST(Radiation, ActsAtTheOriginOfTheDatabase) {
  RadiationSettings settings;
  settings.model = RadiationModel::convolution;
  const double z = 0.3;
  const auto built = make_radiation(closed_database(), settings, radiating({0, 0, z}));
  const RadiationDamping damping = prepare_damping(closed_database());
  const auto memory = make_convolution(retardation(damping));
  memory->advance(0, Vec6::Zero());
  Vec6 expected = Vec6::Zero();
  for (int k = 1; k < 300; ++k) {
    const double t = k * k_step, pitch = 0.2 * std::sin(0.7 * t);
    Vec6 V;
    V << std::sin(1.1 * t) + pitch * z, 0, std::cos(0.8 * t) - 1, 0, pitch, 0;
    memory->advance(t, V);
    expected = memory->load(t, V);
  }
  const Wrench found = last_load(*built.module, 0, Vec3::Zero(), 300);
  EXPECT_LT((found.force - expected.head<3>()).norm(), 1e-9 * expected.norm());
  EXPECT_NEAR(found.torque.y(), expected[4] + z * expected[0], 1e-9 * expected.norm());
}

TEST(Radiation, TakesEnergyAndSaysWhatItIs) {
  const auto built = make_radiation(sphere_database(), {}, [] {
    RadiatingBody body = radiating(Vec3::Zero());
    body.mass_B.diagonal() << 261.8e3, 261.8e3, 261.8e3, 1.7e6, 1.7e6, 1.7e6;
    return body;
  }());
  double work = 0;
  last_load(*built.module, 0.4, Vec3::Zero(), 1000, &work);
  EXPECT_LT(work, 0);
  EXPECT_NE(built.description.find("poles, error"), std::string::npos) << built.description;
  EXPECT_NE(built.description.find("passive"), std::string::npos);
  EXPECT_EQ(built.module->name(), "radiation");
  EXPECT_EQ(built.module->load_on_vessel(), bodies::VesselLoad::water);
  ASSERT_EQ(built.notes.size(), 1);
  EXPECT_NE(built.notes[0].find("The damping of heave is negative"), std::string::npos) << built.notes[0];
}

TEST(Radiation, ContinuesFromACheckpointWithTheSameBits) {
  for (const RadiationModel model : {RadiationModel::state_space, RadiationModel::convolution}) {
    RadiationSettings settings;
    settings.model = model;
    const auto first = make_radiation(closed_database(), settings, radiating(Vec3::Zero()));
    const auto second = make_radiation(closed_database(), settings, radiating(Vec3::Zero()));
    last_load(*first.module, 0, Vec3::Zero(), 100);
    State state;
    const bodies::Bodies bodies = one_vessel();
    first.module->save(bodies, StateWriter(state));
    second.module->restore(StateReader(state));
    bodies::Wrenches one(1), two(1);
    first.module->add_forces(bodies, 2.0, one);
    second.module->add_forces(bodies, 2.0, two);
    EXPECT_EQ(one[0].force, two[0].force);
    EXPECT_EQ(one[0].torque, two[0].torque);
  }
}

/// K(0) of heave is 1000 times H(s) s at infinity, which is 1; mass and added mass are 8000 kg: the longest step is the
/// root of 8 s^2. Surge and pitch allow less: their largest ratio is below 2500 / 7000.
TEST(Radiation, RefusesWhatItCannotCompute) {
  const auto message = [](const RadiationSettings& settings, double step) -> std::string {
    RadiatingBody body = radiating(Vec3::Zero());
    body.step = step;
    try {
      make_radiation(closed_database(), settings, body);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message({}, 1.5), "");
  EXPECT_NE(message({}, 3).find("too long for the radiation"), std::string::npos) << message({}, 3);
  RadiationSettings exact;
  exact.error = 1e-9;
  EXPECT_NE(message(exact, k_step).find("up to 24 poles"), std::string::npos) << message(exact, k_step);
}

}  // namespace nilas::hydro::radiation_test
